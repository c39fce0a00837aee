// SPDX-License-Identifier: MIT
#include "design_parts.hpp"
#include "format.hpp"

#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::report {

namespace {

constexpr double centred = 0.1;  // of the peak, without a residual

/// "a hit of 0.35 m/s", or "a pulse of 0.25 g and 300 ms" of ranges.
std::string cause_words(const design::RestAfter& now, const design::DesignRequest& request,
                        const Physical& physical) {
  if (!now.pulse) {
    return "a hit of " + FigureUnits(physical).velocity_words(now.v0);
  }
  return format(
      "a pulse of {:.4g} g{}", design::peak_load(*now.pulse),
      request.pulse_ranges.lambda_high
          ? " and " + time_shown(physical, duration(design::excitation(*now.pulse)).value())
          : "");
}

/// Of ranges: the worst of them.
std::string far_rest(const design::BuiltNotch& built, const design::DesignRequest& request,
                     const Physical& physical) {
  const auto& farthest = built.farthest;
  const double allowed = request.problem.residual.value_or(centred * built.response.peak_amplitude);
  return farthest && std::abs(farthest->rest) > allowed * for_rounding
             ? format("the mass rests {} off centre after {}",
                      length_shown(physical, std::abs(farthest->rest)),
                      cause_words(*farthest, request, physical))
             : "";
}

}  // namespace

std::string notch_fault(const design::BuiltNotch& built, const design::DesignRequest& request,
                        const Physical& physical) {
  const auto& [problem, limits, search, pulse, ranges] = request;
  const ForcedResponse& response = built.response;
  const double peak = response.peak_amplitude;
  if (response.half_cycles == 0) {
    return "the mass is held throughout the pulse";
  }
  if (built.holds_weakest) {
    return format("the mass is held throughout the weakest pulse, k = {:.4g} g",
                  ranges.k_low.value_or(design::peak_load(*pulse)));
  }
  const bool allowed = problem.residual && response.stop_position &&
                       std::abs(*response.stop_position) <= *problem.residual * for_rounding;
  if (built.shape.width && *built.shape.width / 2 >= peak && !allowed) {
    return "the mass stays inside" +
           (response.stop_position
                ? format(" and stops at x = {}", length_shown(physical, *response.stop_position))
                : "");
  }
  if (peak > problem.beta * for_rounding) {
    return format("the peak exceeds {}", length_shown(physical, problem.beta));
  }
  if (std::string far = far_rest(built, request, physical); !far.empty()) {
    return far;
  }
  const bool kept = problem.residual ? allowed
                                     : response.outcome == Outcome::stopped_at_zero ||
                                           response.outcome == Outcome::stopped_in_notch;
  if (!kept) {
    return "the mass " + outcome_phrase(response);
  }
  if (limits.acceleration_max &&
      response.peak_absolute_acceleration > *limits.acceleration_max * for_rounding) {
    return format("the structure feels {} inside it, more than the limit of {}",
                  acceleration_shown(response.peak_absolute_acceleration),
                  acceleration_shown(*limits.acceleration_max));
  }
  // A notch of the example width, at most a fifth of the peak, cannot do that.
  if (!problem.residual && std::abs(*response.stop_position) > centred * peak * for_rounding) {
    return format("the mass rests {} off centre, inside it",
                  length_shown(physical, std::abs(*response.stop_position)));
  }
  return {};
}

std::string rest_shown(const DesignReport& report, double x) {
  const double stroke = report.result.finding->response.peak_amplitude;
  return length_shown(report.physical, begins_at_nothing(std::abs(x), stroke) ? 0 : x);
}

const Response& told_motion(const DesignReport& report) {
  return report.built_notch ? report.built_notch->response : report.result.finding->response;
}

std::optional<std::string> felt_in_built_notch(const DesignReport& report) {
  if (!report.built_notch) {
    return std::nullopt;
  }
  const design::NotchShape& shape = report.built_notch->shape;
  const ForcedResponse& built = report.built_notch->response;
  const std::string most = acceleration_shown(built.peak_absolute_acceleration);
  if (built.half_cycles == 0) {
    return most + ", all of the load";
  }
  const design::Finding& finding = *report.result.finding;
  const double p = finding.pulse ? finding.pulse->p : report.result.request.problem.p;
  const auto outside = felt_outside(built, p, finding.point.f, shape.width);
  return outside         ? format("{} {}, {} outside it", most,
                          shape.width ? "inside the notch" : "while the notch holds it",
                                  acceleration_shown(*outside))
         : shape.width   ? std::optional(most)
         : finding.pulse ? std::optional(most + " outside the notch")
                         : std::nullopt;
}

std::string built_notch_fault(const DesignReport& report, const Physical& physical) {
  return report.built_notch ? notch_fault(*report.built_notch, report.result.request, physical)
                            : "";
}

std::string_view ideal_words(const design::BuiltNotch& built, const design::Finding& finding) {
  return finding.pulse ? acts_late : built.shape.width ? "has no width" : "holds any load";
}

std::string with_ideal(const DesignReport& report) {
  const auto ideal = report.built_notch
                         ? std::optional(ideal_words(*report.built_notch, *report.result.finding))
                     : notch_sentence(report).empty() ? std::nullopt
                                                      : std::optional(acts_late);
  return ideal ? format(", with a notch that {}", *ideal) : "";
}

void add_built_notch(Document& document, const DesignReport& report, const Physical& physical) {
  const design::BuiltNotch& built = *report.built_notch;
  const design::Finding& finding = *report.result.finding;
  Section& section = document.section("The notch as built");
  if (built.shape.width) {
    section.row("width", length_shown(physical, *built.shape.width));
    section.row("friction inside", format("f + delta/width = {:.6g}", *built.friction));
  } else {
    section.row("holds",
                format("f + hold = {:.4g} g at x = 0", finding.point.f + built.shape.hold.value()));
  }
  if (const auto& farthest = built.farthest) {
    section.row("farthest rest",
                format("x = {} after {}, with {}", rest_shown(report, farthest->rest),
                       cause_words(*farthest, report.result.request, physical),
                       period_words(physical, farthest->p)));
  }
  const Response& ideal = finding.response;
  if (built.changes_nothing) {
    section.line(format("The mass moves as with a notch that {}: nothing changes.",
                        ideal_words(built, finding)));
  } else if (ideal.stop_time) {
    section.row("compare",
                format("with a notch that {} it rests at x = {} after {}",
                       ideal_words(built, finding), length_shown(physical, *ideal.stop_position),
                       time_shown(physical, *ideal.stop_time)));
  }
}

}  // namespace stillpoint::report
