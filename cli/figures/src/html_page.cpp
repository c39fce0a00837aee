// SPDX-License-Identifier: MIT
#include <stillpoint/figures/html_page.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>

namespace stillpoint::figures {

namespace {

constexpr std::string_view page_style = R"(
:root{color-scheme:light dark}
body{font:15px/1.45 "DejaVu Sans",Arial,sans-serif;margin:0 auto;max-width:1180px;padding:16px;color:#222;background:#fff}
h1{font-size:22px;margin:4px 0;overflow-wrap:anywhere}h2{font-size:17px;margin:24px 0 6px;break-after:avoid}
.answer{font-size:17px;overflow-wrap:anywhere}
.figures{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,440px),1fr));gap:20px;margin-top:14px}
.figures figure{margin:0;break-inside:avoid;max-width:560px}
figcaption{font-size:14px;margin:2px 8px 0 14px}
.figure{width:100%;height:auto;display:block}
.plot{cursor:crosshair}
.readout{min-height:1.5em;font-size:13px;padding-left:14%}
.readout button{font:inherit;margin-left:8px}
tr{break-inside:avoid}
.wide{overflow-x:auto;break-inside:avoid}
tr.violated{background:#fbe3e1}
summary{cursor:pointer;font-weight:bold;margin-top:24px}
@media screen and (max-width:520px){body{padding:8px}pre{white-space:pre-wrap;overflow-wrap:anywhere}details pre{white-space:pre}.rows td{min-width:0}td,th{padding:3px 4px 3px 0;overflow-wrap:anywhere}.columns,.columns tr,.columns tbody{display:block}.columns tr{border-bottom:1px solid #999;padding:4px 0}.columns th{display:none}.columns td{display:inline-block;border:0;margin-right:10px;white-space:normal}.columns td[data-head]::before{content:attr(data-head) " ";opacity:.8}.columns td:empty{display:none}}
table{border-collapse:collapse;font-size:14px}td,th{padding:3px 10px;border-bottom:1px solid #ccc;text-align:left;white-space:nowrap}
td{font-variant-numeric:tabular-nums}.rows th{font-weight:normal;color:#666}.rows td{white-space:normal;min-width:12em}
.number{white-space:nowrap}.key{font-weight:bold}.good{color:#00704f}.bad{color:#b3261e;font-weight:bold}.faint{color:#666}
pre{overflow-x:auto;font:13px/1.4 "DejaVu Sans Mono",monospace;background:#f4f4f4;padding:10px}
footer{margin-top:24px;font-size:13px;color:#666}
)";

constexpr std::string_view dark_page_style = R"(
body{color:#ddd;background:#14181d}td,th{border-color:#444}.rows th,.faint{color:#aaa}.good{color:#4fd0a4}.bad{color:#ff8a80}pre{background:#1d232a}tr.violated{background:#45221f}footer{color:#aaa}
)";

/// Short sections stand in pairs, and the input is a few lines of small print at the end, so that a
/// short page is one sheet and no section is alone on one: a wide table stays with what is before
/// it. Each pair is a line of text to the browser, which by default keeps two lines together.
constexpr std::string_view print_style = R"(
@page{margin:10mm 12mm}
body{max-width:none;padding:0;font-size:13px;line-height:1.2;orphans:1;widows:1}h1{font-size:19px}h2{font-size:15px;margin:6px 0 2px}.answer{font-size:15px;margin:4px 0}.figures{margin-top:4px;grid-template-columns:1fr 1fr;gap:2px 40px}figcaption{font-size:11px}.readout,details{display:none}
section:not(:has(tr:nth-child(17),td:nth-child(6))){display:inline-block;vertical-align:top;width:48%;margin-right:1.5%}section:has(td:nth-child(6)){break-before:avoid}section p{margin:6px 0;break-after:avoid}section code{font-size:11px;overflow-wrap:anywhere}
body section.input{display:block;width:auto;margin:10px 0 0;break-before:avoid;break-inside:avoid}.input p{display:none}.input h2,.input pre{display:inline;font-size:11px}
pre{white-space:normal;overflow-wrap:anywhere;overflow:visible;background:none;padding:0 4px}.wide~p{break-before:avoid;break-after:auto}footer{break-before:avoid;margin-top:12px}.wide{overflow:visible}td,.columns th{white-space:normal}td,th{padding:1px 5px}table{font-size:11px}.rows td{min-width:0;overflow-wrap:anywhere}
)";

/// One figure, and those that belong below it, with plots that begin at the same place.
std::string column(std::span<const Figure> group) {
  double left = 0;
  for (const Figure& figure : group) {
    left = std::max(left, plot_left(figure));
  }
  std::string text = "<figure>\n";
  std::string caption;
  for (const Figure& figure : group) {
    text += "<div>" + svg(figure, Frame::in_page, left) +
            "<div class=\"readout\" aria-hidden=\"true\"></div></div>\n";
    caption += (caption.empty() || figure.caption.empty() ? "" : " ") + prose(figure.caption);
  }
  return text + (caption.empty() ? "" : "<figcaption>" + caption + "</figcaption>\n") +
         "</figure>\n";
}

std::string figures(const std::vector<Figure>& list) {
  std::string text = "<div class=\"figures\">\n";
  for (auto first = list.begin(); first != list.end();) {
    const auto last = std::find_if(std::next(first), list.end(),
                                   [](const Figure& figure) { return !figure.below; });
    text += column({&*first, static_cast<std::size_t>(last - first)});
    first = last;
  }
  return text + "</div>\n";
}

}  // namespace

std::string html(const HtmlPage& page) {
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>{}</title>\n<style>{}{}@media screen and (prefers-color-scheme: dark){{{}{}}}\n"
      "@media print{{{}}}</style>\n</head>\n<body>\n<h1>{}</h1>\n<p class=\"answer{}\">{}</p>\n",
      escaped(page.title), page_style, figure_style(), dark_page_style, dark_figure_style(),
      print_style, prose(page.title), page.alarming ? " bad" : "", prose(page.verdict));
  text += page.answer + figures(page.figures) + page.body;
  if (!page.report.empty()) {
    text += fmt::format(
        "<details><summary>The full report as text</summary>\n<pre>{}</pre></details>\n",
        escaped(page.report));
  }
  text +=
      fmt::format("<footer>{}</footer>\n<script>//<![CDATA[{}//]]></script>\n</body>\n</html>\n",
                  escaped(page.footer), html_script());
  return text;
}

}  // namespace stillpoint::figures
