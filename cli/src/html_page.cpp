// SPDX-License-Identifier: MIT
#include "html_page.hpp"

#include "version.hpp"

#include <fmt/format.h>

#include <iterator>

namespace stillpoint::cli {

namespace {

using fmt::format;

constexpr std::string_view page_style = R"(
:root{color-scheme:light dark}
body{font:15px/1.45 "DejaVu Sans",Arial,sans-serif;margin:0 auto;max-width:1180px;padding:16px;color:#222;background:#fff}
h1{font-size:22px;margin:4px 0;overflow-wrap:anywhere}h2{font-size:17px;margin:24px 0 6px}
.figures{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,480px),1fr));gap:20px;margin-top:14px}
.figures figure{margin:0;break-inside:avoid;max-width:640px}
.figure{width:100%;height:auto;display:block}
.plot{cursor:crosshair}
.readout{min-height:1.5em;font-size:13px;padding-left:14%}
.readout button{font:inherit;margin-left:8px}
.wide{overflow-x:auto;break-inside:avoid}
table{border-collapse:collapse;font-size:14px}td,th{padding:3px 10px;border-bottom:1px solid #ccc;text-align:left;white-space:nowrap}
td{font-variant-numeric:tabular-nums}
pre{overflow-x:auto;font:13px/1.4 "DejaVu Sans Mono",monospace;background:#f4f4f4;padding:10px}
footer{margin-top:24px;font-size:13px;color:#666}
)";

constexpr std::string_view dark_page_style = R"(
body{color:#ddd;background:#14181d}td,th{border-color:#444}pre{background:#1d232a}footer{color:#aaa}
)";

constexpr std::string_view print_style = R"(
body{max-width:none;padding:0}.figures{grid-template-columns:1fr 1fr}.readout{display:none}
pre{white-space:pre-wrap;overflow:visible}.wide{overflow:visible}td,th{white-space:normal;padding:2px 5px}table{font-size:12px}
)";

/// Values under the pointer come from what is drawn, by the mapping of the axes that the figure
/// carries; zooming changes the view of the plot, and the ticks with it.
constexpr std::string_view script = R"js(
'use strict';
for (const figure of document.querySelectorAll('svg.figure')) {
  const [x0, x1] = figure.dataset.x.split(' ').map(Number);
  const [y0, y1] = figure.dataset.y.split(' ').map(Number);
  const [left, top, w, h] = figure.dataset.plot.split(' ').map(Number);
  const plot = figure.querySelector('.plot'), frame = figure.querySelector('.frame');
  const readout = figure.parentNode.querySelector('.readout');
  const ring = document.createElementNS(plot.namespaceURI, 'circle');
  ring.setAttribute('class', 'ring orange hover-ring');
  ring.setAttribute('visibility', 'hidden');
  plot.append(ring);
  frame.style.pointerEvents = 'none';
  const value = (px, py) => [x0 + px / w * (x1 - x0), y1 - py / h * (y1 - y0)];
  const points = [];
  for (const curve of plot.querySelectorAll('.curve.hover'))
    for (const m of curve.getAttribute('d').matchAll(/[ML](\S+?) ([^ML]+)/g))
      points.push([+m[1], +m[2], curve.dataset.name]);
  for (const pin of plot.querySelectorAll('.pin[data-at]')) {
    const m = pin.getAttribute('transform').match(/\(([^ ]+) ([^)]+)\)/);
    points.push([+m[1], +m[2], pin.dataset.name, pin.dataset.at.split(' ').map(Number)]);
  }
  let view = [0, 0, w, h];
  const at = event => {
    const box = figure.getBoundingClientRect(), s = figure.viewBox.baseVal.width / box.width;
    const px = (event.clientX - box.left) * s - left, py = (event.clientY - box.top) * s - top;
    return [view[0] + px / w * view[2], view[1] + py / h * view[3]];
  };
  const ticks = (a, b) => {
    const raw = (b - a) / 6, decade = 10 ** Math.floor(Math.log10(raw)), d = raw / decade;
    const step = decade * (d <= 1 ? 1 : d <= 2 ? 2 : d <= 5 ? 5 : 10), all = [];
    for (let i = Math.ceil(a / step); i * step <= b && all.length < 20; ++i) all.push(i * step);
    return all;
  };
  const whole = figure.querySelector('.ticks').innerHTML;
  const show = () => {
    const k = view[2] / w;
    plot.setAttribute('viewBox', view.join(' '));
    for (const pin of plot.querySelectorAll('.pin'))
      pin.setAttribute('transform', pin.getAttribute('transform').replace(/ scale.*/, '') + ` scale(${k})`);
    ring.setAttribute('r', 6 * k);
    let text = whole;
    if (k < 1) {
      text = '';
      const [a, d] = value(view[0], view[1]), [b, c] = value(view[0] + view[2], view[1] + view[3]);
      for (const t of ticks(a, b)) {
        const x = left + (t - a) / (b - a) * w;
        text += `<path class="grid" d="M${x} ${top}v${h}"/><text x="${x}" y="${top + h + 17}" text-anchor="middle">${+t.toPrecision(8)}</text>`;
      }
      for (const t of ticks(c, d)) {
        const y = top + (d - t) / (d - c) * h;
        text += `<path class="grid" d="M${left} ${y}h${w}"/><text x="${left - 6}" y="${y + 4}" text-anchor="end">${+t.toPrecision(8)}</text>`;
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
    if (px < view[0] || py < view[1] || px > view[0] + view[2] || py > view[1] + view[3] || (next > 1 && s === 1)) return;
    event.preventDefault();
    const r = Math.min(1, next) / s;
    move(px - (px - view[0]) * r, py - (py - view[1]) * r, s * r);
  }, {passive: false});
  plot.addEventListener('pointerdown', event => { dragged = at(event); });
  addEventListener('pointerup', () => { dragged = null; });
  figure.addEventListener('dblclick', () => move(0, 0, 1));
  figure.addEventListener('pointerleave', () => { ring.setAttribute('visibility', 'hidden'); readout.textContent = ''; });
  figure.addEventListener('pointermove', event => {
    const [px, py] = at(event);
    if (dragged && view[2] < w) {
      move(view[0] + dragged[0] - px, view[1] + dragged[1] - py, view[2] / w);
      return;
    }
    let best = null, least = (view[2] / 12) ** 2;
    for (const point of points) {
      const d = (point[0] - px) ** 2 + (point[1] - py) ** 2;
      if (d <= least) { least = d; best = point; }
    }
    ring.setAttribute('visibility', best ? 'visible' : 'hidden');
    const [vx, vy] = best ? best[3] || value(best[0], best[1]) : value(px, py);
    if (best) { ring.setAttribute('cx', best[0]); ring.setAttribute('cy', best[1]); }
    readout.textContent = (best && best[2] ? best[2] + ': ' : '') + +vx.toPrecision(5) + ', ' + +vy.toPrecision(5);
  });
  show();
}
)js";

std::string figures(const std::vector<Figure>& list) {
  std::string text = "<div class=\"figures\">\n";
  for (const Figure& figure : list) {
    text += "<figure>\n" + svg(figure, Frame::in_page) +
            "<div class=\"readout\" aria-hidden=\"true\"></div>\n</figure>\n";
  }
  return text + "</div>\n";
}

std::string table(const HtmlTable& table) {
  std::string text = format("<h2>{}</h2>\n<div class=\"wide\"><table>\n", escaped(table.heading));
  bool head = true;
  for (const auto& row : table.rows) {
    text += "<tr>";
    for (const std::string& cell : row) {
      const std::string_view tag = head ? "th" : "td";
      text += format("<{0}>{1}</{0}>", tag, escaped(cell));
    }
    text += "</tr>\n";
    head = false;
  }
  return text + "</table></div>\n";
}

}  // namespace

std::string html(const HtmlPage& page) {
  std::string text = format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>{}</title>\n<style>{}{}@media screen and (prefers-color-scheme: dark){{{}{}}}\n"
      "@media print{{{}}}</style>\n</head>\n<body>\n<h1>{}</h1>\n<p>{}</p>\n",
      escaped(page.title), page_style, figure_style(), dark_page_style, dark_figure_style(),
      print_style, escaped(page.title), escaped(page.verdict));
  text += figures(page.figures);
  for (const HtmlTable& now : page.tables) {
    text += table(now);
  }
  text += format("<h2>Report</h2>\n<pre>{}</pre>\n", escaped(page.report));
  text += format(
      "<h2>Input</h2>\n<p>As <code>scene.json</code>; <code>stillpoint {} scene.json --html "
      "page.html</code> gives this page again.</p>\n<pre>{}</pre>\n",
      escaped(page.command), escaped(page.scene));
  text += format("<footer>{}</footer>\n<script>//<![CDATA[{}//]]></script>\n</body>\n</html>\n",
                 escaped(version_line()), script);
  return text;
}

}  // namespace stillpoint::cli
