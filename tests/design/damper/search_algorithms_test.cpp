// SPDX-License-Identifier: MIT
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(search_algorithms_test)

using namespace stillpoint::design_test;

/// How close every algorithm comes to the default one: of R absolute, of the others relative.
constexpr double algorithm_tolerance = 1e-3;

/// Of R, if a local search follows a global one: SBPLX stops at steps of 1e-10 of x.
constexpr double polished_tolerance = 1e-8;

struct Case {
  Problem problem;
  Limits limits;
};

std::vector<Case> cases() {
  return {{{1, 1, 0.8}, {}},
          {{1, 1, 1.1, Criterion::exact}, {std::nullopt, 0.3, 0.1}},
          {{700, 0.02, 33e3, Criterion::published}, {3.5, std::nullopt, 0}},
          {{2e-4, 30, 5.2e-6, Criterion::exact}, {std::nullopt, std::nullopt, 0.05}}};
}

SearchResult run(const Case& now, Objective objective,
                 const std::optional<std::string>& algorithm) {
  return search(now.problem, now.limits, {objective, algorithm, 20'000, 10}).value();
}

/// What NLopt itself found, to be minimised, and its size.
double by_nlopt(const SearchResult& result, Objective objective) {
  return result.record.by_nlopt.value() * (objective == Objective::robust ? -1 : 1);
}
double unit(double cost, Objective objective) {
  return objective == Objective::robust ? 1 : cost;
}

/// And repeats bit for bit.
BOOST_AUTO_TEST_CASE(every_algorithm_comes_near_the_default_one) {
  const auto bits = [](const SearchResult& of) {
    return std::tuple(of.point.f, of.point.delta, of.point.tolerance, of.record.evaluations,
                      of.record.status);
  };
  for (const Case& now : cases()) {
    BOOST_REQUIRE(admissible_region(now.problem, now.limits).feasible);
    for (const Objective objective : objectives) {
      const double best = by_nlopt(run(now, objective, {}), objective);
      for (const std::string_view algorithm : algorithm_names()) {
        BOOST_TEST_CONTEXT(algorithm << ", " << name(objective) << ", v0 = " << now.problem.v0) {
          const SearchResult result = run(now, objective, std::string(algorithm));
          const DesignPoint& point = result.point;
          BOOST_TEST(result.record.algorithm == algorithm);
          BOOST_TEST((bits(result) == bits(run(now, objective, std::string(algorithm)))));
          BOOST_TEST(result.record.evaluations > 0);
          BOOST_TEST(result.record.evaluations <= 20'000);
          BOOST_TEST(!result.record.status.starts_with("FAILURE"), result.record.status);
          BOOST_TEST(admissible(now.problem, now.limits, point.f, point.delta));
          BOOST_TEST(by_nlopt(result, objective) <=
                     best + algorithm_tolerance * unit(best, objective));
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_global_algorithm_ends_at_the_optimum_itself) {
  RandomSource random(602);
  // DIRECT_L alone misses R by 2e-6 and 8e-6 in these, whose regions are thin.
  std::vector<Case> list{{{13.5, 0.5, 20.2}, {}}, {{363, 0.118, 2414}, {}}};
  while (list.size() < 40) {
    list.push_back({random_feasible_problem(random), {}});
  }
  for (const Case& now : list) {
    const double best = run(now, Objective::robust, {}).record.by_nlopt.value();
    for (const char* algorithm : {"GN_DIRECT_L", "GN_CRS2_LM"}) {
      const SearchResult result = run(now, Objective::robust, algorithm);
      BOOST_TEST(result.record.by_nlopt.value() >= best - polished_tolerance,
                 algorithm << ": " << result.record.by_nlopt.value() << " of " << best << " at v0 "
                           << now.problem.v0 << ", p " << now.problem.p << ", beta "
                           << now.problem.beta);
      BOOST_TEST(result.record.evaluations <= 20'000);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_default_converges_in_a_few_evaluations) {
  RandomSource random(601);
  for (int i = 0; i < 200; ++i) {
    const Problem problem = random_feasible_problem(random);
    for (const Objective objective : objectives) {
      const SearchRecord record = run({problem, {}}, objective, {}).record;
      BOOST_TEST(record.algorithm == "LD_SLSQP");
      BOOST_TEST(record.evaluations <= 100,
                 name(objective) << " takes " << record.evaluations << ", v0 = " << problem.v0
                                 << ", p = " << problem.p << ", beta = " << problem.beta);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_spent_budget_still_gives_an_admissible_point_and_is_kept) {
  for (const Case& now : cases()) {
    for (const std::string_view algorithm : algorithm_names()) {
      const auto found =
          search(now.problem, now.limits, {Objective::robust, std::string(algorithm), 2, 10});
      const auto& [f, delta, tolerance] = found.value().point;
      BOOST_TEST(admissible(now.problem, now.limits, f, delta));
    }
  }
  Problem problem{1, 1, 0.9};
  problem.residual = 0.1;
  problem.arrivals = 3;
  for (const Objective objective : objectives) {
    for (const int budget : {1, 2, 5}) {
      const auto found = search(problem, {}, {objective, "LD_SLSQP", budget, 10});
      BOOST_TEST(found.value().record.evaluations <= budget, name(objective) << ", " << budget);
    }
  }
}

BOOST_AUTO_TEST_CASE(no_algorithm_and_no_budget_are_refused) {
  const auto refused = [](const SearchOptions& options, const std::string& field) {
    test::check_refused(field, [&] { return search({1, 1, 0.9}, {}, options); });
  };
  refused({Objective::robust, "", 100, 10}, "algorithm");
  const std::string text =
      refusal_of<InputError>([] { return run(cases()[0], Objective::robust, "LD_NOTHING"); });
  BOOST_TEST(text.starts_with("algorithm = LD_NOTHING"), text);
  check_contains(text, {"LD_SLSQP", "GN_DIRECT_L"});
  refused({Objective::robust, {}, 0, 10}, "max_evaluations");
  refused({Objective::robust, {}, 100, 0}, "max_seconds");
  refused({Objective::robust, {}, 100, std::nan("")}, "max_seconds");
}

BOOST_AUTO_TEST_SUITE_END()
