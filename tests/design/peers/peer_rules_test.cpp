// SPDX-License-Identifier: MIT
// The rules of the motion beyond the reference scenes, against the kernel.
#include "design/peers/reference_scenes.hpp"
#include "dopri5.hpp"
#include "testing/forced_scene.hpp"
#include "testing/scene_count.hpp"

#include <stillpoint/core/forced_motion.hpp>

namespace stillpoint::peers {

BOOST_AUTO_TEST_SUITE(peer_rules_test)

/// dopri5 as the peer has it, each step shown in 32 parts and a rest looked at 64 times as often,
/// so that no short excursion is missed.
class CloseDopri5 : Dopri5 {
 public:
  using Dopri5::at, Dopri5::Dopri5, Dopri5::has_dense_output, Dopri5::locates_events;

  template <class Load>
  struct Looked : Load {
    [[nodiscard]] double next_look(double t) const { return t + (Load::next_look(t) - t) / 64; }
  };

  template <class AnyMotion>
  void begin(const AnyMotion& motion, double t, const State& state) {
    Dopri5::begin(motion, t, state);
    part_ = parts;
  }

  template <class AnyMotion>
  Step step(const AnyMotion& motion, double limit) {
    if (part_ == parts) {
      whole_ = Dopri5::step(motion, limit);
      part_ = 0;
    }
    const Step part{end_of(part_), end_of(part_ + 1)};
    ++part_;
    state_ = at(motion, part.to);
    return part;
  }

  [[nodiscard]] const State& state() const { return state_; }

 private:
  static constexpr int parts = 32;
  [[nodiscard]] double end_of(int part) const {
    return part == parts ? whole_.to : whole_.from + (whole_.to - whole_.from) * part / parts;
  }

  Step whole_;
  int part_{parts};
  State state_{};
};

Result close_dopri5(const Scene& scene, double tolerance, const Size& size) {
  CloseDopri5 method(tolerance, size);
  return with_load(scene.excitation, [&](const auto& load) {
    const CloseDopri5::Looked<std::decay_t<decltype(load)>> looked{load};
    return EventRun(scene, looked, method, usual_effort).run();
  });
}

/// What the motion reaches in x and v; one that never moves has no size.
Size size_of(double p, const ForcedResponse& motion) {
  const double length =
      std::max({motion.peak_amplitude, std::abs(*motion.final_velocity) / p, 1e-300});
  return {length, p * length, 1 / p};
}

/// The scenes that `make` throws with `dice`, against an integrator that shares only the rules with
/// the kernel.
void dopri5_agrees(test::Dice dice, test::ForcedScene<> (*make)(test::Dice&)) {
  constexpr double decided_margin = 1e-6;
  constexpr double tolerance = 1e-8;  // 1e-14 per step, and what the motion enlarges
  const int count = test::forced_scene_count();
  int undecided = 0;
  double worst = 0;
  for (int i = 0; i < count; ++i) {
    const test::ForcedScene<> drawn = make(dice);
    const Scene s{drawn.oscillator(), drawn.motion.start(), drawn.excitation,
                  std::min(drawn.t_end, 25 / drawn.motion.p), drawn.surface};
    const ForcedResponse exact =
        forced_response(s.oscillator, s.start, s.excitation, {.t_end = s.t_end}, s.surface);
    if (!exact.decision_margin || exact.decision_margin < decided_margin) {
      ++undecided;
      continue;
    }
    const Size size = size_of(s.oscillator.p, exact);
    const Result result = close_dopri5(s, 1e-14, size);
    BOOST_TEST_CONTEXT(drawn) {
      BOOST_TEST(result.finished);
      BOOST_TEST(static_cast<double>(result.passages) == *exact.zero_passages);
      BOOST_TEST(static_cast<double>(result.turns) == *exact.turning_points);
      BOOST_TEST(static_cast<double>(result.sticks) == exact.sticks);
      BOOST_TEST(result.outcome == exact.outcome);
      BOOST_TEST(std::abs(result.peak - exact.peak_amplitude) <= tolerance * size.length);
      BOOST_TEST(std::abs(result.end_time - *exact.end_time) <= tolerance * s.t_end);
      const double off = std::max(std::abs(result.x - *exact.final_position) / size.length,
                                  std::abs(result.v - *exact.final_velocity) / size.speed);
      BOOST_TEST(off <= tolerance);
      worst = std::max(worst, off);
    }
  }
  BOOST_TEST_MESSAGE(count << " scenes, " << undecided << " undecided, worst difference " << worst);
  BOOST_TEST(undecided <= count / 10);
}

// Also notches with a hold or a width, friction in zones, docs/notches.md section 2, and damping,
// docs/damping.md, without a load too.
BOOST_AUTO_TEST_CASE(random_scenes_follow_the_same_rules) {
  dopri5_agrees(test::Dice(40401), test::random_forced_scene);
  dopri5_agrees(test::Dice(40403), test::random_notched_scene);
  dopri5_agrees(test::Dice(40405), [](test::Dice& dice) {
    test::ForcedScene<> scene = test::random_damped_scene(dice);
    scene.zeta = std::min(scene.zeta, 0.9);  // beyond, v dies out long before the turn
    if (dice.once_in(4)) {
      scene.excitation = NoExcitation{};
    }
    return scene;
  });
}

// Nothing holds the mass, and the load begins at 0: x'' + x = -k sin(lambda t).
BOOST_AUTO_TEST_CASE(a_load_that_begins_at_what_friction_holds_moves_the_mass_at_once) {
  const Scene s = with(Harmonic{0.1, 0.5}, {1, 0, 0}, {0, 0}, 10);
  const double x = -0.1 * (std::sin(5.0) - 0.5 * std::sin(10.0)) / (1 - 0.25);
  BOOST_TEST(std::abs(dopri5(s, 1e-12).x - x) < 1e-10);
  BOOST_TEST(std::abs(runge_kutta4(s, 1e-3).x - x) < 1e-10);
}

/// The mass stops and slips on within one step, so that v has the same sign at both of its ends.
BOOST_AUTO_TEST_CASE(a_turn_within_a_step_is_not_missed) {
  const Scene s = with(FullSine{1, 0.126518}, {1, 0.02084904744524763 / 0.44203340000312447, 1e250},
                       {0, 0}, 60);
  const ForcedResponse exact =
      forced_response(s.oscillator, s.start, s.excitation, {.t_end = s.t_end});
  for (const double tolerance : {1e-11, 1e-12, 1e-13}) {
    const Result result = dopri5(s, tolerance, {1, 1, 1e-2});
    BOOST_TEST(static_cast<double>(result.turns) == *exact.turning_points);
    BOOST_TEST(std::abs(result.arrival_speed - *exact.arrival_speed) < 100 * tolerance);
  }
}

BOOST_AUTO_TEST_CASE(the_regularised_model_knows_widths_and_zones) {
  const Scene s{{1, 0.02, 0.02}, {0, 1}, NoExcitation{}, 140, {0.1, {{0.3, 0.04}}}};
  const Result truth = kernel(s);
  const auto error = [&](double width) {
    return std::abs(regularised(s, width).end_time - truth.end_time);
  };
  BOOST_TEST(error(1e-3) < error(1e-2) / 2);
  BOOST_TEST(regularised(s, 1e-3).outcome == Outcome::stopped_in_notch);
  BOOST_TEST(regularised(s, 1e-3).passages == truth.passages);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::peers
