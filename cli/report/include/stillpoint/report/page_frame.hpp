// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/figures/html_page.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::report {

[[nodiscard]] std::string program_version();  ///< "0.1.0"
[[nodiscard]] std::string version_line();     ///< program, NLopt, build type, compiler

/// What a page has besides the answer.
struct PageFrame {
  std::string title;         ///< the user's own, may be empty
  std::string_view command;  ///< that made it
  std::string scene;         ///< its input, from which the page can be made again
};

/// Adds the frame and the version of the program.
void add_frame(figures::HtmlPage& page, const PageFrame& frame);

/// The ids of the figures that the page of a command may have.
[[nodiscard]] std::vector<std::string> figure_ids(std::string_view command);

}  // namespace stillpoint::report
