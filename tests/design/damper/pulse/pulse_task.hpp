// SPDX-License-Identifier: MIT
#pragma once

// Tasks with a pulse, given and random, and the truth about them: its own motions over f, each over
// a notch that it cannot pass.

#include "../random_source.hpp"
#include "../task.hpp"

#include <stillpoint/core/forced_motion.hpp>

#include <variant>

namespace stillpoint::design_test {

/// With p = 1, by the exact criterion and without limits.
inline design::PulseRequest request_of(const design::Pulse& pulse, double beta,
                                       design::Objective objective = design::Objective::robust) {
  return {.problem = {pulse, 1, beta, design::Criterion::exact},
          .search = {.objective = objective}};
}

/// With what a mend says.
inline design::PulseRequest mended(design::PulseRequest request, std::string_view field,
                                   double value) {
  design::PulseProblem& problem = request.problem;
  if (field == "k" || field == "k_high") {
    std::visit([&](auto& kind) { kind.k = value; }, problem.pulse);
  } else if (field == "lambda" || field == "lambda_low") {
    std::visit([&](auto& kind) { kind.lambda = value; }, problem.pulse);
  } else if (field == "k_low") {
    problem.ranges.k_low = value;
  } else if (field == "lambda_high") {
    problem.ranges.lambda_high = value;
  } else if (field == "p" || field == "p_low") {
    problem.p = value;
  } else if (field == "p_high") {
    problem.p_high = value;
  } else if (field == "beta") {
    problem.beta = value;
  } else {
    request.limits = Task{{}, request.limits}.with(field, value).limits;
  }
  return request;
}

/// Each change makes it feasible, and one that is less by this part does not.
inline void check_mends(const design::PulseRequest& request, const std::vector<design::Mend>& mends,
                        double part = 1e-6) {
  for (const design::Mend& mend : mends) {
    BOOST_TEST_CONTEXT(mend.field << " = " << mend.value) {
      const double less = mend.value * (mend.upwards ? 1 - part : 1 + part);
      BOOST_TEST(design::damper(mended(request, mend.field, mend.value)).has_value());
      BOOST_TEST(!design::damper(mended(request, mend.field, less)).has_value());
    }
  }
}

/// One pulse with one spring, at these parts of the ranges.
inline design::PulseProblem at_parts(const design::PulseProblem& problem, double k, double lambda,
                                     double p) {
  const auto between = [](double low, double high, double part) {
    return low + (high - low) * part;
  };
  design::PulseProblem one = problem;
  one.ranges = {};
  one.p_high.reset();
  std::visit(
      [&](auto& kind) {
        kind.k = between(problem.ranges.k_low.value_or(kind.k), kind.k, k);
        kind.lambda =
            between(kind.lambda, problem.ranges.lambda_high.value_or(kind.lambda), lambda);
      },
      one.pulse);
  one.p = between(problem.p, problem.p_high.value_or(problem.p), p);
  return one;
}

inline std::string context_of(const design::PulseRequest& request) {
  const design::PulseProblem& problem = request.problem;
  const design::PulseProblem least = at_parts(problem, 0, 0, 0);
  const design::PulseProblem most = at_parts(problem, 1, 1, 1);
  std::ostringstream text;
  text.precision(17);
  text << name(problem.pulse) << ", k " << peak_load(least.pulse) << ":" << peak_load(most.pulse)
       << ", lambda " << angular_frequency(least.pulse) << ":" << angular_frequency(most.pulse)
       << ", p " << least.p << ":" << most.p << ", beta " << problem.beta << ", "
       << name(problem.criterion) << ", " << name(request.search.objective);
  return text.str();
}

struct Scanned {
  double f{0};
  bool holds{false};  ///< every requirement that is not one of Delta
  double need{0};     ///< the least Delta that stops it
  double peak_amplitude{0};
  std::optional<double> stop_time{};
  double peak_absolute_acceleration{0};
};

/// One pulse with one spring; the rest is that of the request.
inline Scanned scanned(const design::PulseRequest& request, const design::Pulse& pulse, double p,
                       double f) {
  const auto& [problem, limits, search] = request;
  constexpr double unpassable = 1e200;
  const ForcedResponse motion = forced_response({p, f, unpassable}, {}, design::excitation(pulse));
  const double w = motion.arrival_speed.value_or(0);
  const double phi = problem.criterion == design::Criterion::published ? f / p : 0;
  return {f,
          motion.stops_at_zero && motion.half_cycles == 1.0 &&
              motion.peak_amplitude <= problem.beta && f <= limits.f_max.value_or(HUGE_VAL) &&
              motion.peak_absolute_acceleration <= limits.acceleration_max.value_or(HUGE_VAL),
          (w * w + phi * phi) / 2,
          motion.peak_amplitude,
          motion.stop_time,
          motion.peak_absolute_acceleration};
}

inline Scanned scanned(const design::PulseRequest& request, const design::PulseProblem& one,
                       double f) {
  return scanned(request, one.pulse, one.p, f);
}

/// The worst of a grid of the pulses and springs of the ranges; the figures are those of the last.
inline Scanned worst(const design::PulseRequest& request, double f) {
  const bool is_ranged = request.problem.ranges.k_low.has_value();
  Scanned worst{.f = f, .holds = true};
  for (int i = 0; i < (is_ranged ? 45 : 1) && worst.holds; ++i) {
    Scanned now = scanned(
        request, at_parts(request.problem, i % 3 / 2.0, i / 3 % 5 / 4.0, i / 15 % 3 / 2.0), f);
    now.need = std::max(worst.need, now.need);
    worst = now;
  }
  return worst;
}

/// A design stays a relative 1e-9 inside its edges.
inline constexpr double inset = 1e-8;

/// How many of the points that are simulated in the box and in the ranges, corners among them, are
/// not admissible.
inline int outside(const design::PulseRequest& request, const design::DesignPoint& point,
                   int points, RandomSource& random) {
  const auto part = [&](int i) { return i % 3 == 0 ? random.pick(2) : random.uniform(0, 1); };
  const auto off = [&](double side, double low, double high) {
    return 1 + point.tolerance * (1 - inset) * side * (side < 0 ? low : high);
  };
  const auto& [f_low, f_high, delta_low, delta_high] = request.limits.shape;
  int bad = 0;
  for (int i = 0; i < points; ++i) {
    const double f = point.f * off(2 * part(i) - 1, f_low, f_high);
    const double delta = point.delta * off(2 * part(i) - 1, delta_low, delta_high);
    const double at_k = part(i);
    const double at_lambda = part(i);
    const Scanned now = scanned(request, at_parts(request.problem, at_k, at_lambda, part(i)), f);
    bad += !now.holds || now.need > delta || delta > request.limits.delta_max.value_or(HUGE_VAL);
  }
  return bad;
}

/// The largest tolerance of a box whose ends in f are points of the scan; negative without any.
inline double best_tolerance(const std::vector<Scanned>& points, const design::Limits& limits) {
  double best = -1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double need = 0;
    for (std::size_t j = i; j < points.size() && points[j].holds; ++j) {
      need = std::max(need, points[j].need);
      const double tolerance = (points[j].f - points[i].f) / (points[j].f + points[i].f);
      if (need * (1 + tolerance) <= limits.delta_max.value_or(HUGE_VAL) * (1 - tolerance)) {
        best = std::max(best, tolerance);
      }
    }
  }
  return best;
}

/// Its motion from rest, over a notch of that capacity.
inline ForcedResponse simulated(const design::PulseProblem& problem, double f, double delta) {
  return forced_response({problem.p, f, delta}, {}, design::excitation(problem.pulse));
}

/// By that motion, without a tolerance and by the exact criterion.
inline bool admissible(const design::PulseRequest& request, double f, double delta) {
  const auto& [problem, limits, search] = request;
  const ForcedResponse motion = simulated(problem, f, delta);
  return motion.stops_at_zero && motion.half_cycles == 1.0 &&
         motion.peak_amplitude <= problem.beta && f <= limits.f_max.value_or(HUGE_VAL) &&
         delta <= limits.delta_max.value_or(HUGE_VAL) &&
         motion.peak_absolute_acceleration <= limits.acceleration_max.value_or(HUGE_VAL);
}

inline design::Pulse pulse_of(int kind, double k, double lambda) {
  switch (kind) {
    case 0:
      return HalfSine{k, lambda};
    case 1:
      return Rectangle{k, lambda};
    case 2:
      return FullSine{k, lambda};
    case 3:
      return Sawtooth{k, lambda};
    case 4:
      return Trapezoid{k, lambda};
    default:
      return Haversine{k, lambda};
  }
}

inline design::Pulse random_pulse(RandomSource& random, double k, double lambda) {
  return pulse_of(random.pick(6), k, lambda);
}

inline design::PulseRequest random_request(RandomSource& random) {
  const double p = random.log_uniform(1e-2, 1e2);
  const double k = random.log_uniform(1e-2, 1e2);
  design::PulseRequest request{
      .problem = {random_pulse(random, k, p / random.log_uniform(0.02, 5)), p, 1,
                  random.pick(2) == 0 ? design::Criterion::published : design::Criterion::exact}};
  const ForcedResponse free = simulated(request.problem, 1e-3 * k, 1e200);
  request.problem.beta = random.uniform(0.35, 1.2) * free.peak_amplitude;
  random.one_in(2, request.limits.tolerance, [&] { return random.uniform(0, 0.3); });
  random.one_in(4, request.limits.f_max,
                [&] { return random.uniform(0.05, 0.5) * free.peak_absolute_acceleration; });
  if (random.pick(4) == 0) {
    const double w = free.arrival_speed.value_or(0);
    request.limits.delta_max = random.uniform(0.2, 1.5) * w * w / 2;
  }
  random.one_in(4, request.limits.acceleration_max,
                [&] { return random.uniform(0.8, 1.5) * free.peak_absolute_acceleration; });
  request.search.objective = random_objective(random);
  return request;
}

/// The same with ranges of k, lambda and p beyond it, of up to this part of each; some are of one
/// value.
inline design::PulseRequest ranged(design::PulseRequest request, RandomSource& random,
                                   double part) {
  design::PulseProblem& problem = request.problem;
  const auto wider = [&] { return random.pick(3) == 0 ? 1 : 1 + random.uniform(0.3, 1) * part; };
  problem.ranges = {peak_load(problem.pulse) / wider(), angular_frequency(problem.pulse) * wider()};
  problem.p_high = problem.p * wider();
  return request;
}

}  // namespace stillpoint::design_test
