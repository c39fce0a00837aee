// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/figures/figure.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::figures {

struct HtmlTable {
  std::string heading;
  std::vector<std::vector<std::string>> rows;  ///< the first has the headings of the columns
};

/// A page of figures, as data.
struct HtmlPage {
  std::string title;
  std::string verdict;  ///< a sentence below the title
  std::vector<Figure> figures;
  std::vector<HtmlTable> tables;
  std::string report;   ///< plain text; empty: there is none
  std::string command;  ///< "design"
  std::string scene;    ///< the input that makes this page again; empty: not shown
  std::string footer;   ///< which program wrote it
};

/// One file that needs no other.
[[nodiscard]] std::string html(const HtmlPage& page);

/// The script that shows values under the pointer and zooms.
[[nodiscard]] std::string_view html_script() noexcept;

}  // namespace stillpoint::figures
