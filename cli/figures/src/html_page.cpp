// SPDX-License-Identifier: MIT
#include <stillpoint/figures/html_page.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

namespace stillpoint::figures {

namespace {

/// The first figures stand in pairs. What follows flows through two columns, so that a last odd
/// figure has tables beside it; a wide table goes across both.
constexpr std::string_view page_style = R"(
:root{color-scheme:light dark}
body{font:15px/1.45 "DejaVu Sans",Arial,sans-serif;margin:0 auto;max-width:1180px;padding:16px;color:#222;background:#fff}
h1{font-size:22px;margin:4px 0;overflow-wrap:anywhere}h2{font-size:17px;margin:0 0 6px;break-after:avoid}section{padding-top:20px}
.answer{font-size:17px;overflow-wrap:anywhere}
main{columns:2 530px;column-gap:20px;margin-top:14px}
.figures{column-span:all;display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,440px),1fr));gap:20px;margin-bottom:20px}
.across,details,footer{column-span:all}
figure{margin:0;max-width:580px}figure,section,tr{break-inside:avoid}.across{break-inside:auto}
figcaption{font-size:14px;margin:2px 8px 0 14px}
.figure{width:100%;height:auto;display:block}
.plot{cursor:crosshair}
.readout{min-height:1.5em;font-size:13px;padding-left:14%}
.readout button{font:inherit;margin-left:8px}
.wide{overflow-x:auto}
tr.violated{background:#fbe3e1}
summary{cursor:pointer;font-weight:bold;margin-top:24px}figure+details{column-span:none}figure+details summary{margin:8px 14px}
table{border-collapse:collapse;font-size:14px}td,th{padding:3px 10px;border-bottom:1px solid #ccc;text-align:left}
td{font-variant-numeric:tabular-nums}.rows th{font-weight:normal;color:#666;white-space:nowrap}.columns td{padding:3px 8px}.columns td:first-child{white-space:nowrap}
.number{white-space:nowrap}.key{font-weight:bold}.good{color:#00704f}.bad{color:#b3261e;font-weight:bold}.faint{color:#666}
pre{overflow-x:auto;font:13px/1.4 "DejaVu Sans Mono",monospace;background:#f4f4f4;padding:10px}.input pre{white-space:pre-wrap;overflow-wrap:anywhere}
footer{margin-top:24px;font-size:13px;color:#666}
@media screen and (max-width:520px){body{padding:8px}.rows th{white-space:normal}td,th,.columns td{padding:3px 8px 3px 0}details pre{white-space:pre-wrap;overflow-wrap:anywhere}.rows td,.across td{overflow-wrap:anywhere}.columns{font-size:11px}.columns th,.columns td{padding-right:5px}
.across .columns{font-size:14px}.across .columns,.across .columns tr,.across tbody{display:block}.across tr{border-bottom:1px solid #999;padding:4px 0}.across thead{display:none}.across .columns td{display:inline-block;border:0;margin-right:10px}.across td[data-head]::before{content:attr(data-head) " ";opacity:.8}.across td[data-unit]::after{content:" " attr(data-unit);opacity:.8}.across td:empty{display:none}}
)";

constexpr std::string_view dark_page_style = R"(
body{color:#ddd;background:#14181d}td,th{border-color:#444}.rows th,.faint{color:#aaa}.good{color:#4fd0a4}.bad{color:#ff8a80}pre{background:#1d232a}tr.violated{background:#45221f}footer{color:#aaa}
)";

/// Everything flows through the columns, the input as small print at the end. Letters are as large
/// as those of the figures: 10 pixels are 7.5 points.
constexpr std::string_view print_style = R"(
@page{margin:7mm 10mm}
body{max-width:none;padding:0;font-size:10px;line-height:1.15}h1{font-size:16px;margin:0}h2{font-size:13px;margin:0 0 1px}section{padding-top:4px}.answer{font-size:13px;margin:2px 0}table{font-size:11px}
main{columns:2;column-gap:6mm;column-fill:auto;margin:0}.figures{display:block;margin:0}.figures,footer{column-span:none}figure{max-width:none;margin-top:6px}figcaption,main table{font-size:10px}.readout,details:not([open]){display:none}
section:has(tr:nth-child(13)){break-inside:auto}tr:nth-child(-n+4){break-after:avoid}
p{margin:2px 0}p,footer,tr:nth-last-child(-n+5){break-before:avoid}.wide{overflow:visible}td,th{padding:0 5px}.columns td,.columns th{padding:0 3px}.rows td,code{overflow-wrap:anywhere}
.only,.input{column-span:all}.only{width:125mm}.input p{display:none}.input h2,.input pre{display:inline;font-size:10px;line-height:1.1}pre{background:none;padding:0 4px;font-size:10px}.input pre{white-space:normal}footer{margin-top:4px;font-size:10px}
)";

/// The page loads nothing, whatever text is in it: its script and style are its own, and the images
/// of its maps are data.
constexpr std::string_view security_policy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:; "
    "base-uri 'none'; form-action 'none'";

/// One figure, and those that belong below it, with plots that begin at the same place.
std::string column(std::span<const Figure> group, bool only) {
  double left = 0;
  for (const Figure& figure : group) {
    left = std::max(left, plot_left(figure));
  }
  std::string text = only ? "<figure class=\"only\">\n" : "<figure>\n";
  std::string caption;
  for (const Figure& figure : group) {
    text += "<div>" + svg(figure, Frame::in_page, left) +
            "<div class=\"readout\" aria-hidden=\"true\"></div></div>\n";
    const std::string own = prose(figure.caption());
    caption += (caption.empty() || own.empty() ? "" : " ") + own;
  }
  return text + (caption.empty() ? "" : "<figcaption>" + caption + "</figcaption>\n") +
         "</figure>\n";
}

/// In one place with the figure above them.
std::string with_folded(const std::string& above, std::span<const Figure> folded) {
  std::string text = "<div>\n" + above;
  for (const Figure& figure : folded) {
    text += fmt::format("<details><summary>{}</summary>\n{}</details>\n", prose(figure.folded),
                        column({&figure, 1}, false));
  }
  return text + "</div>\n";
}

/// How many figures at the beginning of a list belong together.
template <class Belongs>
std::size_t leading(std::span<const Figure> list, const Belongs& belongs) {
  return static_cast<std::size_t>(std::find_if_not(list.begin(), list.end(), belongs) -
                                  list.begin());
}

/// Pairs, and after them what is left of an odd number.
std::string figures(std::span<const Figure> list) {
  std::vector<std::string> columns;
  while (!list.empty()) {
    const auto is_below = [](const Figure& figure) { return figure.below; };
    const auto is_folded = [](const Figure& figure) { return !figure.folded.empty(); };
    const std::size_t shown = 1 + leading(list.subspan(1), is_below);
    const std::size_t folded = leading(list.subspan(shown), is_folded);
    const bool only = columns.empty() && shown + folded == list.size();
    const std::string text = column(list.first(shown), only);
    columns.push_back(folded == 0 ? text : with_folded(text, list.subspan(shown, folded)));
    list = list.subspan(shown + folded);
  }
  const std::size_t paired = columns.size() / 2 * 2;
  const auto odd = columns.begin() + static_cast<std::ptrdiff_t>(paired);
  return fmt::format("<div class=\"figures\">\n{}</div>\n{}", fmt::join(columns.begin(), odd, ""),
                     fmt::join(odd, columns.end(), ""));
}

}  // namespace

std::string html(const HtmlPage& page) {
  std::string text = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\"/>\n"
      "<title>{}</title>\n<style>{}{}@media screen and (prefers-color-scheme: dark){{{}{}}}\n"
      "@media print{{{}}}</style>\n</head>\n<body>\n<h1>{}</h1>\n<p class=\"answer{}\">{}</p>\n",
      security_policy, escaped(page.title), page_style, figure_style(), dark_page_style,
      dark_figure_style(), print_style, prose(page.title), page.alarming ? " bad" : "",
      prose(page.verdict));
  text += page.answer + "<main>\n" + figures(page.figures) + page.body;
  if (!page.report.empty()) {
    text += fmt::format(
        "<details><summary>The full report as text</summary>\n<pre>{}</pre></details>\n",
        escaped(page.report));
  }
  text += fmt::format(
      "<footer>{}</footer>\n</main>\n<script>//<![CDATA[{}//]]></script>\n</body>\n</html>\n",
      escaped(page.footer), html_script());
  return text;
}

}  // namespace stillpoint::figures
