// SPDX-License-Identifier: MIT
#include <stillpoint/report/page_frame.hpp>

#include <stillpoint/records/text.hpp>
#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/report.hpp>
#include <stillpoint/report/spectrum.hpp>
#include <stillpoint/report/version.hpp>

#include <fmt/format.h>

#include <vector>

namespace stillpoint::report {

void add_frame(figures::HtmlPage& page, const PageFrame& frame) {
  constexpr std::size_t longest_title = 400;
  if (!frame.title.empty()) {
    const std::string title = ": " + records::printable(frame.title, longest_title);
    page.report.insert(page.title.size(), title);  // its first line is the title as well
    page.title += title;
  }
  page.body += fmt::format(
      "<section class=\"input\"><h2>Input</h2>\n<p>Save this as <code>scene.json</code> in the "
      "folder where this page was made; then <code>stillpoint {} "
      "scene.json{} <span class=\"number\">--html</span> page.html</code> makes it "
      "again.</p>\n<pre>{}</pre></section>\n",
      frame.command, frame.command == "sweep" ? " --output rows.csv" : "",
      figures::escaped(frame.scene));
  page.footer = version_line();
}

std::span<const std::string_view> all_design_figures() {
  static const std::vector<std::string_view> all = [] {
    std::vector<std::string_view> list(design_figures.begin(), design_figures.end());
    list.insert(list.end(), record_design_figures.begin(), record_design_figures.end());
    list.insert(list.end(), spectrum_figure_names.begin(), spectrum_figure_names.end());
    return list;
  }();
  return all;
}

}  // namespace stillpoint::report
