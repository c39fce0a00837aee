// SPDX-License-Identifier: MIT
#include "any_task.hpp"
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(residual_test)

// A residual, docs/theory.md section 13: what is admissible, and what each row says, against the
// motions of single hits.

using namespace stillpoint::design_test;

Response motion_of(const Sample& at) {
  return free_response({at.p, at.f, at.delta}, {0, at.v0}, {.times = false});
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
      BOOST_TEST(rows[2].satisfied == (motion_of(at).peak_amplitude <= problem.beta));
      BOOST_TEST((rows[3].satisfied && rows[4].satisfied) == *rests);
    }
    ++cases[static_cast<std::size_t>((*rests ? 2 : 0) + (rows[0].satisfied ? 1 : 0))];
  }
  for (const int count : cases) {
    BOOST_TEST(count > 1000);
  }
}

BOOST_AUTO_TEST_SUITE_END()
