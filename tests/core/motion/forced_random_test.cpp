// SPDX-License-Identifier: MIT
#include "motion.hpp"

#include <boost/math/tools/minima.hpp>

// Seeded random scenes of every excitation: in double against the same rules in 50 digits, and
// every piece examined closely for an event that was stepped over. STILLPOINT_FORCED_SCENES in the
// environment asks for another number of scenes than a thousand.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(forced_random_test)

// Below this margin rounding may decide; scenes that start from rest under a constant load come
// back to x = 0 with v = 0 exactly and have margin 0.
constexpr double decided_margin = 1e-9;
// Relative to the largest of the motion. The worst of 10^5 scenes is said in docs/forced.md.
constexpr double metric_tolerance = 1e-11;
// Edges of friction amplify: above the tolerance an error is compared with what rounded inputs do.
constexpr double allowed_units = 16;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

double largest_load(const Excitation& excitation) {
  return std::visit(
      [](const auto& load) {
        double most = 0;
        if constexpr (requires { load.k; }) {
          most = std::abs(load.k);
        } else if constexpr (requires { load.values; }) {
          for (const double value : load.values) {
            most = std::max(most, std::abs(value));
          }
        }
        return most;
      },
      excitation);
}

/// The largest error of the run, in units of the motion's own size `of`.
template <class Real>
double error(const ForcedScene<>& scene, const ForcedState<double>& of,
             const ForcedState<Real>& got, const ForcedState<Exact>& right) {
  const auto off = [](const Real& value, const Exact& expected) {
    return std::abs(static_cast<double>(value - expected));
  };
  const double length = std::max({of.farthest, std::abs(of.u), std::abs(of.v)});
  const double of_length =
      std::max({off(got.u, right.u), off(got.v, right.v), off(got.farthest, right.farthest)});
  const double force =
      of.acceleration + (largest_load(scene.excitation) + scene.motion.f) / scene.motion.p;
  const double time = scene.motion.p * scene.t_end;
  const double felt =
      std::max({off(got.transmitted.slid, right.transmitted.slid),
                off(got.transmitted.held, right.transmitted.held) / scene.motion.p,
                off(got.transmitted.locked, right.transmitted.locked) / scene.motion.p});
  return std::max({length > 0 ? of_length / length : of_length,
                   off(got.acceleration, right.acceleration) / force, felt / force,
                   off(got.stuck.value(), right.stuck.value()) / time});
}

/// What rounding of the inputs makes of the run: 2^-53 times the sum of |d run / d ln input|.
double rounding(const ForcedScene<>& scene, const ForcedState<double>& of,
                const ForcedRecord<Exact>& right) {
  const Exact step("1e-22");
  ForcedScene<Exact> moved = widened<Exact>(scene);
  double sum = 0;
  for_inputs(moved, [&](Exact& input) {
    const Exact before = input;
    for (const int direction : {1, -1}) {
      input = before * (1 + direction * step);
      const ForcedRecord<Exact> there = run_forced(moved);
      if (there.seen.kinds == right.seen.kinds) {
        sum += error(scene, of, there.state, right.state) / 1e-22;
        break;
      }
    }
    input = before;
  });
  return sum * 0x1p-53;
}

/// Of the scenes that `make` throws with `dice`.
void double_agrees_with_50_digits(Dice dice, ForcedScene<> (*make)(Dice&)) {
  const int count = forced_scene_count();
  double worst = 0;
  int undecided = 0;
  int amplified = 0;
  for (int i = 0; i < count; ++i) {
    const ForcedScene<> scene = make(dice);
    const ForcedRecord<double> got = run_forced(scene);
    if (margin_of(got.state) < decided_margin) {
      ++undecided;
      continue;
    }
    const ForcedRecord<Exact> right = run_forced(widened<Exact>(scene));
    const bool same = got.seen.kinds == right.seen.kinds;
    const double off = error(scene, got.state, got.state, right.state);
    if (same && off <= metric_tolerance) {
      worst = std::max(worst, off);
      continue;
    }
    ++amplified;
    const double rounded = rounding(scene, got.state, right);
    BOOST_TEST((same || rounded > 1), "events differ: " << scene);
    BOOST_TEST(off <= allowed_units * rounded, off / rounded << " times rounding: " << scene);
    BOOST_TEST_MESSAGE(off << " off, " << off / rounded << " times what rounded inputs do");
  }
  BOOST_TEST_MESSAGE(count << " scenes, " << undecided << " undecided, " << amplified
                           << " amplify rounding, worst error of the others " << worst);
  BOOST_TEST(undecided <= count / 20 + 1);
  BOOST_TEST(amplified <= count / 1000 + 1);
}

/// Also in real notches, and with damping.
BOOST_AUTO_TEST_CASE(double_and_50_digits_see_the_same_events_and_metrics) {
  double_agrees_with_50_digits(Dice(20260), random_forced_scene);
  double_agrees_with_50_digits(Dice(20262), random_notched_scene);
  double_agrees_with_50_digits(Dice(20263), random_damped_scene);
}

using SeenMotion = SeenPiece<double>;

double speed(const SeenMotion& piece, double h) {
  return std::visit([h](const auto& motion) { return motion.at(h).v; }, piece.motion);
}

/// lambda/p of a harmonic piece; 1, that of the motion itself, of a linear one.
double fastest(const SeenMotion& piece) {
  return std::visit(
      [](const auto& motion) {
        if constexpr (requires { motion.r(); }) {
          return std::max(1.0, motion.r());
        } else {
          return 1.0;
        }
      },
      piece.motion);
}

struct Looked {
  double least;  ///< v
  double size;   ///< of v
};

/// The smallest v up to `length` after the start of a piece. It samples v evenly, a fixed number
/// per ripple of v (at least a hundred in all), and follows each sample that is below both its
/// neighbours to the minimum between them. So it sees a pair of turns at any distance, unless there
/// are two minima within three samples.
Looked look_closely(const SeenMotion& piece, double length) {
  constexpr double looks_a_ripple = 32;
  constexpr int bits = 26;  // half of the digits of a minimum's place give all of its value
  const double ripples = fastest(piece) * length / (2 * std::numbers::pi);
  const int looks = static_cast<int>(std::max(100.0, std::ceil(looks_a_ripple * ripples)));
  const auto at = [&](int look) { return speed(piece, length * look / looks); };
  Looked found{0, 0};
  double before = at(0);
  double now = at(1);
  for (int look = 1; look < looks; ++look) {
    const double next = at(look + 1);
    found.least = std::min(found.least, now);
    found.size = std::max(found.size, std::abs(now));
    if (now <= before && now <= next) {
      const auto v = [&](double h) { return speed(piece, h); };
      const auto lowest = boost::math::tools::brent_find_minima(v, length * (look - 1) / looks,
                                                                length * (look + 1) / looks, bits);
      found.least = std::min(found.least, lowest.second);
    }
    before = now;
    now = next;
  }
  return found;
}

/// Up to ten times faster than the scenes are by themselves, so that a piece spans many ripples.
void hasten(Excitation& excitation, double by) {
  std::visit(
      [by](auto& wave) {
        if constexpr (requires { wave.lambda; }) {
          wave.lambda *= by;
        }
      },
      excitation);
}

BOOST_AUTO_TEST_CASE(no_piece_hides_a_turn) {
  Dice dice(20261);
  for (int i = 0; i < forced_scene_count(); ++i) {
    ForcedScene<> scene = i % 2 == 0 ? random_forced_scene(dice) : random_damped_scene(dice);
    if (i % 4 == 0) {
      hasten(scene.excitation, 10);
    }
    const ForcedRecord<double> run = run_forced(scene);
    double fastest_yet = 0;  // an ulp of it is rounding, on a piece that is itself an ulp long too
    for (std::size_t j = 0; j < run.seen.pieces.size(); ++j) {
      const auto& piece = run.seen.pieces[j];
      double end =
          j + 1 < run.seen.pieces.size() ? run.seen.pieces[j + 1].begin : run.state.now.value();
      for (const double time : run.seen.times) {
        end = time > piece.begin ? std::min(end, time) : end;
      }
      const auto [least, size] = look_closely(piece, end - piece.begin);
      fastest_yet = std::max(fastest_yet, size);
      BOOST_TEST(least >= -std::max(1e-9 * size, epsilon * fastest_yet),
                 "v = " << least << " on piece " << j << " of " << scene);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
