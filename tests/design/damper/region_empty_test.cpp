// SPDX-License-Identifier: MIT
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(region_empty_test)

using namespace stillpoint::design_test;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
/// Relative: within this, long double may put an edge on the wrong side of a double.
constexpr double long_double_doubt = 1e-18;

/// Whether some double lies between f2 and f3, both taken exactly.
bool holds_a_double(const Problem& problem) {
  const Reference reference(problem);
  auto f = static_cast<double>(reference.f3());
  if (Precise(f) > reference.f3()) {
    f = std::nextafter(f, 0.0);
  }
  return Precise(f) >= reference.f2();
}

void check_explained(const Problem& problem, const Limits& limits, Conflict conflict,
                     const std::vector<std::string>& words) {
  const Region region = admissible_region(problem, limits);
  BOOST_TEST(!region.feasible);
  BOOST_TEST(region.conflict == conflict);
  BOOST_TEST((!region.f_lower && !region.f_upper));
  check_contains(reason(region, problem, limits).value(), words);
}

BOOST_AUTO_TEST_CASE(the_region_is_not_empty_exactly_from_beta_min_on) {
  RandomSource random(201);
  int in_doubt = 0;
  constexpr int count = 1000;
  for (int i = 0; i < count; ++i) {
    Problem problem = random_problem(random, 1, 2);
    const double least = admissible_region(problem).beta_min;
    const auto feasible_at = [&](double beta) {
      problem.beta = beta;
      return admissible_region(problem).feasible;
    };
    BOOST_TEST(feasible_at(least));
    BOOST_TEST(feasible_at(std::nextafter(least, HUGE_VAL)));
    BOOST_TEST(!feasible_at(std::nextafter(least, 0.0)));
    BOOST_TEST(admissible_region(problem).conflict == Conflict::amplitude_against_return);
    // beta_min is the first double that leaves a double between f2 and f3.
    for (const double beta : {std::nextafter(least, 0.0), least}) {
      problem.beta = beta;
      in_doubt += holds_a_double(problem) != feasible_at(beta);
    }
    // Never below condition (10).
    BOOST_TEST(
        (Precise(least) >= Reference(problem).beta_min() * (1 - Precise(long_double_doubt))));
  }
  BOOST_TEST(in_doubt <= count / 100);
}

BOOST_AUTO_TEST_CASE(every_conflict_is_explained) {
  const auto none = std::nullopt;
  // f2 = (1 - 0.25)/1 = 0.75, f3 = 0.353553.
  check_explained({1, 1, 0.5}, {}, Conflict::amplitude_against_return,
                  {"f >= 0.75", "f <= 0.353553"});
  // f2 = 0.225 and f3 = 0.3536 do not fit with 25 %: 0.281 > 0.265.
  check_explained({1, 1, 0.8}, {none, none, 0.25}, Conflict::amplitude_against_return,
                  {"tolerance of 25 %"});
  check_explained({1, 1, 0.8}, {0.2, none, 0}, Conflict::amplitude_against_limit,
                  {"f >= 0.225", "f may be at most 0.2"});
  // With a residual: f2 = 0.75 and f1 = 0.5; f2 = 0.533, f1 = 0.6 and (55) up to (0.3 +
  // sqrt(8.01))/8.
  Problem within{1, 1, 0.5};
  within.residual = 0.45;
  check_explained(within, {}, Conflict::amplitude_against_dead_zone,
                  {"f >= 0.75", "unless f < 0.5"});
  within.beta = 0.6;
  within.residual = 0.1;
  check_explained(within, {}, Conflict::amplitude_against_return,
                  {"f >= 0.533334",
                   "if friction cannot hold the mass there, coming to rest within the residual "
                   "needs f <= 0.391274"});
  // f <= 0.01 leaves a strip of 4 %, too narrow for +-10 %.
  check_explained({1, 1, 1.1}, {0.01, none, 0.1}, Conflict::stop_against_start,
                  {"stop", "start", "delta <= 0.5", "tolerance of 10 %"});
  // Even at f3 the published Delta1 is 1/16.
  check_explained({1, 1, 1.1}, {none, 0.06, 0}, Conflict::stop_against_limit,
                  {"stop", "delta may be at most 0.06", "0.0625"});
  const Problem exact{1, 1, 1.1, Criterion::exact};
  BOOST_TEST(admissible_region(exact, {none, 0.06, 0}).feasible);
}

/// At most f = sqrt(A^2 - (p V0)^2) transmits A: none does below p V0 of the stiffest spring, and
/// at p V0 f = 0, which leaves no Delta.
BOOST_AUTO_TEST_CASE(every_conflict_with_the_acceleration_is_explained) {
  const auto at_most = [](double acceleration, double tolerance = 0) {
    return Limits{.tolerance = tolerance, .acceleration_max = acceleration};
  };
  const Problem stiff{13, 1, 30};
  check_explained(stiff, at_most(12), Conflict::limit_alone,
                  {"even without friction the transmitted acceleration is 13 g, above the limit of "
                   "12 g"});
  BOOST_TEST(*admissible_region(stiff, at_most(12)).f4 == -5);
  BOOST_TEST(!constraints(stiff, at_most(12), 0, 50).back().satisfied);
  check_explained({.v0 = 1, .p = 12, .beta = 30, .p_high = 13}, at_most(12.5),
                  Conflict::limit_alone, {"is 13 g, above the limit of 12.5 g"});
  check_explained(stiff, at_most(13), Conflict::stop_against_start, {});
  // f2 = 7; A = 24.5: f4^2 = 24.25; 7-24-25.
  const Problem triple{24, 1, 18};
  check_explained(
      triple, at_most(24.5), Conflict::amplitude_against_limit,
      {"needs f >= 7, but a transmitted acceleration within 24.5 g needs f <= 4.92442"});
  BOOST_TEST(admissible_region(triple, at_most(25)).feasible);
  BOOST_TEST(!admissible_region(triple, at_most(25, 1e-9)).feasible);
}

BOOST_AUTO_TEST_CASE(an_amplitude_missed_by_an_ulp_is_explained_in_all_digits) {
  Problem problem{1, 1, 1};
  problem.beta = std::nextafter(admissible_region(problem).beta_min, 0.0);
  const Region region = admissible_region(problem);
  BOOST_TEST(!region.feasible);
  // Nothing to see in six digits, so more are shown.
  BOOST_TEST(reason(region, problem)->find("0.353553 ") == std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_reason_is_in_the_units_asked_for) {
  const Problem problem{1, 1, 1.1};
  const Limits limits{std::nullopt, 0.06, 0};
  const std::string text =
      reason(admissible_region(problem, limits), problem, limits, {1000, "mm", 2, "m/s"}).value();
  BOOST_TEST(text.find("delta > 62.5 mm, but delta may be at most 60 mm") != std::string::npos,
             text);
}

BOOST_AUTO_TEST_CASE(a_region_narrower_than_rounding_is_explained) {
  Region region;
  region.conflict = Conflict::narrower_than_rounding;
  BOOST_TEST((reason(region, {1, 1, 1})->find("narrower than rounding") != std::string::npos));
}

BOOST_AUTO_TEST_CASE(what_the_limits_leave_of_f_agrees_with_admissible) {
  constexpr double step = 1e-9;
  RandomSource random(203);
  int met = 0;
  for (int i = 0; i < 3000; ++i) {
    const Problem problem = random_feasible_problem(random);
    const double f3 = admissible_region(problem).f3;
    const double delta2 = *admissible_region(problem).delta2;
    Limits limits;
    limits.tolerance = random.pick(2) == 0 ? 0 : random.uniform(0, 0.3);
    limits.delta_max = random.uniform(0.05, 1.1) * delta2;
    random.one_in(2, limits.f_max, [&] { return random.uniform(0.2, 1.1) * f3; });
    const Region region = admissible_region(problem, limits);
    const double cap = std::min(delta2, *limits.delta_max) * (1 - 1e-15) / (1 + limits.tolerance);
    const auto fits = [&](double f) { return admissible(problem, limits, f, cap); };
    if (!region.feasible) {
      for (int k = 0; k <= 40; ++k) {
        BOOST_TEST(!fits(f3 * k / 40));
      }
      continue;
    }
    ++met;
    const double lower = *region.f_lower;
    const double upper = *region.f_upper;
    BOOST_TEST(fits(upper));
    BOOST_TEST(!fits(upper * (1 + step)));
    BOOST_TEST(!fits(lower * (1 - step)));
    BOOST_TEST(fits(std::min(upper, lower * (1 + step) + step * f3)));
  }
  BOOST_TEST(met > 1000);
}

BOOST_AUTO_TEST_CASE(wrong_input_is_refused_with_the_name_of_its_field) {
  for (const double wrong : {0.0, -1.0, 1e-151, 1e151, double(HUGE_VAL), not_a_number}) {
    test::check_refused("v0", [&] { return admissible_region({wrong, 1, 1}); });
    test::check_refused("p", [&] { return admissible_region({1, wrong, 1}); });
  }
  for (const double wrong : {0.0, -1.0, 1e-301, 1e301, double(HUGE_VAL), not_a_number}) {
    test::check_refused("beta", [&] { return admissible_region({1, 1, wrong}); });
    for (const LimitKind& kind : limit_kinds()) {
      if (kind.least() == 0 && wrong >= 0 && wrong < 1) {
        continue;  // without a notch
      }
      Limits limits;
      limits.*kind.value = wrong;
      test::check_refused(std::string(kind.field), [&] {
        return admissible_region({1, 1, 1}, limits);
      });
    }
  }
  for (const double wrong : {-0.1, 1.0, double(HUGE_VAL), not_a_number}) {
    test::check_refused("tolerance", [&] {
      return admissible_region({1, 1, 1}, {std::nullopt, std::nullopt, wrong});
    });
  }
  test::check_refused("beta", [] { return admissible_region({1e100, 1e140, 1e20}); });     // p beta
  test::check_refused("beta", [] { return admissible_region({1e-150, 1e-140, 1e-20}); });  // p beta
  test::check_refused("beta", [] { return admissible_region({1e100, 1, 1e-50}); });  // p beta / v0
  test::check_refused("beta", [] {
    return admissible_region({1e150, 1e100, 1e-8});
  });  // v0^2 / beta
  for (const double wrong : {-0.1, 1e301, double(HUGE_VAL), not_a_number}) {
    test::check_refused("f", [&] { return constraints({1, 1, 1}, wrong, 0.1); });
    test::check_refused("f", [&] { return delta1_published({1, 1, 1}, wrong); });
    test::check_refused("f", [&] { return delta1_exact({1, 1, 1}, wrong); });
    test::check_refused("delta", [&] { return constraints({1, 1, 1}, 0.1, wrong); });
  }
}

BOOST_AUTO_TEST_CASE(no_constraint_is_ever_nan) {
  for (const double f : {0.0, 1e-300, 1.0, 1e160, 1e300}) {
    for (const Problem& problem :
         {Problem{1e-150, 1e-150, 1}, Problem{1, 1, 1}, Problem{1e150, 1e150, 1}}) {
      for (const Constraint& constraint : constraints(problem, f, 1e300)) {
        BOOST_TEST(!std::isnan(constraint.limit));
        BOOST_TEST(!std::isnan(constraint.slack));
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
