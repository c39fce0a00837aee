// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/report/document.hpp>
#include <stillpoint/sweep/part_label.hpp>
#include <stillpoint/sweep/reduction.hpp>
#include <stillpoint/sweep/run.hpp>

#include <nlohmann/json.hpp>

namespace stillpoint::report {

/// What a sweep without rows found. Nothing in it depends on how it was computed, so the reports of
/// the parts suffice to make that of the whole, to the last byte.
// Moving JSON throws nothing. NOLINTNEXTLINE(bugprone-exception-escape)
struct ReductionReport {
  sweep::PartLabel label;
  sweep::SweepKind kind{};
  sweep::SweepState state;       ///< rows, outcomes, locked motions, feasible designs
  nlohmann::ordered_json found;  ///< all that the report says, but for the digest of a part
};

[[nodiscard]] ReductionReport reduction_report(const sweep::SweepSpec& spec,
                                               const sweep::SweepSummary& summary,
                                               const sweep::Reduction& reduction);

[[nodiscard]] Document document(const ReductionReport& report);
[[nodiscard]] nlohmann::ordered_json json(const ReductionReport& report);

/// Whether the file begins as a JSON report does.
[[nodiscard]] bool is_reduction(const std::string& path);

/// Reads the JSON report of a part. Throws records::FileError if it is not complete.
[[nodiscard]] ReductionReport read_reduction(const std::string& path);

/// The report of the part to compute, if its file is there already and the sweep is to be resumed.
/// Throws InputError if only a part can be resumed, and FileError for another part of the same
/// sweep.
[[nodiscard]] std::optional<ReductionReport> find_reduction(const sweep::SweepSpec& spec);

/// The JSON of the whole sweep, from that of all its parts. Throws as sweep::merge does.
[[nodiscard]] nlohmann::ordered_json merged(const std::vector<std::string>& parts);

}  // namespace stillpoint::report
