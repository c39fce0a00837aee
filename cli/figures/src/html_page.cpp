// SPDX-License-Identifier: MIT
#include "page_files.hpp"

#include <stillpoint/figures/html_page.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

namespace stillpoint::figures {

namespace {

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

/// Pairs, and after them what is left of an odd number.
std::string figures(std::span<const Figure> list) {
  const auto end_of = [list](std::size_t from, const auto& belongs) {
    while (from < list.size() && belongs(list[from])) {
      ++from;
    }
    return from;
  };
  std::vector<std::string> columns;
  for (std::size_t first = 0, next = 0; first < list.size(); first = next) {
    const std::size_t shown = end_of(first + 1, [](const Figure& now) { return now.below; });
    next = end_of(shown, [](const Figure& now) { return !now.folded.empty(); });
    const bool only = first == 0 && next == list.size();
    const std::string text = column(list.subspan(first, shown - first), only);
    columns.push_back(shown == next ? text : with_folded(text, list.subspan(shown, next - shown)));
  }
  const std::size_t paired = columns.size() / 2 * 2;
  const auto odd = columns.begin() + static_cast<std::ptrdiff_t>(paired);
  return fmt::format("<div class=\"figures\">\n{}</div>\n{}", fmt::join(columns.begin(), odd, ""),
                     fmt::join(odd, columns.end(), ""));
}

std::string file_begin(std::string_view title, std::string_view style) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\"/>\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n",
      security_policy, escaped(title), style);
}

}  // namespace

std::string html(const HtmlPage& page) {
  std::string text =
      file_begin(
          page.title,
          fmt::format("{}{}@media screen and (prefers-color-scheme: dark){{{}{}}}"
                      "\n@media print{{{}}}",
                      page_css, figure_style(), page_dark_css, dark_figure_style(), print_css)) +
      fmt::format("<body>\n<h1>{}</h1>\n<p class=\"answer{}\">{}</p>\n", prose(page.title),
                  page.alarming ? " bad" : "", prose(page.verdict));
  text += page.answer + "<main>\n" + figures(page.figures) + page.body;
  if (!page.report.empty()) {
    text += fmt::format(
        "<details><summary>The full report as text</summary>\n<pre>{}</pre></details>\n",
        escaped(page.report));
  }
  text += fmt::format(
      "<footer>{}</footer>\n</main>\n<script>//<![CDATA[{}//]]></script>\n</body>\n</html>\n",
      escaped(page.footer), figures_js);
  return text;
}

std::string_view sheet_style() noexcept {
  return sheet_css;
}

std::string sheet_html(std::string_view title, std::string_view body) {
  return file_begin(title, fmt::format("{}{}@media screen and (prefers-color-scheme: dark){{{}}}",
                                       figure_style(), sheet_style(), dark_figure_style())) +
         fmt::format("<body class=\"sheet\">\n{}</body>\n</html>\n", body);
}

}  // namespace stillpoint::figures
