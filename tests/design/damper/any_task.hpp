// SPDX-License-Identifier: MIT
#pragma once

// Random tasks after a hit, and what the simulation says of points of a box and of the ranges:
// docs/theory.md section 13.

#include "random_source.hpp"
#include "task.hpp"

namespace stillpoint::design_test {

using namespace stillpoint::design;

/// A motion nearer to a tie than that is decided by rounding.
inline constexpr double undecided_within = 1e-12;

/// Of percentages that are known to two decimals.
inline constexpr double two_decimals = 0.006;

inline Problem ranged(double v0_low, double v0, double p, double p_high, std::int64_t arrivals) {
  Problem problem{v0, p, 100 * v0 / p, Criterion::exact, arrivals};
  problem.v0_low = v0_low;
  problem.p_high = p_high;
  return problem;
}

/// One hit on one spring: p beta / V0 from `least` to `most`, up to five arrivals, with limits or
/// without; many have no damper.
inline Task one_hit_task(RandomSource& random, double least = 0.75, double most = 1.5) {
  Task task{random_problem(random, least, most), {}, random.seed()};
  Problem& problem = task.problem;
  Limits& limits = task.limits;
  problem.arrivals = 1 + random.pick(5);
  const double p_v0 = problem.p * problem.v0;
  random.one_in(3, limits.f_max, [&] { return p_v0 * random.log_uniform(0.01, 0.4); });
  random.one_in(4, limits.delta_max,
                [&] { return problem.v0 * problem.v0 * random.uniform(0.05, 0.5); });
  random.one_in(4, limits.acceleration_max,
                [&] { return p_v0 * std::sqrt(1 + random.uniform(0, 0.1)); });
  random.one_in(2, limits.tolerance, [&] { return random.uniform(0.01, 0.2); });
  return task;
}

/// With ranges of hits and springs, a residual and boxes of any shape, or without.
inline Task any_task(RandomSource& random) {
  Task task = one_hit_task(random, 0.75, 2);
  Problem& problem = task.problem;
  Limits& limits = task.limits;
  random.one_in(2, problem.v0_low, [&] {
    return random.pick(4) == 0 ? 0 : problem.v0 / (1 + random.uniform(0, 0.3));
  });
  random.one_in(2, problem.p_high, [&] { return problem.p * (1 + random.uniform(0, 0.1)); });
  random.one_in(2, problem.residual,
                [&] { return problem.v0 / problem.p * random.log_uniform(1e-3, 1.5); });
  if (random.pick(2) == 0) {
    limits.shape = {random.uniform(0, 1), 1, random.uniform(0, 1), random.uniform(0, 1)};
  }
  random.one_in(12, limits.delta_max, [] { return 0; });  // constant friction alone
  if (limits.acceleration_max) {
    *limits.acceleration_max *= problem.stiffest_p() / problem.p;
  }
  return task;
}

/// A damper under one hit on one spring.
struct Sample {
  double f;
  double delta;
  double v0;
  double p;
};

enum class Verdict { good, bad, undecided };

/// Of a rest at r: what the notch leaves of V0^2 is off by some roundings of V0^2, and
/// p^2 x^2 + 2 f x of the rest by as much.
inline double rest_rounding(const Sample& at, double r) {
  constexpr double roundings = 4 * std::numeric_limits<double>::epsilon();
  return roundings * at.v0 * at.v0 / (2 * (at.p * at.p * r + at.f));
}

inline Verdict simulated(const Task& task, const Sample& at) {
  const auto& [problem, limits, seed] = task;
  if (problem.v0_low == 0.0 && at.v0 * at.v0 < 2 * at.delta && at.v0 < problem.v0) {
    return Verdict::good;  // held
  }
  const Response motion = free_response({at.p, at.f, at.delta}, {0, at.v0}, {.times = false});
  constexpr double rounding = 1e-12;
  const double far = std::min(problem.residual.value_or(0), problem.beta) * (1 + rounding);
  const bool within =
      motion.peak_amplitude <= problem.beta * (1 + rounding) &&
      at.f < problem.beta * at.p * at.p * (1 + rounding) &&
      at.f <= limits.f_max.value_or(HUGE_VAL) * (1 + rounding) &&
      at.delta <= limits.delta_max.value_or(HUGE_VAL) * (1 + rounding) &&
      motion.peak_acceleration <= limits.acceleration_max.value_or(HUGE_VAL) * (1 + rounding);
  if (within && motion.decision_margin.value_or(1) < undecided_within) {
    return Verdict::undecided;
  }
  const bool in_time = motion.outcome != Outcome::caught_at_start &&
                       *motion.half_cycles <= static_cast<double>(problem.arrivals);
  const double off = std::abs(*motion.stop_position);
  if (!in_time || !within || off > far + rest_rounding(at, far)) {
    return Verdict::bad;
  }
  return off <= far ? Verdict::good : Verdict::undecided;
}

/// The point at these parts, in [0, 1], of the box of half-width R and of the ranges.
inline Sample at_parts(const Task& task, const DesignPoint& centre, double tolerance,
                       const std::array<double, 4>& part) {
  const auto& [problem, limits, seed] = task;
  const auto between = [](double low, double high, double here) {
    return here == 1 ? high : low + (high - low) * here;
  };
  const auto& [f_low, f_high, delta_low, delta_high] = limits.shape;
  const double v0_low = problem.v0_low.value_or(problem.v0);
  return {
      centre.f * between(1 - tolerance * f_low, 1 + tolerance * f_high, part[0]),
      centre.delta * between(1 - tolerance * delta_low, 1 + tolerance * delta_high, part[1]),
      std::max(between(v0_low, problem.v0, part[2]), 1e-3 * problem.v0),
      between(problem.p, problem.stiffest_p(), part[3]),
  };
}

/// The arrival that a motion ends at or beside; a rest at a peak is beside the one before.
inline double arrival_beside(const Response& motion) {
  const bool at_a_peak = !motion.stops_at_zero && *motion.turning_points == *motion.half_cycles;
  return *motion.half_cycles - (at_a_peak ? 1 : 0);
}

/// At the corners, and along paths on which each of the four only helps to pass or only hinders:
/// they cross whatever lies between two corners. Between two arrivals some rest is at f/p^2, so two
/// neighbours on a path must not differ in theirs unless that is within the residual.
inline bool paths_are_good(const Task& task, const DesignPoint& centre, double tolerance) {
  const auto sample = [&](const std::array<double, 4>& part) {
    return at_parts(task, centre, tolerance, part);
  };
  const auto path_is_good = [&](const std::array<double, 4>& from,
                                const std::array<double, 4>& to) {
    constexpr int steps = 200;
    std::optional<double> before;
    for (int i = 0; i <= steps; ++i) {
      const double on = static_cast<double>(i) / steps;
      std::array<double, 4> part{};
      for (std::size_t k = 0; k < part.size(); ++k) {
        part[k] = from[k] + (to[k] - from[k]) * on;
      }
      const Sample at = sample(part);
      if (simulated(task, at) != Verdict::good) {
        return false;
      }
      const Response motion = free_response({at.p, at.f, at.delta}, {0, at.v0}, {.times = false});
      const double r = std::min(task.problem.residual.value_or(0), task.problem.beta);
      const bool matters = at.f > r * at.p * at.p && *motion.half_cycles > 0;
      const auto now = matters ? std::optional(arrival_beside(motion)) : std::nullopt;
      if (now && before && *now != *before) {
        return false;
      }
      before = now;
    }
    return true;
  };
  return path_is_good({0, 0, 1, 1}, {1, 1, 0, 0}) && path_is_good({0, 0, 1, 1}, {1, 0, 1, 0}) &&
         path_is_good({1, 0, 1, 1}, {1, 0, 1, 0}) && path_is_good({0, 0, 1, 1}, {1, 0, 1, 1}) &&
         path_is_good({1, 0, 1, 0}, {1, 0, 0, 0}) && path_is_good({1, 0, 1, 0}, {1, 1, 1, 0}) &&
         path_is_good({1, 1, 1, 0}, {1, 1, 0, 0}) && path_is_good({1, 0, 0, 0}, {1, 1, 0, 0}) &&
         path_is_good({0, 0, 1, 0}, {0, 0, 0, 0}) && path_is_good({0, 1, 1, 1}, {0, 1, 1, 0}) &&
         path_is_good({0, 0, 1, 1}, {0, 0, 1, 0}) && path_is_good({0, 0, 1, 0}, {1, 0, 1, 0});
}

}  // namespace stillpoint::design_test
