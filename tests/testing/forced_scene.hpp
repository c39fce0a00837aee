// SPDX-License-Identifier: MIT
#pragma once

// A forced motion's inputs in any scalar, its run by the kernel's own template, and how tests print
// and compare them.

#include "kernel/excitation_run.hpp"
#include "kernel/forced_run.hpp"
#include "kernel/on_surface.hpp"
#include "kernel/widened.hpp"
#include "testing/exact_run.hpp"
#include "testing/random_scene.hpp"

#include <stillpoint/core/excitation.hpp>

#include <cstddef>
#include <variant>
#include <vector>

namespace stillpoint::test {

template <class Real = double>
struct ForcedScene {
  Scene<Real> motion;
  BasicExcitation<Real> excitation;
  Real t_end{1};
  std::optional<Real> hold{};
  BasicSurface<Real> surface{};
  Real zeta{0};
  Real breakaway{1};

  [[nodiscard]] BasicOscillator<Real> oscillator() const {
    return {motion.p, motion.f, motion.delta, hold, zeta, breakaway};
  }
};

/// A piece and how long the motion stayed on it, for looking at it closely.
template <class Real>
struct SeenPiece {
  std::variant<HarmonicFlow<Real>, LinearPiece<Real>, DampedPiece<Real>, DampedCurve<Real>> motion;
  Real begin;
};

/// What a run decided, in order, and its pieces.
template <class Real>
class Recorder {
 public:
  static constexpr bool watches = true;

  void event(EventKind kind, const ExactSum<Real>& now, const Real& /*u*/, const Real& /*v*/) {
    kinds.push_back(kind);
    times.push_back(now.value());
  }
  template <class Piece>
  void piece(const ExactSum<Real>& begin, int /*direction*/, const Piece& piece,
             const Real& /*length*/, const Real& /*load*/) {
    if constexpr (requires { piece.flow(); }) {
      pieces.push_back({piece.flow(), begin.value()});
    } else {
      pieces.push_back({piece, begin.value()});
    }
  }

  std::vector<EventKind> kinds;
  std::vector<Real> times;  ///< p tau
  std::vector<SeenPiece<Real>> pieces;
};

template <class Real>
struct ForcedRecord {
  ForcedState<Real> state;
  Recorder<Real> seen;
};

template <class Real>
ForcedRecord<Real> run_forced(const ForcedScene<Real>& scene) {
  ForcedRecord<Real> record;
  record.state = on_surface(
      scene.oscillator(), scene.surface, scene.motion.start(), record.seen, {}, [&](auto& run) {
        run.state().transmitted.largest_load = largest_load_of(scene.excitation, scene.motion.p);
        std::visit([&](const auto& kind) { run_until(run, kind, scene.t_end); }, scene.excitation);
        feel_the_end(run.state(), run.law(), ExactSum<Real>::product(scene.motion.p, scene.t_end));
        return run.state();
      });
  record.state.transmitted.largest_load = {};  // it refers to the scene
  return record;
}

template <class Wide>
ForcedScene<Wide> widened(const ForcedScene<double>& scene) {
  return {widened<Wide>(scene.motion),
          stillpoint::widened<Wide>(scene.excitation),
          Wide(scene.t_end),
          std::optional<Wide>(scene.hold),
          stillpoint::widened<Wide>(scene.surface),
          Wide(scene.zeta),
          Wide(scene.breakaway)};
}

/// Calls `each` with the inputs of the motion but the end of the run and that of a harmonic.
template <class Real, class Each>
void for_inputs(ForcedScene<Real>& scene, const Each& each) {
  const auto visit = [&](auto& input) {
    if constexpr (std::is_same_v<decltype(input), Real&>) {
      each(input);
    }
  };
  auto& [x0, v0, p, f, delta] = scene.motion;
  for (Real* const input : {&x0, &v0, &p, &f, &delta}) {
    each(*input);
  }
  std::visit(
      [&](auto& wave) {
        if constexpr (requires { wave.k; }) {
          each(wave.k);
        }
        if constexpr (requires { wave.lambda; }) {
          each(wave.lambda);
        }
        if constexpr (requires { wave.phase; }) {
          visit(wave.phase);
        }
        if constexpr (requires { wave.values; }) {
          std::ranges::for_each(wave.values, each);
          std::ranges::for_each(wave.times, each);
          each(wave.step);
        }
      },
      scene.excitation);
  for (auto* const input : {&scene.hold, &scene.surface.notch_width}) {
    if (*input) {
      each(**input);
    }
  }
  each(scene.zeta);
  if (scene.breakaway != 1) {
    each(scene.breakaway);
  }
  for (auto& zone : scene.surface.zones) {
    each(zone.to);
    each(zone.f);
  }
}

/// With all inputs in their order.
inline std::ostream& operator<<(std::ostream& out, const ForcedScene<double>& scene) {
  const auto digits = out.precision(17);
  out << std::visit([](const auto& load) { return load.name; }, scene.excitation) << ", t_end "
      << scene.t_end << ", hold " << scene.hold.has_value() << ", width "
      << scene.surface.notch_width.has_value() << ':';
  ForcedScene<> all = scene;
  for_inputs(all, [&out](double input) { out << ' ' << input; });
  out.precision(digits);
  return out;
}

inline Record random_record(Dice& dice, double k) {
  Record record;
  const std::size_t count = 2 + dice.below(60);
  const bool even = dice.once_in(2);
  double time = dice.once_in(3) ? 0 : dice.uniform(0, 2);
  const double step = dice.power_of_ten(-2, 0.7);
  for (std::size_t i = 0; i < count; ++i) {
    const bool repeat = i > 0 && dice.once_in(4);
    const double fresh = dice.once_in(5) ? 0 : k * dice.uniform(-1, 1);
    record.values.push_back(repeat ? record.values.back() : fresh);
    if (!even) {
      record.times.push_back(time);
      time += step * dice.power_of_ten(-1, 0.5);
    }
  }
  record.step = even ? step : 0;
  return record;
}

/// A pulse with a peak that it does not leave as steeply as it reaches it, or the other way round.
inline Excitation random_shape(Dice& dice, double k, double lambda) {
  const unsigned kind = dice.below(3);
  return kind == 0   ? Excitation(Sawtooth{k, lambda})
         : kind == 1 ? Excitation(Trapezoid{k, lambda})
                     : Excitation(Haversine{k, lambda});
}

/// 1 where nothing was close.
inline double margin_of(const ForcedState<double>& state) {
  return state.margin.any() ? state.margin.value() : 1;
}

/// Every kind of excitation, all forces of comparable size, some tens of events.
inline ForcedScene<> random_forced_scene(Dice& dice) {
  ForcedScene<> scene;
  const double p = dice.power_of_ten(-1, 1);
  const double k = dice.power_of_ten(-1, 1);
  const double v = k / p * dice.power_of_ten(-1, 1);
  scene.motion = {0, dice.once_in(3) ? 0 : dice.sign() * v, p,
                  dice.once_in(6) ? 0 : k * dice.power_of_ten(-1.5, 0.1),
                  dice.once_in(2) ? 0 : v * v * dice.power_of_ten(-3, -0.2)};
  if (dice.once_in(4)) {
    scene.motion.x0 = dice.sign() * k / (p * p) * dice.power_of_ten(-1, 0.7);
  }
  const double lambda = dice.once_in(4) ? p * (1 + dice.sign() * dice.power_of_ten(-13, -1))
                                        : p * dice.power_of_ten(-1, 1);
  switch (dice.below(7)) {
    case 0:
    case 1:
      scene.excitation = Harmonic{dice.sign() * k, lambda, dice.uniform(-4, 4)};
      break;
    case 2:
      scene.excitation = Harmonic{k, lambda, dice.uniform(-4, 4), dice.uniform(0, 30) / lambda};
      break;
    case 3:
      scene.excitation =
          dice.once_in(2) ? Excitation(HalfSine{k, lambda}) : Excitation(FullSine{-k, lambda});
      break;
    case 4:
      scene.excitation = Rectangle{k, lambda};
      break;
    case 5:
      scene.excitation = random_shape(dice, dice.sign() * k, lambda);
      break;
    default:
      scene.excitation = random_record(dice, k);
  }
  scene.t_end = dice.uniform(1, 60) / p;
  return scene;
}

/// The same with a notch that lets go, one with a width, steps of friction, or all that
/// goes together.
inline ForcedScene<> random_notched_scene(Dice& dice) {
  ForcedScene<> scene = random_forced_scene(dice);
  auto& [x0, v0, p, f, delta] = scene.motion;
  const double force = f + dice.power_of_ten(-1, 0) * (f > 0 ? f : 0.1);
  const double length = force / (p * p) * dice.power_of_ten(-1, 0.7);
  const unsigned kind = dice.below(4);
  if (kind == 0) {
    scene.hold = dice.once_in(4) ? 0 : force * dice.power_of_ten(-1, 0.5);
  } else if (kind == 1) {
    scene.surface.notch_width = length * dice.power_of_ten(-1.5, 0);
  }
  if (kind >= 2 || dice.once_in(3)) {
    double to = 0;
    for (unsigned zones = 1 + dice.below(3); zones > 0; --zones) {
      to += length * dice.power_of_ten(-1, 0);
      scene.surface.zones.push_back({to, dice.once_in(5) ? 0 : force * dice.power_of_ten(-1, 0.3)});
    }
  }
  if (kind == 3 && dice.once_in(2)) {
    scene.surface.notch_width = length * dice.power_of_ten(-1.5, 0.5);
  }
  return scene;
}

/// The same with damping, friction that holds more than it slides under, or both.
inline ForcedScene<> random_damped_scene(Dice& dice) {
  ForcedScene<> scene = dice.once_in(2) ? random_forced_scene(dice) : random_notched_scene(dice);
  const unsigned kind = dice.below(4);
  if (kind > 0) {
    scene.zeta = dice.once_in(4) ? 1 - dice.power_of_ten(-2, -0.3) : dice.power_of_ten(-10, -0.3);
  }
  if (kind < 2) {
    scene.breakaway = 1 + dice.power_of_ten(-2, 0.5);
  }
  return scene;
}

}  // namespace stillpoint::test
