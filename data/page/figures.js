'use strict';
for (const figure of document.querySelectorAll('svg.figure')) {
  const scales = figure.dataset.scales.split(' ').map(name => name === 'linear'
    ? {to: v => v, from: u => u} : {to: Math.log10, from: u => 10 ** u, decades: true});
  const [x0, x1] = figure.dataset.x.split(' ').map(Number).map(scales[0].to);
  const [y0, y1] = figure.dataset.y.split(' ').map(Number).map(scales[1].to);
  const [left, top, w, h] = figure.dataset.plot.split(' ').map(Number);
  const plot = figure.querySelector('.plot'), pins = figure.querySelector('.pins');
  const readout = figure.parentNode.querySelector('.readout');
  const ring = document.createElementNS(plot.namespaceURI, 'circle');
  ring.setAttribute('class', 'ring orange hover-ring');
  ring.setAttribute('visibility', 'hidden');
  pins.append(ring);
  figure.querySelector('.frame').style.pointerEvents = 'none';
  const value = (px, py) => [scales[0].from(x0 + px / w * (x1 - x0)), scales[1].from(y1 - py / h * (y1 - y0))];
  const points = [];
  for (const curve of plot.querySelectorAll('.curve.hover'))
    for (const m of curve.getAttribute('d').matchAll(/[MLC]([^MLC]+)/g))
      points.push([...m[1].trim().split(' ').slice(-2).map(Number), curve.dataset.name]);
  const place = pin => pin.getAttribute('transform').match(/-?[\d.]+/g).map(Number);
  for (const pin of pins.querySelectorAll('.pin[data-at]')) {
    const [px, py] = place(pin);
    points.push([px, py, pin.dataset.name, pin.dataset.at.split(' ').map(Number)]);
  }
  // What the colour of a map says at a place; nothing if there is no map.
  let named = () => '';
  const image = plot.querySelector('image');
  if (image) {
    const names = new Map(image.dataset.names.split('|').map(entry => [entry.slice(0, 7), entry.slice(8)]));
    const picture = new Image();
    picture.onload = () => {
      const canvas = document.createElement('canvas');
      canvas.width = picture.width; canvas.height = picture.height;
      const pixels = canvas.getContext('2d', {willReadFrequently: true});
      pixels.drawImage(picture, 0, 0);
      named = (px, py) => {
        const [r, g, b] = pixels.getImageData(px / w * canvas.width, py / h * canvas.height, 1, 1).data;
        return names.get('#' + [r, g, b].map(c => c.toString(16).padStart(2, '0')).join('')) || '';
      };
    };
    picture.src = image.getAttribute('href');
  }
  let view = [0, 0, w, h];
  const at = event => {
    const box = figure.getBoundingClientRect(), s = figure.viewBox.baseVal.width / box.width;
    const px = (event.clientX - box.left) * s - left, py = (event.clientY - box.top) * s - top;
    return [view[0] + px / w * view[2], view[1] + py / h * view[3]];
  };
  const inside = ([px, py]) =>
    px >= view[0] && py >= view[1] && px <= view[0] + view[2] && py <= view[1] + view[3];
  const rounds = (a, b, wanted) => {
    const raw = (b - a) / wanted, decade = 10 ** Math.floor(Math.log10(raw)), d = raw / decade;
    const step = decade * (d <= 1 ? 1 : d <= 2 ? 2 : d <= 5 ? 5 : 10), all = [];
    for (let i = Math.ceil(a / step); i * step <= b && all.length < 20; ++i) all.push(i * step);
    return all;
  };
  // As few digits as distinguish the numbers.
  const words = values => {
    const step = Math.abs(values[1] - values[0]) || 1;
    for (let digits = 6; ; ++digits) {
      const all = values.map(v => +v.toPrecision(digits));
      if (digits === 17 || all.every((v, i) => Math.abs(v - values[i]) <= 1e-3 * step)) return all;
    }
  };
  // The positions of the ticks of an axis between its values a and b, from 0 to 1, and their labels.
  const ticks = (scale, a, b, wanted) => {
    const from = scale.to(a), to = scale.to(b);
    const values = scale.decades && to - from >= 2
      ? rounds(from, to, wanted).filter(Number.isInteger).map(scale.from) : rounds(a, b, wanted);
    const all = words(values);
    return values.map((t, i) => [(scale.to(t) - from) / (to - from), all[i]]);
  };
  const letter = 8.3;
  const fitting = (scale, a, b) => {
    let all = [];
    for (const wanted of [6, 4, 3, 2]) {
      all = ticks(scale, a, b, wanted);
      if (all.length * (12 + letter * Math.max(...all.map(t => String(t[1]).length))) < w) break;
    }
    return all;
  };
  const room = left - 24;  // of a number beside the plot
  const has_ticks = axis => figure.querySelector(`.ticks path[d*="${axis}"]`) !== null;
  const has_x = has_ticks('v'), has_y = has_ticks('h');
  const inset = figure.querySelector('.inset');
  const whole = figure.querySelector('.ticks').innerHTML;
  const show = () => {
    const k = view[2] / w;
    for (const svg of [plot, pins]) svg.setAttribute('viewBox', view.join(' '));
    for (const pin of figure.querySelectorAll('.pin'))
      pin.setAttribute('transform', pin.getAttribute('transform').replace(/ scale.*/, '') + ` scale(${k})`);
    for (const pin of pins.querySelectorAll('.pin'))  // nothing clips them
      pin.setAttribute('visibility', k < 1 && !inside(place(pin)) ? 'hidden' : 'visible');
    ring.setAttribute('r', 6 * k);
    if (inset) inset.setAttribute('visibility', k < 1 ? 'hidden' : 'visible');
    let text = whole;
    if (k < 1) {
      text = '';
      const [a, d] = value(view[0], view[1]), [b, c] = value(view[0] + view[2], view[1] + view[3]);
      if (has_x) for (const [u, t] of fitting(scales[0], a, b)) {
        const x = left + u * w;
        text += `<path class="grid" d="M${x} ${top}v${h}"/><text x="${x}" y="${top + h + 17}" text-anchor="middle">${t}</text>`;
      }
      if (has_y) for (const [u, t] of ticks(scales[1], c, d, h < 200 ? 5 : 6)) {
        const y = top + (1 - u) * h;
        text += `<path class="grid" d="M${left} ${y}h${w}"/><text x="${left - 6}" y="${Math.min(y + 4, top + h + 1)}" text-anchor="end"${
          letter * String(t).length > room ? ` textLength="${room}" lengthAdjust="spacingAndGlyphs"` : ''}>${t}</text>`;
      }
    }
    figure.querySelector('.ticks').innerHTML = text;
  };
  const move = (x, y, size) => {
    const s = Math.min(1, Math.max(size, 1e-3));
    view = [Math.min(Math.max(x, 0), w * (1 - s)), Math.min(Math.max(y, 0), h * (1 - s)), w * s, h * s];
    show();
  };
  let dragged = null;
  figure.addEventListener('wheel', event => {
    const [px, py] = at(event), s = view[2] / w, next = s * (event.deltaY < 0 ? 0.8 : 1.25);
    if (!inside([px, py]) || (next > 1 && s === 1)) return;
    if (!event.ctrlKey && !event.metaKey) {  // the page scrolls
      readout.textContent = 'Hold Ctrl to zoom with the wheel.';
      return;
    }
    event.preventDefault();
    const r = Math.min(1, next) / s;
    move(px - (px - view[0]) * r, py - (py - view[1]) * r, s * r);
  }, {passive: false});
  // On the figure, not the plot: where nothing is drawn, nothing of the plot is under the pointer.
  figure.addEventListener('pointerdown', event => { dragged = event.button === 0 && inside(at(event)) ? at(event) : null; });
  addEventListener('pointerup', () => { dragged = null; });
  figure.addEventListener('dblclick', () => move(0, 0, 1));
  const leave = () => { ring.setAttribute('visibility', 'hidden'); readout.textContent = ''; };
  figure.addEventListener('pointerleave', leave);
  figure.addEventListener('pointermove', event => {
    const [px, py] = at(event);
    figure.style.cursor = inside([px, py]) ? 'crosshair' : '';
    if (!event.buttons) dragged = null;  // released outside the window
    if (dragged && view[2] < w) {
      move(view[0] + dragged[0] - px, view[1] + dragged[1] - py, view[2] / w);
      return;
    }
    if (!inside([px, py])) {
      leave();
      return;
    }
    let best = null, least = (view[2] / 12) ** 2;
    for (const point of points) {
      const d = (point[0] - px) ** 2 + (point[1] - py) ** 2;
      if (d <= least && inside(point)) { least = d; best = point; }
    }
    ring.setAttribute('visibility', best ? 'visible' : 'hidden');
    const [vx, vy] = best ? best[3] || value(best[0], best[1]) : value(px, py);
    if (best) { ring.setAttribute('cx', best[0]); ring.setAttribute('cy', best[1]); }
    const name = best ? best[2] : named(px, py);
    readout.textContent = (name ? name + ': ' : '') + +vx.toPrecision(5) + ', ' + +vy.toPrecision(5);
  });
  show();
}
