// SPDX-License-Identifier: MIT
#include "damper.hpp"
#include "pulse_task.hpp"

BOOST_AUTO_TEST_SUITE(pulse_design_test)

// Designs for a pulse, compared with scans of f by simulation, one run each with a notch that holds
// every arrival, and against simulations of the (f, Delta) of their boxes.

using namespace stillpoint::design_test;

/// With a delta_max the scan's best is too large, because it misses maxima of the need.
constexpr double scan_misses = 0.01;
/// With ranges it misses what is between its pulses and springs, and the design keeps a reserve
/// between two lambdas: docs/theory.md section 15.
constexpr double sampled = 0.01;
/// The search ends at this tolerance: docs/theory.md section 8.
constexpr double widest = 0.995;

std::vector<Scanned> scan(const PulseRequest& request) {
  constexpr int even = 160;
  constexpr int small = 60;
  const auto& [problem, limits, search] = request;
  const double k = problem.ranges.k_low.value_or(peak_load(problem.pulse));
  // Twice as far as a mass with the speed of the whole pulse can pull back; never beyond k.
  const double far =
      std::min(k, 2 * peak_load(problem.pulse) * std::numbers::pi *
                      problem.p_high.value_or(problem.p) / angular_frequency(problem.pulse));
  std::vector<double> grid;
  for (int i = 0; i < small; ++i) {
    grid.push_back(far / even * std::pow(10, -4.0 * (small - i) / small));
    if (far < k) {
      grid.push_back(far * std::pow(k / far, (i + 0.5) / small));
    }
  }
  for (int i = 1; i < even; ++i) {
    grid.push_back(far * i / even);
  }
  std::ranges::sort(grid);
  std::vector<Scanned> points;
  points.reserve(grid.size());
  for (const double f : grid) {
    points.push_back(worst(request, f));
  }
  return points;
}

/// The least objective of the points whose box lies in the scan.
double best_value(const std::vector<Scanned>& points, const PulseRequest& request) {
  const auto& [problem, limits, search] = request;
  double best = HUGE_VAL;
  for (const Scanned& now : points) {
    const double low = now.f * (1 - limits.tolerance);
    const double high = now.f * (1 + limits.tolerance);
    double need = 0;
    // The neighbours beyond the box hold as well, so that no edge lies between.
    bool fits = points.front().f <= low && high <= points.back().f;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool inside =
          (i + 1 == points.size() || points[i + 1].f > low) && (i == 0 || points[i - 1].f < high);
      if (inside) {
        fits = fits && points[i].holds;
        need = std::max(need, points[i].need);
      }
    }
    if (fits && need * (1 + limits.tolerance) <=
                    limits.delta_max.value_or(HUGE_VAL) * (1 - limits.tolerance)) {
      best = std::min(best, value_of(search.objective, now));
    }
  }
  return best;
}

// Known by hand: while the rectangle lasts the mass swings about k - f, so the peak is 2 (k - f) at
// tau = pi = its end; from there it swings about f and reaches 4 f - 2 k, so it returns for
// f <= k/2. With k = 1/2 and beta = 0.8 that leaves f from 0.1 to 0.25, whose middle has 3/7.
BOOST_AUTO_TEST_CASE(a_rectangle_of_half_a_natural_period_has_the_design_that_is_known) {
  const PulseRequest request = request_of(Rectangle{0.5, 1}, 0.8);
  const DesignResult result = design::design(request);
  const Found& finding = result.finding.value();
  const auto close = tt::tolerance(inset);
  BOOST_TEST(finding.point.f == 0.175, close);
  BOOST_TEST(finding.point.tolerance == 3.0 / 7, close);
  BOOST_TEST(result.region.f2 == 0.1, close);
  BOOST_TEST(result.region.f3 == 0.25, close);
  BOOST_TEST(result.region.beta_min == 0.5, close);
  BOOST_TEST_REQUIRE(result.intervals.value().size() == 1U);
  BOOST_TEST(result.intervals->front().low == 0.1, close);
  BOOST_TEST(result.intervals->front().high == 0.25, close);
  // w^2 = A (A - 2 f) with A = 0.8, f = 0.1.
  BOOST_TEST(finding.point.delta >= 0.24 / (1 - 3.0 / 7));
  BOOST_TEST(least_delta(request.problem, 0.1).value() == 0.24, close);
  BOOST_TEST(!least_delta(request.problem, 0.26).has_value());
  RandomSource random(20261121);
  BOOST_TEST(outside(request, {0.17427, 0.42267, 0.416}, 200, random) == 0);
  BOOST_TEST(design::design(request_of(Rectangle{0.5, 1}, 0.5001)).finding.has_value());
  BOOST_TEST(!design::design(request_of(Rectangle{0.5, 1}, 0.4999)).finding.has_value());
  PulseRequest too_much = request;
  too_much.limits.tolerance = 0.5;
  const auto most = design::design(too_much).most_tolerant;
  BOOST_REQUIRE(most.has_value());
  BOOST_TEST(most->f == 0.175, close);
  BOOST_TEST(most->tolerance == 3.0 / 7, close);
  BOOST_TEST(!result.most_tolerant.has_value());
}

/// With ranges and more room than a pulse alone needs.
PulseRequest ranged_request(RandomSource& random) {
  PulseRequest request = ranged(random_request(random), random, 0.25);
  request.problem.beta *= 1.3;
  request.limits.tolerance *= random.pick(2) / 3.0;
  request.limits.f_max.reset();
  request.search.objective = Objective::robust;
  return request;
}

/// One pulse with one spring, or ranges of them.
BOOST_AUTO_TEST_CASE(random_designs_are_the_best_of_a_scan_and_hold_all_over_their_box) {
  RandomSource random(20261122);
  constexpr int tasks = 200;
  const char* const asked = std::getenv("STILLPOINT_POINTS");
  const int points = asked == nullptr ? 400 : std::atoi(asked) / tasks;
  std::array<int, 2> found{};
  std::array<int, 2> empty{};
  int mend_lists = 0;
  for (int i = 0; i < tasks; ++i) {
    const bool in_ranges = i % 14 == 0;
    const PulseRequest request = in_ranges ? ranged_request(random) : random_request(random);
    const auto& [problem, limits, search] = request;
    const std::vector<Scanned> scanned = scan(request);
    const double best = best_tolerance(scanned, limits);
    BOOST_TEST_CONTEXT("request " << i << ": " << context_of(request)) {
      if (!design::damper(request)) {
        ++empty[in_ranges ? 1 : 0];
        BOOST_TEST(best < limits.tolerance + (in_ranges ? sampled : 0));
        constexpr int enough = 4;  // each costs about twenty searches for a design
        if (!in_ranges && ++mend_lists <= enough) {
          const DesignResult result = design::design(request);
          BOOST_TEST(result.reason.has_value());
          BOOST_TEST(!result.mends.empty());
          check_mends(request, result.mends);
        }
        continue;
      }
      const DesignResult result = design::design(request);
      BOOST_TEST_REQUIRE(result.finding.has_value());
      ++found[in_ranges ? 1 : 0];
      const DesignPoint& point = result.finding->point;
      const ForcedResponse& motion = result.finding->pulse.value().response;
      BOOST_TEST(point.tolerance >= limits.tolerance);
      BOOST_TEST(outside(request, point, points, random) == 0);
      BOOST_TEST(result.finding->cross_check.passed);
      if (search.objective == Objective::robust) {
        const double most = std::min(best, widest);
        BOOST_TEST(point.tolerance >= most - (in_ranges ? sampled : scan_misses * most));
      } else {
        BOOST_TEST(value_of(search.objective, motion) <=
                   best_value(scanned, request) * (1 + inset));
      }
    }
  }
  BOOST_TEST(found[0] >= 100);
  BOOST_TEST(found[1] >= 9);
  BOOST_TEST(empty[0] >= 12);
}

// The rectangle above admits f from 0.1 to 0.25. From f (1 - 0.5 R) to f (1 + R) fits for
// f = 0.1/(1 - 0.5 R) = 0.25/(1 + R), R = 2/3, f = 0.15. Where delta_max binds, R solves
// need (1 + R)/(1 - R/4) = delta_max, with the need w^2/2 = 2 (0.5 - f) (0.5 - 2 f) of the lowest
// f.
BOOST_AUTO_TEST_CASE(a_box_with_sides_of_its_own_is_the_one_that_is_known) {
  PulseRequest request = request_of(Rectangle{0.5, 1}, 0.8);
  request.limits.shape = {.f_low = 0.5, .f_high = 1, .delta_low = 0.25, .delta_high = 1};
  const auto close = tt::tolerance(inset);
  const DesignResult result = design::design(request);
  BOOST_TEST(result.finding.value().point.f == 0.15, close);
  BOOST_TEST(result.finding.value().point.tolerance == 2.0 / 3, close);
  // Of both sides alike there is (f - 0.1)/f = 1/3 below.
  BOOST_TEST(even_tolerance(result) == 1.0 / 3, close);

  request.limits.delta_max = 0.2;
  const DesignResult bound = design::design(request);
  const DesignPoint& point = bound.finding.value().point;
  const double r = point.tolerance;
  const double low = point.f * (1 - 0.5 * r);
  BOOST_TEST(point.f * (1 + r) == 0.25,
             close);  // the need falls with f, so f is as large as it can be
  BOOST_TEST(2 * (0.5 - low) * (0.5 - 2 * low) * (1 + r) / (1 - r / 4) == 0.2, close);
  RandomSource random(20261123);
  BOOST_TEST(outside(request, point, 200, random) == 0);

  // One side alone: f may only grow, and delta not at all. The search ends at 99.5 %.
  request.limits = {.tolerance = 0.5, .shape = {0, 1, 0, 0}};
  const DesignResult upwards = design::design(request);
  BOOST_TEST(upwards.finding.value().point.f == 0.25 / 1.995, close);
  BOOST_TEST(upwards.finding.value().point.tolerance == 0.995, close);
}

BOOST_AUTO_TEST_CASE(a_full_sine_leaves_no_velocity_and_has_designs_all_the_same) {
  const DesignResult result = design::design(request_of(FullSine{0.5, 0.8}, 0.4));
  const PulseCheck& check = result.finding.value().pulse.value();
  BOOST_TEST(!check.start.has_value());
  BOOST_TEST(!check.peak_error.has_value());
  BOOST_TEST(!check.stop_time_error.has_value());
  BOOST_TEST(!result.reduced_v0.has_value());
  BOOST_TEST((result.region.beta_min == 0.0));  // it returns for every f < k
  BOOST_TEST(result.finding->cross_check.passed);
}

/// The mass stops and slips on by 2e-6 of its peak, within a step of the integrator.
BOOST_AUTO_TEST_CASE(a_design_whose_motion_nearly_sticks_is_checked_right) {
  PulseRequest request = request_of(FullSine{0.44203340000312447, 0.126518}, 0.5598269888140844);
  request.problem.criterion = Criterion::published;
  request.limits = {.delta_max = 0.0018018212406573713, .acceleration_max = 0.5662266322316939};
  BOOST_TEST(design::design(request).finding.value().cross_check.passed);
}

/// Of the velocity k/lambda only about p/lambda is left at the end, and with it the error of
/// rounding is so much larger.
BOOST_AUTO_TEST_CASE(checks_know_the_rounding_of_a_short_full_sine) {
  for (const double lambda : {1e3, 3e4, 1e6, 1e8}) {
    const DesignResult result = design::design(request_of(FullSine{100, lambda}, 1));
    const CrossCheck& check = result.finding.value().cross_check;
    BOOST_TEST(check.passed);
    const double rounding = std::max(1.1e-12, 1e-15 * lambda);
    BOOST_TEST(check.methods.at(0).tolerance <= rounding);
  }
}

BOOST_AUTO_TEST_CASE(each_reason_names_the_two_that_conflict) {
  const auto conflict = [](double beta, const Limits& limits) {
    PulseRequest request = request_of(Rectangle{0.5, 1}, beta);
    request.limits = limits;
    const DesignResult result = design::design(request);
    BOOST_TEST(!result.finding.has_value());
    BOOST_TEST(!result.region.feasible);
    BOOST_TEST(result.reason.has_value());
    check_mends(request, result.mends);
    return result.region.conflict;
  };
  using enum Conflict;
  BOOST_TEST((conflict(0.49, {}) == amplitude_against_return));
  BOOST_TEST((conflict(0.6, {.tolerance = 0.5}) == amplitude_against_return));
  BOOST_TEST((conflict(0.8, {.f_max = 0.09}) == amplitude_against_limit));
  // While the mass swings back it feels p^2 x - f or f, on its way out f + x <= f + 2 (k - f).
  BOOST_TEST((conflict(0.8, {.acceleration_max = 0.7}) == limit_alone));
  // The least need is that of the graze at f = 0.25; a box of +-20 % reaches below it.
  BOOST_TEST((conflict(0.8, {.delta_max = 0.05, .tolerance = 0.2}) == stop_against_limit));
}

/// The motions that a search has met move an edge by roundings; the mend fits all the same.
BOOST_AUTO_TEST_CASE(a_mended_tolerance_is_found_to_the_last_bit) {
  RandomSource random(2907);
  int mends = 0;
  for (int i = 0; i < 60; ++i) {
    PulseRequest request =
        request_of(HalfSine{1, random.uniform(0.6, 0.9)}, 1.8, Objective::acceleration);
    request.limits = {.delta_max = random.uniform(0.05, 0.3), .tolerance = 0.9};
    const DesignResult empty = design::design(request);
    for (const Mend& mend : empty.mends) {
      if (mend.field == "tolerance") {
        ++mends;
        const DesignResult result = design::design(mended(request, mend.field, mend.value));
        BOOST_TEST(result.finding.has_value(), "tolerance = " << mend.value);
      }
    }
  }
  BOOST_TEST(mends > 50);
}

BOOST_AUTO_TEST_SUITE_END()
