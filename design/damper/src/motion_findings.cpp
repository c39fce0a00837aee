// SPDX-License-Identifier: MIT
#include <stillpoint/design/motion_findings.hpp>

#include <stillpoint/core/elementary.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/nearby_ends.hpp>
#include <stillpoint/design/suite_task.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <variant>

namespace stillpoint::design {

namespace {

using enum FindingKind;
using records::Dimension;

/// How long the load acts.
double load_end(const SimulationRequest& request) {
  return std::min(duration(request.excitation).value_or(HUGE_VAL),
                  request.t_end.value_or(HUGE_VAL));
}

/// Empty if it is never told where it rests.
std::optional<ForcedResponse> with_width(const Oscillator& damper, const Excitation& pulse,
                                         double width) {
  constexpr double most = 1000;
  try {
    return forced_response(damper, {}, pulse, {.half_cycle_limit = most}, {width, {}});
  } catch (const TooManyHalfCycles&) {
    return std::nullopt;
  }
}

void add_lock(std::vector<Finding>& all, const SimulationRequest& request,
              const ForcedResponse& forced) {
  Finding lock = lock_of(forced, load_end(request));
  // A run that is cut counts the rest in which it is locked as a stick.
  const double last =
      forced.outcome == Outcome::running ? *forced.end_time - *forced.locked_from : 0;
  const double moved = *forced.locked_from - (forced.stick_time - last);
  constexpr double hardly = 0.1;
  if (*forced.locked_from > 0 && moved < hardly * *forced.locked_from) {
    lock.add("moved", moved, Dimension::time);
  }
  all.push_back(std::move(lock));
}

void add_rest(std::vector<Finding>& all, const Simulation& motion) {
  const Response& response = motion.response;
  const bool notch = response.outcome == Outcome::stopped_in_notch;
  Finding& still = all.emplace_back(never_moves).tell("by", notch ? "notch" : "friction");
  if (motion.forced) {
    still.add("largest_load", figures_of(response).acceleration, Dimension::gravities);
  } else {
    still.add("stop_position", response.stop_position, Dimension::length);
  }
}

/// How the peaks of a motion that goes on under a harmonic load develop, by the last of them; not
/// if they are not listed.
void add_peaks(std::vector<Finding>& all, const SimulationRequest& request,
               const Simulation& motion) {
  const auto* const load = std::get_if<Harmonic>(&request.excitation);
  const std::vector<HalfCycle>& listed = motion.half_cycles;
  constexpr std::size_t compared = 8;
  constexpr std::size_t settled = 4;
  if (load == nullptr || load->duration || motion.response.outcome != Outcome::running ||
      listed.size() <= compared ||
      motion.response.half_cycles != static_cast<double>(listed.size())) {
    return;
  }
  const bool cut = listed.back().peak_time == listed.back().end_time;  // before its peak
  const auto last = listed.end() - (cut ? 1 : 0);
  std::vector<double> peaks;
  std::transform(last - compared, last, std::back_inserter(peaks),
                 [](const HalfCycle& now) { return now.peak; });
  constexpr double same = 0.005;
  const auto [low, high] = std::ranges::minmax(std::span(peaks).last(settled));
  const bool settles = high - low <= same * high;
  const bool grows = std::ranges::is_sorted(peaks);
  const bool shrinks = std::ranges::is_sorted(peaks, std::ranges::greater());
  const auto [least, most] = std::ranges::minmax(peaks);
  all.emplace_back(peaks_develop)
      .tell("trend", settles   ? "settle"
                     : grows   ? "grow"
                     : shrinks ? "shrink"
                               : "vary")
      .add("last_peak", peaks.back(), Dimension::length)
      .add("least_peak", least, Dimension::length)
      .add("largest_peak", most, Dimension::length);
}

/// No damper is built more accurately than the first. That of a load or a surface is no tolerance:
/// below the second, rounding may decide.
void add_margin(std::vector<Finding>& all, const SimulationRequest& request,
                const Simulation& motion) {
  const auto& margin = motion.response.decision_margin;
  const bool of_inputs = has_closed_form(request);
  if (margin && *margin < (of_inputs ? 0.01 : 1e-9)) {
    const bool starts = motion.response.outcome == Outcome::caught_at_start;
    Finding& close = all.emplace_back(close_call).tell("changes", starts ? "start" : "stop");
    if (of_inputs && *margin > std::numeric_limits<double>::epsilon()) {
      close.add("decision_margin", margin);
    }
  }
}

bool lie_far_apart(const Interval& rests, double peak) {
  constexpr double of_the_peak = 0.01;
  constexpr double of_the_rest = 0.1;
  const double farthest = std::max(std::abs(rests.low), std::abs(rests.high));
  return rests.high - rests.low > std::max(of_the_peak * peak, of_the_rest * farthest);
}

/// If f and Delta slightly off change the end much.
void add_nearby(std::vector<Finding>& all, const SimulationRequest& request,
                const Simulation& motion) {
  if (has_closed_form(request)) {
    return;
  }
  const auto ends = nearby_ends(request, motion);
  if (!ends) {
    return;
  }
  const bool apart = ends->rests && lie_far_apart(*ends->rests, motion.response.peak_amplitude);
  if (!apart && !ends->rest_differs && !ends->lock_differs) {
    return;
  }
  Finding& finding = all.emplace_back(sensitive).tell(
      "varied", request.oscillator.delta > 0 ? "f and delta" : "f");
  if (apart) {
    finding.add("rest_low", ends->rests->low, Dimension::length)
        .add("rest_high", ends->rests->high, Dimension::length);
  }
  if (ends->rest_differs || ends->lock_differs) {
    finding.tell("changes", ends->rest_differs ? "rest" : "lock");
  }
}

}  // namespace

bool moves(const Response& response) {
  return response.stop_time != 0.0;
}

double holding_friction(const SimulationRequest& request) {
  const auto& zones = request.surface.zones;
  return request.oscillator.breakaway * (zones.empty() ? request.oscillator.f : zones.front().f);
}

double least_width(double f, double delta, double load) {
  return load > f ? delta / (load - f) : HUGE_VAL;
}

void add_failed(std::vector<Finding>& all, const CrossCheck& check) {
  const auto method = std::ranges::find(check.methods, false, &CheckMethod::passed);
  if (method != check.methods.end()) {
    all.emplace_back(check_failed)
        .add("relative_error", method->relative_error)
        .add("tolerance", method->tolerance);
  }
}

Finding lock_of(const ForcedResponse& motion, double load_end) {
  return Finding(locks)
      .add("largest_load_while_locked", motion.largest_load_while_locked, Dimension::gravities)
      .add("final_position", motion.final_position, Dimension::length)  // off 0 in a wide notch
      .add("locked_from", motion.locked_from, Dimension::time)
      .add("load_end", load_end, Dimension::time);
}

Finding no_notch(double width, double peak, double searched_delta) {
  const bool some = std::isfinite(width);
  Finding finding(no_notch_works);
  finding.add("least_width", some ? std::optional(width) : std::nullopt, Dimension::length)
      .add("peak_amplitude", peak, Dimension::length);
  if (some && searched_delta > 0) {
    finding.add("proposed", searched_delta * peak / width, Dimension::length);
  }
  return finding;
}

Finding late_notch(const Oscillator& damper, const Excitation& pulse, double least_load,
                   double peak, double rest, bool searched) {
  const double least = least_width(damper.breakaway * damper.f, damper.delta, least_load);
  const double most = 2 * peak;
  if (least >= most) {
    return no_notch(least, peak, searched ? damper.delta : 0);
  }
  constexpr int widths = 24;
  for (int i = 1; i <= widths; ++i) {  // the widest first, which is felt least
    const double width = most * elementary::exp(elementary::log(least / most) * i / (widths + 1));
    const auto motion = with_width(damper, pulse, width);
    if (motion && motion->stop_position && motion->peak_amplitude > width / 2 &&
        std::abs(*motion->stop_position) <= std::min(width / 2, rest)) {
      return Finding(acts_late).add("width", width, Dimension::length);
    }
  }
  return Finding(no_width_found)
      .count("widths", widths)
      .add("least_width", least, Dimension::length)
      .add("most_width", most, Dimension::length);
}

std::optional<double> caught_impulse(const SimulationRequest& request, const Response& response) {
  const Oscillator& oscillator = request.oscillator;
  const Start& start = request.start;
  // A load can free the mass from a notch that lets go.
  const bool freed = is_forced(request) && oscillator.hold && start.x0 == 0 &&
                     !request.surface.notch_width && holds_at_start(oscillator.delta, start.v0);
  const bool caught = response.outcome == Outcome::caught_at_start || freed;
  return caught && start.v0 != 0 ? std::optional(std::abs(start.v0)) : std::nullopt;
}

std::vector<Finding> findings_of(const SimulationRequest& request, const Simulation& motion) {
  std::vector<Finding> all;
  const Response& response = motion.response;
  const auto& forced = motion.forced;
  const double delta = request.oscillator.delta;
  if (forced && forced->left_notch_from_rest) {
    const double width =
        least_width(holding_friction(request), delta, peak_load(request.excitation));
    if (width >= 2 * response.peak_amplitude) {
      all.push_back(no_notch(width, response.peak_amplitude));
    }
  }
  if (forced && forced->locks()) {
    add_lock(all, request, *forced);
  } else if (!moves(response) && response.outcome != Outcome::caught_at_start) {
    add_rest(all, motion);
  }
  if (const auto impulse = caught_impulse(request, response)) {
    all.emplace_back(catches_hit)
        .add("caught_impulse", impulse, Dimension::velocity)
        .add("least_velocity", std::sqrt(2 * delta), Dimension::velocity);
  }
  if (forced && response.jump > 0) {
    all.emplace_back(jolts).add("jump", response.jump, Dimension::velocity);
  }
  add_margin(all, request, motion);
  add_nearby(all, request, motion);
  add_peaks(all, request, motion);
  const auto load = duration(request.excitation);
  if (load && request.t_end && *request.t_end < *load) {
    all.emplace_back(ends_before_load)
        .add("end_time", request.t_end, Dimension::time)
        .add("load_end", load, Dimension::time);
  }
  return all;
}

}  // namespace stillpoint::design
