// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/figures/figure.hpp>

namespace stillpoint::figures {

/// A page of figures, as data.
struct HtmlPage {
  std::string title;
  std::string verdict;   ///< the answer, below the title
  bool alarming{false};  ///< of the verdict
  std::string answer{};  ///< HTML above the figures
  std::vector<Figure> figures;
  std::string body;    ///< HTML below them; its tables may have the class rows or columns, its text
                       ///< key, good, bad, faint
  std::string report;  ///< plain text, folded away below the body
  std::string footer;  ///< which program wrote it
};

/// One self-contained file.
[[nodiscard]] std::string html(const HtmlPage& page);

/// The style of a sheet to be printed, for what is inside an element of the class "sheet", and the
/// file of one.
[[nodiscard]] std::string_view sheet_style() noexcept;
[[nodiscard]] std::string sheet_html(std::string_view title, std::string_view body);

}  // namespace stillpoint::figures
