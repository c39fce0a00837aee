// SPDX-License-Identifier: MIT
#pragma once

// The parts of the document of a design under records.

#include "sections.hpp"

#include <stillpoint/core/simulation.hpp>
#include <stillpoint/design/record_design.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace stillpoint::report {

struct RealNotchFault;
struct RecordDesignReport;

/// "the record", "every record", "1 of 2 records"
[[nodiscard]] std::string of_records(std::size_t count, std::size_t all);

[[nodiscard]] std::string figure_shown(const Physical& physical, design::SuiteObjective which,
                                       double value);

/// Both, in enough digits to be told apart if the first is larger.
[[nodiscard]] std::pair<std::string, std::string> told_apart(const Physical& physical,
                                                             design::SuiteObjective which,
                                                             double one, double other);

/// A stroke or a residual; "less than 0.001 mm" of what nobody can measure.
[[nodiscard]] std::string displacement_shown(const Physical& physical, double length,
                                             std::optional<int> digits = {});

/// What to build and what it does, or what is in the way.
[[nodiscard]] std::string record_verdict(const RecordDesignReport& report);

[[nodiscard]] std::optional<RealNotchFault> real_notch_fault(const design::RecordDesign& result,
                                                             const Physical& physical);
/// The largest change of velocity at a notch without a width, and under which record; none of a
/// mass that hardly moves.
struct VelocityJump {
  double speed{0};
  std::size_t record{0};
};
[[nodiscard]] VelocityJump largest_jump(const design::RecordDesign& result);
/// The impulses of a notch without a width; and if it is the paper's, what the mass feels in one
/// with a width, and how wide that must be.
void add_notch(Section& answer, const RecordDesignReport& report);

/// The motion of the design under one of its records.
[[nodiscard]] SimulationRequest motion_request(const design::RecordDesign& result,
                                               std::size_t record);

/// What holds the mass, and which records end with it held or moving.
void add_rest(Section& answer, const design::RecordDesign& result);
/// The figures under the worst record of a mean, which may be far beyond the limits.
void add_worst_of_mean(Section& answer, const design::RecordDesign& result,
                       const Physical& physical);
void add_records(Document& document, const design::RecordDesign& result, const Physical& physical);
/// "locked in the notch to the end of every record; ..."; empty if no record locks the mass.
[[nodiscard]] std::string lock_words(const design::RecordDesign& result);

/// Whether its figures are means of several records.
[[nodiscard]] bool is_mean(const design::RecordDesignRequest& task);

/// "0.0049 %"
[[nodiscard]] std::string change_words(double change);
/// "f and delta", or the one that can be off: a zero stays zero.
[[nodiscard]] std::string_view inexact_parts(const design::RecordDesign& result);
/// "7 of 64 samples fail"
[[nodiscard]] std::string samples_words(const design::Sensitivity& near);
/// Within the tolerance, more than a quarter of the dampers fail, or one is much worse.
[[nodiscard]] bool is_delicate(const design::RecordDesign& result);
/// Of the motion that came closest to another outcome.
void add_decision_margin(Section& section, const design::RecordDesign& result);
/// The worst of the samples, and the nearest damper that is much worse.
void add_tolerance(Section& answer, const design::RecordDesign& result, const Physical& physical);

/// Of a design: as many as it was rounded to, or almost every digit that it has.
inline constexpr int printed_digits = 12;
/// In which a period is printed; the usual ones unless it was searched.
[[nodiscard]] std::optional<int> period_digits(const design::RecordDesignRequest& task);

/// "0.199 g, stroke 307 mm, residual 35.7 mm"
[[nodiscard]] std::string worst_words(const design::RecordDesign& result,
                                      const design::SuiteFigures& worst, const Physical& physical);

/// Whether its stroke pulls the mass back with less than a thousandth of the load.
[[nodiscard]] bool hardly_moves(double p, double peak, double load);
[[nodiscard]] bool hardly_moves(const design::RecordDesign& result);

}  // namespace stillpoint::report
