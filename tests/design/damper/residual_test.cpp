// SPDX-License-Identifier: MIT
#include "any_task.hpp"
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(residual_test)

// A residual, docs/theory.md section 13: what is admissible, and what each row says, against the
// motions of single hits.

using namespace stillpoint::design_test;
using namespace stillpoint::design_test;

Response motion_of(const Sample& at) {
  return free_response({at.p, at.f, at.delta}, {0, at.v0}, {.times = false});
}

double peak_of(const Sample& at) {
  return motion_of(at).peak_amplitude;
}

/// Its rest, beside the dead zone and the peak, which have rows of their own; empty if rounding may
/// decide.
std::optional<bool> rests_in_time(const Problem& problem, const Sample& at) {
  const Response motion = motion_of(at);
  const double off = std::abs(*motion.stop_position);
  const double r = std::min(problem.residual.value_or(0), problem.beta);
  const bool at_the_edge = r > 0 && std::abs(off / r - 1) < undecided_within;
  if (*motion.decision_margin < undecided_within || at_the_edge) {
    return std::nullopt;
  }
  return *motion.half_cycles <= static_cast<double>(problem.arrivals) && off <= r;
}

/// Whether every hit of a grid over the range rests in time, within beta and below the dead zone.
std::optional<bool> serves_a_grid(const Problem& problem, double f, double delta) {
  constexpr int steps = 400;
  bool all = f < problem.beta * problem.p * problem.p;
  for (int i = 0; i <= steps; ++i) {
    const double v0 = *problem.v0_low + (problem.v0 - *problem.v0_low) * i / steps;
    const Sample at{f, delta, v0, problem.p};
    const auto rests = rests_in_time(problem, at);
    if (!rests) {
      return std::nullopt;
    }
    all = all && *rests && 2 * delta <= v0 * v0 && peak_of(at) <= problem.beta;
  }
  return all;
}

// What a row says is true of the motion, whatever the other rows say: also where the peak is too
// large or friction could hold the mass at the limit of the stroke.
BOOST_AUTO_TEST_CASE(each_row_with_a_residual_says_what_the_motion_does) {
  std::array<int, 4> cases{};  // rests or not, in either kind of dead zone
  for (std::uint64_t seed = 1'220'000; seed < 1'240'000; ++seed) {
    RandomSource random(seed);
    Problem problem{random.log_uniform(0.1, 10), random.log_uniform(0.1, 10), 0, Criterion::exact};
    const double length = problem.v0 / problem.p;
    problem.beta = length * random.log_uniform(0.05, 3);
    problem.residual = length * random.log_uniform(0.02, 2);
    problem.arrivals = 1 + random.pick(3);
    const Sample at{problem.v0 * problem.p * random.log_uniform(0.02, 5),
                    problem.v0 * problem.v0 / 2 * random.log_uniform(1e-3, 1), problem.v0,
                    problem.p};
    const auto rests = rests_in_time(problem, at);
    if (!rests) {
      continue;
    }
    const auto rows = constraints(problem, at.f, at.delta);
    BOOST_TEST_CONTEXT("seed " << seed) {
      BOOST_TEST(rows[0].satisfied == (at.f < problem.beta * problem.p * problem.p));
      BOOST_TEST(rows[2].satisfied == (peak_of(at) <= problem.beta));
      BOOST_TEST((rows[3].satisfied && rows[4].satisfied) == *rests);
      BOOST_TEST(admissible(problem, {}, at.f, at.delta) ==
                 std::ranges::all_of(rows, &Constraint::satisfied));
    }
    ++cases[static_cast<std::size_t>((*rests ? 2 : 0) + (rows[0].satisfied ? 1 : 0))];
  }
  for (const int count : cases) {
    BOOST_TEST(count > 1000);
  }
}

BOOST_AUTO_TEST_CASE(a_damper_is_admissible_if_all_hits_of_a_range_rest_within_the_residual) {
  int served = 0;
  int refused = 0;
  int between = 0;  // two hits of the grid
  for (std::uint64_t seed = 1'250'000; seed < 1'258'000; ++seed) {
    RandomSource random(seed);
    Problem problem{1, 1, random.log_uniform(0.3, 1.5), Criterion::exact};
    problem.v0_low = 1 - random.log_uniform(0.01, 0.6);
    problem.residual = random.log_uniform(0.05, 1);
    problem.arrivals = 1 + random.pick(3);
    const double f = random.log_uniform(0.03, 2);
    const double delta = random.log_uniform(1e-3, 0.5);
    if (const auto serves = serves_a_grid(problem, f, delta)) {
      const bool claimed = admissible(problem, {}, f, delta);
      BOOST_TEST((*serves || !claimed), "seed " << seed);
      (claimed ? served : refused) += 1;
      between += *serves && !claimed;
    }
  }
  BOOST_TEST(served > 500);
  BOOST_TEST(refused > 500);
  BOOST_TEST(between < 10);
}

BOOST_AUTO_TEST_SUITE_END()
