// SPDX-License-Identifier: MIT
#include "damper.hpp"
#include "pulse/region.hpp"
#include "pulse_task.hpp"

BOOST_AUTO_TEST_SUITE(pulse_search_test)

// NLopt's optimum under a pulse compared with the one along f, found without it.

using namespace stillpoint::design_test;

/// LD_CCSAQ creeps along a constraint; the others agree to 1e-7.
constexpr double creeping = 1e-3;

BOOST_AUTO_TEST_CASE(every_algorithm_finds_the_optimum_that_brackets_find) {
  for (const std::string_view algorithm : algorithm_names()) {
    for (const Objective objective : objectives) {
      PulseRequest request = request_of(HalfSine{0.5, 0.6}, 0.6, objective);
      request.limits.tolerance = 0.05;
      request.limits.delta_max = 0.1;
      request.search.algorithm = algorithm;
      request.search.max_evaluations = 2000;
      const DesignResult result = design::design(request);
      const SearchRecord& found = result.finding.value().search.value();
      BOOST_TEST_CONTEXT(algorithm << " " << name(objective)) {
        BOOST_TEST_REQUIRE(found.by_nlopt.has_value());
        BOOST_TEST(*found.by_nlopt == found.along_f.value(), tt::tolerance(creeping));
      }
    }
  }
}

// The f whose need is delta_max itself is the best that fits. After four rests two runs of it
// differ by more than a last digit, and a design that left them no room would fail its own check.
BOOST_AUTO_TEST_CASE(a_design_at_the_edge_of_delta_max_leaves_room_for_rounding) {
  PulseRequest request{
      .problem = {FullSine{0.062063979677861654, 0.15618816201005284}, 0.67668106563338437,
                  0.15814880463153116, Criterion::exact},
      .limits = {.f_max = 0.029968416646649516, .delta_max = 0.0007687369087384583}};
  for (const Objective objective : {Objective::amplitude, Objective::acceleration}) {
    request.search.objective = objective;
    const DesignResult result = design::design(request);
    BOOST_TEST(result.finding.value().cross_check.passed);
    const auto& [f, delta, tolerance] = result.finding->point;
    BOOST_TEST(delta <= *request.limits.delta_max);
    BOOST_TEST(scanned(request, request.problem.pulse, request.problem.p, f).need <=
               delta * (1 - 1e-10));
  }
}

// A local search may end at another optimum, of which a pulse has several. What is found along f
// is never the worse.
BOOST_AUTO_TEST_CASE(random_tasks_have_one_optimum_by_both_ways) {
  RandomSource random(20261123);
  constexpr double close = 1e-4;
  int both = 0;
  int apart = 0;
  for (int i = 0; i < 2000; ++i) {
    const PulseRequest request = random_request(random);
    const auto optimum =
        design::search(PulseRegion(request.problem, request.limits), request.search);
    if (!optimum) {
      continue;
    }
    ++both;
    // Tolerances are compared as they are: they may be 0.
    const double scale = request.search.objective == Objective::robust
                             ? 1
                             : std::max(optimum->searched, optimum->bracketed);
    BOOST_TEST_CONTEXT("task " << i) {
      BOOST_TEST(optimum->bracketed <= optimum->searched + close * scale);
    }
    apart += optimum->searched > optimum->bracketed + close * scale ? 1 : 0;
  }
  BOOST_TEST(both >= 1000);
  BOOST_TEST(apart <= both / 200);
}

// The parts of an interval that delta_max leaves are those of a dense scan, local minima included.
BOOST_AUTO_TEST_CASE(parts_within_delta_max_are_those_of_a_scan) {
  RandomSource random(20261125);
  int divided = 0;
  for (int i = 0; i < 600; ++i) {
    PulseRequest request =
        request_of(random_pulse(random, 1, 1 / random.log_uniform(0.02, 5)), HUGE_VAL);
    const WorstReturn profile(request.problem);
    const auto& some = profile.samples()[profile.samples().size() / 3];
    request.limits.delta_max = random.uniform(0.2, 1.2) * some.need(request.problem.criterion);
    const PulseRegion region(request.problem, request.limits);
    KnownMotions known(*region.profile());
    const double tolerance = random.uniform(0, 0.5);
    const double most = *request.limits.delta_max * (1 - tolerance) / (1 + tolerance);
    for (const Island& island : region.islands()) {
      const auto parts = region.parts(island, tolerance, 1, known);
      divided += parts.size() > 1 ? 1 : 0;
      constexpr int looks = 400;
      for (int j = 1; j < looks; ++j) {
        const double f = island.low * std::pow(island.high / island.low, 1.0 * j / looks);
        const double need = region.at(f).need(request.problem.criterion);
        const bool inside = std::ranges::any_of(
            parts, [f](const Island& part) { return part.low <= f && f <= part.high; });
        BOOST_TEST_CONTEXT("task " << i << ", f " << f << ", need " << need << " of " << most) {
          BOOST_TEST((inside ? need <= most : need >= most * (1 - 1e-9)));
        }
      }
    }
  }
  BOOST_TEST(divided >= 20);
}

// The least acceleration is between the last sample, which is the end of the interval, and the one
// before it.
BOOST_AUTO_TEST_CASE(an_optimum_next_to_the_end_of_an_interval_is_found) {
  PulseRequest request{
      .problem = {FullSine{2.04517, 1.3573529}, 4.74295, 0.11563612, Criterion::published},
      .search = {.objective = Objective::acceleration}};
  const SearchRecord found = design::design(request).finding.value().search.value();
  double least = HUGE_VAL;
  for (double f = 1.9; f < 2.045; f += 1e-4) {
    least = std::min(
        least,
        scanned(request, request.problem.pulse, request.problem.p, f).peak_absolute_acceleration);
  }
  BOOST_TEST(found.along_f.value() <= least);
  BOOST_TEST(found.along_f.value() == least, tt::tolerance(1e-5));
  BOOST_TEST(found.by_nlopt.value() == least, tt::tolerance(1e-5));
}

// Nothing moves at f = k, and what hardly moves cannot be checked.
BOOST_AUTO_TEST_CASE(a_design_stays_far_enough_from_k_for_its_motion_to_be_known) {
  PulseRequest request{
      .problem = {FullSine{0.350972, 1034.6095}, 5.0931, 1.1144844e-06, Criterion::published},
      .search = {.objective = Objective::time}};
  const DesignResult result = design::design(request);
  BOOST_TEST(result.finding.value().cross_check.passed);
  BOOST_TEST(result.finding->point.f == 0.9999 * 0.350972, tt::tolerance(1e-8));
  // A full sine returns up to there with any beta.
  BOOST_TEST(result.region.beta_min == 0);
  BOOST_TEST(result.region.f3 == 0.350972);
}

BOOST_AUTO_TEST_SUITE_END()
