// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/figures/html_page.hpp>
#include <stillpoint/report/document.hpp>
#include <stillpoint/sweep/run.hpp>

#include <nlohmann/json.hpp>

#include <array>
#include <string_view>

namespace stillpoint::report {

/// `spec` and what came of it; of rows in a file.
[[nodiscard]] Document document(const sweep::SweepSpec& spec, const sweep::SweepSummary& summary);
[[nodiscard]] nlohmann::ordered_json json(const sweep::SweepSpec& spec,
                                          const sweep::SweepSummary& summary);

/// The map, and the document where the rows went to a file.
[[nodiscard]] figures::HtmlPage page(const sweep::SweepSpec& spec,
                                     const sweep::SweepSummary& summary,
                                     const sweep::SweepMap& map);

inline constexpr std::array<std::string_view, 1> sweep_figures{"map"};

}  // namespace stillpoint::report
