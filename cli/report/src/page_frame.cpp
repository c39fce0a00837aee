// SPDX-License-Identifier: MIT
#include <stillpoint/report/page_frame.hpp>

#include <stillpoint/design/search.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/report/record_design.hpp>
#include <stillpoint/texts/embedded.hpp>

#include <fmt/format.h>

namespace stillpoint::report {

std::string program_version() {
  return STILLPOINT_VERSION;
}

std::string version_line() {
  return fmt::format("stillpoint {} (NLopt {}, {} build, {})", program_version(),
                     design::nlopt_version(), STILLPOINT_BUILD_TYPE, STILLPOINT_COMPILER);
}

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

std::vector<std::string> figure_ids(std::string_view command) {
  const bool of_dampers = command == "design" || command == "region";
  command = of_dampers ? "design" : command;
  const auto words = records::words_of(texts::line_of("words/figures.txt", command), " ");
  std::vector<std::string> ids(words.begin(), words.end());
  for (int record = 1; of_dampers && record <= most_drawn_records; ++record) {
    ids.push_back(fmt::format("record-{}", record));
    ids.push_back(ids.back() + "-load");
  }
  return ids;
}

}  // namespace stillpoint::report
