// SPDX-License-Identifier: MIT
#include "damped_task.hpp"

BOOST_AUTO_TEST_SUITE(damped_hits_test)

// What is told of damped hits, of each by the motions themselves: all hits of a range down to the
// weakest that the notch lets go, each spring and each damping.

using namespace stillpoint::design_test;

/// Of a limit, and of an end beyond which a damper fails: what is left to rounding and to the steps
/// in which ends are looked for.
constexpr double rounding = 1e-9;
constexpr double beyond = 2e-3;

struct DampedTask {
  Problem problem;
  Interval zeta;
};

DampedTask drawn(RandomSource& random) {
  DampedTask task;
  Problem& problem = task.problem;
  problem.v0 = random.log_uniform(0.5, 2);
  problem.p = random.log_uniform(0.5, 2);
  problem.criterion = Criterion::exact;
  problem.beta = problem.v0 / problem.p * random.uniform(0.55, 1);
  problem.arrivals = 1 + static_cast<std::int64_t>(random.pick(3));
  random.one_in(2, problem.v0_low,
                [&] { return random.pick(2) == 0 ? 0 : problem.v0 * random.uniform(0.6, 1); });
  random.one_in(3, problem.residual, [&] { return problem.beta * random.uniform(0.02, 0.2); });
  if (!problem.residual) {
    random.one_in(3, problem.p_high, [&] { return problem.p * random.uniform(1, 1.1); });
  }
  problem.breakaway = random.pick(2) == 0 ? 1 : random.uniform(1, 2);
  const double least = random.pick(5) == 0 ? 0 : random.uniform(0.01, 0.1);
  task.zeta = {least, random.pick(2) == 0 ? least : least + random.uniform(0.01, 0.05)};
  return task;
}

bool rests(const DampedTask& task, const Oscillator& oscillator, double v0) {
  const Problem& problem = task.problem;
  const Response motion = free_response(oscillator, {0, v0});
  return motion.half_cycles <= static_cast<double>(problem.arrivals) &&
         motion.peak_amplitude <= problem.beta * (1 + rounding) &&
         std::abs(motion.stop_position.value()) <= problem.residual.value_or(0) * (1 + rounding);
}

/// Every motion of the task that a damper does not hold at its start, evenly and at the ends.
bool serves(const DampedTask& task, double f, double delta) {
  const Problem& problem = task.problem;
  constexpr int hits = 30;
  const int springs = problem.p_high ? 4 : 1;
  const int dampings = task.zeta.low < task.zeta.high ? 40 : 1;
  constexpr double let_go = 1 + 2e-5;
  const double weakest =
      std::max(problem.v0_low.value_or(problem.v0), std::sqrt(2 * delta) * let_go);
  for (int i = 0; i <= hits; ++i) {
    const double v0 = std::lerp(std::min(weakest, problem.v0), problem.v0, double(i) / hits);
    for (int k = 0; k <= springs; ++k) {
      for (int z = 0; z <= dampings; ++z) {
        const double p = std::lerp(problem.p, problem.stiffest_p(), double(k) / springs);
        const double zeta = std::lerp(task.zeta.low, task.zeta.high, double(z) / dampings);
        if (v0 * v0 > 2 * delta && !rests(task, {p, f, delta, {}, zeta, problem.breakaway}, v0)) {
          return false;
        }
      }
    }
  }
  return problem.v0_low == 0.0 || problem.starting_v0() * problem.starting_v0() > 2 * delta;
}

RecordDesignRequest request_of(const DampedTask& task) {
  return as_case({.problem = task.problem, .limits = {}}, task.zeta);
}

BOOST_AUTO_TEST_CASE(each_delta_that_is_told_is_feasible) {
  RandomSource random(6301);
  int seen = 0;
  for (int i = 0; i < 20; ++i) {
    const DampedTask task = drawn(random);
    RecordDesignRequest request = request_of(task);
    request.maps = true;
    request.tolerance = {{}, {}, {}, {}};
    const FeasibleRegion region = design::design(request).region.value();
    for (const FeasibleDelta& each : region.deltas) {
      if (each.f < region.f.back().high) {  // where a strip ends motions graze
        const double delta = std::lerp(each.delta.low, each.delta.high, random.uniform(0.01, 0.99));
        BOOST_TEST(serves(task, each.f, delta), "task " << i << ", f " << each.f << ", " << delta);
        ++seen;
      }
    }
  }
  BOOST_TEST(seen > 200);
}

/// With a tolerance that is asked for, unless the largest is.
RecordDesignRequest objective_of(const DampedTask& task, SuiteObjective objective) {
  RecordDesignRequest request = request_of(task);
  request.objective = objective;
  if (objective != SuiteObjective::robust) {
    constexpr Spread off{0.03, 0.03};
    request.tolerance = {off, off, {}, {}};
    request.requires_tolerance = true;
  }
  return request;
}

void check_box(const DampedTask& task, const RecordDesign& design, RandomSource& random) {
  const auto& [f, delta, p, width, samples, exact, worst, of, in] = design.finding->box;
  for (int k = 0; k < 8; ++k) {
    const double of_f =
        k < 4 ? (k % 2 == 0 ? f.low : f.high) : std::lerp(f.low, f.high, random.uniform(0, 1));
    const double of_delta = k % 4 < 2 ? delta.low : delta.high;
    BOOST_TEST(serves(task, of_f, of_delta), "f " << of_f << ", " << of_delta);
  }
}

void check_ends(const DampedTask& task, const RecordDesign& design) {
  const SuiteDamper& damper = design.nearest.damper;
  const WorksFor works = design.finding->works_for.value();
  const auto serves_with = [&](double Problem::*input, double value) {
    DampedTask now = task;
    now.problem.*input = value;
    return serves(now, damper.f, damper.delta);
  };
  BOOST_TEST(serves_with(&Problem::v0, *works.hit.high * (1 - rounding)));
  BOOST_TEST(serves_with(&Problem::p, works.p.low * (1 + rounding)));
  BOOST_TEST(!serves_with(&Problem::v0, *works.hit.high * (1 + beyond)));
  BOOST_TEST(!serves_with(&Problem::p, works.p.low * (1 - beyond)));
}

BOOST_AUTO_TEST_CASE(there_is_a_design_where_there_is_a_region_and_its_box_serves) {
  RandomSource random(6302);
  int found = 0;
  int none = 0;
  for (int i = 0; i < 30; ++i) {
    const DampedTask task = drawn(random);
    const SuiteObjective objective =
        std::array{SuiteObjective::robust, SuiteObjective::acceleration,
                   SuiteObjective::amplitude}[static_cast<std::size_t>(i) % 3];
    RecordDesignRequest request = objective_of(task, objective);
    const RecordDesign design = design::design(request);
    request.maps = true;
    if (objective == SuiteObjective::robust) {
      request.tolerance = {{}, {}, {}, {}};
    }
    BOOST_TEST_CONTEXT("task " << i << ", " << name(objective)) {
      BOOST_TEST(design.finding.has_value() == !design::design(request).region->f.empty());
      (design.finding ? found : none) += 1;
      if (design.finding) {
        check_box(task, design, random);
        check_ends(task, design);
      }
    }
  }
  BOOST_TEST(found > 10);
  BOOST_TEST(none > 2);
}

BOOST_AUTO_TEST_CASE(a_judged_damper_is_admissible_if_it_serves) {
  RandomSource random(6303);
  int admissible = 0;
  int not_admissible = 0;
  for (int i = 0; i < 150; ++i) {
    const DampedTask task = drawn(random);
    const Problem& problem = task.problem;
    const double f = problem.v0 * problem.p * random.uniform(0.02, 0.4);
    const double delta = problem.v0 * problem.v0 * random.uniform(0.02, 0.5);
    const bool served = serves(task, f, delta);
    BOOST_TEST(is_admissible(request_of(task), f, delta) == served,
               "task " << i << ", f " << f << ", " << delta);
    (served ? admissible : not_admissible) += 1;
  }
  BOOST_TEST(admissible > 20);
  BOOST_TEST(not_admissible > 20);
}

BOOST_AUTO_TEST_CASE(parts_and_fronts_have_no_tolerance_that_was_not_asked_for) {
  const DampedTask task{{.v0 = 1, .p = 1, .beta = 0.75, .criterion = Criterion::exact},
                        {0.05, 0.05}};
  RecordDesignRequest request = request_of(task);
  request.tolerance = {{}, {}, {}, {}};
  request.parts = {{"A", 0.26, 0.47}, {"B", 0.3, 0.08}, {"C", 0.31, 0.05}};
  for (const RatedPart& part : design::design(request).parts) {
    BOOST_TEST(part.admissible == serves(task, part.part.f, part.part.delta), part.part.name);
  }
  request = request_of(task);
  request.trade_offs = 4;
  for (const SuitePoint& point : design::design(request).trade_off) {
    const Response own = free_response({1, point.damper.f, point.damper.delta, {}, task.zeta.low},
                                       {0, task.problem.v0});
    BOOST_TEST(std::abs(point.figures.front().peak / own.peak_amplitude - 1) <= rounding);
  }
}

BOOST_AUTO_TEST_SUITE_END()
