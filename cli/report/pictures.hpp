// SPDX-License-Identifier: MIT
#pragma once

#include "json_report.hpp"
#include "output.hpp"
#include "settings.hpp"
#include "sweep_report.hpp"

#include <stillpoint/figures/html_page.hpp>
#include <stillpoint/sweep/map.hpp>

#include <span>
#include <string>
#include <string_view>

namespace stillpoint::cli {

/// The figures that a command may draw; each is a file NAME.svg of --svg.
[[nodiscard]] std::span<const std::string_view> figure_names(Command command);

/// The file of a figure in the directory of --svg.
[[nodiscard]] std::string svg_path(const std::string& directory, std::string_view figure);

/// Whether --html or --svg asks for any.
[[nodiscard]] bool wants_pictures(const Settings& settings);

/// Makes the directory of --svg and asks whether --html can be written, so that a long run does not
/// end in vain. Throws UsageError.
void prepare_pictures(const Settings& settings);

[[nodiscard]] figures::HtmlPage design_page(const DesignInput& input,
                                            const design::DesignResult& result);
[[nodiscard]] figures::HtmlPage region_page(const RegionInput& input,
                                            const design::RegionAnswer& answer);
[[nodiscard]] figures::HtmlPage simulate_page(const SimulateInput& input, const Simulation& answer);

[[nodiscard]] figures::HtmlPage sweep_page(const sweep::SweepSpec& spec,
                                           const sweep::SweepSummary& summary,
                                           const sweep::SweepMap& map);

/// Writes the page, with the title and the input that `settings` have, and each figure alone, where
/// they are asked for. Throws UsageError.
void write_pictures(const Settings& settings, Command command, figures::HtmlPage page,
                    Output& output);

}  // namespace stillpoint::cli
