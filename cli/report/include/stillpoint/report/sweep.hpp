// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/figures/figure.hpp>
#include <stillpoint/report/document.hpp>
#include <stillpoint/sweep/map.hpp>
#include <stillpoint/sweep/run.hpp>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>

namespace stillpoint::report {

/// `spec` and its outcome, for rows in a file.
struct SweepReport {
  sweep::SweepSpec spec;
  sweep::SweepSummary summary{};
  std::optional<sweep::SweepMap> map{};
  std::optional<std::string> record{};  ///< the file of the excitation
};

[[nodiscard]] Document document(const SweepReport& report);
[[nodiscard]] nlohmann::ordered_json json(const SweepReport& report);
/// The map if there is one.
[[nodiscard]] std::vector<figures::Figure> drawings(const SweepReport& report);

/// "4.2e+06 of 1e+08 rows, 4 %, 1.9e+06 rows/s", after `seconds` of a run that began with
/// `begun_with` rows.
[[nodiscard]] std::string progress_words(double rows, std::int64_t begun_with,
                                         const std::optional<std::int64_t>& total, double seconds);

}  // namespace stillpoint::report
