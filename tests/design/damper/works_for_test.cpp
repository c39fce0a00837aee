// SPDX-License-Identifier: MIT
#include "any_task.hpp"
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(works_for_test)

using namespace stillpoint::design_test;

struct Point {
  Problem problem;
  Limits limits;
  double f;
  double delta;

  [[nodiscard]] bool holds() const { return admissible(problem, limits, f, delta); }
  [[nodiscard]] Point with_v0(double v0) const {
    Point now = *this;
    now.problem.v0 = v0;
    if (now.problem.v0_low != 0.0) {
      now.problem.v0_low.reset();
    }
    return now;
  }
  [[nodiscard]] Point with_p(double p) const {
    Point now = *this;
    now.problem.p = p;
    now.problem.p_high.reset();
    return now;
  }
  [[nodiscard]] WorksFor served() const { return works_for(problem, limits, f, delta).value(); }
};

/// Towards Delta2 the upper edge of p runs away: it is f/phi with phi in proportion to V0^2 -
/// 2 Delta, so an ulp of Delta moves it by this many.
double steepness(const Point& now) {
  return 1 / (1 - 2 * now.delta / now.problem.v0 / now.problem.v0);
}

const Point plain{{1, 1, 0.8}, {}, 0.26, 0.37};

/// The name of the only condition that is violated just beyond an edge.
std::string binding(const Point& beyond) {
  std::string names;
  for (const Constraint& now : constraints(beyond.problem, beyond.limits, beyond.f, beyond.delta)) {
    names += now.satisfied ? "" : std::string(now.name);
  }
  return names;
}

/// Of one hit, of ranges and with a residual.
BOOST_AUTO_TEST_CASE(both_ends_are_included_and_nothing_beyond_them) {
  RandomSource random(2302);
  int met = 0;
  int in_ranges = 0;
  for (int i = 0; i < 30'000; ++i) {
    const Task task = i % 2 == 0 ? one_hit_task(random) : any_task(random);
    const Problem& problem = task.problem;
    const bool one_hit = i % 2 == 0;
    const Point now{problem, with_tolerance(task.limits, 0),
                    problem.v0 * problem.p * random.log_uniform(0.01, 0.5),
                    problem.v0 * problem.v0 * random.uniform(0, 0.5)};
    const auto served = works_for(now.problem, now.limits, now.f, now.delta);
    BOOST_TEST(served.has_value() == now.holds());
    if (!served) {
      continue;
    }
    ++met;
    in_ranges += problem.v0_low || problem.p_high;
    const bool plain_one = one_hit && problem.arrivals == 1;
    const double beyond = plain_one ? 2e-14 : 1e-9;
    const double above = beyond * (plain_one ? steepness(now) : 1);
    BOOST_TEST_CONTEXT(context_of(task) << ", f = " << now.f << ", delta = " << now.delta) {
      const auto& [v0, p, load] = *served;
      BOOST_TEST((load == ServedLoad::v0));
      BOOST_TEST(v0.low <= problem.v0_low.value_or(problem.v0));
      BOOST_TEST(*v0.high >= problem.v0);
      BOOST_TEST(p.low <= problem.p);
      BOOST_TEST(p.high.value_or(HUGE_VAL) >= problem.stiffest_p());
      BOOST_TEST((problem.v0_low == 0.0 || now.with_v0(v0.low).holds()));
      BOOST_TEST(now.with_v0(*v0.high).holds());
      for (const double inside : {p.low, p.high.value_or(p.low)}) {
        BOOST_TEST(now.with_p(inside).holds());
      }
      BOOST_TEST((problem.v0_low == 0.0 || !now.with_v0(v0.low * (1 - beyond)).holds()));
      BOOST_TEST(!now.with_v0(*v0.high * (1 + beyond)).holds());
      BOOST_TEST(!now.with_p(p.low * (1 - beyond)).holds());
      BOOST_TEST((!p.high || (!plain_one && steepness(now) > 1e5) ||
                  !now.with_p(*p.high * (1 + above)).holds()));
    }
  }
  BOOST_TEST(met > 2000);
  BOOST_TEST(in_ranges > 500);
}

BOOST_AUTO_TEST_CASE(each_requirement_binds_at_its_end) {
  constexpr double beyond = 1e-9;
  const auto below = [](const ServedInterval& of) { return of.low * (1 - beyond); };
  const auto above = [](const ServedInterval& of) { return *of.high * (1 + beyond); };
  const auto by_v0 = [](const Point& now, const auto& side) {
    return binding(now.with_v0(side(now.served().hit)));
  };
  const auto by_p = [](const Point& now, const auto& side) {
    return binding(now.with_p(side(now.served().p)));
  };
  Point wide = plain;
  wide.problem.beta = 2;
  Point soft = wide;
  soft.limits.acceleration_max = 1.05;
  Point weak = wide;  // sqrt(2 Delta) < sqrt(8) f
  weak.f = 0.34;
  weak.delta = 0.3;
  BOOST_TEST(by_v0(plain, below) == "start");  // sqrt(0.74) > sqrt(8) 0.26
  BOOST_TEST(by_v0(weak, below) == "return");
  BOOST_TEST(by_v0(plain, above) == "amplitude");
  BOOST_TEST(by_v0(wide, above) == "stop");
  BOOST_TEST(by_v0(soft, above) == "acceleration");
  BOOST_TEST(by_p(plain, below) == "amplitude");
  BOOST_TEST(by_p(wide, below) == "return");
  BOOST_TEST(by_p(plain, above) == "stop");
  BOOST_TEST(by_p(soft, above) == "acceleration");
  // By hand: V0^2 <= beta (beta p^2 + 2 f), p^2 >= (V0^2 - 2 beta f)/beta^2.
  BOOST_TEST(close(*plain.served().hit.high, sqrt(Precise(0.8) * (Precise(0.8) + 0.52)), 1e-15));
  BOOST_TEST(
      close(plain.served().p.low, sqrt(1 - Precise(1.6) * Precise(0.26)) / Precise(0.8), 1e-15));
  BOOST_TEST(
      close(*soft.served().p.high, sqrt(Precise(1.05) * 1.05 - Precise(0.26) * 0.26), 1e-15));
}

BOOST_AUTO_TEST_CASE(f_max_and_the_tolerance_change_no_end_but_an_inadmissible_point_has_none) {
  Point now = plain;
  now.limits = {0.27, 0.38, 0.5};
  BOOST_TEST(now.served().hit.low == plain.served().hit.low);
  BOOST_TEST(*now.served().p.high == *plain.served().p.high);
  now.limits.f_max = 0.25;
  BOOST_TEST(!works_for(now.problem, now.limits, now.f, now.delta));
  BOOST_TEST(!works_for(plain.problem, {}, 0.36, 0.37));
  BOOST_TEST(!works_for(plain.problem, {}, 0, 0.5));
}

BOOST_AUTO_TEST_CASE(at_delta2_the_hit_may_not_be_weaker_and_no_spring_is_too_stiff) {
  const Point now{{1, 1, 2}, {}, 0.26, 0.5};
  BOOST_TEST(now.served().hit.low == 1);
  BOOST_TEST(!now.served().p.high.has_value());
  BOOST_TEST(now.with_p(1e6).holds());
}

BOOST_AUTO_TEST_CASE(a_range_of_one_value_is_that_value) {
  for (const auto& [f, delta] : {std::pair(0.26, 0.37), std::pair(0.06, 0.2)}) {
    const Problem one{1, 1, 0.95, Criterion::exact, 3};
    Problem range = one;
    range.v0_low = range.p_high = 1;
    const WorksFor expected = works_for(one, {}, f, delta).value();
    const WorksFor found = works_for(range, {}, f, delta).value();
    BOOST_TEST(found.hit.low == expected.hit.low);
    BOOST_TEST(*found.hit.high == *expected.hit.high);
    BOOST_TEST(found.p.low == expected.p.low);
    BOOST_TEST(*found.p.high == *expected.p.high);
  }
}

BOOST_AUTO_TEST_CASE(the_ends_of_the_valid_inputs_are_no_error) {
  int met = 0;
  for (const double v0 : {1e-150, 1e150}) {
    for (const double p : {1e-150, 1e-3, 1e3, 1e150}) {
      const double beta = v0 / p;
      if (!(beta >= 1e-300 && beta <= 1e300 && v0 / beta * v0 <= 1e305)) {
        continue;
      }
      const Point now{{v0, p, beta}, {}, 0.26 * v0 * p, 0.37 * v0 * v0};
      if (now.f <= 1e300 && now.delta <= 1e300 && now.delta > 0) {
        const auto served = works_for(now.problem, now.limits, now.f, now.delta);
        met += served.has_value();
        BOOST_TEST(served.has_value() == now.holds());
        BOOST_TEST((!served || served->hit.low <= v0));
      }
    }
  }
  BOOST_TEST(met > 0);
}

BOOST_AUTO_TEST_SUITE_END()
