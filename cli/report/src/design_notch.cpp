// SPDX-License-Identifier: MIT
#include "design_parts.hpp"
#include "format.hpp"

#include <cmath>

namespace stillpoint::report {

namespace {

const Response& with_the_papers_notch(const design::Finding& finding) {
  return finding.pulse ? finding.pulse->response : finding.response;
}

/// What is wrong with the design in the notch that will be built; empty if nothing is.
std::string fault_of(const design::BuiltNotch& built, const design::DesignRequest& request,
                     const Physical& physical) {
  const auto& [problem, limits, search, pulse, ranges] = request;
  const ForcedResponse& response = built.response;
  const double peak = response.peak_amplitude;
  constexpr double rounding = 1 + 1e-9;
  if (response.half_cycles == 0) {
    return "this notch holds the mass throughout the pulse";
  }
  if (built.shape.width && *built.shape.width / 2 >= peak) {
    return format(
        "the mass never leaves a notch {} wide: it stops at x = {}",
        length_shown(physical, *built.shape.width),
        response.stop_position ? length_shown(physical, *response.stop_position) : "none");
  }
  if (peak > problem.beta * rounding) {
    return format("with this notch the peak exceeds {}", length_shown(physical, problem.beta));
  }
  const Outcome outcome = response.outcome;
  if (outcome != Outcome::stopped_at_zero && outcome != Outcome::stopped_in_notch) {
    return "with this notch the mass " + outcome_phrase(response);
  }
  if (limits.acceleration_max &&
      response.peak_absolute_acceleration > *limits.acceleration_max * rounding) {
    return format("inside this notch the structure feels {}, more than the limit of {}",
                  acceleration_shown(response.peak_absolute_acceleration),
                  acceleration_shown(*limits.acceleration_max));
  }
  return {};
}

}  // namespace

const Response& told_motion(const DesignReport& report) {
  return report.built_notch ? report.built_notch->response
                            : with_the_papers_notch(*report.result.finding);
}

std::optional<std::string> felt_in_built_notch(const DesignReport& report) {
  if (!report.built_notch) {
    return std::nullopt;
  }
  const auto& [shape, friction, built, changes_nothing] = *report.built_notch;
  const std::string most = acceleration_shown(built.peak_absolute_acceleration);
  if (built.half_cycles == 0) {
    return most + ", all of the load";
  }
  const design::Finding& finding = *report.result.finding;
  const double p = finding.pulse ? finding.pulse->p : report.result.request.problem.p;
  // It slides at the largest acceleration outside, f + p^2 |x|, where it is farthest.
  const double outside = finding.point.f + p * p * built.peak_amplitude;
  constexpr double rounding = 1 + 1e-9;
  const bool more = built.peak_absolute_acceleration > rounding * outside;
  if (!shape.width) {
    return more ? std::optional(format("{} while the notch holds it, {} outside it", most,
                                       acceleration_shown(outside)))
                : std::nullopt;
  }
  const bool leaves = *shape.width / 2 < built.peak_amplitude;
  return more && leaves
             ? format("{} inside the notch, {} outside it", most, acceleration_shown(outside))
             : most;
}

std::string built_notch_fault(const DesignReport& report, const Physical& physical) {
  return report.built_notch ? fault_of(*report.built_notch, report.result.request, physical) : "";
}

void add_built_notch(Document& document, const design::BuiltNotch& built,
                     const design::Finding& finding, const Physical& physical) {
  const auto& [shape, friction, response, changes_nothing] = built;
  const Response& paper = with_the_papers_notch(finding);
  Section& section = document.section("The notch as built");
  if (shape.width) {
    section.row("width", length_text(physical, *shape.width));
    section.row("friction inside", format("f + delta/width = {:.6g}", *friction));
  } else {
    section.row("holds",
                format("f + hold = {:.4g} g at x = 0", finding.point.f + shape.hold.value()));
    if (changes_nothing) {
      section.line("The mass moves as if the notch held any load: nothing changes.");
      return;
    }
  }
  if (paper.stop_time) {
    std::string ideal =
        format("rest at x = {} after {}", length_shown(physical, *paper.stop_position),
               time_shown(physical, *paper.stop_time));
    if (response.stop_time && *response.stop_time > 0) {
      ideal += format(", {:.3g} % {}", 100 * std::abs(*paper.stop_time / *response.stop_time - 1),
                      *response.stop_time < *paper.stop_time ? "later" : "earlier");
    }
    section.row(shape.width ? "without width" : "holding all", ideal);
  }
  section.line(format(
      "Tolerance, works for, checks, the region and the tables below are those of a notch that {}.",
      shape.width ? "has no width" : "holds any load"));
}

}  // namespace stillpoint::report
