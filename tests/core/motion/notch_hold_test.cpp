// SPDX-License-Identifier: MIT
#include "motion.hpp"

// A notch that lets go, docs/notches.md rule 1, with inputs for which the answer is
// simple.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(notch_hold_test)

constexpr double infinite = std::numeric_limits<double>::infinity();

BOOST_AUTO_TEST_CASE(a_load_of_exactly_f_and_hold_is_held_and_an_ulp_more_is_not) {
  // 0.1 + 0.2 rounds up to 0.30000000000000004, 0.3 is below the exact sum, and that above it.
  for (const double k : {0.3, -0.3, 0.30000000000000004, -0.30000000000000004}) {
    for (const double p : {1.0, 0.7, 3.3}) {
      const bool held = std::abs(k) == 0.3;
      const auto response = run({p, 0.1, 1, 0.2}, {0, 0}, constant(k), 10);
      BOOST_TEST((*response.half_cycles == 0) == held);
      // Under a pulse, and by its crest under a harmonic.
      BOOST_TEST((*run({p, 0.1, 1, 0.2}, {0, 0}, Rectangle{k, 1}, 10).half_cycles == 0) == held);
      BOOST_TEST((*run({p, 0.1, 1, 0.2}, {0, 0}, Harmonic{k, 1}, 10).half_cycles == 0) == held);
    }
  }
  // 0.25 + 0.5 is exact.
  BOOST_TEST(*run({1, 0.25, 1, 0.5}, {0, 0}, constant(0.75), 10).half_cycles == 0);
  BOOST_TEST(*run({1, 0.25, 1, 0.5}, {0, 0}, constant(std::nextafter(0.75, 1.0)), 10).half_cycles ==
             1);
}

BOOST_AUTO_TEST_CASE(each_departure_from_the_notch_begins_a_half_cycle) {
  const Oscillator oscillator{1, 0.02, 0.1, 0.1};
  const Harmonic load{0.3, 0.5};
  const auto response = run(oscillator, {0, 0}, load, 60);
  const auto list = forced_half_cycles(oscillator, {0, 0}, load, 60, 100);
  BOOST_TEST(static_cast<double>(list.size()) == *response.half_cycles);
  BOOST_TEST(list.size() > 5U);
  for (std::size_t i = 0; i < list.size(); ++i) {
    // It leaves with v = 0 where |W| = 0.12, later than it came to rest.
    BOOST_TEST(list[i].departure_speed == 0);
    BOOST_TEST(std::abs(std::abs(0.3 * std::sin(list[i].start_time / 2)) - 0.12) <= 1e-14);
    if (i > 0) {
      BOOST_TEST(list[i].start_time > list[i - 1].end_time);
      BOOST_TEST(list[i].side == -list[i - 1].side);
    }
  }
  // A run that ends while the notch holds the mass knows the same half-cycle.
  for (std::size_t i = 1; i < list.size(); ++i) {
    const double held = (list[i - 1].end_time + list[i].start_time) / 2;
    const HalfCycle last = forced_half_cycles(oscillator, {0, 0}, load, held, 100).back();
    BOOST_TEST(last.index == list[i - 1].index);
    BOOST_TEST(last.end_time == list[i - 1].end_time);
  }
  const ForcedTrajectory path(oscillator, {0, 0}, load, {.horizon = 60});
  for (const HalfCycle& now : list) {
    BOOST_TEST(std::abs(path.at(now.start_time).x) <= 1e-14);
    BOOST_TEST(std::abs(path.at(now.peak_time).x - now.side * now.peak) <= 1e-13);
  }
}

/// A hold of 1e100 is another branch at each rest, and no other motion.
BOOST_AUTO_TEST_CASE(a_hold_beyond_every_load_changes_no_bit) {
  int stopped = 0;
  for (int i = 0; i < 200; ++i) {
    const double f = 0.001 * (i % 70);
    const double delta = 0.001 * (1 + i % 40);
    const Harmonic load{0.1 + 0.002 * i, 0.3 + 0.01 * i, 0.1 * i};
    const Start start{0, 0.3 + 0.005 * i};
    const auto paper = run({1, f, delta}, start, load, 50);
    auto held = run({1, f, delta, 1e100}, start, load, 50);
    held.sticks = paper.sticks;  // the others are rests for ever
    held.stick_time = paper.stick_time;
    held.decision_margin = paper.decision_margin;
    BOOST_TEST((held == paper));
    stopped += paper.outcome == Outcome::stopped_at_zero;
  }
  BOOST_TEST(stopped > 20);
}

BOOST_AUTO_TEST_CASE(a_wrong_hold_is_refused) {
  for (const double hold :
       {-1.0, -infinite, infinite, std::numeric_limits<double>::quiet_NaN(), 1e200}) {
    BOOST_CHECK_THROW((void)run({1, 0, 1, hold}, {0, 0}, constant(1), 10), InputError);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
