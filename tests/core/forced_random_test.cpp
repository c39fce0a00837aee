// SPDX-License-Identifier: MIT
#define BOOST_TEST_MODULE forced_random
#include "support/forced_scene.hpp"
#include "support/scene_count.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <string>

// Seeded random scenes of every excitation: in double against the same rules in 50 digits, and
// every piece looked at closely for an event that was stepped over. STILLPOINT_FORCED_SCENES in the
// environment asks for another number of scenes than a thousand.

namespace stillpoint::test {

namespace {

// Below this margin rounding may decide; scenes that start from rest under a constant load come
// back to x = 0 with v = 0 exactly and have margin 0.
constexpr double decided_margin = 1e-9;
// Relative to the largest of the motion. The worst of 10^5 scenes is said in docs/forced.md.
constexpr double metric_tolerance = 1e-11;

double margin_of(const ForcedState<double>& state) {
  return state.margin.any() ? state.margin.value() : 1;
}

double largest_load(const AnyExcitation<double>& excitation) {
  if (const auto* record = std::get_if<Record<>>(&excitation)) {
    double most = 0;
    for (const double value : record->values) {
      most = std::max(most, std::abs(value));
    }
    return most;
  }
  return std::visit(
      [](const auto& wave) {
        if constexpr (requires { wave.k; }) {
          return std::abs(wave.k);
        } else {
          return 0.0;
        }
      },
      excitation);
}

/// The largest error of the run, in units of the motion's own size.
double error(const ForcedScene<>& scene, const ForcedState<double>& got,
             const ForcedState<Exact>& right) {
  const auto off = [](double value, const Exact& expected) {
    return std::abs(static_cast<double>(value - expected));
  };
  const double length = std::max({got.farthest, std::abs(got.u), std::abs(got.v)});
  const double of_length =
      std::max({off(got.u, right.u), off(got.v, right.v), off(got.farthest, right.farthest)});
  const double force =
      got.acceleration + (largest_load(scene.excitation) + scene.motion.f) / scene.motion.p;
  const double time = scene.motion.p * scene.t_end;
  return std::max({length > 0 ? of_length / length : of_length,
                   off(got.acceleration, right.acceleration) / force,
                   off(got.stick_time.value(), right.stick_time.value()) / time});
}

}  // namespace

BOOST_AUTO_TEST_CASE(double_and_50_digits_see_the_same_events_and_metrics) {
  Dice dice(20260);
  const int count = forced_scene_count();
  double worst = 0;
  int undecided = 0;
  for (int i = 0; i < count; ++i) {
    const ForcedScene<> scene = random_forced_scene(dice);
    const ForcedRecord<double> got = run_forced(scene);
    if (margin_of(got.state) < decided_margin) {
      ++undecided;
      continue;
    }
    const ForcedRecord<Exact> right = run_forced(widened<Exact>(scene));
    BOOST_TEST((got.seen.kinds == right.seen.kinds), "events differ: " << scene);
    const double off = error(scene, got.state, right.state);
    BOOST_TEST(off <= metric_tolerance, off << " off: " << scene);
    worst = std::max(worst, off);
  }
  BOOST_TEST_MESSAGE(count << " scenes, " << undecided << " undecided, worst error " << worst);
  BOOST_TEST(undecided <= count / 20 + 1);
}

BOOST_AUTO_TEST_CASE(no_piece_hides_a_turn) {
  Dice dice(20261);
  constexpr int looks = 100;
  for (int i = 0; i < forced_scene_count(); ++i) {
    const ForcedScene<> scene = random_forced_scene(dice);
    const ForcedRecord<double> run = run_forced(scene);
    for (std::size_t j = 0; j < run.seen.pieces.size(); ++j) {
      const auto& piece = run.seen.pieces[j];
      double end =
          j + 1 < run.seen.pieces.size() ? run.seen.pieces[j + 1].begin : run.state.now.value();
      for (const double time : run.seen.times) {
        end = time > piece.begin ? std::min(end, time) : end;
      }
      double least = 0;
      double size = 0;
      for (int look = 1; look < looks; ++look) {
        const double h = (end - piece.begin) * look / looks;
        const auto at = [h](const auto& motion) { return motion.at(h).v; };
        const double v = std::visit(at, piece.motion);
        least = std::min(least, v);
        size = std::max(size, std::abs(v));
      }
      BOOST_TEST(least >= -1e-9 * size, "v = " << least << " on piece " << j << " of " << scene);
    }
  }
}

}  // namespace stillpoint::test
