// SPDX-License-Identifier: MIT
#include "damper.hpp"
#include "pulse_task.hpp"

BOOST_AUTO_TEST_SUITE(pulse_region_test)

// The region of a pulse without a design, and dampers compared with it: the region is that of the
// design, and the dampers stand as their own motions say.

using namespace stillpoint::design_test;
using Names = std::set<std::string_view>;

/// Known by hand: f from 0.1 to 0.25 with beta = 0.8, peak A = 1 - 2 f, w^2 = A (A - 2 f).
RegionRequest half_period(double beta = 0.8) {
  return {.problem = {0, 1, beta, Criterion::exact}, .pulse = Rectangle{0.5, 1}};
}

RegionAnswer at(RegionRequest request, double f, double delta) {
  request.f = f;
  request.delta = delta;
  return answer(request);
}

Names violated(const RegionAnswer& answer) {
  Names names;
  for (const Constraint& now : answer.constraints) {
    if (!now.satisfied) {
      names.insert(now.name);
    }
  }
  return names;
}

RegionRequest region_of(const PulseRequest& request) {
  const auto& [problem, limits, search] = request;
  RegionRequest region{{0, problem.p, problem.beta, problem.criterion},
                       limits,
                       {},
                       {},
                       problem.pulse,
                       problem.ranges};
  region.problem.p_high = problem.p_high;
  return region;
}

void check_same(const RegionVerdict& region, const RegionVerdict& of_design) {
  const auto numbers = [](const RegionVerdict& of) {
    const Region& now = of.region;
    const DesignPoint most = of.most_tolerant.value_or(DesignPoint());
    std::vector<double> all{now.f1,
                            now.f2,
                            now.f3,
                            now.delta2.value_or(-1),
                            now.f_lower.value_or(-1),
                            now.f_upper.value_or(-1),
                            now.beta_min,
                            most.f,
                            most.tolerance};
    for (const Mend& mend : of.mends) {
      all.push_back(mend.value);
    }
    for (const Interval& interval : of.intervals.value()) {
      all.insert(all.end(), {interval.low, interval.high});
    }
    return all;
  };
  BOOST_TEST(numbers(region) == numbers(of_design), tt::per_element());
  BOOST_TEST((region.region.conflict == of_design.region.conflict));
  BOOST_TEST((region.reason == of_design.reason));
}

/// How far the damper is from an edge of the truth, as a part of what is compared.
bool near_an_edge(const PulseRequest& request, double f, double delta) {
  constexpr double near = 1e-9;
  for (const double f_side : {1 - near, 1 + near}) {
    for (const double delta_side : {1 - near, 1 + near}) {
      if (admissible(request, f * f_side, delta * delta_side) != admissible(request, f, delta)) {
        return true;
      }
    }
  }
  return false;
}

BOOST_AUTO_TEST_CASE(edges_and_limits_divide_what_is_admissible_from_what_is_not) {
  constexpr double aside = 1e-9;
  constexpr double need = 0.65 * 0.3 / 2;
  const Limits limited{.f_max = 0.2, .delta_max = 0.4, .acceleration_max = 0.805};  // f + A = 1 - f
  struct Row {
    double f;
    double delta;
    Names names{};
    Limits limits{};
  };
  for (const auto& [f, delta, names, limits] :
       {Row{0.1 * (1 - aside), 1, {"amplitude"}}, Row{0.1 * (1 + aside), 1},
        Row{0.25 * (1 - aside), 1}, Row{0.25 * (1 + aside), 1, {"return"}},
        Row{0.175, need * (1 - aside), {"stop"}}, Row{0.175, need * (1 + aside)},
        Row{0, 1, {"amplitude"}}, Row{0.21, 0.3, {"f_max"}, limited},
        Row{0.2, 0.41, {"delta_max"}, limited}, Row{0.19, 0.3, {"acceleration"}, limited},
        // What never starts violates that alone.
        Row{0.5, 1, {"start"}, {.acceleration_max = 1e-3}}, Row{5, 1, {"start"}, {.f_max = 9}}}) {
    RegionRequest task = half_period();
    task.limits = limits;
    const RegionAnswer found = at(task, f, delta);
    BOOST_TEST_CONTEXT("f = " << f << ", delta = " << delta) {
      BOOST_TEST((violated(found) == names));
      BOOST_TEST(found.admissible.value() == names.empty());
      BOOST_TEST((!names.contains("start") || (!found.delta1_exact && !found.tolerance)));
    }
  }
}

// The largest box about the middle of f from 0.1 to 0.25 is 3/7.
BOOST_AUTO_TEST_CASE(the_tolerance_asked_for_decides) {
  RegionRequest task = half_period();
  task.limits.tolerance = 3.0 / 7 - 1e-9;
  BOOST_TEST(at(task, 0.175, 0.49).admissible.value());
  task.limits.tolerance = 3.0 / 7 + 1e-9;
  const RegionAnswer lacking = at(task, 0.175, 0.49);
  BOOST_TEST(!lacking.admissible.value());
  BOOST_TEST(violated(lacking).empty());
  BOOST_TEST(lacking.tolerance.value() == 3.0 / 7, tt::tolerance(1e-8));
  // f may be off upwards alone: from 0.175 to 0.25, by 3/7 of it.
  task.limits.tolerance = 0;
  shape_box(task.limits, spread_of_factors("tolerance-f", 1, 1.42), std::nullopt);
  BOOST_TEST(at(task, 0.175, 0.49).admissible.value());
  shape_box(task.limits, spread_of_factors("tolerance-f", 1, 1.44), std::nullopt);
  BOOST_TEST(!at(task, 0.175, 0.49).admissible.value());
}

// With f -> 0 the mass arrives with w^2/2 = 2 k^2/p^2 = 0.5, and half of a Delta of 1 stops it. No
// f is too small for that, so no box is too wide for f, however near to 0 it is.
BOOST_AUTO_TEST_CASE(the_least_f_that_is_examined_bounds_no_box) {
  for (const double f : {1e-12, 4e-10, 6e-10, 1e-9, 1e-8}) {
    BOOST_TEST_CONTEXT("f = " << f) {
      BOOST_TEST(at(half_period(1.1), f, 1).tolerance.value() == 0.5, tt::tolerance(1e-6));
    }
  }
  // The least stop time is that of the least f.
  PulseRequest fastest{{Rectangle{0.5, 1}, 1, 1.1, Criterion::exact}, {}, {}};
  fastest.search.objective = Objective::time;
  const DesignPoint point = design::design(fastest).finding.value().point;
  BOOST_TEST(point.f < 1e-8);
  BOOST_TEST(point.tolerance == 0.5, tt::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(is_that_of_the_design_which_is_admissible_in_it) {
  RandomSource random(20261123);
  int feasible = 0;
  int empty = 0;
  for (int i = 0; i < 120; ++i) {
    PulseRequest request = random_request(random);
    BOOST_TEST_CONTEXT("request " << i << ", " << name(request.problem.pulse)) {
      const DesignResult designed = design::design(request);
      RegionRequest region = region_of(request);
      if (designed.finding) {
        ++feasible;
        region.f = designed.finding->point.f;
        region.delta = designed.finding->point.delta;
        const RegionAnswer found = answer(region);
        BOOST_TEST(found.admissible.value());
        BOOST_TEST(found.tolerance.value() >= request.limits.tolerance - 1e-12);
        const auto of_design = least_delta(request.problem, *region.f);
        BOOST_TEST((request.problem.criterion == Criterion::exact
                        ? found.delta1_exact
                        : found.delta1_published) == of_design);
        const double more = std::pow(*region.f / request.problem.p, 2) / 2;
        BOOST_TEST(found.delta1_published.value() == *found.delta1_exact + more,
                   tt::tolerance(1e-12));
        BOOST_TEST((found.practice && !found.arrival));
        BOOST_TEST(found.constraints.size() == designed.finding->constraints.size());
      } else {
        ++empty;
      }
      request.search.objective = Objective::robust;
      check_same(answer(region), design::design(request));
    }
  }
  BOOST_TEST(feasible > 40);
  BOOST_TEST(empty > 20);
}

BOOST_AUTO_TEST_CASE(the_delta_that_keep_a_tolerance_are_those_that_are_admissible_with_it) {
  RandomSource random(20261125);
  constexpr double beside = 1e-6;
  int some = 0;
  int none = 0;
  for (int i = 0; i < 80; ++i) {
    PulseRequest request = random_request(random);
    request.limits.tolerance = random.uniform(0.01, 0.2);
    const RegionRequest task = region_of(request);
    const auto admits = [&](double f, double delta) {
      return at(task, f, delta).admissible.value();
    };
    const auto feasible = feasible_delta(request.problem, request.limits);
    const double f = answer(task).region.f3 * random.uniform(0.05, 1.1);
    const auto delta = feasible(f);
    BOOST_TEST_CONTEXT("request " << i << ", f = " << f) {
      if (!delta || delta->low * (1 + 2 * beside) >= delta->high) {
        const double need = least_delta(request.problem, f).value_or(1);
        BOOST_TEST(!admits(f, need * random.uniform(1, 3)));
        ++none;
        continue;
      }
      BOOST_TEST(admits(f, delta->low * (1 + beside)));
      BOOST_TEST(!admits(f, delta->low * (1 - beside)));
      const double high = std::isinf(delta->high) ? 10 * delta->low : delta->high;
      BOOST_TEST(admits(f, high * (1 - beside)));
      BOOST_TEST((std::isinf(delta->high) || !admits(f, high * (1 + beside))));
      ++some;
    }
  }
  BOOST_TEST(some > 15, some);
  BOOST_TEST(none > 15, none);
}

/// A = 1, w^2 = 1.
BOOST_AUTO_TEST_CASE(without_friction_the_delta_are_known_too) {
  const auto delta_at_0 = [](double beta) {
    return feasible_delta({Rectangle{0.5, 1}, 1, beta, Criterion::exact}, {})(0);
  };
  BOOST_TEST(delta_at_0(1.1).value().low == 0.5, tt::tolerance(1e-12));
  BOOST_TEST(!delta_at_0(0.9));
}

BOOST_AUTO_TEST_CASE(random_dampers_stand_as_their_own_motion_says) {
  RandomSource random(20261124);
  int inside = 0;
  int outside = 0;
  for (int i = 0; i < 150; ++i) {
    PulseRequest request = random_request(random);
    request.problem.criterion = Criterion::exact;
    request.limits.tolerance = 0;
    const RegionRequest task = region_of(request);
    const RegionAnswer bounds = answer(task);
    const double far = bounds.region.f3 * 1.3;
    for (int j = 0; j < 4; ++j) {
      const double f = random.uniform(0, far);
      const double need = least_delta(request.problem, f).value_or(bounds.region.f3);
      const double delta = need * random.uniform(0.5, 3);
      if (near_an_edge(request, f, delta)) {
        continue;
      }
      const bool truly = admissible(request, f, delta);
      const RegionAnswer answered = at(task, f, delta);
      BOOST_TEST(answered.admissible.value() == truly, name(request.problem.pulse)
                                                           << ", request " << i << ", f = " << f
                                                           << ", delta = " << delta);
      BOOST_TEST(violated(answered).empty() == truly);
      BOOST_TEST(answered.works_for.has_value() == truly);
      (truly ? inside : outside) += 1;
    }
  }
  BOOST_TEST(inside > 100);
  BOOST_TEST(outside > 100);
}

// With peak 1 - 2 f and acceleration f + A = 1 - f of the same rectangle beta asks for f >= 0.18,
// and f_max or the acceleration for an f that is hardly larger: no look at an f comes to lie
// between.
BOOST_AUTO_TEST_CASE(a_narrow_interval_between_two_limits_is_found) {
  const auto close = tt::tolerance(1e-9);
  RegionRequest by_f_max = half_period(0.64);
  by_f_max.limits.f_max = 0.1801;
  const RegionAnswer narrow = answer(by_f_max);
  BOOST_TEST_REQUIRE(narrow.region.feasible);
  BOOST_TEST(narrow.intervals->front().low == 0.18, close);
  BOOST_TEST(narrow.intervals->front().high == 0.1801, close);
  by_f_max.limits.f_max = 0.1799;
  BOOST_TEST(!answer(by_f_max).region.feasible);
  // Under a full sine with lambda = 4 p the mass feels more and more as f grows, up to k: beta
  // against that.
  RegionRequest by_load = by_f_max;
  by_load.limits = {};
  by_load.pulse = FullSine{0.5, 4};
  const auto motion_at = [&](double f) {
    return forced_response({1, f, 1e200}, {}, design::excitation(*by_load.pulse));
  };
  constexpr double low = 0.2711;
  constexpr double high = 0.2712;
  BOOST_TEST_REQUIRE(motion_at(high).peak_absolute_acceleration >
                     motion_at(low).peak_absolute_acceleration);
  by_load.problem.beta = motion_at(low).peak_amplitude;
  by_load.limits.acceleration_max = motion_at(high).peak_absolute_acceleration;
  const RegionAnswer loaded = answer(by_load);
  BOOST_TEST_REQUIRE(loaded.region.feasible);
  BOOST_TEST(loaded.intervals->front().low == low, close);
  BOOST_TEST(loaded.intervals->front().high == high, close);
}

// Every pulse with every spring of the ranges: what one of them violates is not admissible.
BOOST_AUTO_TEST_CASE(with_ranges_every_pulse_counts) {
  RegionRequest task = half_period(0.9);
  task.pulse = Rectangle{0.55, 1};
  task.pulse_ranges.k_low = 0.45;
  // The weakest returns for f <= 0.225, and the peak of the strongest is 2 (0.55 - f).
  const RegionAnswer bounds = answer(task);
  const auto close = tt::tolerance(1e-8);
  BOOST_TEST(bounds.region.beta_min == 2 * (0.55 - 0.225), close);
  // From the peak A = 2 (k - f) the mass comes back with A (A - 2 f).
  BOOST_TEST(at(task, 0.2, 2).delta1_exact.value() == 0.7 * (0.7 - 0.4) / 2, close);
  BOOST_TEST(bounds.intervals.value().front().low == 0.1, close);
  BOOST_TEST(bounds.intervals->front().high == 0.225, close);
  BOOST_TEST((violated(at(task, 0.0999, 2)) == Names{"amplitude"}));
  BOOST_TEST((violated(at(task, 0.2251, 2)) == Names{"return"}));
  BOOST_TEST(violated(at(task, 0.5, 2)).contains("start"));
  BOOST_TEST(at(task, 0.1625, 0.63).tolerance.value() == 0.0625 / 0.1625, close);
}

// Where the f that return have gaps, `return` compares f with the end of an interval next to it,
// not with the last f of all. The stroke is ten times the peak, so the intervals end where it
// returns.
BOOST_AUTO_TEST_CASE(return_has_the_nearest_end_of_an_interval) {
  RegionRequest task = half_period(0.05);
  task.pulse = FullSine{0.5, 20};
  const auto intervals = answer(task).intervals.value();
  BOOST_TEST_REQUIRE(intervals.size() == 2U);
  const auto compared = [&](double f, std::string_view relation, double limit) {
    const auto all = at(task, f, 1).constraints;
    const auto now = std::ranges::find(all, "return", &Constraint::name);
    BOOST_TEST(now->relation == relation);
    BOOST_TEST(now->limit == limit, tt::tolerance(1e-6));
    BOOST_TEST(now->satisfied == (now->slack >= 0));
  };
  const auto& [first, second] = std::pair(intervals[0], intervals[1]);
  compared(first.high * 0.5, "<=", first.high);
  compared(first.high * 1.1, "<=", first.high);
  compared(second.low * 0.9, ">=", second.low);
  compared(second.low * 1.1, ">=", second.low);
  compared(second.high * 0.99, "<=", 0.5);
}

BOOST_AUTO_TEST_CASE(wrong_input_names_its_field) {
  const auto field_of = [](const std::function<void(RegionRequest&)>& spoil) {
    RegionRequest wrong = half_period();
    spoil(wrong);
    return refused_field([&] { static_cast<void>(answer(wrong)); });
  };
  BOOST_TEST(field_of([](auto&) {}).empty());
  BOOST_TEST(field_of([](auto& wrong) { wrong.problem.arrivals = 2; }) == "arrivals");
  BOOST_TEST(field_of([](auto& wrong) { wrong.problem.residual = 0.1; }) == "residual");
  BOOST_TEST(field_of([](auto& wrong) { wrong.delta = 1; }) == "f");
  BOOST_TEST(field_of([](auto& wrong) { wrong.f = -1, wrong.delta = 1; }) == "f");
  BOOST_TEST(field_of([](auto& wrong) { wrong.problem.beta = -1; }) == "beta");
  BOOST_TEST(field_of([](auto& wrong) { wrong.pulse = Rectangle{0, 1}; }) == "k");
}

BOOST_AUTO_TEST_SUITE_END()
