// SPDX-License-Identifier: MIT
#pragma once

// What an answer tells of a damper beside its motion, for hits and pulses.

#include "pulse/first_return.hpp"

#include <stillpoint/core/elementary.hpp>
#include <stillpoint/design/admissible_region.hpp>
#include <stillpoint/design/box_shape.hpp>
#include <stillpoint/design/design_result.hpp>
#include <stillpoint/design/practice.hpp>

namespace stillpoint::design {

/// A point that was found, simulated and checked.
[[nodiscard]] Found finding_of(const Problem& problem, const Limits& limits,
                               const DesignPoint& point);

/// The same for a pulse, without its constraints and its practice. `expected` is the motion that
/// the search had, in its units; the forced motion with this Delta and Runge-Kutta integration are
/// the checks of it.
[[nodiscard]] Found finding_under_pulse(const PulseProblem& problem, const DesignPoint& point,
                                        const FirstReturn& expected);

/// The least Delta for an f by either criterion, of a hit or a pulse.
inline void add_delta1(Judged& answer, const Problem& problem, double f) {
  answer.delta1_published = delta1_published(problem, f);
  answer.delta1_exact = delta1_exact(problem, f);
}
inline void add_delta1(Judged& answer, PulseProblem problem, double f) {
  problem.criterion = Criterion::published;
  answer.delta1_published = least_delta(problem, f);
  problem.criterion = Criterion::exact;
  answer.delta1_exact = least_delta(problem, f);
}

/// The practice of a motion, and over the ranges of its hit; and the farthest that the weakest
/// friction of its box lets the mass go.
inline void add_practice(Judged& answer, const Problem& problem, const Limits& limits,
                         const DesignPoint& point, const Response& motion) {
  const double f = box_about(granted(point, limits), limits.shape).f.low;
  answer.stroke_worst =
      problem.v0 / (f + elementary::hypot(f, problem.p * problem.v0)) * problem.v0;
  answer.practice = practice({problem.p, point.f, point.delta}, motion, limits.acceleration_max);
  if (answer.practice && (problem.p_high || problem.v0_low)) {
    answer.practice_worst = worst_practice(problem, limits, point.f, point.delta);
  }
  if (const auto& told = answer.practice_worst ? answer.practice_worst : answer.practice) {
    answer.notch_width_min = told->notch_width_min;
  }
}
/// Of the motion under the pulse of `problem` and its ranges that moves the mass farthest.
inline void add_practice(Judged& answer, const PulseProblem& problem, const Limits& limits,
                         const PulseMotion& motion, const Oscillator& damper) {
  const auto& limit = limits.acceleration_max;
  answer.practice = practice(damper, motion.response, limit, peak_load(motion.pulse));
  if (answer.practice && answer.practice->notch_width_min) {
    answer.notch_width_min = least_notch_width_from_rest(
        damper.f, damper.delta, *limit, problem.p_high.value_or(problem.p),
        problem.ranges.k_low.value_or(peak_load(problem.pulse)));
  }
}

}  // namespace stillpoint::design
