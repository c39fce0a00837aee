// SPDX-License-Identifier: MIT
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(catalogue_test)

// The truth about a part is its own simulation, and the order of the values that the parts have.

namespace {

using namespace stillpoint::design_test;

/// Relative; nearer to an edge than that, the rounding of the simulation decides.
constexpr double undecided_within = 1e-9;

struct Shop {
  Problem problem;
  Limits limits;
  std::vector<Part> parts;
};

Shop random_shop(RandomSource& random, int size) {
  Shop shop{random_problem(random, 0.75, 1.5), {}, {}};
  shop.problem.criterion = Criterion::exact;  // which the simulation knows
  shop.problem.arrivals = 1 + random.pick(3);
  shop.limits.tolerance = random.pick(2) == 0 ? 0 : random.uniform(0, 0.2);
  const double p_v0 = shop.problem.p * shop.problem.v0;
  random.one_in(3, shop.limits.f_max, [&] { return random.uniform(0.1, 0.4) * p_v0; });
  random.one_in(3, shop.limits.delta_max,
                [&] { return random.uniform(0.2, 0.6) * shop.problem.v0 * shop.problem.v0; });
  random.one_in(3, shop.limits.acceleration_max, [&] { return random.uniform(1.01, 1.07) * p_v0; });
  for (int i = 0; i < size; ++i) {
    shop.parts.push_back({"part " + std::to_string(i), random.uniform(0, 0.45) * p_v0,
                          random.uniform(0, 0.6) * shop.problem.v0 * shop.problem.v0});
  }
  return shop;
}

/// By simulation: it stops at x = 0 in time, within beta and the limits.
bool works(const Shop& shop, double f, double delta) {
  const auto& [problem, limits, parts] = shop;
  if (problem.v0 * problem.v0 < 2 * delta) {
    return false;
  }
  const Response motion = free_response({problem.p, f, delta}, {0, problem.v0});
  return motion.outcome == Outcome::stopped_at_zero && motion.half_cycles <= problem.arrivals &&
         motion.peak_amplitude <= problem.beta && f <= limits.f_max.value_or(HUGE_VAL) &&
         delta <= limits.delta_max.value_or(HUGE_VAL) &&
         motion.peak_absolute_acceleration <= limits.acceleration_max.value_or(HUGE_VAL);
}

/// The value that the objective minimises, from the simulation.
double part_value(const Shop& shop, Objective objective, const RatedPart& rated) {
  return objective == Objective::robust
             ? -rated.tolerance.value()
             : value_of(objective, free_response({shop.problem.p, rated.part.f, rated.part.delta},
                                                 {0, shop.problem.v0}));
}

std::vector<std::string> names_of(const std::vector<RatedPart>& parts) {
  std::vector<std::string> names;
  names.reserve(parts.size());
  for (const RatedPart& rated : parts) {
    names.push_back(rated.part.name);
  }
  return names;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_part_is_judged_as_it_moves) {
  RandomSource random(21);
  int fit = 0;
  int fail = 0;
  for (int i = 0; i < 40; ++i) {
    const Shop shop = random_shop(random, 50);
    for (const RatedPart& rated :
         ranked(shop.problem, shop.limits, Objective::robust, shop.parts)) {
      const auto& [name, f, delta] = rated.part;
      const bool moves_right = works(shop, f, delta);
      if (moves_right != works(shop, f * (1 + undecided_within), delta) ||
          moves_right != works(shop, f * (1 - undecided_within), delta)) {
        continue;
      }
      BOOST_TEST_CONTEXT(name << ", f = " << f << ", delta = " << delta) {
        BOOST_TEST(rated.tolerance.has_value() == moves_right);
        BOOST_TEST(rated.violated.empty() == moves_right);
        BOOST_TEST(rated.admissible ==
                   (rated.tolerance && *rated.tolerance >= shop.limits.tolerance));
        for (const double r : {0.0, rated.tolerance.value_or(0) * 0.999}) {
          for (int corner = 0; corner < 4 && moves_right; ++corner) {
            BOOST_TEST(works(shop, f * (1 + (corner % 2 == 0 ? r : -r)),
                             delta * (1 + (corner < 2 ? r : -r))));
          }
        }
        for (const Constraint& now : rated.violated) {
          BOOST_TEST(!now.satisfied);
        }
        (rated.admissible ? fit : fail) += 1;
      }
    }
  }
  BOOST_TEST(fit > 100);
  BOOST_TEST(fail > 100);
}

BOOST_AUTO_TEST_CASE(the_order_is_that_of_the_objective) {
  RandomSource random(22);
  int compared = 0;
  for (int i = 0; i < 40; ++i) {
    const Shop shop = random_shop(random, 60);
    for (const Objective objective : objectives) {
      const auto parts = ranked(shop.problem, shop.limits, objective, shop.parts);
      BOOST_TEST_REQUIRE(parts.size() == shop.parts.size());
      const auto fits = [](const RatedPart& rated) { return rated.admissible; };
      const auto stands = [](const RatedPart& rated) { return rated.tolerance.has_value(); };
      BOOST_TEST(std::is_partitioned(parts.begin(), parts.end(), fits));
      BOOST_TEST(std::is_partitioned(parts.begin(), parts.end(), stands));
      for (std::size_t k = 1; k < parts.size(); ++k) {
        if (parts[k].admissible) {
          ++compared;
          BOOST_TEST(part_value(shop, objective, parts[k - 1]) <=
                     part_value(shop, objective, parts[k]));
        } else if (parts[k].tolerance && !parts[k - 1].admissible) {
          BOOST_TEST(*parts[k - 1].tolerance >= *parts[k].tolerance);
        }
      }
      std::vector<std::string> names = names_of(parts);
      std::ranges::sort(names);
      BOOST_TEST((std::ranges::adjacent_find(names) == names.end()));
    }
  }
  BOOST_TEST(compared > 500);
}

BOOST_AUTO_TEST_CASE(equals_keep_their_order_and_the_nearest_miss_is_first_of_those_that_fail) {
  // At beta = 0.9, f2 = 0.10556; f3 = 0.35355, Delta2 = 0.5.
  const std::vector<Part> parts{{"far in f", 0.02, 0.501}, {"far", 0.01, 0.45},
                                {"near", 0.1, 0.45},       {"twin 1", 0.2, 0.45},
                                {"twin 2", 0.2, 0.45},     {"too strong", 0.36, 0.45}};
  const auto all = ranked({1, 1, 0.9}, {}, Objective::acceleration, parts);
  const std::vector<std::string> names = names_of(all);
  // f2/f - 1: 10.6, 4.28 and 0.056, which is worse than delta/Delta2 - 1 = 0.002; f/f3 - 1: 0.018.
  const std::vector<std::string> expected{"twin 1", "twin 2",   "too strong",
                                          "near",   "far in f", "far"};
  BOOST_TEST(names == expected, tt::per_element());
  BOOST_TEST_REQUIRE(all[2].violated.size() == 1U);
  BOOST_TEST(all[2].violated[0].name == "return");
  BOOST_TEST(all[3].violated[0].name == "amplitude");
}

BOOST_AUTO_TEST_CASE(the_best_part_is_the_design) {
  RandomSource random(23);
  int designs = 0;
  for (int i = 0; i < 60; ++i) {
    const Shop shop = random_shop(random, 30);
    DesignRequest request{shop.problem, shop.limits};
    request.search.objective = random_objective(random);
    const Choice choice = choose(request, shop.parts);
    const RatedPart& best = choice.parts.front();
    BOOST_TEST(choice.result.finding.has_value() == best.admissible);
    BOOST_TEST(choice.result.reason.has_value() != best.admissible);
    if (!best.admissible) {
      continue;
    }
    ++designs;
    const Found& finding = *choice.result.finding;
    BOOST_TEST(finding.point.f == best.part.f);
    BOOST_TEST(finding.point.delta == best.part.delta);
    BOOST_TEST(finding.point.tolerance == *best.tolerance);
    BOOST_TEST(finding.cross_check.passed);
    BOOST_TEST(!finding.search.has_value());
    BOOST_TEST(finding.works_for.has_value());
    // No part is better than the best damper of any size.
    const DesignResult any = design::design(request);
    BOOST_TEST_REQUIRE(any.finding.has_value());
    if (request.search.objective == Objective::robust) {
      BOOST_TEST(any.finding->point.tolerance >= finding.point.tolerance - undecided_within);
    }
  }
  BOOST_TEST(designs > 20);
}

BOOST_AUTO_TEST_CASE(a_mend_is_the_least_change_that_lets_a_part_in) {
  RandomSource random(24);
  int mended = 0;
  int more_arrivals = 0;
  for (int i = 0; i < 200; ++i) {
    const Shop shop = random_shop(random, 4);
    const auto any_fits = [&](const Problem& problem, const Limits& limits) {
      return std::ranges::any_of(shop.parts, [&](const Part& part) {
        return admissible(problem, limits, part.f, part.delta);
      });
    };
    const auto mends = part_mends(shop.problem, shop.limits, shop.parts);
    if (any_fits(shop.problem, shop.limits)) {
      BOOST_TEST(mends.empty());
      continue;
    }
    for (const Mend& mend : mends) {
      Problem problem = shop.problem;
      if (mend.field == "arrivals") {
        problem.arrivals = static_cast<std::int64_t>(mend.value);
        BOOST_TEST(any_fits(problem, shop.limits));
        --problem.arrivals;
        BOOST_TEST(!any_fits(problem, shop.limits));
        ++more_arrivals;
        continue;
      }
      Task now{problem, shop.limits};
      double& input = now.input(mend.field);
      BOOST_TEST(mend.upwards == (mend.value > input));
      BOOST_TEST(mend.upwards == (mend.field != "tolerance"));
      input = mend.value;
      BOOST_TEST(any_fits(now.problem, now.limits), mend.field << " = " << mend.value);
      input = std::nextafter(mend.value, mend.upwards ? 0 : 1);
      BOOST_TEST(!any_fits(now.problem, now.limits), mend.field << " = " << mend.value << ", less");
      ++mended;
    }
  }
  BOOST_TEST(mended > 50);
  BOOST_TEST(more_arrivals > 5);
}

BOOST_AUTO_TEST_CASE(the_largest_values_are_judged_and_mended_in_doubles) {
  const std::vector<Part> parts{{"strong", 1e150, 0.45}, {"held", 0.2, 1e299}};
  const Limits limits{.f_max = 0.3, .delta_max = 0.4, .tolerance = 0.1, .acceleration_max = 1.05};
  const Choice none = choose({{1, 1, 0.9}, limits}, parts);
  for (const RatedPart& rated : none.parts) {
    BOOST_TEST(!rated.violated.empty());
    for (const Constraint& now : rated.violated) {
      BOOST_TEST(std::isfinite(now.limit));
      BOOST_TEST(std::isfinite(now.slack));
    }
  }
  BOOST_TEST(none.result.mends.empty());
}

BOOST_AUTO_TEST_CASE(what_does_not_come_back_is_not_judged_by_delta1) {
  // At f > f3 the published Delta1 is (S - 2f)^2/2 > 0, and means nothing.
  const std::vector<Part> strong{{"strong", 0.36, 1e-9}};
  const auto rated = ranked({1, 1, 0.9}, {}, Objective::robust, strong);
  BOOST_TEST_REQUIRE(rated[0].violated.size() == 1U);
  BOOST_TEST(rated[0].violated[0].name == "return");
}

BOOST_AUTO_TEST_CASE(if_no_part_fits_the_reason_says_so) {
  const std::vector<Part> weak{{"weak", 0.1, 0.45}};
  const Choice none = choose({{1, 1, 0.9}}, weak);
  BOOST_TEST(none.result.region.feasible);
  BOOST_TEST(none.result.reason.value() == "the only part of the catalogue is not admissible");
  // The stroke of f = 0.1 is sqrt(1 + f^2) - f.
  BOOST_TEST_REQUIRE(none.result.mends.size() == 1U);
  BOOST_TEST(none.result.mends[0].field == "beta");
  BOOST_TEST(std::abs(none.result.mends[0].value - (std::sqrt(1.01) - 0.1)) < 1e-15);
}

BOOST_AUTO_TEST_CASE(refuses_what_it_cannot_judge) {
  BOOST_CHECK_THROW((void)choose({{1, 1, 0.9}}, {}), InputError);
  for (const Part& wrong :
       {Part{"negative", -0.2, 0.45}, Part{"strong", 1e200, 0.45}, Part{"huge", 0.2, HUGE_VAL}}) {
    BOOST_CHECK_THROW((void)choose({{1, 1, 0.9}}, std::vector{wrong}), InputError);
  }
}

BOOST_AUTO_TEST_SUITE_END()
