// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/figures/figure.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::figures {

struct HtmlTable {
  std::string heading;
  std::vector<std::vector<std::string>> rows;  ///< the first one heads the columns
};

/// A page of figures, as data.
struct HtmlPage {
  std::string title;
  std::string verdict;  ///< a sentence below the title
  std::vector<Figure> figures;
  std::vector<HtmlTable> tables;
  std::string report;   ///< the one for people; empty: there is none
  std::string command;  ///< "design"
  std::string scene;    ///< what gives this page again; empty: not said
  std::string footer;   ///< which program wrote it
};

/// One file that needs nothing else.
[[nodiscard]] std::string html(const HtmlPage& page);

/// What makes its figures answer the pointer.
[[nodiscard]] std::string_view html_script() noexcept;

}  // namespace stillpoint::figures
