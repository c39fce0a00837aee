// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/report/document.hpp>
#include <stillpoint/sweep/checkpoint.hpp>
#include <stillpoint/sweep/run.hpp>

#include <nlohmann/json.hpp>

#include <optional>

namespace stillpoint::report {

/// What a sweep without rows found. Nothing in it depends on how it was computed.
struct ReductionReport {
  sweep::Checkpoint found;
  std::optional<sweep::SweepPart> part{};  ///< of a sweep in parts
};

[[nodiscard]] ReductionReport reduction_report(const sweep::SweepSpec& spec,
                                               const sweep::SweepSummary& summary);

[[nodiscard]] Document document(const ReductionReport& report);
[[nodiscard]] nlohmann::ordered_json json(const ReductionReport& report);

}  // namespace stillpoint::report
