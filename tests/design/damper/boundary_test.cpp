// SPDX-License-Identifier: MIT
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(boundary_test)

// The region's edges to the last bit, in the formulas and in the simulation.

using namespace stillpoint::design_test;

double below(double value) {
  return std::nextafter(value, 0.0);
}
double above(double value) {
  return std::nextafter(value, HUGE_VAL);
}

Response simulate(const Problem& problem, double f, double delta) {
  return free_response({problem.p, f, delta}, {0, problem.v0}, {.times = false});
}

bool stops_at_first_return(const Response& response) {
  return response.outcome == Outcome::stopped_at_zero && *response.half_cycles == 1;
}

/// A half-cycle in whole numbers: f^2 + (V0 p)^2 = S^2 with S >= 3 f, p = 1.
struct Triple {
  double f;
  double v0;
  double s;

  [[nodiscard]] double published() const { return (s - 2 * f) * (s - 2 * f) / 2; }
  [[nodiscard]] double exact() const { return (s - f) * (s - 3 * f) / 2; }
};

constexpr std::array<Triple, 4> triples{{{7, 24, 25}, {11, 60, 61}, {12, 35, 37}, {28, 96, 100}}};

/// Of edges in long double, relative: some roundings of 64 bits.
const Precise wide_rounding = Precise(0x1p-61);

// At f3 and next to it, where 1 - 8 a^2 cancels and Delta1 is a rounding of V0^2.
BOOST_AUTO_TEST_CASE(delta_1_at_f3_is_right_to_the_last_bit) {
  RandomSource random(409);
  for (int i = 0; i < 3000; ++i) {
    Problem problem = random_problem(random, 2, 3);
    problem.criterion = Criterion::exact;
    const Reference reference(problem);
    double f = admissible_region(problem).f3;
    BOOST_TEST(!delta1_exact(problem, above(f)));
    BOOST_TEST((Precise(f) <= reference.f3() && Precise(above(f)) > reference.f3()));
    for (int ulps = 0; ulps < 3; ++ulps, f = below(f)) {
      const Precise delta1 = reference.delta1_exact(f);
      auto stops = static_cast<double>(delta1);
      stops = stops > delta1 ? below(stops) : stops;
      BOOST_TEST(!admissible(problem, {}, f, stops));
      BOOST_TEST(admissible(problem, {}, f, above(above(stops))));
    }
  }
}

// Also where beta p is nearly V0, and A_max nearly p V0, by more than the inputs' own rounding.
BOOST_AUTO_TEST_CASE(small_edges_of_stroke_and_acceleration_keep_their_digits) {
  RandomSource random(410);
  for (int i = 0; i < 3000; ++i) {
    Problem problem = random_problem(random, 2, 3);
    const double little = random.log_uniform(0x1p-50, 0x1p-20);
    problem.beta = problem.v0 / problem.p * (1 - little);
    const Reference reference(problem);
    const double more = i % 2 == 0 ? little : random.log_uniform(0x1p-20, 10);
    const Limits limits{.acceleration_max = problem.v0 * problem.p * (1 + more)};
    const Region region = admissible_region(problem, limits);
    BOOST_TEST(Precise(region.f2) >= reference.f2() * (1 - wide_rounding));
    BOOST_TEST(Precise(below(region.f2)) < reference.f2() * (1 + wide_rounding));
    const Precise felt = Precise(problem.v0) * problem.p;
    const Precise most = *limits.acceleration_max;
    const Precise f4 = sqrt((most - felt) * (most + felt));
    BOOST_TEST(Precise(*region.f4) <= f4 * (1 + wide_rounding));
    BOOST_TEST(Precise(above(*region.f4)) > f4 * (1 - wide_rounding));
  }
}

BOOST_AUTO_TEST_CASE(delta_of_a_whole_number_triple_tips_both_bounds_at_the_last_bit) {
  for (const Triple& t : triples) {
    for (const double scale : {0x1p-30, 1.0, 0x1p30}) {  // of lengths
      const double f = t.f * scale;
      const Problem published{t.v0 * scale, 1, 10 * t.v0 * scale, Criterion::published};
      const Problem exact{t.v0 * scale, 1, 10 * t.v0 * scale, Criterion::exact};
      const double at_published = t.published() * scale * scale;
      const double at_exact = t.exact() * scale * scale;
      BOOST_TEST(delta1_published(published, f) == at_published);
      BOOST_TEST(delta1_exact(exact, f).value() == at_exact);
      BOOST_TEST(!admissible(published, {}, f, at_published));
      BOOST_TEST(admissible(published, {}, f, above(at_published)));
      BOOST_TEST(!admissible(exact, {}, f, at_exact));
      BOOST_TEST(admissible(exact, {}, f, above(at_exact)));
      // The published bound is safe on both sides; at the exact one the motion changes. At
      // v_-^2 = 2 Delta itself it stops, but the region excludes that, because it has no tolerance.
      BOOST_TEST(stops_at_first_return(simulate(exact, f, below(at_published))));
      BOOST_TEST(constraints(published, f, below(at_published))[4].by_criterion_alone);
      BOOST_TEST(constraints(published, f, above(at_exact))[4].by_criterion_alone);
      BOOST_TEST(!constraints(published, f, below(at_exact))[4].by_criterion_alone);
      BOOST_TEST(stops_at_first_return(simulate(exact, f, at_exact)));
      BOOST_TEST(*simulate(exact, f, below(at_exact)).zero_passages >= 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_largest_delta_that_starts_is_the_last_double_below_the_exact_one) {
  RandomSource random(306);
  int square_is_above = 0;
  for (int i = 0; i < 20000; ++i) {
    const double v0 =
        i % 2 == 0 ? random.log_uniform(smallest_speed, largest_speed) : random.uniform(0.5, 2);
    const Problem problem{.v0 = v0, .p = 1, .beta = v0};
    const double delta = *admissible_region(problem).delta2;
    const Precise exact = Precise(v0) * Precise(v0) / 2;
    BOOST_TEST(Precise(delta) <= exact);
    BOOST_TEST(Precise(above(delta)) > exact);
    square_is_above += Precise(v0 * v0 / 2) > exact;
    // An ulp of v0 is several of the square.
    const double f = v0 / 4;
    BOOST_TEST(!admissible(problem, {}, f, above(delta)));
    const auto served = works_for(problem, {}, f, delta);
    BOOST_TEST_REQUIRE(served.has_value());
    BOOST_TEST(served->hit.low <= v0);
    BOOST_TEST(Precise(served->hit.low) * Precise(served->hit.low) >= 2 * Precise(delta));
    BOOST_TEST(Precise(below(served->hit.low)) * Precise(below(served->hit.low)) <
               2 * Precise(delta));
    BOOST_TEST(simulate(problem, f, delta).outcome == Outcome::stopped_at_zero);
    BOOST_TEST(simulate(problem, f, above(delta)).outcome == Outcome::caught_at_start);
    const auto caught = forced_response({1, f, above(delta)}, {0, v0}, Rectangle{v0, 1});
    BOOST_TEST(caught.outcome == Outcome::caught_at_start);
  }
  BOOST_TEST(square_is_above > 5000);
}

BOOST_AUTO_TEST_SUITE_END()
