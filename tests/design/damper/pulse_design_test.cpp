// SPDX-License-Identifier: MIT
#include "random_source.hpp"
#include "testing/printing.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/design/cross_check.hpp>
#include <stillpoint/design/design.hpp>
#include <stillpoint/design/region.hpp>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(pulse_design_test)

// Designs for a pulse, compared with the conditions (32) of docs/theory.md written out with V(f),
// with a scan of the (f, Delta) plane, and with the forced motion.

namespace {

using namespace stillpoint;
using namespace stillpoint::design;
using namespace stillpoint::design_test;

/// Relative distance of the design from its edges: 1e-9 from f3, and as much for each velocity.
constexpr double inset = 1e-8;

double v0_at(const PulseProblem& problem, double f) {
  return problem_at(problem, f).v0;
}

/// One (f, Delta) with the velocity of its own f.
bool holds(const PulseProblem& problem, const Limits& limits, double f, double delta) {
  if (f >= peak_load(problem.pulse)) {
    return false;
  }
  const Problem now = problem_at(problem, f);
  return stillpoint::design::admissible(now, {limits.f_max, limits.delta_max, 0}, f, delta);
}

/// The motion under the pulse itself, from rest.
bool holds_under_pulse(const PulseProblem& problem, double f, double delta) {
  const ForcedResponse motion =
      forced_response({problem.p, f, delta}, {}, excitation(problem.pulse));
  return motion.stops_at_zero && motion.half_cycles == 1.0 && motion.peak_amplitude <= problem.beta;
}

/// The whole box, at many points.
bool box_holds(const PulseProblem& problem, const Limits& limits, double f, double delta,
               double tolerance) {
  constexpr int steps = 8;
  for (int i = -steps; i <= steps; ++i) {
    for (int j = -steps; j <= steps; ++j) {
      const double f_here = f * (1 + tolerance * i / steps);
      const double delta_here = delta * (1 + tolerance * j / steps);
      if (!holds(problem, limits, f_here, delta_here) ||
          !holds_under_pulse(problem, f_here, delta_here)) {
        return false;
      }
    }
  }
  return true;
}

PulseRequest random_request(RandomSource& random) {
  PulseRequest request;
  const double p = random.log_uniform(1e-2, 1e2);
  const double k = random.log_uniform(1e-2, 1e2);
  const double lambda = p / random.log_uniform(1e-3, 1);
  if (random.pick(2) == 0) {
    request.problem.pulse = HalfSine{k, lambda};
  } else {
    request.problem.pulse = Rectangle{k, lambda};
  }
  request.problem.p = p;
  request.problem.criterion = random.pick(2) == 0 ? Criterion::published : Criterion::exact;
  request.problem.beta = 1;
  const double v0 = problem_at(request.problem, 0).v0;
  request.problem.beta = random.uniform(0.55, 1.5) * v0 / p;
  if (random.pick(2) == 0) {
    request.limits.tolerance = random.uniform(0, 0.35);
  }
  if (random.pick(4) == 0) {
    request.limits.f_max = random.uniform(0.1, 0.5) * v0 * p;
  }
  if (random.pick(4) == 0) {
    request.limits.delta_max = random.uniform(0.1, 0.6) * v0 * v0;
  }
  request.search.objective =
      std::array{Objective::robust, Objective::amplitude, Objective::time,
                 Objective::acceleration}[static_cast<std::size_t>(random.pick(4))];
  return request;
}

/// The grid points whose box is admissible: whether there are any, and the best objective.
struct Scan {
  bool any{false};
  double best{0};
};

double value_of(const PulseRequest& request, double f, double tolerance) {
  const Prediction motion = predict(problem_at(request.problem, f), f);
  switch (request.search.objective) {
    case Objective::robust:
      return -tolerance;
    case Objective::amplitude:
      return motion.peak_amplitude;
    case Objective::time:
      return motion.stop_time;
    case Objective::acceleration:
      break;
  }
  return motion.peak_acceleration;
}

bool corners_hold(const PulseRequest& request, double f, double delta, double tolerance) {
  const auto& [problem, limits, search] = request;
  // The design need not stop at the high corner.
  const double high = f * (1 + tolerance);
  const double v0 = v0_at(problem, high);
  const bool starts_and_returns = high * std::sqrt(8.0) <= v0 * problem.p &&
                                  delta * (1 + tolerance) <= v0 * v0 / 2 &&
                                  high <= limits.f_max.value_or(HUGE_VAL) &&
                                  delta * (1 + tolerance) <= limits.delta_max.value_or(HUGE_VAL);
  const double low = f * (1 - tolerance);
  const double low_delta = delta * (1 - tolerance);
  return starts_and_returns && holds(problem, limits, low, low_delta) &&
         holds(problem, limits, f, delta) && holds_under_pulse(problem, low, low_delta) &&
         holds_under_pulse(problem, high, low_delta);
}

Scan scan(const PulseRequest& request) {
  constexpr int steps = 30;
  const auto& [problem, limits, search] = request;
  const double v0 = v0_at(problem, 0);
  Scan result;
  for (int i = 1; i <= steps; ++i) {
    for (int j = 1; j < steps; ++j) {
      const double f = v0 * problem.p / std::sqrt(8.0) * i / steps;
      const double delta = v0 * v0 / 2 * j / steps;
      double tolerance = limits.tolerance;
      if (!corners_hold(request, f, delta, tolerance)) {
        continue;
      }
      if (search.objective == Objective::robust) {
        while (corners_hold(request, f, delta, tolerance + 1e-3)) {
          tolerance += 1e-3;
        }
      }
      const double value = value_of(request, f, tolerance);
      result.best = result.any ? std::min(result.best, value) : value;
      result.any = true;
    }
  }
  return result;
}

PulseRequest half_sine(double k, double lambda, double beta) {
  PulseRequest request;
  request.problem = {HalfSine{k, lambda}, 1, beta, Criterion::published};
  return request;
}

bool warns(const PulseCheck& check, PulseWarning warning) {
  return std::ranges::find(check.warnings, warning) != check.warnings.end();
}

PulseRequest mended(PulseRequest request, const Mend& mend) {
  const auto set = [&](auto change) { std::visit(change, request.problem.pulse); };
  if (mend.field == "k") {
    set([&](auto& kind) { kind.k = mend.value; });
  } else if (mend.field == "lambda") {
    set([&](auto& kind) { kind.lambda = mend.value; });
  } else if (mend.field == "p") {
    request.problem.p = mend.value;
  } else if (mend.field == "beta") {
    request.problem.beta = mend.value;
  } else if (mend.field == "f_max") {
    request.limits.f_max = mend.value;
  } else if (mend.field == "delta_max") {
    request.limits.delta_max = mend.value;
  } else {
    BOOST_REQUIRE(mend.field == "tolerance");
    request.limits.tolerance = mend.value;
  }
  return request;
}

}  // namespace

// With the velocity of its own f the design is the one that a plain task would have.
BOOST_AUTO_TEST_CASE(the_design_is_consistent_with_the_velocity_that_its_f_leaves) {
  const PulseRequest request = half_sine(0.5, 20, 0.05);
  const DesignResult result = stillpoint::design::design(request);
  const Finding& finding = result.finding.value();
  BOOST_TEST(result.request.problem.v0 == v0_at(request.problem, finding.point.f));
  BOOST_TEST(result.request.problem.v0 == finding.pulse.value().start.speed);
  BOOST_TEST(box_holds(request.problem, {}, finding.point.f, finding.point.delta,
                       finding.point.tolerance * (1 - 1e-12)));
  BOOST_TEST(!corners_hold(request, finding.point.f, finding.point.delta,
                           finding.point.tolerance * (1 + 1e-6)));
  // Friction takes 2 % of the velocity 2 k / lambda.
  BOOST_TEST(result.request.problem.v0 == 0.05, boost::test_tools::tolerance(0.03));
  BOOST_TEST(result.request.problem.v0 < 0.0495);
}

BOOST_AUTO_TEST_CASE(random_designs_hold_over_their_box_and_are_the_best_of_a_scan) {
  RandomSource random(20261121);
  int found = 0;
  int empty = 0;
  for (int i = 0; i < 300; ++i) {
    const PulseRequest request = random_request(random);
    const DesignResult result = stillpoint::design::design(request);
    const Scan best = scan(request);
    BOOST_TEST_CONTEXT("request " << i << " objective " << name(request.search.objective)) {
      if (!result.finding) {
        ++empty;
        BOOST_TEST(!best.any);
        BOOST_TEST(!result.reason.empty());
        for (const Mend& mend : result.mends) {
          BOOST_TEST_CONTEXT(mend.field << " = " << mend.value) {
            BOOST_TEST(stillpoint::design::design(mended(request, mend)).finding.has_value());
          }
        }
        continue;
      }
      ++found;
      const auto& [f, delta, tolerance] = result.finding->point;
      BOOST_TEST(tolerance >= request.limits.tolerance);
      BOOST_TEST(corners_hold(request, f, delta, request.limits.tolerance));
      BOOST_TEST(box_holds(request.problem, request.limits, f, delta,
                           std::min(0.999, tolerance) * (1 - 1e-12)) == true);
      if (best.any) {
        const double value = value_of(request, f, tolerance);
        BOOST_TEST(value <= best.best + inset * std::abs(best.best));
      }
      BOOST_TEST(result.finding->cross_check.passed);
    }
  }
  BOOST_TEST(found >= 150);
  BOOST_TEST(empty >= 30);
}

// docs/forced.md section 8: from above, by less than 0.55 (p / lambda)^2.
BOOST_AUTO_TEST_CASE(the_reduction_errs_to_the_safe_side_by_less_than_its_bound) {
  for (const double shortness : {1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01}) {
    for (const double part : {0.05, 0.3, 0.5, 0.7, 0.9, 0.97}) {
      for (const Pulse& pulse :
           {Pulse(HalfSine{0.5, 1 / shortness}), Pulse(Rectangle{0.5, 1 / shortness})}) {
        const PulseProblem problem{pulse, 1, 1, Criterion::exact};
        double f = 0;
        for (int i = 0; i < 200; ++i) {  // f = part of the largest, f3(V(f))
          f += 0.5 * (v0_at(problem, f) / std::sqrt(8.0) - f);
        }
        f *= part;
        const Problem now = problem_at(problem, f);
        const double delta = (delta1(now, f) + now.v0 * now.v0 / 2) / 2;
        const double peak = forced_response({1, f, delta}, {}, excitation(pulse)).peak_amplitude;
        const double error = predict(now, f).peak_amplitude / peak - 1;
        const double squared = shortness * shortness;
        const bool flat = std::holds_alternative<Rectangle>(pulse);
        // Taken relative to the reduced figure, so that it stays below 1 at p / lambda = 1.
        const double relative = error / (1 + error) / squared;
        BOOST_TEST_CONTEXT(name(pulse) << " p/lambda " << shortness << " part " << part) {
          BOOST_TEST(relative > (flat ? 0.36 : 0.21));
          BOOST_TEST(relative < (flat ? 0.55 : 0.31));
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_pulse_itself_is_a_third_method) {
  const DesignResult result = stillpoint::design::design(half_sine(0.5, 20, 0.05));
  const Finding& finding = result.finding.value();
  BOOST_REQUIRE(finding.cross_check.methods.size() == 3);
  const CheckMethod& method = finding.cross_check.methods[2];
  BOOST_TEST(method.name == "forced_pulse");
  BOOST_TEST(method.tolerance == 0.05 * 0.05, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(method.passed);
  BOOST_TEST(method.decided);
  const PulseCheck& check = finding.pulse.value();
  BOOST_TEST(check.shortness == 0.05);
  BOOST_TEST(check.friction_ratio == finding.point.f / 0.5);
  BOOST_TEST(check.response.stops_at_zero);
  BOOST_TEST(method.peak_amplitude == check.response.peak_amplitude);
  BOOST_TEST(method.stop_time == check.response.stop_time.value() - check.start.tau);
  BOOST_TEST(check.peak_error == predict(result.request.problem, finding.point.f).peak_amplitude /
                                         check.response.peak_amplitude -
                                     1);
  BOOST_TEST(check.warnings.empty());
  // A wrong figure of the forced run would not pass.
  BOOST_TEST(method.relative_error > 1e-4);
}

BOOST_AUTO_TEST_CASE(a_long_pulse_is_warned_of) {
  const DesignResult result = stillpoint::design::design(half_sine(0.5, 4, 0.3));
  BOOST_TEST(warns(result.finding.value().pulse.value(), PulseWarning::pulse_not_short));
}

BOOST_AUTO_TEST_CASE(friction_that_is_not_small_against_the_pulse_is_warned_of) {
  PulseRequest request;
  request.problem = {Rectangle{0.5, 3}, 1, 0.6, Criterion::published};
  request.search.objective = Objective::amplitude;
  const PulseCheck check = stillpoint::design::design(request).finding.value().pulse.value();
  BOOST_TEST(check.friction_ratio > 0.2);
  BOOST_TEST(warns(check, PulseWarning::friction_not_small));
}

// At f3 the reduced motion barely comes back, and the true one would fall short.
BOOST_AUTO_TEST_CASE(a_design_on_the_edge_stops_at_zero_under_the_pulse_itself) {
  for (const Objective objective :
       {Objective::robust, Objective::amplitude, Objective::time, Objective::acceleration}) {
    PulseRequest request = half_sine(0.5, 20, 0.05);
    request.search.objective = objective;
    const DesignResult result = stillpoint::design::design(request);
    const Finding& finding = result.finding.value();
    const double f3 = result.region.f3;
    BOOST_TEST(finding.pulse.value().response.stops_at_zero);
    BOOST_TEST(finding.cross_check.passed);
    BOOST_TEST(finding.point.f < f3);
    if (objective == Objective::amplitude) {  // wants the most friction
      BOOST_TEST(finding.point.f > f3 * (1 - 0.05 * 0.05));
      BOOST_TEST(!holds_under_pulse(request.problem, f3 * (1 - 1e-9), finding.point.delta));
    }
  }
}

// Barely feasible by its velocity, so that the pulse itself decides.
BOOST_AUTO_TEST_CASE(a_mend_holds_under_the_pulse_itself) {
  const DesignResult none = stillpoint::design::design(half_sine(0.5, 20, 0.02));
  BOOST_TEST(!none.finding.has_value());
  BOOST_TEST(none.mends.size() >= 3U);
  for (const Mend& mend : none.mends) {
    const DesignResult one = stillpoint::design::design(mended(half_sine(0.5, 20, 0.02), mend));
    const Finding& finding = one.finding.value();
    BOOST_TEST(finding.pulse.value().response.stops_at_zero, mend.field);
    BOOST_TEST(finding.pulse.value().response.half_cycles.value() == 1);
  }
}

BOOST_AUTO_TEST_CASE(what_is_left_for_f_holds_at_its_ends_and_not_beyond) {
  for (const auto& [pulse, beta] :
       std::vector<std::pair<Pulse, double>>{{HalfSine{0.5, 20}, 0.0357},
                                             {HalfSine{0.5, 20}, 0.05},
                                             {Rectangle{0.1, 8}, 0.0285},
                                             {HalfSine{0.5, 1.87}, 0.31}}) {
    PulseRequest request;
    request.problem = {pulse, 1, beta, Criterion::published};
    const Region region = stillpoint::design::design(request).region;
    BOOST_REQUIRE(region.feasible);
    // With the largest Delta that starts, which is the one that stops most surely.
    const auto fits = [&](double f) {
      const double v0 = v0_at(request.problem, f);
      return corners_hold(request, f, v0 * v0 / 2, 0);
    };
    BOOST_TEST(fits(region.f_lower.value()));
    BOOST_TEST(fits(region.f_upper.value()));
    BOOST_TEST(!fits(region.f_lower.value() * (1 - 1e-9)));
    BOOST_TEST(!fits(region.f_upper.value() * (1 + 1e-9)));
  }
}

BOOST_AUTO_TEST_CASE(an_empty_region_says_why_and_what_mends_it) {
  PulseRequest request;
  request.problem = {Rectangle{0.5, 20}, 1, 0.03, Criterion::published};
  request.limits.tolerance = 0.1;
  const DesignResult result = stillpoint::design::design(request);
  BOOST_TEST(!result.finding.has_value());
  BOOST_TEST(!result.region.feasible);
  BOOST_TEST(result.region.conflict == Conflict::amplitude_against_return);
  BOOST_TEST(result.reason.find("coming back to x = 0 needs") != std::string::npos);
  std::vector<std::string> fields;
  for (const Mend& mend : result.mends) {
    fields.emplace_back(mend.field);
    BOOST_TEST(stillpoint::design::design(mended(request, mend)).finding.has_value());
    // and a change by a little less does not
    Mend less = mend;
    less.value *= mend.upwards ? 1 - 1e-9 : 1 + 1e-9;
    BOOST_TEST(!stillpoint::design::design(mended(request, less)).finding.has_value());
  }
  BOOST_TEST((fields == std::vector<std::string>{"k", "lambda", "p", "beta"}));
}

// No mend of p or lambda goes beyond what a forced run can follow.
BOOST_AUTO_TEST_CASE(the_shortest_pulses_are_mended_too) {
  for (const double lambda : {1e6, 1.1e6, 1e9, 1e12}) {
    PulseRequest request;
    request.problem = {Rectangle{1, lambda}, 1, 1, Criterion::published};
    request.limits.delta_max = 1e-3 / (lambda * lambda);
    const DesignResult result = stillpoint::design::design(request);
    BOOST_TEST(!result.finding.has_value());
    BOOST_TEST(!result.mends.empty());
    for (const Mend& mend : result.mends) {
      BOOST_TEST(stillpoint::design::design(mended(request, mend)).finding.has_value(), mend.field);
    }
  }
}

BOOST_AUTO_TEST_CASE(wrong_pulses_are_refused_by_field) {
  const auto field_of = [](double k, double lambda, double p, double beta) -> std::string {
    PulseRequest request;
    request.problem = {HalfSine{k, lambda}, p, beta, Criterion::published};
    try {
      static_cast<void>(stillpoint::design::design(request));
    } catch (const InputError& error) {
      return error.field();
    }
    return "";
  };
  BOOST_TEST(field_of(0.5, 20, 1, 0.05).empty());
  BOOST_TEST(field_of(0, 20, 1, 0.05) == "k");
  BOOST_TEST(field_of(-0.5, 20, 1, 0.05) == "k");
  BOOST_TEST(field_of(std::nan(""), 20, 1, 0.05) == "k");
  BOOST_TEST(field_of(0.5, 0, 1, 0.05) == "lambda");
  BOOST_TEST(field_of(0.5, 1, 1, 1.5).empty());         // lambda = p
  BOOST_TEST(field_of(0.5, 0.99, 1, 1.5) == "lambda");  // below p
  BOOST_TEST(field_of(0.5, 1.1e12, 1, 0.05) == "lambda");
  BOOST_TEST(field_of(0.5, 20, -1, 0.05) == "p");
  BOOST_TEST(field_of(0.5, 20, 1, 0) == "beta");
  BOOST_TEST(field_of(0.5, 20, 1, HUGE_VAL) == "beta");
}

BOOST_AUTO_TEST_SUITE_END()
