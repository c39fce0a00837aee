// SPDX-License-Identifier: MIT
// The headline of a design under records: what to build, what it does, and the worst of what can
// go wrong. The rest is in the rows below it.
#include "format.hpp"
#include "record_design_parts.hpp"
#include "sentence.hpp"

#include <stillpoint/report/record_design.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace stillpoint::report {

namespace {

using design::SuiteFigures;

/// Whether the acceleration promised is that of a mass that the notch holds.
bool is_of_a_lock(const design::RecordDesign& result) {
  const double promised = result.finding->point.figures.acceleration;
  return result.finding->point.figures.peak > 0 && !is_mean(result.request) &&
         std::ranges::any_of(result.finding->responses, [promised](const ForcedResponse& response) {
           return response.largest_load_while_locked == promised;
         });
}

/// Of which acceleration the figure is: " between the velocity jumps at the notch (up to 0.89
/// m/s)", which it does not count.
std::string which_acceleration(const RecordDesignReport& report) {
  const std::string_view locked = is_of_a_lock(report.result) ? " while it is locked" : "";
  const double jump = largest_jump(report.result).speed;
  return jump == 0 ? std::string(locked)
                   : format("{}{}{} (up to {})", locked, locked.empty() ? "" : " and",
                            jumps_words(report.result.finding->point.damper.delta, {}),
                            FigureUnits(report.physical).velocity_words(jump));
}

/// The figures of the records combined, those of a mean with the largest of any record.
std::string does_words(const RecordDesignReport& report) {
  const auto& [result, physical, fault] = report;
  const SuiteFigures& combined = result.finding->point.figures;
  const std::size_t count = result.request.records.size();
  std::optional<SuiteFigures> most;
  if (is_mean(result.request)) {
    most.emplace();
    for (const ForcedResponse& response : result.finding->responses) {
      const SuiteFigures figures = design::suite_figures(response);
      most->peak = std::max(most->peak, figures.peak);
      most->acceleration = std::max(most->acceleration, figures.acceleration);
      most->residual = std::max(most->residual, figures.residual);
    }
  }
  const auto shown = [&](double SuiteFigures::*figure, const auto& words) {
    return words(combined.*figure) + (most ? format(" ({})", words((*most).*figure)) : "");
  };
  const auto length = [&](double value) { return displacement_shown(physical, value); };
  return format("{}: {} transmitted{}{}",
                most ? format("Mean (and largest) of {} records", count)
                     : design::suite_words(*result.request.combine, count),
                shown(&SuiteFigures::acceleration, acceleration_shown), which_acceleration(report),
                combined.peak == 0
                    ? ""
                    : format(", stroke {}, residual {}", shown(&SuiteFigures::peak, length),
                             shown(&SuiteFigures::residual, length)));
}

/// Empty if the mass moves.
std::string stands_still(const design::RecordDesign& result) {
  const std::size_t all = result.finding->responses.size();
  return !hardly_moves(result) ? ""
         : result.finding->point.figures.peak > 0
             ? "The mass hardly moves. "
             : format("The mass never moves: it is held through {}. ", of_records(all, all));
}

/// " Locked in the notch to the end of the record; ..."; empty if it does not lock or never moves.
std::string lock_caveat(const design::RecordDesign& result) {
  return result.finding->point.figures.peak == 0 ? "" : next_sentence(lock_words(result));
}

/// What a lock, a real notch and an inexact damper spoil, in a few words.
std::string caveat(const RecordDesignReport& report) {
  const auto& [result, physical, fault] = report;
  const design::Sensitivity& near = result.finding->sensitivity;
  const auto& with_little = near.with_least_friction;
  return lock_caveat(result) + (fault ? format(" {}.", fault->headline) : "") +
         (with_little ? format(" With f = {}, about the least of any part: {}.",
                               design::least_friction, worst_words(result, *with_little, physical))
                      : "") +
         (near.much_worse
              ? format(" Off by {}, it is much worse.", change_words(near.much_worse->change))
          : is_delicate(result) ? format(" Off by up to {:.3g} %, {}.", 100 * near.tolerance,
                                         near.admissible < near.samples ? samples_words(near)
                                                                        : "it may be much worse")
                                : "");
}

/// A damper that changes this much less than anyone can build it is none.
bool is_needle(const design::RecordDesign& result) {
  constexpr double built = 1e-3;
  const auto& worse = result.finding->sensitivity.much_worse;
  return worse && worse->change < built;
}

}  // namespace

std::string record_verdict(const RecordDesignReport& report) {
  const design::RecordDesign& result = report.result;
  const bool interrupted = result.search.interrupted;
  if (!result.finding) {
    return (interrupted ? "Interrupted. " : "") + shortfall_sentence(report);
  }
  const Physical& physical = report.physical;
  const design::SuiteDamper& damper = result.finding->point.damper;
  return (interrupted ? "Interrupted: the best so far. " : "") + stands_still(result) +
         format("{} {}, with {}. {}.{}{}",
                hardly_moves(result) ? "The damper found has"
                : is_needle(result)  ? "Too exact to be built:"
                                     : "Build",
                damper_words(physical, damper.f, damper.delta,
                             {result.request.notch_width, result.request.hold}, printed_digits),
                period_words(physical, damper.p, period_digits(result.request)), does_words(report),
                caveat(report),
                result.finding->check.passed
                    ? ""
                    : " But the check DISAGREES: do not rely on this design.");
}

}  // namespace stillpoint::report
