// SPDX-License-Identifier: MIT
#include "random_source.hpp"

#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/design/design.hpp>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(arrivals_test)

// Dampers that stop the mass at a later arrival, docs/theory.md section 12. The truth is the
// half-cycle map forwards, in long double, or the simulation; the library follows it backwards.

namespace {

using namespace stillpoint;
using namespace stillpoint::design;
using namespace stillpoint::design_test;
using Wide = long double;

/// Of a cost or of R, as in search_test.
constexpr double cost_tolerance = 1e-8;
/// Error in R of the scan of 60 by 60 points, absolute.
constexpr double scan_miss = 0.03;
/// Relative; nearer to a tie than that, the rounding of the simulation decides.
constexpr double undecided_within = 1e-12;

/// The arrival at which the mass stops at x = 0 with the peak within beta; 0 if there is none. The
/// published criterion asks at the last arrival that the speed at x = f/p^2 be small enough.
int arrival_by_map(const Problem& problem, Wide f, Wide delta) {
  const Wide phi = f / problem.p;
  const Wide d = 2 * delta;
  const Wide v0 = problem.v0;
  if (v0 * v0 < d) {
    return 0;
  }
  Wide r = std::sqrt(v0 * v0 + phi * phi);
  if (r - phi > Wide(problem.p) * problem.beta) {
    return 0;
  }
  for (int n = 1; n <= problem.arrivals; ++n) {
    if (r < 3 * phi) {
      return 0;
    }
    const Wide t = r - 2 * phi;
    const Wide arrival = t * t - phi * phi;
    if (problem.criterion == Criterion::published ? t * t < d : arrival < d) {
      return n;
    }
    if (arrival < d) {
      return 0;  // it stops here, but the published criterion does not vouch for it
    }
    r = std::sqrt(t * t - d);
  }
  return 0;
}

bool within_limits(const Problem& problem, const Limits& limits, Wide f, Wide delta) {
  const Wide p_v0 = Wide(problem.p) * problem.v0;
  return (!limits.f_max || f <= *limits.f_max) &&
         (!limits.delta_max || delta <= *limits.delta_max) &&
         (!limits.acceleration_max || std::sqrt(f * f + p_v0 * p_v0) <= *limits.acceleration_max);
}

bool box_by_map(const Problem& problem, const Limits& limits, Wide f, Wide delta, Wide r) {
  const int low = arrival_by_map(problem, f * (1 - r), delta * (1 - r));
  return low > 0 && low == arrival_by_map(problem, f * (1 + r), delta * (1 + r)) &&
         within_limits(problem, limits, f * (1 + r), delta * (1 + r));
}

Wide tolerance_by_map(const Problem& problem, const Limits& limits, Wide f, Wide delta) {
  if (!box_by_map(problem, limits, f, delta, 0)) {
    return -1;
  }
  Wide low = 0;
  Wide high = 1;
  while (high - low > 1e-12L) {
    const Wide middle = (low + high) / 2;
    (box_by_map(problem, limits, f, delta, middle) ? low : high) = middle;
  }
  return low;
}

double cost_of(Objective objective, const Problem& problem, double f, double delta) {
  const Response response = free_response({problem.p, f, delta}, {0, problem.v0});
  return objective == Objective::amplitude ? response.peak_amplitude
         : objective == Objective::time    ? *response.stop_time
                                           : response.peak_acceleration;
}

/// Over f and Delta evenly and by factors.
std::vector<std::pair<double, double>> grid(const Problem& problem) {
  constexpr int steps = 60;
  std::vector<std::pair<double, double>> list;
  for (int i = 1; i <= steps; ++i) {
    for (int j = 1; j <= steps; ++j) {
      const double part = static_cast<double>(i) / steps;
      const double f = problem.v0 * problem.p * 0.36;
      const double delta = problem.v0 * problem.v0 * 0.5 * j / steps;
      list.emplace_back(f * part, delta);
      list.emplace_back(f * std::pow(10, -6 * part), delta);
    }
  }
  return list;
}

struct Task {
  Problem problem;
  Limits limits;
};

Task random_task(RandomSource& random) {
  Task task{random_problem(random, 0.75, 1.5), {}};
  task.problem.arrivals = 2 + random.pick(4);
  const double f3 = task.problem.v0 * task.problem.p / std::sqrt(8.0);
  if (random.pick(2) == 0) {
    task.limits.f_max = f3 * random.log_uniform(0.01, 1.1);
  }
  if (random.pick(3) == 0) {
    task.limits.delta_max = task.problem.v0 * task.problem.v0 * random.uniform(0.05, 0.5);
  }
  if (random.pick(4) == 0) {
    task.limits.acceleration_max =
        task.problem.p * task.problem.v0 * std::sqrt(1 + random.uniform(0, 0.1));
  }
  task.limits.tolerance = random.pick(2) == 0 ? 0 : random.uniform(0.01, 0.3);
  return task;
}

std::string context_of(const Task& task) {
  const Problem& now = task.problem;
  std::ostringstream text;
  text.precision(17);
  text << name(now.criterion) << ", v0 = " << now.v0 << ", p = " << now.p << ", beta = " << now.beta
       << ", arrivals = " << now.arrivals << ", f_max = " << task.limits.f_max.value_or(0)
       << ", delta_max = " << task.limits.delta_max.value_or(0)
       << ", acceleration_max = " << task.limits.acceleration_max.value_or(0)
       << ", tolerance = " << task.limits.tolerance;
  return text.str();
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_tolerances_of_the_strips_are_those_of_the_table) {
  struct Known {
    double beta;
    std::vector<double> percent;
  };
  constexpr double two_decimals = 0.005 + 1e-4;
  for (const Known& known : {Known{0.8, {22.22}}, Known{0.9, {37.61, 18.71, 8.128, 1.613}},
                             Known{0.95, {37.61, 28.02, 16.44, 11.24, 8.166, 6.005}},
                             Known{0.99, {37.61, 32.70, 19.61, 14.00, 10.88, 8.893}},
                             Known{2, {37.61, 33.333, 20, 14.286, 11.111, 9.091}}}) {
    const auto list = strips({1, 1, known.beta, Criterion::exact, 6});
    BOOST_REQUIRE(list.size() == known.percent.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
      BOOST_TEST(list[i].arrival == static_cast<std::int64_t>(i + 1));
      BOOST_TEST(std::abs(100 * list[i].tolerance - known.percent[i]) < two_decimals);
    }
  }
  const auto little = strips({1, 1, 2, Criterion::exact, 3}, {0.001, std::nullopt, 0});
  BOOST_TEST(std::abs(little[0].tolerance - 0.002) < 1e-5);
  BOOST_TEST(std::abs(little[1].tolerance - 1.0 / 3) < 1e-6);
}

BOOST_AUTO_TEST_CASE(no_point_of_a_dense_scan_is_better) {
  RandomSource random(901);
  int found_later = 0;
  int empty = 0;
  for (int i = 0; i < 60; ++i) {
    const Task task = random_task(random);
    const auto& [problem, limits] = task;
    const auto points = grid(problem);
    for (const Objective objective : objectives) {
      BOOST_TEST_CONTEXT(name(objective) << ", " << context_of(task)) {
        double best = HUGE_VAL;
        for (const auto& [f, delta] : points) {
          if (objective == Objective::robust) {
            const Wide tolerance = tolerance_by_map(problem, limits, f, delta);
            if (tolerance >= limits.tolerance) {
              best = std::min(best, -static_cast<double>(tolerance));
            }
          } else if (box_by_map(problem, limits, f, delta, limits.tolerance)) {
            best = std::min(best, cost_of(objective, problem, f, delta));
          }
        }
        const auto found = search(problem, limits, {objective, "", 20'000, 10});
        if (!found) {
          ++empty;
          BOOST_TEST(best == HUGE_VAL);
          continue;
        }
        const DesignPoint& point = found->point;
        found_later += arrival_of(problem, point.f, point.delta).value() > 1;
        BOOST_TEST(point.tolerance >= limits.tolerance);
        BOOST_TEST(std::abs(point.tolerance - static_cast<double>(tolerance_by_map(
                                                  problem, limits, point.f, point.delta))) < 1e-11);
        if (objective == Objective::robust) {
          BOOST_TEST(-point.tolerance <= best + cost_tolerance);
          BOOST_TEST((best == HUGE_VAL || -point.tolerance >= best - scan_miss));
        } else {
          BOOST_TEST(cost_of(objective, problem, point.f, point.delta) <=
                     best * (1 + cost_tolerance));
        }
      }
    }
  }
  BOOST_TEST(found_later > 30);
  BOOST_TEST(empty > 4);
}

BOOST_AUTO_TEST_CASE(the_room_along_the_reach_edge_changes_its_sign_once) {
  // (50) with both sides followed back by (39), in long double; phi_b = 1.
  const auto square = [](Wide phi, Wide d, Wide radius, int steps) {
    for (int i = 0; i < steps; ++i) {
      radius = 2 * phi + std::sqrt(radius * radius + d);
    }
    return radius * radius - phi * phi;
  };
  int changed = 0;
  for (const int n : {2, 3, 4, 5, 7, 10, 20, 50, 200}) {
    // Above kappa = 1 - 1/n the room is positive at last, (51); at 1 it is an identity.
    for (int k = 1; k < 60; ++k) {
      const Wide kappa = Wide(k) / 60;
      int changes = 0;
      bool positive = false;
      for (int i = 0; i <= 600; ++i) {
        const Wide delta = std::pow(Wide(10), -6 + Wide(i) / 40);
        const bool now = square(kappa, kappa * delta, kappa, n) > square(1, delta, 3, n - 1);
        changes += now != positive;
        positive = now;
      }
      BOOST_TEST(changes <= 1, "n = " << n << ", kappa = " << static_cast<double>(kappa));
      changed += changes;
    }
  }
  BOOST_TEST(changed > 20);
}

BOOST_AUTO_TEST_CASE(the_search_finds_the_tolerance_of_the_closed_form) {
  RandomSource random(902);
  int later = 0;
  for (int i = 0; i < 300; ++i) {
    Task task = random_task(random);
    task.limits.tolerance = 0;
    const auto found = search(task.problem, task.limits);
    const auto list = strips(task.problem, task.limits);
    BOOST_TEST(found.has_value() == !list.empty());
    if (found && !list.empty()) {
      const auto best = std::ranges::max_element(list, {}, &Strip::tolerance);
      later += best->arrival > 1;
      BOOST_TEST(std::abs(found->point.tolerance - best->tolerance) <= cost_tolerance,
                 context_of(task) << ": " << found->point.tolerance << " found, " << best->tolerance
                                  << " by the closed form");
    }
  }
  BOOST_TEST(later > 50);
}

BOOST_AUTO_TEST_CASE(every_simulated_point_of_a_box_stops_at_the_arrival_of_its_design) {
  RandomSource random(903);
  int boxes = 0;
  int points = 0;
  while (boxes < 110) {
    const Task task = random_task(random);
    const auto found = search(task.problem, task.limits);
    if (!found || arrival_of(task.problem, found->point.f, found->point.delta) == 1) {
      continue;
    }
    ++boxes;
    const auto [f, delta, tolerance] = found->point;
    const auto n = static_cast<double>(*arrival_of(task.problem, f, delta));
    int failed = 0;
    for (int i = 0; i < 1000; ++i, ++points) {
      const double at_f = f * (1 + random.uniform(-1, 1) * tolerance);
      const double at_delta = delta * (1 + random.uniform(-1, 1) * tolerance);
      const Response response =
          free_response({task.problem.p, at_f, at_delta}, {0, task.problem.v0}, {.times = false});
      failed += !response.stops_at_zero || response.half_cycles != n ||
                response.peak_amplitude > task.problem.beta ||
                !within_limits(task.problem, task.limits, at_f, at_delta);
    }
    BOOST_TEST(failed == 0, context_of(task));
  }
  BOOST_TEST(points >= 100'000);
}

BOOST_AUTO_TEST_CASE(the_arrival_is_the_one_that_the_simulation_shows) {
  RandomSource random(904);
  std::array<int, 6> met{};
  for (int i = 0; i < 20'000; ++i) {
    Problem problem = random_problem(random, 0.75, 1.5);
    problem.criterion = Criterion::exact;
    problem.arrivals = 5;
    const double f = problem.v0 * problem.p * random.log_uniform(1e-6, 0.4);
    const double delta = problem.v0 * problem.v0 * random.uniform(0, 0.55);
    const Response response = free_response({problem.p, f, delta}, {0, problem.v0});
    if (*response.decision_margin < undecided_within) {
      continue;
    }
    const bool centred = response.outcome == Outcome::stopped_at_zero && *response.half_cycles <= 5;
    const auto arrival = arrival_of(problem, f, delta);
    BOOST_TEST(arrival.has_value() == centred);
    if (arrival && centred) {
      BOOST_TEST(static_cast<double>(*arrival) == *response.half_cycles);
      ++met[static_cast<std::size_t>(*arrival)];
    }
  }
  for (int n = 1; n <= 5; ++n) {
    BOOST_TEST(met[static_cast<std::size_t>(n)] > 100);
  }
}

BOOST_AUTO_TEST_CASE(a_design_of_a_later_arrival_is_reported_and_cross_checked) {
  RandomSource random(905);
  int later = 0;
  for (int i = 0; i < 100; ++i) {
    const Task task = random_task(random);
    for (const Objective objective : objectives) {
      const DesignResult result =
          design::design(DesignRequest{task.problem, task.limits, {objective, "", 20'000, 10}});
      BOOST_TEST(result.region.feasible == result.finding.has_value());
      if (!result.finding) {
        BOOST_TEST(!result.reason.empty());
        continue;
      }
      const Finding& finding = *result.finding;
      later += finding.arrival.value() > 1;
      BOOST_TEST(finding.cross_check.passed, name(objective) << ", " << context_of(task));
      BOOST_TEST(*finding.response.half_cycles == static_cast<double>(*finding.arrival));
      BOOST_TEST(finding.response.stops_at_zero);
      for (const Constraint& constraint : finding.constraints) {
        BOOST_TEST(constraint.satisfied, constraint.name);
      }
      BOOST_TEST(finding.point.f >= *result.region.f_lower);
      BOOST_TEST(finding.point.f <= *result.region.f_upper);
    }
  }
  BOOST_TEST(later > 50);
}

BOOST_AUTO_TEST_CASE(a_later_arrival_works_for_its_own_strip_of_hits) {
  // f = 0.1, Delta = 0.2, p = 1: the hits that stop at the second arrival, by hand: from r = 0.3,
  // r_1 = 0.2 + sqrt(0.09 + 0.4) = 0.9 and V0 = sqrt(0.81 - 0.01) = sqrt(0.8); beta = 2 is far.
  const Problem problem{1, 1, 2, Criterion::exact, 2};
  const auto served = works_for(problem, {}, 0.1, 0.2);
  BOOST_REQUIRE(served.has_value());
  BOOST_TEST(std::abs(served->v0.low - std::sqrt(0.8)) < 1e-15);
  // From r = 0.1: 0.2 + sqrt(0.41), then once more.
  const double second = 0.2 + std::sqrt(0.41);
  const double first = 0.2 + std::sqrt(second * second + 0.4);
  BOOST_TEST(std::abs(*served->v0.high - std::sqrt(first * first - 0.01)) < 1e-15);
  for (const auto& [v0, inside] : {std::pair{served->v0.low, true},
                                   {std::nextafter(served->v0.low, 0), false},
                                   {*served->v0.high, true},
                                   {std::nextafter(*served->v0.high, 9), false}}) {
    Problem hit = problem;
    hit.v0 = v0;
    BOOST_TEST(admissible(hit, {}, 0.1, 0.2) == inside);
  }
}

/// Of (51) and the table of section 12: V0 = p = 1, beta not binding, f at most 0.001.
BOOST_AUTO_TEST_CASE(more_arrivals_are_offered_where_they_help) {
  const auto offered = [](double beta, double tolerance, std::optional<double> delta_max,
                          std::int64_t arrivals = 1) -> std::int64_t {
    const Problem problem{1, 1, beta, Criterion::exact, arrivals};
    const auto list = mends(problem, {0.001, delta_max, tolerance});
    const auto found = std::ranges::find(list, "arrivals", &Mend::field);
    return found == list.end() ? 0 : static_cast<std::int64_t>(found->value);
  };
  BOOST_TEST(offered(1, 0.3, {}) == 2);
  BOOST_TEST(offered(1, 0.34, {}) == 0);   // above 1/3
  BOOST_TEST(offered(0.9, 0.3, {}) == 0);  // the peak of f = 0.001 is 0.999
  BOOST_TEST(offered(1, 0, {}) == 0);      // there is one with the first arrival
  // A passage takes Delta = 0.05 of the energy 1/2 and a half-cycle 2 f x = 0.002 at most, so that
  // 0.03 to 0.05 are left at the tenth arrival, which stops it, and 0.08 to 0.1 at the ninth.
  const std::int64_t tenth = offered(1, 0, 0.05);
  BOOST_TEST(tenth == 10);
  BOOST_TEST(offered(1, 0, 0.05, 9) == tenth);
  BOOST_TEST(offered(1, 0, 0.05, 10) == 0);
}

BOOST_AUTO_TEST_CASE(mends_of_several_arrivals_are_least_and_suffice) {
  RandomSource random(906);
  constexpr double nearer = 1e-6;
  int mended = 0;
  int unexplained = 0;
  for (int i = 0; i < 150; ++i) {
    Task task = random_task(random);
    task.limits.tolerance *= 1.5;
    if (admissible_region(task.problem, task.limits).feasible) {
      continue;
    }
    unexplained +=
        reason(admissible_region(task.problem, task.limits), task.problem, task.limits).empty();
    for (const Mend& mend : mends(task.problem, task.limits)) {
      ++mended;
      const auto with = [&](double value) {
        Task now = task;
        if (mend.field == "arrivals") {
          now.problem.arrivals = static_cast<std::int64_t>(value);  // rounded down
          return now;
        }
        (mend.field == "v0"                 ? now.problem.v0
         : mend.field == "p"                ? now.problem.p
         : mend.field == "beta"             ? now.problem.beta
         : mend.field == "f_max"            ? now.limits.f_max.emplace()
         : mend.field == "delta_max"        ? now.limits.delta_max.emplace()
         : mend.field == "acceleration_max" ? now.limits.acceleration_max.emplace()
                                            : now.limits.tolerance) = value;
        return now;
      };
      const Task now = with(mend.value);
      const Task not_yet = with(mend.value * (mend.upwards ? 1 - nearer : 1 + nearer));
      BOOST_TEST_CONTEXT(mend.field << " = " << mend.value << ", " << context_of(task)) {
        BOOST_TEST(admissible_region(now.problem, now.limits).feasible);
        BOOST_TEST(search(now.problem, now.limits).has_value());
        BOOST_TEST(!admissible_region(not_yet.problem, not_yet.limits).feasible);
      }
    }
  }
  BOOST_TEST(mended > 100);
  BOOST_TEST(unexplained == 0);
}

BOOST_AUTO_TEST_CASE(a_damper_that_cannot_stop_the_mass_in_time_is_explained) {
  const Problem problem{1, 1, 2, Criterion::exact, 3};
  const Limits little{1e-3, 0.01, 0};
  const Region region = admissible_region(problem, little);
  BOOST_TEST((region.conflict == Conflict::no_arrival));
  BOOST_TEST(reason(region, problem, little).find("passes x = 0 3 times") != std::string::npos);
  const Limits wide{1e-3, std::nullopt, 0.4};
  const Region narrow = admissible_region(problem, wide);
  BOOST_TEST((narrow.conflict == Conflict::no_arrival));
  BOOST_TEST(reason(narrow, problem, wide).find("first 3 arrivals") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
