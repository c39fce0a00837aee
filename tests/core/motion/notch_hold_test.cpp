// SPDX-License-Identifier: MIT
#include "motion.hpp"

// A notch of limited capacity, docs/notches.md rule 1, with inputs for which the answer is
// simple.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(notch_hold_test)

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

BOOST_AUTO_TEST_CASE(a_notch_lets_go_when_the_load_exceeds_what_it_and_friction_hold) {
  // W = 0.2 sin(tau / 2) exceeds f + h = 0.05 + 0.05 at tau = pi / 3 and sets off with v = 0 and
  // a = -h: x = -0.05 h^2 / 2 to first order.
  const auto response = run({1, 0.05, 0.5, 0.05}, {0, 0}, Harmonic{0.2, 0.5}, pi / 3 + 1e-6);
  BOOST_TEST(response.sticks == 1);
  close(response.stick_time, pi / 3);
  BOOST_TEST(*response.final_position == -0.05 * 1e-12 / 2, tt::tolerance(1e-5));
  BOOST_TEST(!response.left_notch_from_rest);
  BOOST_TEST(*response.zero_passages == 0);
  BOOST_TEST(*run({1, 0.05, 0.5, 0.05}, {0, 0}, Harmonic{0.2, 0.5}, pi / 3 - 1e-6).half_cycles ==
             0);
}

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

BOOST_AUTO_TEST_CASE(an_arrival_that_the_notch_stops_is_decided_by_the_load_at_once) {
  // W = 1 pushes from x = 0.25, v = 0 back: about -1 with amplitude 1.25, at x = 0 v^2 = 0.5625 <
  // 2 * 0.3. The load 1 exceeds h = 0.9: it sets off again from v = 0, about -1 up to -2 and back.
  const auto goes_on = run({1, 0, 0.3, 0.9}, {0.25, 0}, constant(1), 6);
  BOOST_TEST(*goes_on.zero_passages == 1);
  BOOST_TEST(goes_on.sticks == 0);
  close(goes_on.peak_amplitude, 2);
  const double stopped = std::acos(0.8);
  close(*goes_on.final_position, -1 + std::cos(6 - stopped));
  // With h = 1 it is held.
  const auto stays = run({1, 0, 0.3, 1}, {0.25, 0}, constant(1), 6);
  BOOST_TEST(stays.outcome == Outcome::running);  // the record might still release it
  BOOST_TEST(*stays.final_position == 0);
  BOOST_TEST(*stays.zero_passages == 0);
  BOOST_TEST(stays.sticks == 1);
  close(stays.stick_time, 6 - stopped);
}

BOOST_AUTO_TEST_CASE(without_any_hold_the_notch_only_takes_energy) {
  // h = 0, f = 0: any load but 0 sets the mass free.
  const auto response = run({1, 0, 0.3, 0}, {0.25, 0}, constant(1), 6);
  BOOST_TEST(*response.zero_passages == 1);
  const auto from_rest = run({1, 0, 0.3, 0}, {0, 0}, constant(1e-300), 6);
  BOOST_TEST(*from_rest.half_cycles == 1);
  const auto nothing = run({1, 0, 0.3, 0}, {0, 0}, constant(0), 6);
  BOOST_TEST(*nothing.half_cycles == 0);
}

BOOST_AUTO_TEST_CASE(a_caught_start_waits_for_its_load) {
  // v0^2 = 1 < 2 * 0.51. W = 0.2 sin(tau / 2) exceeds 0.1 at pi / 3.
  const auto leaves = run({1, 0, 0.51, 0.1}, {0, 1}, Harmonic{0.2, 0.5}, 2);
  BOOST_TEST(*leaves.half_cycles == 1);
  close(leaves.stick_time, pi / 3);
  const auto held = run({1, 0, 0.51, 0.2}, {0, 1}, Harmonic{0.2, 0.5}, 2);
  BOOST_TEST(held.outcome == Outcome::caught_at_start);
  BOOST_TEST(*held.stop_time == 0);
  const auto after_a_pulse = run({1, 0, 0.51, 0.2}, {0, 1}, HalfSine{0.2, 0.5}, std::nullopt);
  BOOST_TEST(after_a_pulse.outcome == Outcome::caught_at_start);
}

BOOST_AUTO_TEST_CASE(a_rest_in_the_notch_is_final_once_the_load_is_over) {
  const auto response = run({1, 0.02, 0.3, 0.05}, {0, 0}, HalfSine{0.5, 2}, std::nullopt);
  BOOST_TEST(response.outcome == Outcome::stopped_at_zero);
  BOOST_TEST(response.stop_position.value() == 0);
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
    const auto held = run({1, f, delta, 1e100}, start, load, 50);
    BOOST_TEST(held.outcome == paper.outcome);
    BOOST_TEST(held.peak_amplitude == paper.peak_amplitude);
    BOOST_TEST(held.peak_absolute_acceleration == paper.peak_absolute_acceleration);
    BOOST_TEST((held.stop_time == paper.stop_time));
    BOOST_TEST((held.stop_position == paper.stop_position));
    BOOST_TEST((held.half_cycles == paper.half_cycles));
    BOOST_TEST((held.locked_from == paper.locked_from));
    BOOST_TEST((held.final_velocity == paper.final_velocity));
    stopped += paper.outcome == Outcome::stopped_at_zero;
  }
  BOOST_TEST(stopped > 20);
}

BOOST_AUTO_TEST_CASE(the_structure_feels_what_the_notch_holds_until_it_lets_go) {
  // |W| grows to f + h = 0.12 before each release; sliding, f + p^2 |x| is more: 0.02 + 0.5078.
  const Harmonic load{0.3, 0.5};
  const auto slides = run({1, 0.02, 0.1, 0.1}, {0, 0}, load, 60);
  close(slides.peak_absolute_acceleration, 0.02 + slides.peak_amplitude);
  BOOST_TEST(!slides.locked_from);  // it slides at the end
  // f + h = 0.29 is felt at the release at asin(0.29 / 0.3) / 0.5, and before it nothing else.
  const auto released = run({1, 0.09, 0.1, 0.2}, {0, 0}, load, 2.7);
  BOOST_TEST(*released.half_cycles == 1);
  close(released.peak_absolute_acceleration, 0.29);
  // A notch that holds all of the load locks from the start.
  const auto locked = run({1, 0.09, 0.1, 0.25}, {0, 0}, load, 60);
  BOOST_TEST(locked.locked_from.value() == 0);
  close(locked.largest_load_while_locked.value(), 0.3);
  close(locked.peak_absolute_acceleration, 0.3);
}

BOOST_AUTO_TEST_CASE(a_batch_takes_a_hold) {
  const Eigen::ArrayXd f = Eigen::ArrayXd::LinSpaced(5, 0, 0.1);
  const Eigen::ArrayXd delta = Eigen::ArrayXd::LinSpaced(5, 0, 0.2);
  ForcedBatchOptions options;
  options.scene.t_end = 30;
  options.hold = 0.07;
  const auto all = forced_batch(0.3, 1, f, delta, Harmonic{0.3, 0.7}, options);
  for (Eigen::Index i = 0; i < f.size(); ++i) {
    const auto one = run({1, f[i], delta[i], 0.07}, {0, 0.3}, Harmonic{0.3, 0.7}, 30);
    BOOST_TEST(*all[static_cast<std::size_t>(i)].final_position == *one.final_position);
  }
}

BOOST_AUTO_TEST_CASE(a_wrong_hold_is_refused) {
  for (const double hold :
       {-1.0, -infinite, infinite, std::numeric_limits<double>::quiet_NaN(), 1e200}) {
    BOOST_CHECK_THROW((void)run({1, 0, 1, hold}, {0, 0}, constant(1), 10), InputError);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
