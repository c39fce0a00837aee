// SPDX-License-Identifier: MIT
#include "any_task.hpp"
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(mends_test)

using namespace stillpoint::design_test;

/// A change smaller by this, relative to the change, must not suffice.
constexpr double smaller = 1e-9;

std::map<std::string, double> mends_of(const Task& now) {
  std::map<std::string, double> list;
  for (const Mend& mend : mends(now.problem, now.limits)) {
    BOOST_TEST(list.emplace(mend.field, mend.value).second);
  }
  return list;
}

Task random_task(RandomSource& random) {
  Task now{random_problem(random, 0.3, 3), {}};
  const Region region = admissible_region(now.problem);
  random.one_in(2, now.limits.f_max, [&] { return region.f3 * random.log_uniform(1e-3, 2); });
  random.one_in(2, now.limits.delta_max,
                [&] { return *region.delta2 * random.log_uniform(1e-3, 2); });
  random.one_in(2, now.limits.tolerance, [&] { return random.uniform(0, 0.6); });
  random.one_in(3, now.limits.acceleration_max,
                [&] { return now.problem.v0 * now.problem.p * random.log_uniform(0.5, 2); });
  return now;
}

std::vector<std::string> fields_of(const Task& now) {
  std::vector<std::string> list{"v0", "p", "beta"};
  for (const LimitKind& kind : limit_kinds()) {
    if (now.limits.*kind.value) {
      list.emplace_back(kind.field);
    }
  }
  if (now.limits.tolerance > 0) {
    list.emplace_back("tolerance");
  }
  return list;
}

/// Where no input mends alone, the largest tolerance is that of a stroke of any size without
/// limits.
BOOST_AUTO_TEST_CASE(where_no_input_mends_the_largest_tolerance_of_any_damper_is_known) {
  RandomSource random(1109);
  int seen = 0;
  for (int i = 0; i < 2000; ++i) {
    const Task now = random_task(random);
    const RegionAnswer found = answer({.problem = now.problem, .limits = now.limits});
    BOOST_TEST((!found.largest_tolerance || found.mends.empty()));
    if (now.feasible() || !found.mends.empty() || found.criterion_mend) {
      continue;
    }
    ++seen;
    const double most = found.largest_tolerance.value();
    BOOST_TEST(most < now.limits.tolerance);
    Task wide{now.problem, {.tolerance = most}};
    wide.problem.beta = 1e9 * wide.problem.v0 / wide.problem.p;
    BOOST_TEST(wide.with("tolerance", most * (1 - smaller)).feasible());
    BOOST_TEST(!wide.with("tolerance", most * (1 + smaller)).feasible());
  }
  BOOST_TEST(seen > 30);
}

/// Constant friction alone stops no mass at x = 0, whatever else is changed.
BOOST_AUTO_TEST_CASE(without_a_notch_a_residual_is_the_mend) {
  RandomSource random(1112);
  for (int i = 0; i < 200; ++i) {
    Task now = random_task(random);
    now.limits.delta_max = 0;
    now.problem.arrivals = 1 + random.pick(3);
    BOOST_TEST(!now.feasible());
    const RegionAnswer found = answer({.problem = now.problem, .limits = now.limits});
    BOOST_TEST(found.reason.value().ends_with("allow a residual"));
    const auto list = mends_of(now);
    BOOST_TEST((!list.contains("v0") && !list.contains("p") && !list.contains("beta")));
    if (const auto mend = list.find("residual"); mend != list.end()) {
      now.problem.residual = mend->second;
      BOOST_TEST(now.feasible());
      now.problem.residual = mend->second * (1 - smaller);
      BOOST_TEST(!now.feasible());
    }
  }
  // V0 = p = 1: from f3 on the mass does not come back, and rests at 3 f - S. So the box of 10 %
  // begins at f3 and rests within that of its other end.
  const double f = 1.1 / 0.9 / std::sqrt(8.0);
  const auto list = mends_of({{1, 1, 0.85, Criterion::exact}, {.delta_max = 0, .tolerance = 0.1}});
  BOOST_TEST(list.at("residual") == 3 * f - std::sqrt(1 + f * f), tt::tolerance(1e-14));
}

/// Offered if and only if the same task has a damper with the exact Delta1.
BOOST_AUTO_TEST_CASE(the_exact_criterion_is_offered_where_it_alone_mends) {
  RandomSource random(1111);
  int offered = 0;
  int refused = 0;
  for (int i = 0; i < 4000; ++i) {
    const Task now = random_task(random);
    if (now.feasible()) {
      BOOST_TEST(!criterion_mend(now.problem, now.limits));
      continue;
    }
    Task exact = now;
    exact.problem.criterion = Criterion::exact;
    BOOST_TEST(criterion_mend(now.problem, now.limits).has_value() ==
               (now.problem.criterion == Criterion::published && exact.feasible()));
    BOOST_TEST(!criterion_mend(exact.problem, exact.limits));
    ++(exact.feasible() ? offered : refused);
  }
  BOOST_TEST(offered > 30);
  BOOST_TEST(refused > 500);
  // Delta1 published is 1/16 at f3, exact it is 0 there.
  const Task narrow{{1, 1, 2}, {std::nullopt, 0.01, 0}};
  BOOST_TEST((criterion_mend(narrow.problem, narrow.limits) == Criterion::exact));
}

BOOST_AUTO_TEST_CASE(every_mend_mends_and_no_smaller_change_does) {
  RandomSource random(1102);
  std::map<std::string, int> met;
  int lowered = 0;  // of p, which amplitude wants larger, and the stop under f_max smaller
  for (int i = 0; i < 2400; ++i) {
    const bool one_hit = i < 2000;
    Task now = one_hit ? random_task(random) : any_task(random);
    now.problem.beta *= one_hit ? 1 : 0.8;
    const Region region = admissible_region(now.problem, now.limits);
    BOOST_TEST(reason(region, now.problem, now.limits).has_value() == !region.feasible);
    BOOST_TEST((region.conflict == Conflict::none) == region.feasible);
    const auto list = mends_of(now);
    BOOST_TEST((list.empty() || !now.feasible()));
    for (const auto& [field, value] : list) {
      ++met[one_hit ? field : "in ranges"];
      if (!one_hit) {
        const Task mended = now.with(field, value);
        BOOST_TEST_CONTEXT(field << " = " << value << ", " << context_of(now)) {
          BOOST_TEST(mended.feasible());
          BOOST_TEST(search(mended.problem, mended.limits).has_value());
          BOOST_TEST((!now.with(field, value * (1 - 1e-6)).feasible() ||
                      !now.with(field, value * (1 + 1e-6)).feasible()));
        }
        continue;
      }
      if (field == "arrivals") {
        Task more = now;
        for (more.problem.arrivals = 2; static_cast<double>(more.problem.arrivals) < value;
             ++more.problem.arrivals) {
          BOOST_TEST(!more.feasible());
        }
        BOOST_TEST(more.feasible());
        continue;
      }
      const double old = Task(now).input(field);
      lowered += field == "p" && value < old ? 1 : 0;
      BOOST_TEST_CONTEXT(field << " from " << old << " to " << value) {
        BOOST_TEST(now.with(field, value).feasible());
        const double less = value + (old - value) * smaller;
        BOOST_TEST((less == value || !now.with(field, less).feasible()));
        BOOST_TEST(!now.with(field, std::nextafter(value, old)).feasible());
        for (int k = 1; k < 30; ++k) {
          BOOST_TEST(!now.with(field, old + (value - old) * k / 30).feasible());
          // Nor is a change the other way smaller: what fits may be an interval of p.
          const double factor = std::pow(old / value, k / 30.0);
          BOOST_TEST((field != "p" || !now.with(field, old * factor).feasible()));
        }
      }
    }
  }
  for (const char* field :
       {"v0", "p", "beta", "f_max", "delta_max", "tolerance", "arrivals", "in ranges"}) {
    BOOST_TEST(met[field] > 50, field << " met " << met[field] << " times");
  }
  BOOST_TEST((lowered > 20 && lowered < met["p"] - 20), lowered << " of " << met["p"]);
}

BOOST_AUTO_TEST_CASE(what_is_not_listed_cannot_mend_alone) {
  RandomSource random(1103);
  int unlisted = 0;
  for (int i = 0; i < 500; ++i) {
    const Task now = random_task(random);
    if (now.feasible()) {
      continue;
    }
    const auto list = mends_of(now);
    for (const std::string& field : fields_of(now)) {
      if (list.contains(field)) {
        continue;
      }
      ++unlisted;
      const double old = Task(now).input(field);
      for (int k = -200; k <= 200; ++k) {
        const double value = field == "tolerance" ? (k + 200) / 401.0 : old * std::pow(1.05, k);
        BOOST_TEST(!now.with(field, value).feasible(), field << " = " << value << " would mend");
      }
    }
  }
  BOOST_TEST(unlisted > 100);
}

// p V0 alone is 948 g, so that no f at all is left below the limit.
BOOST_AUTO_TEST_CASE(a_limit_of_the_acceleration_below_p_v0_is_mended_for_several_arrivals) {
  const Problem problem{58.025323666135705, 16.336770498866795, 7.4187136861399212,
                        Criterion::exact, 5};
  const Limits limits{.tolerance = 0.01, .acceleration_max = 938.363};
  BOOST_TEST((admissible_region(problem, limits).conflict == Conflict::limit_alone));
  const auto list = mends(problem, limits);
  const auto mend = std::ranges::find(list, "acceleration_max", &Mend::field);
  BOOST_REQUIRE((mend != list.end()));
  BOOST_TEST(mend->value >= problem.p * problem.v0);
}

BOOST_AUTO_TEST_SUITE_END()
