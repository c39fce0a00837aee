// SPDX-License-Identifier: MIT
#include "damper.hpp"
#include "scan.hpp"

BOOST_AUTO_TEST_SUITE(acceleration_limit_test)

namespace {

using namespace stillpoint::design_test;

/// Of S, relative: f4 is rounded inwards once, from inputs that are taken as decimals where they
/// would leave rounding alone.
constexpr double s_tolerance = 1e-15;

Limits at_most(double acceleration, double tolerance = 0) {
  Limits limits;
  limits.acceleration_max = acceleration;
  limits.tolerance = tolerance;
  return limits;
}

}  // namespace

BOOST_AUTO_TEST_CASE(f4_is_where_s_meets_the_limit) {
  RandomSource random(2501);
  for (int i = 0; i < 1000; ++i) {
    const Problem problem = random_problem(random, 0.3, 3);
    const double limit = problem.v0 * problem.p * (1 + random.log_uniform(1e-12, 10));
    const Region region = admissible_region(problem, at_most(limit));
    BOOST_TEST_REQUIRE(region.f4.has_value());
    BOOST_TEST(close(limit, Reference(problem).s(*region.f4), s_tolerance));
    BOOST_TEST(Reference(problem).s(*region.f4) <= Precise(limit) * (1 + s_tolerance));
    // It is the only change to the rows.
    const auto rows = constraints(problem, at_most(limit), region.f3 / 2, *region.delta2 / 2);
    BOOST_TEST(rows.size() == 6U);
    BOOST_TEST(rows.back().name == "acceleration");
    BOOST_TEST(rows.back().limit == *region.f4);
    BOOST_TEST(rows.back().satisfied == (region.f3 / 2 <= *region.f4));
  }
  BOOST_TEST(!admissible_region({1, 1, 1}).f4.has_value());
}

BOOST_AUTO_TEST_CASE(no_friction_is_small_enough_where_the_spring_alone_exceeds_the_limit) {
  const Problem problem{13, 1, 30};
  const Limits limits = at_most(12);
  const Region region = admissible_region(problem, limits);
  BOOST_TEST(!region.feasible);
  BOOST_TEST((region.conflict == Conflict::limit_alone));
  BOOST_TEST(region.limit->field == "acceleration_max");
  BOOST_TEST(*region.f4 == -5);
  BOOST_TEST((reason(region, problem, limits)
                  ->find("even without friction the transmitted acceleration is 13 g, above the "
                         "limit of 12 g") != std::string::npos));
  // Of springs with p of 12 to 13, the stiffest decides.
  const Problem springs{.v0 = 1, .p = 12, .beta = 30, .p_high = 13};
  const auto of_stiffest =
      reason(admissible_region(springs, at_most(12.5)), springs, at_most(12.5));
  BOOST_TEST((of_stiffest->find("is 13 g, above the limit of 12.5 g") != std::string::npos),
             *of_stiffest);
  BOOST_TEST(!constraints(problem, limits, 0, 50).back().satisfied);
  BOOST_TEST(!largest_tolerance(problem, limits, 1, 80));
  // At equality S = A needs f = 0, which leaves no Delta.
  const Region touching = admissible_region(problem, at_most(13));
  BOOST_TEST((touching.conflict == Conflict::stop_against_start));
  const DesignResult none = design::design({problem, limits});
  BOOST_TEST(!none.finding);
  BOOST_TEST(none.mends.size() == 3U);  // v0, p, acceleration_max
}

BOOST_AUTO_TEST_CASE(amplitude_and_acceleration_may_conflict) {
  // f2 = 7 with V0 = 24, p = 1, beta = 18; A = 24.5: f4^2 = 24.25.
  const Problem problem{24, 1, 18};
  const Region region = admissible_region(problem, at_most(24.5));
  BOOST_TEST((region.conflict == Conflict::amplitude_against_limit));
  BOOST_TEST(region.limit->field == "acceleration_max");
  BOOST_TEST((
      reason(region, problem, at_most(24.5))
          ->find("needs f >= 7, but a transmitted acceleration within 24.5 g needs f <= 4.92442") !=
      std::string::npos));
  BOOST_TEST(admissible_region(problem, at_most(25)).feasible);  // 7-24-25
  BOOST_TEST(!admissible_region(problem, at_most(25, 1e-9)).feasible);
  const auto list = mends(problem, at_most(24.5));
  const auto limit = std::ranges::find(list, "acceleration_max", &Mend::field);
  BOOST_TEST_REQUIRE((limit != list.end()));
  BOOST_TEST(std::abs(limit->value - 25) < 1e-14);
}

/// A larger p helps the amplitude and harms the acceleration: what fits is an interval of p.
BOOST_AUTO_TEST_CASE(the_mend_of_p_is_the_nearest_of_a_scan) {
  RandomSource random(2502);
  constexpr double step = 1.0005;
  std::array<int, 3> seen{};
  for (int i = 0; i < 400; ++i) {
    const Problem problem = random_problem(random, 0.5, 1.2);
    const Limits limits = at_most(problem.v0 * problem.p * random.uniform(0.7, 1.2),
                                  random.pick(2) * random.uniform(0, 0.3));
    if (admissible_region(problem, limits).feasible) {
      continue;
    }
    const auto feasible = [&](double factor) {
      Problem now = problem;
      now.p *= factor;
      return admissible_region(now, limits).feasible;
    };
    std::optional<double> nearest;
    for (double factor = step; factor < 5 && !nearest; factor *= step) {
      nearest = feasible(factor)       ? std::optional(factor)
                : feasible(1 / factor) ? std::optional(1 / factor)
                                       : std::nullopt;
    }
    const auto list = mends(problem, limits);
    const auto mend = std::ranges::find(list, "p", &Mend::field);
    if (nearest) {
      BOOST_TEST_REQUIRE((mend != list.end()), "a scan found p times " << *nearest);
      ++seen.at(*nearest > 1 ? 0 : 1);
      BOOST_TEST(std::abs(mend->value / problem.p / *nearest - 1) < step - 1);
    } else if (mend == list.end()) {
      ++seen.at(2);
    } else {
      BOOST_TEST(feasible(mend->value / problem.p * (1 + (mend->upwards ? 1e-12 : -1e-12))) ==
                 feasible(mend->value / problem.p));
    }
  }
  for (const int count : seen) {
    BOOST_TEST(count > 5);
  }
}

BOOST_AUTO_TEST_CASE(each_design_meets_the_limit_over_its_box_and_no_better_one_is_missed) {
  RandomSource random(2503);
  constexpr double scan_tolerance = 2e-3;
  int met = 0;
  for (int i = 0; i < 60; ++i) {
    const Problem problem = random_feasible_problem(random);
    const Limits limits = at_most(problem.v0 * problem.p * random.uniform(1, 1.1),
                                  random.pick(2) * random.uniform(0, 0.1));
    const DesignResult result = design::design({problem, limits});
    if (!result.finding) {
      BOOST_TEST(result.reason.has_value());
      continue;
    }
    ++met;
    const auto& [f, delta, tolerance] = result.finding->point;
    BOOST_TEST(admissible(problem, limits, f, delta));
    BOOST_TEST(result.finding->cross_check.passed);
    // What the mass feels at the box's worst corner, by the motion itself.
    const double worst = f * (1 + std::max(limits.tolerance, tolerance));
    const Response motion = free_response({problem.p, worst, delta}, {0, problem.v0});
    BOOST_TEST(worst + problem.p * motion.peak_amplitude * problem.p <=
               *limits.acceleration_max * (1 + 1e-13));
    // f4 is a limit of f like f_max.
    Limits by_f = limits;
    by_f.f_max = admissible_region(problem, limits).f4;
    by_f.acceleration_max = std::nullopt;
    const double best = -static_cast<double>(Scan(problem, by_f).least_cost(Objective::robust));
    BOOST_TEST(tolerance >= best * (1 - scan_tolerance));
  }
  BOOST_TEST(met > 50);
}

BOOST_AUTO_TEST_SUITE_END()
