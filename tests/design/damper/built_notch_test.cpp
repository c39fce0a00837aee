// SPDX-License-Identifier: MIT
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(built_notch_test)

using namespace stillpoint::design_test;

/// Every hit up to v0.
DesignRequest random_request(RandomSource& random) {
  DesignRequest request;
  Problem& problem = request.problem;
  problem = random_problem(random, 0.75, 2);
  problem.criterion = Criterion::exact;
  problem.arrivals = 1 + random.pick(4);
  problem.v0_low = 0;
  random.one_in(2, problem.p_high, [&] { return problem.p * (1 + random.uniform(0, 0.1)); });
  problem.residual = problem.v0 / problem.p * random.log_uniform(1e-3, 0.5);
  random.one_in(2, request.limits.delta_max,
                [&] { return problem.v0 * problem.v0 * random.log_uniform(0.003, 0.5); });
  return request;
}

/// docs/notches.md, rule 3.
ForcedResponse motion_after(const DesignPoint& damper, double width, double v0, double p) {
  const auto& [f, delta, tolerance] = damper;
  const bool caught = v0 * v0 <= 2 * delta;
  const Surface surface =
      caught ? Surface{{}, {{width / 2, f + delta / width}}} : Surface{width, {}};
  return forced_response({p, f, caught ? 0 : delta}, {0, v0}, NoExcitation(), {}, surface);
}

/// Nor goes farther, or is felt more.
BOOST_AUTO_TEST_CASE(no_hit_up_to_the_strongest_rests_farther_than_is_said) {
  int seen = 0;
  for (std::uint64_t seed = 1'300'000; seed < 1'300'200; ++seed) {
    RandomSource random(seed);
    const DesignRequest request = random_request(random);
    const DesignResult result = design::design(request);
    if (!result.finding) {
      continue;
    }
    ++seen;
    const DesignPoint& damper = result.finding->point;
    const double peak = result.finding->response.peak_amplitude;
    const double width = peak * random.log_uniform(1e-3, 0.4);
    const WorstMotions said = built_notch(result, {width, {}}).worst.value();
    for (const TriedMotion& worst : {said.farthest, said.peak, said.felt}) {
      const ForcedResponse again = motion_after(damper, width, worst.v0, worst.p);
      BOOST_TEST(again.peak_amplitude == worst.response.peak_amplitude);
      BOOST_TEST(again.stop_position.value_or(0) == worst.rest());
      BOOST_TEST(worst.from_inside == (worst.v0 * worst.v0 <= 2 * damper.delta));
    }
    constexpr int hits = 400;
    double farthest = 0;
    double most = 0;
    double felt = 0;
    for (const double p : {request.problem.p, request.problem.stiffest_p()}) {
      for (int i = 1; i <= hits; ++i) {
        const ForcedResponse motion = motion_after(damper, width, request.problem.v0 * i / hits, p);
        farthest = std::max(farthest, std::abs(motion.stop_position.value_or(0)));
        most = std::max(most, motion.peak_amplitude);
        felt = std::max(felt, motion.peak_absolute_acceleration);
      }
    }
    constexpr double resolved = 0.02;
    BOOST_TEST_CONTEXT("seed " << seed << ", peak " << peak) {
      BOOST_TEST(farthest <= std::abs(said.farthest.rest()) * (1 + resolved));
      BOOST_TEST(most <= said.peak.response.peak_amplitude * (1 + 1e-12));
      BOOST_TEST(felt <= said.felt.response.peak_absolute_acceleration * (1 + resolved));
    }
  }
  BOOST_TEST(seen > 50);
}

BOOST_AUTO_TEST_SUITE_END()
