// SPDX-License-Identifier: MIT
#include "motion.hpp"

// Short pulses, p = 1: eps = 1 / lambda. Expected values in closed form.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(forced_pulse_test)

/// The amplitude without friction, long after the pulse.
double free_amplitude(const Excitation& pulse) {
  const auto response = forced_response({1, 0, 0}, {0, 0}, pulse, {.t_end = 20});
  return std::hypot(*response.final_position, *response.final_velocity);
}

BOOST_AUTO_TEST_CASE(without_friction_each_pulse_leaves_its_closed_form) {
  for (const double k : {0.1, 1.0}) {
    for (const double eps : {0.9, 0.5, 0.2, 0.05, 1e-3}) {
      const double lambda = 1 / eps;
      const double half = 2 * k * eps * std::cos(pi * eps / 2) / (1 - eps * eps);
      const double full = 2 * k * eps * std::sin(pi * eps) / (1 - eps * eps);
      const double flat = 2 * k * std::sin(pi * eps / 2);
      BOOST_TEST(std::abs(free_amplitude(HalfSine{k, lambda}) - half) <= 1e-14);
      BOOST_TEST(std::abs(free_amplitude(FullSine{k, lambda}) - full) <= 1e-14);
      BOOST_TEST(std::abs(free_amplitude(Rectangle{k, lambda}) - flat) <= 1e-14);
      // |integral of W exp(i tau)|
      const double lasts = pi * eps;
      const double sine = std::sin(lasts);
      const double bend = 2 * std::sin(lasts / 2) * std::sin(lasts / 2);
      const double tooth =
          k / lasts * std::hypot(lasts * sine - bend, sine - lasts * std::cos(lasts));
      const double flanks = 2 * k * std::sin(0.45 * lasts) * std::sin(lasts / 20) / (lasts / 20);
      const double squared = k * std::sin(lasts / 2) / (1 - eps * eps / 4);
      BOOST_TEST(std::abs(free_amplitude(Sawtooth{k, lambda}) - tooth) <= 1e-14);
      BOOST_TEST(std::abs(free_amplitude(Trapezoid{k, lambda}) - flanks) <= 1e-14);
      BOOST_TEST(std::abs(free_amplitude(Haversine{k, lambda}) - squared) <= 1e-14);
    }
  }
}

/// Those that leave a velocity.
template <class Check>
void for_pulses(double lambda, const Check& check) {
  check(HalfSine{0.5, lambda});
  check(Rectangle{0.5, lambda});
  check(Sawtooth{0.5, lambda});
  check(Trapezoid{0.5, lambda});
  check(Haversine{0.5, lambda});
}

template <class Pulse>
void check_is_record(const ForcedScene<>& scene, const Pulse& pulse, double rounding) {
  ForcedScene<> same = scene;
  same.excitation = pulse;
  const ForcedState<double> state = run_forced(same).state;
  same.excitation = record_of(pulse, *duration(pulse));
  const ForcedState<double> as_record = run_forced(same).state;
  const double scale = std::abs(state.u) + std::abs(state.v);
  BOOST_TEST_CONTEXT(same) {
    BOOST_TEST(std::abs(state.u - as_record.u) <= rounding * scale);
    BOOST_TEST(std::abs(state.v - as_record.v) <= rounding * scale);
    BOOST_TEST(state.passages == as_record.passages);
    BOOST_TEST(state.sticks == as_record.sticks);
    const auto& felt = state.transmitted;
    BOOST_TEST(std::abs(felt.slid - as_record.transmitted.slid) <= rounding * felt.slid);
    BOOST_TEST(std::abs(felt.held - as_record.transmitted.held) <= rounding * felt.held);
  }
}

BOOST_AUTO_TEST_CASE(trapezoid_and_sawtooth_are_records_of_their_corners) {
  Dice dice(20261128);
  for (int i = 0; i < 500; ++i) {
    const ForcedScene<> scene = random_damped_scene(dice);
    const double k = dice.sign() * dice.power_of_ten(-1, 1);
    const double lambda = scene.motion.p * dice.power_of_ten(-1, 1);
    check_is_record(scene, Trapezoid{k, lambda}, 0);
    check_is_record(scene, Sawtooth{k, lambda}, 1e-9);
  }
}

// A constant load moves the centre of the motion, (F39), and no rule if x = 0 is not special.
BOOST_AUTO_TEST_CASE(a_haversine_is_a_harmonic_and_a_constant) {
  Dice dice(20261129);
  for (int i = 0; i < 500; ++i) {
    ForcedScene<> scene = random_forced_scene(dice);
    scene.motion.delta = 0;
    scene.zeta = dice.once_in(2) ? 0 : dice.uniform(0, 0.5);
    const double p = scene.motion.p;
    const Haversine pulse{dice.sign() * dice.power_of_ten(-1, 1), p * dice.power_of_ten(-1, 1)};
    const double shift = pulse.k / 2 / p;
    scene.excitation = pulse;
    scene.t_end = *duration(pulse) * dice.uniform(0.05, 0.99);
    const ForcedState<double> state = run_forced(scene).state;
    scene.excitation = Harmonic{pulse.k / 2, 2 * pulse.lambda, -pi / 2};
    scene.motion.x0 += shift / p;
    const ForcedState<double> shifted = run_forced(scene).state;
    const double scale = std::abs(shift) + state.farthest + std::abs(scene.motion.v0);
    BOOST_TEST_CONTEXT(scene) {
      BOOST_TEST(std::abs(state.u + shift - shifted.u) <= 1e-11 * scale);
      BOOST_TEST(std::abs(state.v - shifted.v) <= 1e-11 * scale);
      BOOST_TEST(state.sticks == shifted.sticks);
    }
  }
}

// (F22) and (F23), from where the load or the mass ends, whichever is first: on a spring so soft
// that only load and friction matter.
BOOST_AUTO_TEST_CASE(the_equivalent_start_is_that_of_the_motion_under_load_and_friction) {
  constexpr double soft = 1e-6;
  constexpr double of_the_spring = 1e-10;
  const auto close = tt::tolerance(of_the_spring);
  for_pulses(20, [&](const auto& pulse) {
    for (const double ratio : {0.0, 0.04, 0.3, 0.5, 0.7, 0.75, 0.9, 0.99}) {
      const double f = ratio * pulse.k;
      const ForcedTrajectory path({soft, f, 0}, {}, pulse, {*duration(pulse)});
      const auto turn = std::ranges::find(path.events(), EventKind::turn, &Event::kind);
      const State end = turn != path.events().end() ? turn->state : path.at(path.horizon());
      const double x = std::abs(end.x);
      const double v = std::abs(end.v);
      const double speed = std::sqrt(v * v + 2 * f * x);
      BOOST_TEST_CONTEXT(pulse.name << ", f = " << ratio << " k") {
        const EquivalentStart start = equivalent_start(pulse, f).value();
        BOOST_TEST(start.speed == speed, close);
        BOOST_TEST(start.tau == end.tau - 2 * x / (speed + v), close);
      }
    }
  });
  BOOST_TEST(equivalent_start(HalfSine{-0.5, 20}, 0)->speed == 0.05);
  BOOST_TEST(!equivalent_start(HalfSine{0.5, 20}, 0.5).has_value());
  BOOST_TEST(!equivalent_start(Rectangle{0.5, 20}, 0.6).has_value());
}

// (F23): tau_s and the free stop time against the true one. The free motion rests at its turn,
// without point friction, where f / p is more than half of the peak.
BOOST_AUTO_TEST_CASE(the_equivalent_start_is_right_to_second_order) {
  for_pulses(1, [](auto pulse) {
    double before = 0;
    for (const double eps : {0.00625, 0.003125, 0.0015625}) {
      pulse.lambda = 1 / eps;
      const double f = 0.3 * eps;  // the motion keeps its shape as it shrinks
      const auto forced = forced_response({1, f, 0}, {0, 0}, pulse);
      const EquivalentStart start = equivalent_start(pulse, f).value();
      const auto free = free_response({1, f, 0}, {0, start.speed});
      BOOST_TEST(*forced.half_cycles == *free.half_cycles);
      const double error = std::abs((start.tau + *free.stop_time) / *forced.stop_time - 1);
      if (before > 0) {
        BOOST_TEST(std::log2(before / error) > 1.9);
      }
      before = error;
    }
    BOOST_TEST(before <= 1e-6);
  });
}

BOOST_AUTO_TEST_CASE(the_equivalent_velocity_vanishes_as_friction_comes_to_equal_the_load) {
  // k = lambda = 1, f = 1 - d: 3 d to first order. v^2 is a difference of numbers near 1.
  constexpr double rounding = 3e-8;  // twice the root of an epsilon
  for (double d = 0x1p-28; d >= 0x1p-53; d /= 1.25) {
    const auto start = equivalent_start(HalfSine{1, 1}, 1 - d).value_or(EquivalentStart{});
    BOOST_TEST(std::abs(start.speed - 3 * d) <= rounding, start.speed << " at 1 - " << d);
    BOOST_TEST(start.tau >= 0);
    BOOST_TEST(start.tau <= pi);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
