// SPDX-License-Identifier: MIT
#include "motion.hpp"

// Under a harmonic that barely exceeds the friction, a slip is as small as the square of the
// excess, which is the difference of two inputs. Every metric must nevertheless be that of inputs
// changed by rounding: its error is compared with its condition, sum |d metric / d ln input|, from
// runs in 50 digits. docs/forced.md section 9.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(forced_condition_test)

// Units of 2^-53 times the condition. The worst of 4000 scenes is 92: a slip grows as the fourth
// power of an angle, and it may be the last of a hundred.
constexpr double allowed_units = 128;

constexpr std::array<const char*, 6> names{"final position",    "final velocity", "peak amplitude",
                                           "peak acceleration", "arrival speed",  "stick time"};

template <class Real>
std::array<Real, 6> metrics_of(const ForcedState<Real>& state, const Real& p) {
  using std::abs;
  return {state.u / p,
          state.v,
          std::max(state.farthest, Real(abs(state.u))) / p,
          state.acceleration * p,
          state.arrival_speed.value_or(Real(0)),
          state.stuck.value() / p};
}

/// From rest or not, f below |k| by 1e-9 to 1e-2 of it.
ForcedScene<> friction_near_load(Dice& dice) {
  const double p = dice.power_of_ten(-1, 1);
  const double lambda = p * dice.power_of_ten(-1, 1);
  const double k = dice.power_of_ten(-1, 1);
  const double v = k / std::max(p, lambda);
  const bool rests = dice.once_in(2);
  return {{rests ? 0 : dice.sign() * v / p * dice.power_of_ten(-3, 0),
           rests || dice.once_in(2) ? 0 : dice.sign() * v * dice.power_of_ten(-3, 0), p,
           k * (1 - dice.power_of_ten(-9, -2)),
           dice.once_in(2) ? 0 : v * v * dice.power_of_ten(-12, -0.2)},
          Harmonic{dice.sign() * k, lambda, dice.uniform(-4, 4)},
          dice.uniform(1, 30) / p};
}

/// Sums over the inputs of |d metric / d ln input|, by one-sided differences. An input for which
/// either side is another motion is left out, which makes the bound stricter.
std::array<Exact, 6> conditions(ForcedScene<Exact> moved, const ForcedRecord<Exact>& run) {
  const Exact step("1e-22");
  const std::array<Exact, 6> metrics = metrics_of(run.state, moved.motion.p);
  std::array<Exact, 6> sums{};
  const auto add = [&](Exact& input) {
    const Exact before = input;
    for (const int direction : {1, -1}) {
      input = before * (1 + direction * step);
      const ForcedRecord<Exact> there = run_forced(moved);
      if (there.seen.kinds == run.seen.kinds) {
        const std::array<Exact, 6> others = metrics_of(there.state, moved.motion.p);
        for (std::size_t j = 0; j < sums.size(); ++j) {
          sums[j] += abs(Exact(others[j] - metrics[j])) / step;
        }
        break;
      }
    }
    input = before;
  };
  for_inputs(moved, add);
  add(moved.t_end);
  // The place is kept to an ulp of itself, so that an arrival from there at the speed v has v^2/2
  // to an ulp of the largest force times the largest place: where that is far more than v^2, after
  // a slip that came back hardly farther than it had gone, no input counts as much.
  if (metrics[4] != 0) {
    sums[4] += metrics[2] * metrics[3] / metrics[4];
  }
  for (std::size_t j = 0; j < sums.size(); ++j) {
    sums[j] = std::max(sums[j], Exact(abs(metrics[j])));
  }
  return sums;
}

BOOST_AUTO_TEST_CASE(where_friction_nearly_holds_the_load_errors_are_those_of_rounded_inputs) {
  Dice dice(20281);
  std::array<double, 6> worst{};
  const int count = forced_scene_count() / 5;
  for (int i = 0; i < count; ++i) {
    const ForcedScene<> scene = friction_near_load(dice);
    const ForcedRecord<double> got = run_forced(scene);
    const auto wide = widened<Exact>(scene);
    const ForcedRecord<Exact> right = run_forced(wide);
    BOOST_TEST((got.seen.kinds == right.seen.kinds), "events differ: " << scene);
    if (got.seen.kinds != right.seen.kinds) {
      continue;
    }
    const std::array<double, 6> values = metrics_of(got.state, scene.motion.p);
    const std::array<Exact, 6> truths = metrics_of(right.state, wide.motion.p);
    const std::array<Exact, 6> sums = conditions(wide, right);
    for (std::size_t j = 0; j < sums.size(); ++j) {
      const Exact error = abs(Exact(values[j] - truths[j]));
      const double units = error == 0 ? 0 : static_cast<double>(error / (sums[j] * 0x1p-53));
      BOOST_TEST(units <= allowed_units, names[j] << " " << values[j] << " is " << units
                                                  << " times as far from " << truths[j].str(20)
                                                  << " as a rounded input makes it: " << scene);
      worst[j] = std::max(worst[j], units);
    }
  }
  for (std::size_t j = 0; j < worst.size(); ++j) {
    BOOST_TEST_MESSAGE(names[j] << ": worst error " << worst[j] << " of " << count << " scenes");
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
