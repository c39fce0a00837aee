// SPDX-License-Identifier: MIT
#pragma once

// The sections that several documents share. The headers that this one brings are not listed again
// in this folder.

#include "format.hpp"
#include "units.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/design/motion_findings.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/record_design_result.hpp>
#include <stillpoint/design/shown_damper.hpp>
#include <stillpoint/design/suite_task.hpp>
#include <stillpoint/report/digits.hpp>
#include <stillpoint/report/report.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace stillpoint::report {

/// What a damper is asked for, and the units to say so in.
struct ShownTask {
  const design::Problem& problem;
  const design::Limits& limits;
  const std::optional<design::Pulse>& pulse;
  const design::PulseRanges& ranges;
  const Physical& physical;
};
[[nodiscard]] inline ShownTask task_of(const DesignReport& report) {
  const design::DesignRequest& request = report.result.request;
  return {request.problem, request.limits, request.pulse, request.pulse_ranges, report.physical};
}
[[nodiscard]] inline ShownTask task_of(const RegionReport& report) {
  const design::RegionRequest& request = report.request;
  return {request.problem, request.limits, request.pulse, request.pulse_ranges, report.physical};
}
/// " (230 kN of friction)"; "" without a mass.
[[nodiscard]] std::string force_beside(const Physical& physical, double f);
/// "a friction force of 283.81 kN and a notch that takes 69.423 kJ at a passage" if the mass is
/// known, else "f = 0.26 and delta = 0.37", with the digits that f has unless others are asked for,
/// and how the notch differs from the paper's; as little friction as possible without an `f`.
[[nodiscard]] std::string damper_words(const Physical& physical, const std::optional<double>& f,
                                       double delta, const design::NotchShape& shape = {},
                                       std::optional<int> digits = {});
/// "a period of 2.8 s", or "p = 1".
[[nodiscard]] std::string period_words(const Physical& physical, double p,
                                       std::optional<int> digits = {});
/// The same with the stiffness, if the mass is known.
[[nodiscard]] std::string spring_words(const Physical& physical, double p,
                                       std::optional<int> digits = {});
inline constexpr int digits_of_region = 6;
/// "up to 0.0043 or 0.0106 to 0.0236"
[[nodiscard]] std::string feasible_words(std::span<const Interval> f);
/// "2.1 mm to 8.2 mm or at least 9 mm"; of many the largest.
[[nodiscard]] std::string delta_words(std::span<const Interval> all, const Physical& physical);
/// "0.340 to 0.429", "up to 0.463", "at least 0.5" or "any size".
[[nodiscard]] std::string interval_text(const design::ServedInterval& interval);
/// "peak 137.37 mm, at rest after 1.5287 s, 0.09465 g transmitted outside the notch"
[[nodiscard]] std::string does_words(const design::ShownDamper& shown, const Physical& physical);
/// Peak, rest and acceleration, and how wide its notch must be so that a pulse moves the mass.
void add_motion(Section& answer, const design::ShownDamper& shown, const Physical& physical);
/// "a hit of 0.44 m/s and a period of 2.94 s", "k = 0.5 g and p = 1": which motion of a task with
/// ranges is shown; empty without.
[[nodiscard]] std::string shown_motion(const design::ShownDamper& shown, const Physical& physical);
/// What a notch as built is compared with: "has no width", "holds any load", "acts only after the
/// start".
[[nodiscard]] std::string_view ideal_words(const design::ShownDamper& shown);

/// "2 x a.AT2": the factor and the file of a record of a suite.
[[nodiscard]] std::string scaled_name(std::string_view file, double scale);
/// "0.31 %", "42 %"
[[nodiscard]] std::string part_words(double part);
/// "2 x a.AT2, in g (assumed), peak 0.3 g".
[[nodiscard]] std::string record_words(std::string_view file, double scale, std::string_view units,
                                       bool assumed, double peak);
/// " between the velocity jumps at the notch", of an acceleration that does not count them; empty
/// of a notch with a width, and without a notch.
[[nodiscard]] std::string_view jumps_words(double delta, const std::optional<double>& width);
inline constexpr int usual_digits = 4;
/// "34.18 %", which the damper withstands.
[[nodiscard]] std::string percent_digits(double tolerance, int shown = usual_digits);
/// Whether more than rounding is left.
[[nodiscard]] bool leaves_any(double tolerance);
/// "f +-8.63 %, delta -10 to +20 %" of a box; "f exact" of what may not be off.
[[nodiscard]] std::string sides_text(const design::BoxShape& shape, double tolerance, int shown,
                                     std::string_view delta = "delta",
                                     std::string_view sign = "+-");
/// "34.18 %", or the sides of a box of another shape.
[[nodiscard]] std::string tolerance_text(const design::Limits& limits, double tolerance,
                                         int shown = usual_digits);
/// In a table: "+-34.18 %", or that of f and that of delta.
[[nodiscard]] std::string tolerance_cell(const design::Limits& limits,
                                         const std::optional<double>& tolerance);
/// "f and delta may both be off by +-34.18 %", likewise; without a notch f alone.
[[nodiscard]] std::string tolerance_words(const design::Limits& limits, double tolerance,
                                          double delta);

/// Between which forces and energies of a passage it may be built, if the mass is known.
void add_buildable(Section& answer, const Physical& physical, const Interval& f,
                   const Interval& delta);
/// The same of its tolerance, or of the one that was asked for.
void add_buildable(Section& answer, const Physical& physical, const design::DesignPoint& damper,
                   const design::Limits& limits);

/// The hits or pulses, and the periods, for which it works, if known.
void add_works_for(Section& section, const std::optional<design::WorksFor>& served,
                   const Physical& physical);
/// Why there is no admissible design, and one way out.
[[nodiscard]] std::string none_admissible(const design::RegionVerdict& empty,
                                          const ShownTask& task);
/// " One way out: a max displacement of at least 168.8 mm." Of several mends the first of what a
/// designer can choose: nobody chooses the hit, and the period only by another isolator.
[[nodiscard]] std::string one_way_out(std::span<const design::Mend> mends, const Physical& physical,
                                      const design::Limits& limits = {},
                                      const std::optional<design::Pulse>& pulse = {});
/// What would make it feasible.
Section& add_mends(Document& document, std::span<const design::Mend> mends,
                   const Physical& physical, const design::Limits& limits = {},
                   const std::optional<design::Pulse>& pulse = {});
void add_mends(Document& document, const design::RegionVerdict& empty, const ShownTask& task);
/// A name of the interface as people read it: "dead zone", "largest f".
[[nodiscard]] std::string in_words(std::string_view name);
/// How independent methods agree: "2 independent methods agree to within 1.3e-12".
void add_check(Section& answer, const design::CrossCheck& check);

/// What is known of the dampers of a box: proved of all, or tried of some.
[[nodiscard]] std::string box_words(const design::SuiteBox& box, bool holds);
/// Of one that is damped, by up to `most_zeta` where that varies, or holds more at rest.
void add_damping(Section& answer, const Oscillator& oscillator, double most_zeta = 0);
/// How wide a notch must be for the load to move the mass, unless none is.
void add_start(Section& answer, double least_width, const Response& response,
               const Physical& physical);
/// Whether Delta is compared with Delta1 of the first arrival: not for a damper that stops at a
/// later one, nor if a rest off centre is allowed.
[[nodiscard]] bool stops_by_delta1(std::span<const design::Constraint> constraints);
/// Else whether it stops there does not matter.
[[nodiscard]] bool returns(std::span<const design::Constraint> constraints);
/// "delta <= 8.1577 mm", rounded so that what is as printed meets it.
[[nodiscard]] std::string requirement(const design::Constraint& now, const FigureUnits& units);
/// "needs delta <= 8.1577 mm"
[[nodiscard]] std::string need(const design::Constraint& now, const FigureUnits& units);
/// Each with its slack: by how much a damper meets or misses it.
void add_constraints(Document& document, std::span<const design::Constraint> constraints,
                     const Physical& physical, std::string_view of_what = {});
/// What those under a pulse are of; empty after a hit.
[[nodiscard]] inline std::string_view of_first_swing(const ShownTask& task) {
  return task.pulse ? "Each refers to the motion up to the first return, outside the notch." : "";
}

using design::moves;  // not if friction or the notch holds the mass from the start
/// "stops at x = 0" and so on.
[[nodiscard]] std::string outcome_phrase(Outcome outcome);
/// A motion that is still running may be at rest.
[[nodiscard]] std::string outcome_phrase(const ForcedResponse& response);

/// "tolerance 1e-09"; "" if it has none.
[[nodiscard]] std::string setting(const peers::MethodRow& now);
/// Why simulate uses its method.
[[nodiscard]] std::string_view reason(const SimulationRequest& request);

}  // namespace stillpoint::report
