// SPDX-License-Identifier: MIT
#include "design_parts.hpp"
#include "format.hpp"

#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::report {

namespace {

constexpr double centred = 0.1;  // of the peak, without a residual

/// "hit of 0.35 m/s", "hit of 0.2 m/s from inside the notch", or "pulse of 0.25 g and 300 ms" of
/// ranges.
std::string cause_words(const design::TriedMotion& now, const design::DesignRequest& request,
                        const Physical& physical) {
  if (!now.pulse) {
    return format("hit of {}{}", FigureUnits(physical).velocity_words(now.v0),
                  now.from_inside ? " from inside the notch" : "");
  }
  return format(
      "pulse of {:.4g} g{}", design::peak_load(*now.pulse),
      request.pulse_ranges.lambda_high
          ? " and " + time_shown(physical, duration(design::excitation(*now.pulse)).value())
          : "");
}

/// " after a hit of 0.35 m/s, with a period of 2.8 s".
std::string after_words(const design::TriedMotion& now, const design::DesignRequest& request,
                        const Physical& physical) {
  return format(" after a {}{}", cause_words(now, request, physical),
                request.problem.p_high ? ", with " + period_words(physical, now.p) : "");
}

/// " (weakest hit, stiffest spring)": which motion of the ranges it is, shortly.
std::string which_words(const design::TriedMotion& now, const design::DesignRequest& request,
                        const Physical& physical) {
  const auto& [problem, limits, search, pulse, ranges] = request;
  std::string words;
  if (pulse ? ranges.k_low || ranges.lambda_high : problem.v0_low.has_value()) {
    words = pulse                       ? cause_words(now, request, physical)
            : now.v0 == problem.v0      ? "strongest hit"
            : now.v0 == *problem.v0_low ? "weakest hit"
                                        : cause_words(now, request, physical);
  }
  if (problem.p_high) {
    words += words.empty() ? "" : ", ";
    words += now.p == problem.p         ? "softest spring"
             : now.p == *problem.p_high ? "stiffest spring"
                                        : period_words(physical, now.p);
  }
  return format(" ({})", words);
}

/// Of ranges: whether the worst of them rests too far off centre.
bool rests_far(const design::BuiltNotch& built, const design::Problem& problem) {
  const double allowed = problem.residual.value_or(centred * built.response.peak_amplitude);
  return built.worst && std::abs(built.worst->farthest.rest()) > allowed * for_rounding;
}

/// In any motion that was tried.
double most_felt(const design::BuiltNotch& built) {
  return (built.worst ? built.worst->felt.response : built.response).peak_absolute_acceleration;
}

}  // namespace

std::string built_notch_fault(const DesignReport& report) {
  const design::BuiltNotch& built = *report.built_notch;
  const design::DesignRequest& request = report.result.request;
  const Physical& physical = report.physical;
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
  const auto after = [&](design::TriedMotion design::WorstMotions::*of) {
    return built.worst ? after_words(*built.worst.*of, request, physical) : "";
  };
  const double largest = built.worst ? built.worst->peak.response.peak_amplitude : peak;
  if (largest > problem.beta * for_rounding) {
    return format("the peak exceeds {}{}", length_shown(physical, problem.beta),
                  after(&design::WorstMotions::peak));
  }
  if (rests_far(built, problem)) {
    return format("the mass rests {} off centre{}",
                  length_shown(physical, std::abs(built.worst->farthest.rest())),
                  after(&design::WorstMotions::farthest));
  }
  const bool kept = problem.residual ? allowed
                                     : response.outcome == Outcome::stopped_at_zero ||
                                           response.outcome == Outcome::stopped_in_notch;
  if (!kept) {
    return "the mass " + outcome_phrase(response);
  }
  if (limits.acceleration_max && most_felt(built) > *limits.acceleration_max * for_rounding) {
    return format("the structure feels {} inside it{}, more than the limit of {}",
                  acceleration_shown(most_felt(built)), after(&design::WorstMotions::felt),
                  acceleration_shown(*limits.acceleration_max));
  }
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

std::optional<ToldMotion::Tried> tried_in_built_notch(const DesignReport& report,
                                                      const Physical& physical) {
  if (!report.built_notch || !report.built_notch->worst) {
    return std::nullopt;
  }
  const design::WorstMotions& worst = *report.built_notch->worst;
  const design::DesignRequest& request = report.result.request;
  const std::string rest = rest_shown(report, std::abs(worst.farthest.rest()));
  return ToldMotion::Tried{worst.peak.response.peak_amplitude,
                           which_words(worst.peak, request, physical),
                           rest == "0" ? "at x = 0 in every motion that was tried"
                                       : format("up to {} off centre in the motions tried{}", rest,
                                                which_words(worst.farthest, request, physical)),
                           rests_far(*report.built_notch, request.problem)};
}

std::optional<std::string> felt_in_built_notch(const DesignReport& report) {
  if (!report.built_notch) {
    return std::nullopt;
  }
  const auto& [shape, friction, built, same, strip, worst, holds] = *report.built_notch;
  const design::DesignRequest& request = report.result.request;
  const std::string most = acceleration_shown(most_felt(*report.built_notch));
  if (built.half_cycles == 0) {
    return most + ", all of the load";
  }
  const design::Found& finding = *report.result.finding;
  const auto which = [&](const design::TriedMotion& now) {
    return which_words(now, request, report.physical);
  };
  const std::string of_most = worst ? which(worst->felt) : ", with f and delta as given";
  const double p = worst ? worst->outside.p : finding.pulse ? finding.pulse->p : request.problem.p;
  const Response& slides = worst ? worst->outside.response : built;
  const double outside = finding.point.f + p * slides.peak_amplitude * p;
  const bool leaves = shape.width.value_or(0) / 2 < slides.peak_amplitude;
  if (leaves && most_felt(*report.built_notch) > for_rounding * outside) {
    const std::string of_outside = worst ? which(worst->outside) : of_most;
    return format("{} {}{}, {} outside it{}", most,
                  shape.width ? "inside the notch" : "while the notch holds it",
                  of_most == of_outside ? "" : of_most, acceleration_shown(outside), of_outside);
  }
  return shape.width ? most + (leaves ? " outside the notch, no more inside it" : "") + of_most
                     : most + " outside the notch" + of_most;
}

std::string_view ideal_words(const design::BuiltNotch& built, const design::Found& finding) {
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
  const design::Found& finding = *report.result.finding;
  Section& section = document.detail("The notch as built");
  if (built.shape.width) {
    section.row("width", length_shown(physical, *built.shape.width));
    section.row("friction inside", format("f + delta/width = {:.6g}", *built.friction));
  } else {
    section.row("holds",
                format("f + hold = {:.4g} g at x = 0", finding.point.f + built.shape.hold.value()));
  }
  if (built.from_start) {
    const bool caught = report.result.request.problem.has_caught_hits(finding.point.delta);
    section.row("way out",
                format("free: v0 is the speed with which the mass leaves the notch; the row of the "
                       "answer is for one that acts on the way out too{}",
                       caught ? ", as on the weak hits of the range" : ""));
  }
  if (built.worst) {
    const design::TriedMotion& farthest = built.worst->farthest;
    section.row("farthest rest",
                format("x = {} after a {}, with {}", rest_shown(report, farthest.rest()),
                       cause_words(farthest, report.result.request, physical),
                       period_words(physical, farthest.p)));
  }
  const Response& ideal = finding.response;
  if (!built.changes_nothing && ideal.stop_time) {
    section.row("compare",
                format("with a notch that {} it rests at x = {} after {}",
                       ideal_words(built, finding), length_shown(physical, *ideal.stop_position),
                       time_shown(physical, *ideal.stop_time)));
  }
}

}  // namespace stillpoint::report
