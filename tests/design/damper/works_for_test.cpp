// SPDX-License-Identifier: MIT
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(works_for_test)

namespace {

using namespace stillpoint::design_test;

/// Of an edge, relative: the formula's long double is exact, and `admissible` rounds its own edges
/// inwards by some ulps.
constexpr double edge_tolerance = 1e-13;

struct Point {
  Problem problem;
  Limits limits;
  double f;
  double delta;

  [[nodiscard]] bool holds() const { return admissible(problem, limits, f, delta); }
  [[nodiscard]] Point with_v0(double v0) const {
    Point now = *this;
    now.problem.v0 = v0;
    return now;
  }
  [[nodiscard]] Point with_p(double p) const {
    Point now = *this;
    now.problem.p = p;
    return now;
  }
  [[nodiscard]] WorksFor served() const { return works_for(problem, limits, f, delta).value(); }
};

Point random_point(RandomSource& random) {
  Point now{random_feasible_problem(random), {}, 0, 0};
  const Region region = admissible_region(now.problem);
  now.f = region.f3 * random.uniform(0, 1);
  now.delta = *region.delta2 * random.uniform(0, 1);
  random.one_in(3, now.limits.acceleration_max,
                [&] { return now.problem.v0 * now.problem.p * random.uniform(1, 1.2); });
  return now;
}

/// The last that holds on the way from `inside` to `outside`, by halving in 50 digits of the
/// paper's own formulas.
Precise bisected(const Point& now, Precise inside, Precise outside,
                 const std::function<bool(const Point&, const Precise&)>& holds) {
  for (int i = 0; i < 80; ++i) {
    const Precise middle = (inside + outside) / 2;
    (holds(now, middle) ? inside : outside) = middle;
  }
  return inside;
}

bool reference_holds(const Point& now, const Precise& v0, const Precise& p) {
  const Precise f(now.f);
  const Precise delta(now.delta);
  const Precise beta(now.problem.beta);
  const Precise s = sqrt(f * f + v0 * v0 * p * p);
  const bool exact = now.problem.criterion == Criterion::exact;
  const Precise delta1 = ((s - 2 * f) * (s - 2 * f) - (exact ? f * f : Precise(0))) / (2 * p * p);
  return f < beta * p * p && (s - f) <= beta * p * p && s >= 3 * f && 2 * delta <= v0 * v0 &&
         delta > delta1 && (!now.limits.acceleration_max || s <= *now.limits.acceleration_max);
}

bool holds_at_v0(const Point& now, const Precise& v0) {
  return reference_holds(now, v0, now.problem.p);
}

bool holds_at_p(const Point& now, const Precise& p) {
  return reference_holds(now, now.problem.v0, p);
}

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

}  // namespace

BOOST_AUTO_TEST_CASE(the_ends_are_those_of_bisection_in_50_digits) {
  RandomSource random(2301);
  int met = 0;
  for (int i = 0; i < 600; ++i) {
    const Point now = random_point(random);
    BOOST_TEST(works_for(now.problem, now.limits, now.f, now.delta).has_value() == now.holds());
    if (!now.holds()) {
      continue;
    }
    ++met;
    const auto& [v0, p] = now.served();
    const Precise speed(now.problem.v0);
    const Precise stiffness(now.problem.p);
    BOOST_TEST(close(v0.low, bisected(now, speed, 0, holds_at_v0), edge_tolerance));
    BOOST_TEST(close(*v0.high, bisected(now, speed, 3 * speed, holds_at_v0), edge_tolerance));
    BOOST_TEST(close(p.low, bisected(now, stiffness, stiffness / 1e9, holds_at_p), edge_tolerance));
    BOOST_TEST_REQUIRE(p.high.has_value());
    BOOST_TEST(close(*p.high, bisected(now, stiffness, 2 * Precise(*p.high), holds_at_p),
                     edge_tolerance * steepness(now)));
  }
  BOOST_TEST(met > 100);
}

BOOST_AUTO_TEST_CASE(both_ends_are_included_and_nothing_beyond_them) {
  RandomSource random(2302);
  constexpr double beyond = 2e-14;
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const Point now = random_point(random);
    if (!now.holds()) {
      continue;
    }
    ++met;
    const auto& [v0, p] = now.served();
    BOOST_TEST(v0.low <= now.problem.v0);
    BOOST_TEST(*v0.high >= now.problem.v0);
    BOOST_TEST(p.low <= now.problem.p);
    BOOST_TEST(*p.high >= now.problem.p);
    // The dead zone never binds: within beta, beta p^2 >= p^2 A >= 2 f, twice what it asks for.
    BOOST_TEST(now.problem.beta * p.low * p.low >= 2 * now.f * (1 - edge_tolerance));
    BOOST_TEST(now.with_v0(v0.low).holds());
    BOOST_TEST(now.with_v0(*v0.high).holds());
    BOOST_TEST(now.with_p(p.low).holds());
    BOOST_TEST(now.with_p(*p.high).holds());
    BOOST_TEST(!now.with_v0(v0.low * (1 - beyond)).holds());
    BOOST_TEST(!now.with_v0(*v0.high * (1 + beyond)).holds());
    BOOST_TEST(!now.with_p(p.low * (1 - beyond)).holds());
    BOOST_TEST(!now.with_p(*p.high * (1 + beyond * steepness(now))).holds());
  }
  BOOST_TEST(met > 300);
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
