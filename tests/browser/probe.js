// SPDX-License-Identifier: MIT
// Stands first in the head of a copy of a page. Collects what goes wrong from the start on; once
// the page is there, uses its figures as a hand with a mouse would and tells the page around it
// what is then seen, in pixels of the window. It judges nothing.
'use strict';
{
  const errors = [];
  addEventListener('error', event => errors.push(String(event.message)));
  addEventListener('unhandledrejection', event => errors.push(String(event.reason)));
  for (const kind of ['error', 'warn', 'assert'])
    console[kind] = (...words) => errors.push(words.join(' '));

  const pair = text => text.split(' ').map(Number);
  const box = element => {
    const {left, top, right, bottom} = element.getBoundingClientRect();
    return {left, top, right, bottom};
  };
  const centre = element => {
    const {left, top, right, bottom} = box(element);
    return [(left + right) / 2, (top + bottom) / 2];
  };

  // Sends an event to the topmost element at the point; returns whether the page left the default to the browser.
  const point = (kind, type, [x, y], more = {}) => document.elementFromPoint(x, y).dispatchEvent(
    new kind(type, {clientX: x, clientY: y, bubbles: true, cancelable: true, ...more}));

  // Values spaced evenly along an axis.
  const scales = svg => svg.dataset.scales.split(' ');
  const even = {linear: value => value, logarithmic: Math.log10};

  const axes = svg => {
    const [to_x, to_y] = scales(svg).map(name => even[name]);
    const [x0, x1] = pair(svg.dataset.x).map(to_x), [y0, y1] = pair(svg.dataset.y).map(to_y);
    const [left, top, width, height] = pair(svg.dataset.plot);
    const {left: ox, top: oy, right} = box(svg);
    const scale = (right - ox) / svg.viewBox.baseVal.width;
    return {
      place: ([x, y]) => [ox + scale * (left + (to_x(x) - x0) / (x1 - x0) * width),
                          oy + scale * (top + (y1 - to_y(y)) / (y1 - y0) * height)],
      part: ([a, b]) => [ox + scale * (left + a * width), oy + scale * (top + (1 - b) * height)],
    };
  };

  const marks = svg => [...svg.querySelectorAll('[data-at]')].map(
    mark => ({name: mark.dataset.name, at: pair(mark.dataset.at), seen: centre(mark),
              hidden: getComputedStyle(mark).visibility === 'hidden'}));

  // A line of the grid and the number that belongs to it.
  const ticks = svg => [...svg.querySelectorAll('.ticks path')].map(line => {
    const {left, top, right, bottom} = box(line), label = line.nextElementSibling;
    const across = right - left > bottom - top;
    return {axis: across ? 'y' : 'x', value: +label.textContent,
            seen: across ? (top + bottom) / 2 : (left + right) / 2,
            label: centre(label)[across ? 1 : 0]};
  });
  const state = svg => ({scales: scales(svg), marks: marks(svg), ticks: ticks(svg),
                         frame: box(svg.querySelector('.frame'))});

  const readout = svg => svg.parentNode.querySelector('.readout').textContent;
  const hover = (svg, at) => {
    point(PointerEvent, 'pointermove', at);
    const ring = svg.querySelector('.hover-ring');
    return {pointer: at, readout: readout(svg),
            ring: ring.getAttribute('visibility') === 'visible' ? centre(ring) : null};
  };

  const drag = (from, to) => {
    point(PointerEvent, 'pointerdown', from, {buttons: 1});
    point(PointerEvent, 'pointermove', to, {buttons: 1});
    point(PointerEvent, 'pointerup', to);
  };

  const wheel = (at, deltaY, ctrlKey = true) => !point(WheelEvent, 'wheel', at, {deltaY, ctrlKey});

  // Far in about the anchor, some way to the side, back again.
  const zooming = (svg, anchor) => {
    anchor = anchor.map(Math.round);  // a wheel has only whole pixels
    const seen = {anchor, before: state(svg)};
    seen.taken_without_key = wheel(anchor, -100, false);
    seen.without_key = state(svg);
    seen.taken = wheel(anchor, -100);
    for (let i = 0; i < 5; ++i) wheel(anchor, -100);
    seen.zoomed = state(svg);
    seen.hover = hover(svg, seen.zoomed.marks.length ? seen.zoomed.marks[0].seen : anchor);
    const middle = axes(svg).part([0.5, 0.5]);
    seen.by = [9, -7];
    drag(middle, [middle[0] + seen.by[0], middle[1] + seen.by[1]]);
    seen.dragged = state(svg);
    hover(svg, middle);
    seen.let_go = state(svg);
    point(PointerEvent, 'pointerdown', middle, {buttons: 1});  // and released outside the window
    hover(svg, anchor);
    seen.lost = state(svg);
    point(PointerEvent, 'pointerup', middle);
    point(MouseEvent, 'dblclick', middle);
    seen.restored = state(svg);
    seen.taken_at_whole = wheel(anchor, 100);
    seen.taken_outside = wheel(centre(svg.querySelector('.title')), -100);
    return seen;
  };

  const background = element => {
    for (let now = element; now; now = now.parentElement) {
      const colour = getComputedStyle(now).backgroundColor;
      if (!/, 0\)$/.test(colour)) return colour;
    }
    return 'none';
  };
  const text = (element, colour) => ({text: element.textContent.slice(0, 60), box: box(element),
                                      colour, background: background(element)});

  const figure = (svg, asked) => {
    const {place, part} = axes(svg);
    const seen = {box: box(svg), rest: state(svg), has_map: svg.querySelector('.plot image') !== null};
    for (const mark of seen.rest.marks) mark.due = place(mark.at);
    for (const tick of seen.rest.ticks)
      tick.due = tick.axis === 'x' ? place([tick.value, 1])[0] : place([1, tick.value])[1];
    seen.texts = [...svg.querySelectorAll('text')].map(word => {
      const style = getComputedStyle(word);
      const note = word.closest('.plot');  // which clips what goes beyond it
      const [left, top] = part([0, 1]), [right, bottom] = part([1, 0]);
      const pixels = parseFloat(style.fontSize) * (seen.box.right - seen.box.left) / svg.viewBox.baseVal.width;
      return {...text(word, style.fill), pixels, rim: note ? style.stroke : 'none',
              room: note ? {left, top, right, bottom} : seen.box};
    });
    seen.inks = [...svg.querySelectorAll('.plot .curve, .plot .disc, .plot .ring, .plot .edge')]
      .map(mark => getComputedStyle(mark).color);
    seen.hover_marks = seen.rest.marks.map(mark => hover(svg, mark.due));
    seen.hover_asked = asked.map(at => hover(svg, place(at)));
    seen.hover_corner = {...hover(svg, part([0.97, 0.97])), due: part([0.97, 0.97])};
    seen.hover_title = hover(svg, centre(svg.querySelector('.title')));
    hover(svg, part([0.5, 0.5]));
    svg.dispatchEvent(new PointerEvent('pointerleave'));
    seen.after_leaving = readout(svg);
    seen.zoom = zooming(svg, seen.rest.marks.length ? seen.rest.marks[0].due : part([0.3, 0.6]));
    return seen;
  };

  // Numbers at the end of a line whose units begin the next.
  const parted = () => {
    const found = [], walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT), range = new Range();
    for (let node; (node = walk.nextNode());) {
      if (node.parentElement.closest('svg, pre, script')) continue;
      for (const number of node.data.matchAll(/\d\s(mm?|m?s|m\/s|k?g|kN|MN\/m|k?J|%)(?!\w)/g)) {
        range.setStart(node, number.index);
        range.setEnd(node, number.index + number[0].length);
        if (range.getClientRects().length > 1) found.push(node.data.slice(0, 60) + ': ' + number[0]);
      }
    }
    return found;
  };

  // How high a figure that is folded away is before and after its summary is clicked.
  const unfolded = details => {
    const closed = details.offsetHeight;
    details.querySelector('summary').click();
    return {closed, opened: details.offsetHeight};
  };

  // The rules for print hold on the screen, and those for the screen do not.
  const lay_out_as_printed = () => {
    for (const sheet of document.styleSheets)
      for (const rule of sheet.cssRules)
        if (rule.media && /\bscreen\b/.test(rule.media.mediaText)) rule.media.mediaText = 'print';
        else if (rule.media && rule.media.mediaText === 'print') rule.media.mediaText = 'all';
  };

  addEventListener('load', () => {
    const [page, look] = window.name.split(' ');
    const seen = {};
    try {
      if (look === 'print') lay_out_as_printed();
      seen.width = innerWidth;
      seen.scroll_width = document.documentElement.scrollWidth;
      seen.dark = matchMedia('(prefers-color-scheme: dark)').matches;
      seen.texts = [...document.querySelectorAll('h1,h2,p,th,td,pre,footer')].map(
        word => text(word, getComputedStyle(word).color));
      seen.captions = [...document.querySelectorAll('figure')].map(
        figure => [...figure.querySelectorAll('figcaption')].map(words => words.textContent).join('|'));
      seen.cut = [...document.querySelectorAll('.wide')].filter(
        wide => wide.scrollWidth > wide.clientWidth).map(wide => wide.textContent.slice(0, 60));
      seen.parted = parted();
      seen.headings = [...document.querySelectorAll('h2')].map(heading => ({
        text: heading.textContent, after: getComputedStyle(heading).breakAfter,
        with_next: heading.nextElementSibling ? getComputedStyle(heading.nextElementSibling).breakInside : 'nothing'}));
      seen.folded = [...document.querySelectorAll('figure+details')].map(
        details => look === 'print' ? {closed: details.offsetHeight} : unfolded(details));
      seen.figures = {};
      for (const svg of document.querySelectorAll('svg.figure')) {
        const id = svg.querySelector('title').id.replace('-title', '');
        seen.figures[id] = look === 'print' ? {box: box(svg)} : figure(svg, parent.asked(page, id));
      }
    } catch (error) {
      errors.push('probe: ' + error.stack);
    }
    seen.errors = errors;
    parent.tell(page, look, seen);
  });
}
