// SPDX-License-Identifier: MIT
#include "motion.hpp"

// Where the energy goes: docs/forced.md section 11.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(motion_energies_test)

/// Of the sum of the sizes of all energies.
constexpr double balance_tolerance = 1e-12;
constexpr double rounding = 1e-14;

/// What the balance leaves over, as a share of the sizes. A load may take back all that it gave,
/// but that is seen in the speed.
double imbalance(const MotionEnergies& of) {
  const Energies& parts = of.energies.value();
  const double gone = parts.end + parts.friction + parts.notch + parts.damping;
  const double size =
      parts.start + std::abs(parts.load) + gone + of.peak_velocity * of.peak_velocity / 2;
  return size > 0 ? std::abs(parts.start + parts.load - gone) / size : 0;
}

Energies of_free(const Oscillator& oscillator, const Start& start) {
  return motion_energies(oscillator, start, NoExcitation()).energies.value();
}

/// To its end, or that of the run; empty with very many half-cycles: each piece of one in zones may
/// round by half an ulp in the same direction.
std::optional<MotionEnergies> of_scene(const ForcedScene<>& scene, bool to_end) {
  constexpr double most_half_cycles = 5e3;
  try {
    return motion_energies(scene.oscillator(), scene.motion.start(), scene.excitation,
                           {.t_end = to_end ? std::nullopt : std::optional(scene.t_end),
                            .half_cycle_limit = most_half_cycles},
                           scene.surface);
  } catch (const TooManyHalfCycles&) {
    return std::nullopt;
  }
}

/// A run negates its load as well, bit for bit, if that is no sine.
bool mirrors(ForcedScene<>& scene) {
  scene.motion.x0 = -scene.motion.x0;
  scene.motion.v0 = -scene.motion.v0;
  if (auto* record = std::get_if<Record>(&scene.excitation)) {
    std::ranges::transform(record->values, record->values.begin(), std::negate());
    return true;
  }
  return std::visit(
      []<class Kind>(Kind& kind) {
        if constexpr (IsPolygon<Kind>) {
          kind.k = -kind.k;
        }
        return IsPolygon<Kind> || std::is_same_v<Kind, NoExcitation>;
      },
      scene.excitation);
}

BOOST_AUTO_TEST_CASE(random_motions_keep_their_energy_in_balance) {
  std::uint64_t seed = 1;
  for (const auto random_scene :
       {&random_forced_scene, &random_notched_scene, &random_damped_scene}) {
    Dice dice(seed);
    for (int i = 0; i < forced_scene_count() / 2; ++i) {
      ForcedScene<> scene = random_scene(dice);
      if (dice.once_in(6)) {
        scene.excitation = NoExcitation();
      }
      const bool to_end = duration(scene.excitation) && dice.once_in(2);
      BOOST_TEST_CONTEXT("seed " << seed << ", scene " << i << ": " << scene) {
        const std::optional<MotionEnergies> found = of_scene(scene, to_end);
        if (found && found->energies) {
          const Energies& parts = *found->energies;
          BOOST_TEST(imbalance(*found) <= balance_tolerance);
          BOOST_TEST(std::min({parts.friction, parts.notch, parts.damping}) >= 0);
        }
        if (mirrors(scene)) {
          BOOST_TEST((of_scene(scene, to_end) == found));
        }
      }
    }
    ++seed;
  }
}

BOOST_AUTO_TEST_CASE(a_fast_load_keeps_the_balance_over_many_of_its_turns) {
  Dice dice(4);
  for (int i = 0; i < 30; ++i) {
    const double v0 = dice.power_of_ten(-1, 2);
    const double k = dice.power_of_ten(0, 3);
    const double lambda = dice.power_of_ten(1.5, 4);
    const Harmonic load{k, lambda, dice.uniform(-4, 4)};
    const Oscillator oscillator{.p = 1, .f = dice.power_of_ten(-2, 0), .delta = 0.001};
    const MotionEnergies found = motion_energies(oscillator, {0, v0}, load, {.t_end = 10});
    BOOST_TEST_CONTEXT("k " << k << ", lambda " << lambda << ", v0 " << v0) {
      BOOST_TEST(imbalance(found) <= balance_tolerance);
    }
  }
}

/// Peaks at 1, 0.8, 0.6, 0.4 and 0.2, the last of which leads to x = 0.
BOOST_AUTO_TEST_CASE(friction_takes_f_times_the_way_from_peak_to_peak) {
  const MotionEnergies found = motion_energies({.p = 1, .f = 0.1}, {1, 0}, NoExcitation());
  BOOST_TEST(std::abs(found.energies->slip_path - 5) <= rounding);
  BOOST_TEST(std::abs(found.energies->friction - 0.5) <= rounding);
  BOOST_TEST(std::abs(found.energies->end) <= rounding);
  BOOST_TEST(std::abs(found.peak_velocity - 0.9) <= rounding);
}

/// v^2 is 1, 3/4, 1/2 and 1/4 as it leaves x = 0, and each peak is v/p.
BOOST_AUTO_TEST_CASE(a_notch_takes_delta_at_each_passage) {
  const Energies found = of_free({.p = 2, .delta = 0.125}, {0, 1});
  BOOST_TEST(found.notch == 0.5);
  BOOST_TEST(found.friction == 0);
  BOOST_TEST(std::abs(found.slip_path - (1.5 + std::sqrt(0.75) + std::sqrt(0.5))) <= rounding);
}

BOOST_AUTO_TEST_CASE(the_way_past_very_many_notches_is_that_of_their_sum) {
  constexpr int passages = 100'000;
  const double delta = 0.5 / passages;
  double sum = 0;
  for (int n = 1; n <= passages; ++n) {
    sum += 2 * std::sqrt(2 * delta * n);
  }
  const Energies found = of_free({.p = 1, .delta = delta}, {0, 1});
  BOOST_TEST(std::abs(found.slip_path / sum - 1) <= 1e-12);
}

BOOST_AUTO_TEST_CASE(astronomically_many_half_cycles_keep_the_balance) {
  for (const double f : {1e-9, 1e-100}) {
    const MotionEnergies found = motion_energies({.p = 1, .f = f}, {0, 1}, NoExcitation());
    BOOST_TEST(imbalance(found) <= rounding);
    BOOST_TEST(std::abs(found.energies->slip_path * f - 0.5) <= rounding);
  }
}

BOOST_AUTO_TEST_CASE(a_start_that_the_notch_catches_gives_it_all) {
  for (const std::optional<double> hold : {std::optional<double>(), std::optional(0.2)}) {
    const Oscillator oscillator{.p = 1, .f = 0.1, .delta = 1, .hold = hold};
    for (const Excitation& load : {Excitation(), Excitation(HalfSine{0.25, 1})}) {
      const MotionEnergies found = motion_energies(oscillator, {0, 1}, load);
      BOOST_TEST((found == MotionEnergies{1, Energies{.notch = 0.5, .start = 0.5}}));
    }
  }
}

BOOST_AUTO_TEST_CASE(a_load_that_friction_holds_does_no_work) {
  const auto found =
      motion_energies({.p = 1, .f = 0.1}, {0.01, 0}, Harmonic{0.08, 1}, {.t_end = 50});
  BOOST_TEST((found == MotionEnergies{0, Energies{.start = 5e-5, .end = 5e-5}}));
}

BOOST_AUTO_TEST_CASE(damping_alone_takes_all_but_an_exponential) {
  constexpr double zeta = 0.1;
  const double omega = std::sqrt(1 - zeta * zeta);
  const Oscillator oscillator{.p = 2, .zeta = zeta};
  const double t_end = 3 * 2 * pi / (omega * oscillator.p);
  const auto found =
      motion_energies(oscillator, {0, 1}, NoExcitation(), {.t_end = t_end}).energies.value();
  const double left = std::exp(-2 * zeta * oscillator.p * t_end);
  BOOST_TEST(std::abs(found.damping - 0.5 * (1 - left)) <= rounding);
  BOOST_TEST(found.friction == 0);
}

/// From a turn at u, v(h) = -u exp(-zeta h) sin(omega h)/omega is largest at tan(omega h) =
/// omega/zeta, where the sine is omega.
BOOST_AUTO_TEST_CASE(a_motion_that_never_ends_has_only_its_peak_velocity) {
  for (const double zeta : {0.0, 0.1}) {
    const MotionEnergies found = motion_energies({.p = 2, .zeta = zeta}, {0.5, 0}, NoExcitation());
    const double omega = std::sqrt(1 - zeta * zeta);
    BOOST_TEST(!found.energies);
    BOOST_TEST(std::abs(found.peak_velocity - std::exp(-zeta * std::acos(zeta) / omega)) <=
               rounding);
  }
}

/// Published by others: the normal force, 10 times the friction here, times the distance slid from
/// t = 4 to 12 over that time, without a spring.
BOOST_AUTO_TEST_CASE(friction_under_a_sine_wears_as_published) {
  struct Row {
    double k, power;
  };
  for (const auto& [k, power] :
       {Row{15, 15.2671}, Row{1.5, 0.409062}, Row{1.01, 2.26164e-4}, Row{0.99, 0}}) {
    const auto worn = [load = Harmonic{k, 2 * pi}](double t_end) {
      const Oscillator oscillator{.p = 1e-4, .f = 1};
      return motion_energies(oscillator, {}, load, {.t_end = t_end}).energies->friction;
    };
    BOOST_TEST(std::abs(10 * (worn(12) - worn(4)) / 8 - power) <= 1e-5 * power);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
