// SPDX-License-Identifier: MIT
#include "any_task.hpp"
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(ranges_search_test)

// The best damper for ranges, a residual and boxes of any shape, against scans and along f.

using namespace stillpoint::design_test;

BOOST_AUTO_TEST_CASE(the_soonest_stop_with_a_residual_is_on_the_edge_of_the_first_arrival) {
  // The first arrival stops the mass where Delta >= Delta1(f), (26); its time grows with f, and
  // Delta is D = min(V_a^2/2, delta_max)/(1 + R) at most: the soonest has Delta1(f) = D. A design
  // stays a relative 1e-9 inside its edges, of which the time takes a part.
  constexpr double relative = 1e-9;
  struct Case {
    double weakest;
    double tolerance;
    double delta_max;
    double residual;
    int arrivals;
  };
  for (const auto& [weakest, tolerance, delta_max, residual, arrivals] :
       {Case{1, 0, 0.2, 0.03, 2}, Case{0.85, 0, 0.19, 0.02, 4}, Case{1, 0.01, 0.25, 0.05, 2},
        Case{0.95, 0.02, 1, 0.2, 4}, Case{0.86, 0, 1, 0.03, 4}}) {
    const double most = std::min(weakest * weakest / 2, delta_max) / (1 + tolerance);
    double low = 0;
    double high = 1 / std::sqrt(8.0);
    for (int i = 0; i < 60; ++i) {
      const double f = (low + high) / 2;
      const double s = std::sqrt(1 + f * f);
      ((s - f) * (s - 3 * f) / 2 > most ? low : high) = f;
    }
    const double s = std::sqrt(1 + high * high);
    const double least = std::atan2(1, high) + std::acos(-high / (s - 2 * high));  // (25)
    const Problem problem{.v0 = 1,
                          .p = 1,
                          .beta = 2,
                          .criterion = Criterion::exact,
                          .arrivals = arrivals,
                          .v0_low = weakest,
                          .residual = residual};
    const auto found = search(problem, {.delta_max = delta_max, .tolerance = tolerance},
                              {.objective = Objective::time});
    BOOST_TEST_REQUIRE(found.has_value());
    const auto& [f, delta, its] = found->point;
    const double time = free_response({1, f, delta}, {0, 1}).stop_time.value();
    BOOST_TEST(std::abs(time / least - 1) <= relative,
               "V_a = " << weakest << ", R = " << tolerance << ": " << time << ", " << least);
  }
}

BOOST_AUTO_TEST_CASE(a_box_reaches_the_largest_f_that_returns_with_its_upper_part_alone) {
  constexpr double relative = 2e-9;
  for (const double part : {0.0, 0.5, 1.0}) {
    const auto found =
        search({.v0 = 1, .p = 1, .beta = 2, .criterion = Criterion::exact},
               {.tolerance = 0.2, .shape = {1, part, 1, 1}}, {.objective = Objective::amplitude});
    BOOST_TEST_REQUIRE(found.has_value());
    const double largest = 1 / std::sqrt(8.0) / (1 + 0.2 * part);
    BOOST_TEST(std::abs(found->point.f / largest - 1) <= relative);
  }
}

/// With the ranges and the residual the soonest stop is at the limit on Delta.
BOOST_AUTO_TEST_CASE(no_damper_with_the_largest_delta_stops_the_mass_sooner) {
  Problem problem{1, 1, 2, Criterion::exact, 5};
  problem.v0_low = 0.7297;
  problem.residual = 0.0379;
  const Limits limits{.f_max = 0.2257, .delta_max = 0.08806};
  const auto stop_time = [&](double f, double delta) {
    return free_response({1, f, delta}, {0, 1}).stop_time.value();
  };
  const DesignPoint found = search(problem, limits, {.objective = Objective::time}).value().point;
  const double least = stop_time(found.f, found.delta);
  const double inside = *limits.delta_max * (1 - 1e-8);
  for (int i = 0; i <= 3000; ++i) {
    const double f = 0.11 + 1e-6 * i;
    BOOST_TEST((!admissible(problem, limits, f, inside) || least <= stop_time(f, inside)), f);
  }
}

BOOST_AUTO_TEST_CASE(no_point_of_a_scan_is_better) {
  constexpr double more = 1e-3;  // of R or of a cost, relative
  int found_some = 0;
  int empty = 0;
  for (int i = 0; i < 40; ++i) {
    RandomSource random(1'202'000 + static_cast<std::uint64_t>(i));
    Task task = any_task(random);
    task.problem.criterion = Criterion::exact;
    const Objective objective = random_objective(random);
    const auto found = search(task.problem, task.limits, {objective, {}, 20'000, 10});
    (found ? found_some : empty) += 1;
    const auto cost = [&](const DesignPoint& at) {
      return value_of(objective,
                      free_response({task.problem.p, at.f, at.delta}, {0, task.problem.v0}));
    };
    const bool robust = objective == Objective::robust;
    constexpr int steps = 20;
    for (int j = 1; j <= steps; ++j) {
      for (int k = 1; k <= steps; ++k) {
        const DesignPoint at{task.problem.v0 * task.problem.p * 0.4 * j / steps,
                             task.problem.v0 * task.problem.v0 * 0.5 * k / steps, 0};
        // What would have to be admissible for this point to be better.
        const double tolerance =
            robust && found ? found->point.tolerance * (1 + more) + more : task.limits.tolerance;
        if (tolerance >= 1 || (!robust && found && cost(at) > cost(found->point) * (1 - more))) {
          continue;
        }
        const bool better = paths_are_good(task, at, tolerance);
        BOOST_TEST(!better, name(objective) << " at f = " << at.f << ", delta = " << at.delta
                                            << ": " << context_of(task));
      }
    }
  }
  BOOST_TEST(found_some > 15);
  BOOST_TEST(empty > 3);
}

BOOST_AUTO_TEST_CASE(the_strips_have_the_tolerance_of_the_best_design) {
  // Ranges whose best damper has its box between amplitude and return, both to rounding.
  Task task{{.v0 = 0.3096579750154308,
             .p = 0.3096579750154308,
             .beta = 0.8257123548396179,
             .criterion = Criterion::exact,
             .v0_low = 0.2533565250126252,
             .p_high = 0.3422535513328445},
            {}};
  constexpr double found_by_nlopt = 1e-6;
  constexpr double inset = 1e-8;  // of a design from its edges
  int later = 0;
  for (int i = 0; i < 360; ++i) {
    task.limits.tolerance = 0;
    const auto best = search(task.problem, task.limits);
    const auto list = strips(task.problem, task.limits);
    const auto widest = std::ranges::max_element(list, {}, &Strip::tolerance);
    const double largest = list.empty() ? 0 : widest->tolerance;
    const double found = best ? best->point.tolerance : 0;
    BOOST_TEST(largest >= found * (1 - found_by_nlopt), context_of(task));
    if (i > 60) {
      BOOST_TEST(std::abs(found - largest) <= inset, context_of(task));
      BOOST_TEST(best.has_value() == !list.empty(), context_of(task));
      later += best && widest->arrival > 1;
    }
    RandomSource random(1'206'000 + static_cast<std::uint64_t>(i));
    task = i < 60 ? any_task(random) : one_hit_task(random);
  }
  BOOST_TEST(later > 50);
}

// Over f it has two maxima, of which the higher one is where the box just fits below the cap of f.
BOOST_AUTO_TEST_CASE(the_search_finds_what_is_found_along_f_alone) {
  // Each stays a relative 1e-9 inside open edges, in its own way; golden sections end within
  // 1e-9 of f.
  constexpr double same = 2e-9;
  constexpr double widest = 1 - 1e-6;  // neither need find a wider box
  int compared = 0;
  for (int i = 0; i < 300; ++i) {
    RandomSource random(1'209'000 + static_cast<std::uint64_t>(i));
    const Task task = any_task(random);
    const auto& [problem, limits, seed] = task;
    for (const Objective objective : objectives) {
      const auto found = search(problem, limits, {objective, {}, 20'000, 10});
      BOOST_TEST_CONTEXT(name(objective) << ", " << context_of(task)) {
        if (!found) {
          continue;
        }
        const auto& [f, delta, tolerance] = found->point;
        const double along_f = found->record.along_f.value();
        const double unit = objective == Objective::robust ? 1 : along_f;
        const auto tried = [&](double value) {
          return objective == Objective::robust ? std::min(value, widest) : value;
        };
        BOOST_TEST(std::abs(tried(found->record.by_nlopt.value()) - tried(along_f)) <= same * unit);
        const Response motion = free_response({problem.p, f, delta}, {0, problem.v0});
        const double its = objective == Objective::robust ? tolerance : value_of(objective, motion);
        BOOST_TEST(std::abs(tried(its) - tried(along_f)) <= same * unit);
        ++compared;
      }
    }
  }
  BOOST_TEST(compared > 400);
}

BOOST_AUTO_TEST_CASE(the_largest_tolerance_of_a_strip_is_the_higher_of_two) {
  const Problem problem{.v0 = 0.42299466034777228,
                        .p = 0.93224266359929842,
                        .beta = 0.44985869358394509,
                        .arrivals = 3,
                        .v0_low = 0.367375,
                        .residual = 0.0837888};
  const Strip first = strips(problem).front();
  BOOST_TEST(first.arrival == 1);
  // Above the largest f of the second strip no other way has a point.
  for (int i = 0; i <= 40; ++i) {
    const double f = 0.086 + (*first.f_upper - 0.086) * i / 40;
    for (int j = 1; j <= 40; ++j) {
      const double delta = problem.v0 * problem.v0 / 2 * j / 40;
      BOOST_TEST(largest_tolerance(problem, {}, f, delta).value_or(0) <= first.tolerance);
    }
  }
}

/// Nothing in the box of that tolerance is simulated to fail, and along some path through a larger
/// one something does: of designs and of any point.
BOOST_AUTO_TEST_CASE(the_tolerance_of_a_damper_is_its_largest) {
  constexpr double more = 0.01;
  constexpr int points = 150;
  int designs = 0;
  int others = 0;
  int decided = 0;
  for (int i = 0; i < 8000; ++i) {
    RandomSource random(1'203'000 + static_cast<std::uint64_t>(i));
    Task task = any_task(random);
    const bool designed = i % 2 == 0;
    DesignPoint at{task.problem.v0 * task.problem.p * random.log_uniform(0.003, 0.4),
                   task.problem.v0 * task.problem.v0 * random.uniform(0.05, 0.5), 0};
    if (designed) {
      const auto found =
          search(task.problem, task.limits, {random_objective(random), {}, 20'000, 10});
      if (!found) {
        continue;
      }
      at = found->point;
    } else {
      task.problem.criterion = Criterion::exact;
    }
    const double tolerance =
        largest_tolerance(task.problem, task.limits, at.f, at.delta).value_or(-more);
    BOOST_TEST_CONTEXT(context_of(task)) {
      BOOST_TEST(
          (!designed || (at.tolerance >= task.limits.tolerance && at.tolerance <= tolerance)));
      BOOST_TEST((task.problem.criterion == Criterion::published || tolerance + more >= 1 ||
                  !paths_are_good(task, at, tolerance + more)));
      if (tolerance < 0) {
        continue;
      }
      ++(designed ? designs : others);
      int bad = 0;
      for (int k = 0; k < points; ++k) {
        std::array<double, 4> part{};
        for (double& here : part) {
          here = random.pick(2) == 0 ? random.pick(2) : random.uniform(0, 1);
        }
        const Verdict verdict = simulated(task, at_parts(task, at, tolerance, part));
        decided += verdict != Verdict::undecided;
        bad += verdict == Verdict::bad;
      }
      BOOST_TEST(bad == 0);
    }
  }
  BOOST_TEST(designs > 1500);
  BOOST_TEST(others > 200);
  BOOST_TEST(decided > (designs + others) * points / 10 * 9);
}

BOOST_AUTO_TEST_SUITE_END()
