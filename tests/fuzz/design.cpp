// SPDX-License-Identifier: MIT
#include "fuzz.hpp"

#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/design/design.hpp>

// What holds for every design: its cross-check passes, and at the corners of its tolerance box,
// under the weakest and the strongest hit and on the softest and the stiffest spring, the simulated
// mass does what was asked for.

namespace {

using namespace stillpoint;
using namespace stillpoint::fuzz;
using namespace stillpoint::design;

DesignRequest any_request(fuzz::Numbers& numbers) {
  DesignRequest request;
  Problem& problem = request.problem;
  Limits& limits = request.limits;
  problem.v0 = numbers.power_of_ten(-5, 5);
  problem.p = numbers.power_of_ten(-5, 5);
  problem.beta = numbers.uniform(0.69, 2) * problem.v0 / problem.p;
  problem.criterion = numbers.once_in(2) ? Criterion::published : Criterion::exact;
  problem.arrivals = 1 + numbers.below(4);
  const double force = problem.v0 * problem.p;
  const double energy = problem.v0 * problem.v0;
  if (numbers.once_in(2)) {
    problem.v0_low = numbers.once_in(4) ? 0 : problem.v0 / (1 + numbers.uniform(0, 0.5));
  }
  if (numbers.once_in(2)) {
    problem.p_high = problem.p * (1 + numbers.uniform(0, 0.2));
  }
  if (numbers.once_in(2)) {
    problem.residual = problem.v0 / problem.p * numbers.power_of_ten(-4, 0);
  }
  if (numbers.once_in(2)) {
    limits.shape = {numbers.uniform(0, 1), 1, numbers.uniform(0, 1), numbers.uniform(0, 1)};
  }
  if (numbers.once_in(3)) {
    limits.f_max = force * numbers.power_of_ten(-2, -0.4);
  }
  if (numbers.once_in(4)) {
    limits.delta_max = energy * numbers.uniform(0.05, 0.6);
  }
  if (numbers.once_in(4)) {
    limits.acceleration_max = problem.stiffest_p() * problem.v0 * (1 + numbers.uniform(0, 0.1));
  }
  limits.tolerance = numbers.once_in(2) ? 0 : numbers.uniform(0, 0.3);
  request.search.objective = static_cast<Objective>(numbers.below(4));
  return request;
}

std::string shown(const DesignRequest& request) {
  const auto& [problem, limits, search, pulse, ranges] = request;
  return fmt::format(
      "{}, {}, v0 {}:{}, p {}:{}, beta {}, arrivals {}, residual {}, f_max {}, delta_max {}, "
      "acceleration_max {}, tolerance {} of {} {} {} {}",
      name(search.objective), name(problem.criterion), problem.v0_low.value_or(problem.v0),
      problem.v0, problem.p, problem.stiffest_p(), problem.beta, problem.arrivals,
      problem.residual.value_or(0), limits.f_max.value_or(0), limits.delta_max.value_or(0),
      limits.acceleration_max.value_or(0), limits.tolerance, limits.shape.f_low,
      limits.shape.f_high, limits.shape.delta_low, limits.shape.delta_high);
}

/// The motion of a damper after a hit does what was asked for, unless rounding decides.
bool holds(const DesignRequest& request, const Oscillator& oscillator, double v0) {
  constexpr double rounding = 1e-12;
  const auto& [problem, limits, search, pulse, ranges] = request;
  if (problem.v0_low == 0.0 && v0 * v0 < 2 * oscillator.delta && v0 < problem.v0) {
    return true;  // the notch holds it, and may
  }
  const Response motion = free_response(oscillator, {0, v0}, {.times = false});
  const auto within = [](double value, double limit) { return value <= limit * (1 + rounding); };
  if (!within(motion.peak_amplitude, problem.beta) ||
      !within(oscillator.f, limits.f_max.value_or(HUGE_VAL)) ||
      !within(oscillator.delta, limits.delta_max.value_or(HUGE_VAL)) ||
      !within(motion.peak_acceleration, limits.acceleration_max.value_or(HUGE_VAL))) {
    return false;
  }
  if (motion.decision_margin.value_or(1) < rounding) {
    return true;
  }
  const double residual = problem.residual.value_or(0);
  // What a rest is off by where the last arc takes all but some roundings of the energy.
  const double roundings =
      1e-15 * v0 * v0 / (2 * (oscillator.p * oscillator.p * residual + oscillator.f));
  return motion.outcome != Outcome::caught_at_start &&
         motion.half_cycles <= static_cast<double>(problem.arrivals) &&
         std::abs(*motion.stop_position) <= residual * (1 + rounding) + roundings;
}

void require_box(const DesignRequest& request, const DesignPoint& point, fuzz::Numbers& numbers) {
  const auto& [problem, limits, search, pulse, ranges] = request;
  const double tolerance = point.tolerance;
  const BoxShape& shape = limits.shape;
  for (unsigned corner = 0; corner < 24; ++corner) {
    // The corners, then what is between them.
    const auto between = [&](unsigned bit, double low, double high) {
      return corner >= 16 ? numbers.uniform(low, high) : (corner >> bit & 1U) != 0 ? high : low;
    };
    const double f =
        point.f * between(0, 1 - tolerance * shape.f_low, 1 + tolerance * shape.f_high);
    const double delta =
        point.delta * between(1, 1 - tolerance * shape.delta_low, 1 + tolerance * shape.delta_high);
    const double v0 = std::max(between(2, problem.v0_low.value_or(problem.v0), problem.v0),
                               1e-3 * problem.v0);  // of every hit from 0 on
    const double p = between(3, problem.p, problem.stiffest_p());
    require(holds(request, {p, f, delta}, v0),
            "{}: the design f {}, delta {}, tolerance {} fails at f {}, delta {}, v0 {}, p {}",
            shown(request), point.f, point.delta, tolerance, f, delta, v0, p);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  accepted([&] {
    fuzz::Numbers numbers(data, size);
    const DesignRequest request = any_request(numbers);
    const DesignResult result = stillpoint::design::design(request);
    require(result.region.feasible == result.finding.has_value() &&
                result.reason.has_value() != result.finding.has_value(),
            "{}: the region is {}feasible: {}", shown(request), result.region.feasible ? "" : "in",
            result.reason.value_or(""));
    if (!result.finding) {
      return;
    }
    const Found& finding = *result.finding;
    require(finding.point.tolerance >= request.limits.tolerance, "{}: the tolerance is {}",
            shown(request), finding.point.tolerance);
    for (const Constraint& constraint : finding.constraints) {
      require(constraint.satisfied, "{}: {} is violated", shown(request), constraint.name);
    }
    require(finding.cross_check.passed, "{}: the cross-check fails", shown(request));
    require_box(request, finding.point, numbers);
  });
  return 0;
}
