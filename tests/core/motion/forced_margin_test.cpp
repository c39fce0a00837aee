// SPDX-License-Identifier: MIT
#include "motion.hpp"

// The decision margin (docs/forced.md section 7) sees close decisions: where a small change of all
// inputs changes a count or the outcome, the margin is small too.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(forced_margin_test)

/// The motion before a decision amplifies a change of the inputs, most at resonance. docs/forced.md
/// section 9 has what more scenes show.
constexpr double enlarged = 10;

bool same_counts(const ForcedState<double>& a, const ForcedState<double>& b) {
  return a.passages == b.passages && a.turning_points == b.turning_points && a.sticks == b.sticks &&
         a.moved == b.moved && a.outcome == b.outcome;
}

/// Every input changed by a relative `by` at most.
ForcedScene<> shifted(ForcedScene<> scene, Dice& dice, double by) {
  const auto shift = [&](double& value) { value *= 1 + by * dice.uniform(-1, 1); };
  for_inputs(scene, shift);
  shift(scene.t_end);
  if (auto* wave = std::get_if<Harmonic>(&scene.excitation); wave != nullptr && wave->duration) {
    shift(*wave->duration);
  }
  return scene;
}

/// A record that stays on a few levels, those of the friction among them.
Record record_of_levels(Dice& dice, double p, double k, double f) {
  const std::array levels{0.0, 0.0, f, -f, k, -k, k / 2};
  Record record{{}, dice.once_in(2) ? pi / p / 4 : dice.power_of_ten(-1.5, 0.5) / p, {}};
  const unsigned count = 3 + dice.below(40);
  for (unsigned i = 0; i < count; ++i) {
    const bool repeat = i > 0 && dice.once_in(3);
    record.values.push_back(repeat ? record.values.back() : levels.at(dice.below(levels.size())));
  }
  return record;
}

/// Events that meet: p over lambda simple, so that turns meet the ends of pulses; loads of f;
/// starts at the edge of the dead zone.
ForcedScene<> constructed_scene(Dice& dice) {
  constexpr std::array ratios{1.0, 0.5, 0.25, 2.0, 1.0 / 3};
  ForcedScene<> scene = random_forced_scene(dice);
  Scene<>& motion = scene.motion;
  const double p = motion.p;
  const double k = p * p * dice.power_of_ten(-1, 1);
  const double lambda = p * ratios.at(dice.below(ratios.size()));
  motion.f = dice.once_in(6) ? k : dice.once_in(5) ? 0 : k * dice.power_of_ten(-1.5, -0.1);
  switch (dice.below(5)) {
    case 0:
    case 1:
      scene.excitation = Rectangle{k, lambda};
      break;
    case 2:
      scene.excitation =
          dice.once_in(2) ? Excitation(HalfSine{k, lambda}) : random_shape(dice, k, lambda);
      break;
    case 3:
      scene.excitation =
          Harmonic{k, lambda, pi / 2 * dice.below(4), (1 + dice.below(9)) * pi / 2 / lambda};
      break;
    default:
      scene.excitation = record_of_levels(dice, p, k, motion.f);
  }
  if (const unsigned start = dice.below(4); start < 3) {
    motion.v0 = 0;
    motion.x0 = start == 0 ? 0 : (start == 1 ? k : k - motion.f) * dice.sign() / (p * p);
  }
  scene.t_end = dice.uniform(1, 40) / p;
  return scene;
}

template <class MakeScene>
void margins_are_honest(MakeScene make_scene, std::uint64_t seed, int least_changes) {
  Dice dice(seed);
  int changed = 0;
  double worst = 0;
  for (int i = 0; i < 4 * forced_scene_count(); ++i) {
    const ForcedScene<> scene = make_scene(dice);
    const ForcedState<double> state = run_forced(scene).state;
    for (const double by : {1e-13, 1e-11, 1e-9, 1e-7}) {
      if (!same_counts(state, run_forced(shifted(scene, dice, by)).state)) {
        ++changed;
        worst = std::max(worst, margin_of(state) / by);
        BOOST_TEST(margin_of(state) <= enlarged * by,
                   "margin " << margin_of(state) << ", changed by " << by << ": " << scene);
      }
    }
  }
  BOOST_TEST_MESSAGE(changed << " changes, the margin at most " << worst << " times the change");
  BOOST_TEST(changed >= least_changes);  // otherwise nothing would be tested
}

BOOST_AUTO_TEST_CASE(of_random_scenes_are_honest) {
  // About one in 200 changes: with the sanitizers' few none may.
  margins_are_honest(random_forced_scene, 20262, forced_scene_count() / 200);
}

BOOST_AUTO_TEST_CASE(of_scenes_whose_events_meet_are_honest) {
  margins_are_honest(constructed_scene, 20263, forced_scene_count() / 2);
}

struct Tipping {
  ForcedScene<> scene;
  double least;  ///< margin
  double most;
  std::optional<int> turns{};
  std::optional<int> passages{};
  std::optional<Outcome> outcome{};
};

std::ostream& operator<<(std::ostream& stream, const Tipping& tipping) {
  return stream << tipping.scene;
}

std::vector<Tipping> tippings() {
  constexpr double far = 0.05;
  constexpr double rounding = 1e-15;
  constexpr double gap = 1e-4;
  constexpr double little = 1e-6;
  constexpr double e = gap * gap / 2;
  // The mass comes to rest, and is driven back, as the rectangle ends: p / lambda = 1.
  const auto turn_at_the_end = [](double lambda) {
    return ForcedScene<>{{-0.003304324429155196, 0, 15.745363180993461, 0.021068881543849644, 0},
                         Rectangle{0.5386610473108896, lambda},
                         0.9563953391389604};
  };
  const auto balanced = [](double k, double delta) {
    const Record record{{k, k}, pi / 2 - gap / 100, {}};
    return ForcedScene<>{{gap, 0, 1, 1, delta}, record, 20};
  };
  const auto driven = [](const Excitation& load, double t_end, double f = 1) {
    return ForcedScene<>{{0, 0, 1, f, 0}, load, t_end};
  };
  const auto pushed_back = [](double by) {
    return ForcedScene<>{{0, 0.3, 1, 0.5, 0}, Rectangle{0.01, pi / std::atan2(0.3, 0.51) / by}, 20};
  };
  const double p = 0.14130925140754189;
  const double just_less = little / 2 * (1 - 1e-5);
  const double just_more = little / 2 * (1 + 1e-5);
  return {
      // A relative change of 1e-9 makes 5 or 3 of 4 turns.
      {turn_at_the_end(15.7453631651), 0, 2e-9, 5},
      {turn_at_the_end(15.745363180993461), 0, rounding},
      {turn_at_the_end(15.7453631967), 0, 2e-9, 3},
      // p = f = 1, at rest at x = gap. A load k = 1 + e sets the mass off and balances friction:
      // x'' = -x - e, so that it comes to x = 0 at pi/2 - e/gap with the speed gap, and Delta holds
      // it there. The load ends just before pi/2. With k = 1 - e it ends first, and friction alone
      // stops the mass within gap^2/2.
      {balanced(1 + 1e-2 * gap, gap), 0, 1e-2 * gap, {}, {}, Outcome::stopped_at_zero},
      {balanced(1 - 1e-2 * gap, gap), 0, 1, {}, {}, Outcome::stopped_in_dead_zone},
      // From rest, k = 1, f = 0.45: the turn at tau = pi, u = -1.1, is held there by k, |c| = 0.1,
      // until 2 pi, and then released by the end: |c| = 1.1, up to u = 0.2.
      {driven(Rectangle{1, 0.5}, 20, 0.45), far, 1},
      // f = 0.5, x0 = 1.2: W = -1.2 cos tau holds it until x + W comes within 1e-9 of f, and is cut
      // off there: x alone sets it off in the same direction, to where it rests at x = -0.2.
      {{{1.2, 0, 1, 0.5, 0}, Harmonic{1.2, 1, -pi / 2, std::acos((0.7 + 1e-9) / 1.2)}, 20},
       far,
       1,
       1},
      // f = 0.5, v0 = 0.3, W = 0.01: turns at atan(0.3 / 0.51) and is held there, with W or
      // without.
      // The rectangle ends 1e-9 later, or earlier.
      {pushed_back(1 + 1e-9), far, 1, 1},
      {pushed_back(1 - 1e-9), far, 1, 1},
      // p = f = W = 1, from x0 = gap: x'' = -x, so that x = 0 at pi/2 with the speed gap. There W
      // ends, and friction stops the mass gap^2 / 2 beyond. With k smaller by 2e it would be at 2e.
      {{{gap, 0, 1, 1, 0}, Rectangle{1, 2}, 20}, 0, e, {}, 1},
      {{{gap, 0, 1, 1, 0}, Rectangle{1 - 2 * e, 2}, 20}, 0, 1, {}, 0},
      // A load that comes near friction while it holds: at a sample, a peak and a plateau; the
      // crest
      // of a harmonic that is cut off after it, and one cut off before its crest.
      {driven(Record{{0, 1 - little, 0, 0}, 1, {}}, 10), just_less, just_more, 0},
      {driven(Record{{0, -1 + little, -1 + little, 0}, 1, {}}, 10), just_less, just_more, 0},
      {driven(Harmonic{1 - little, 1, 0, 0.8 * pi}, 10), just_less, just_more},
      {driven(Harmonic{1 - little, 1, 0, pi / 6}, 10), (1 - 1e-5) / 3, (1 + 1e-5) / 3},
      // One that hardly releases.
      {driven(Record{{0, 0.5, 1 + little, 0}, 1, {}}, 10), 0, little, 1},
      // The end of the run meets an event: without friction it turns at pi/2 and passes at pi.
      {{{0, 1, 1, 0, 0}, Harmonic{0, 1}, pi / 2}, 0, rounding},
      {{{0, 1, 1, 0, 0}, Harmonic{0, 1}, pi}, 0, rounding},
      // After a whole period under the load it is back at x = 0, at rest but for rounding, and
      // without friction it stays on the side that rounding gave it. The run ends before it turns.
      {{{0, 0, p, 0, 0}, Rectangle{0.19327387831216181, p / 2}, 7.6 / p}, 0, 1e-14}};
}

BOOST_DATA_TEST_CASE(each_is_the_one_by_hand, data::make(tippings()), tipping) {
  const ForcedState<double> state = run_forced(tipping.scene).state;
  BOOST_TEST(margin_of(state) >= tipping.least);
  BOOST_TEST(margin_of(state) <= tipping.most);
  const auto is = [](auto value, const std::optional<int>& expected) {
    BOOST_TEST(static_cast<int>(value) == expected.value_or(static_cast<int>(value)));
  };
  is(state.turning_points, tipping.turns);
  is(state.passages, tipping.passages);
  BOOST_TEST((!tipping.outcome || state.outcome == tipping.outcome));
}

BOOST_AUTO_TEST_CASE(no_sample_of_a_long_rest_is_overlooked) {
  // Half of f = 1 to and fro, and at one sample a load that comes near f, or exceeds it.
  constexpr double gap = 1e-6;
  for (std::size_t at = 1; at < 40; ++at) {
    Record record{std::vector<double>(41), 1, {}};
    for (std::size_t i = 0; i < record.values.size(); ++i) {
      record.values[i] = i % 2 == 0 ? 0.5 : -0.5;
    }
    const double sign = record.values[at] > 0 ? 1 : -1;
    record.values[at] = sign * (1 - gap);
    const auto held = run_forced(ForcedScene<>{{0, 0, 1, 1, 0}, record, 50}).state;
    BOOST_TEST(!held.moved);
    BOOST_TEST(margin_of(held) == gap / 2, tt::tolerance(1e-5));
    record.values[at] = sign * 2;
    const auto released = run_forced(ForcedScene<>{{0, 0, 1, 1, 0}, record, 50}).state;
    BOOST_TEST(released.moved);
    // On its way from -0.5 to 2 the load passes 1 after 0.6 of the interval.
    const auto end = static_cast<double>(at);
    const auto first = run_forced(ForcedScene<>{{0, 0, 1, 1, 0}, record, end}).state;
    BOOST_TEST(first.stuck.value() == end - 0.4, tt::tolerance(1e-15));
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
