// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"
#include "output.hpp"

#include <stillpoint/figures/html_page.hpp>

#include <span>
#include <string>
#include <string_view>

namespace stillpoint::cli {

/// The figures that a command may draw; each is a file NAME.svg of --svg.
[[nodiscard]] std::span<const std::string_view> figure_names(Command command);

/// The file of a figure in the directory of --svg.
[[nodiscard]] std::string svg_path(const std::string& directory, std::string_view figure);

/// Whether --html or --svg asks for a page or its figures.
[[nodiscard]] bool wants_page(const Settings& settings);

/// Makes the directory of --svg and checks that --html can be written, so that no long run is in
/// vain. Throws UsageError.
void prepare_page(const Settings& settings);

/// Writes the page, with the title and the input that `settings` have, and each figure alone, where
/// they are asked for. Throws UsageError.
void write_page(const Settings& settings, Command command, figures::HtmlPage page, Output& output);

}  // namespace stillpoint::cli
