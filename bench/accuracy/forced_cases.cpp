// SPDX-License-Identifier: MIT
#include "hard_case.hpp"

#include "testing/forced_scene.hpp"
#include "testing/scene_s5.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/state.hpp>
#include <stillpoint/core/trajectory.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

// Inputs in the order V0, p, f, Delta, k, lambda, phase, end.

namespace stillpoint::accuracy {

namespace {

template <class Real>
test::ForcedScene<Real> harmonic_scene(const Inputs<Real>& in) {
  test::ForcedScene<Real> scene;
  scene.motion = {Real(0), in[0], in[1], in[2], in[3]};
  scene.excitation = BasicHarmonic<Real>{in[4], in[5], in[6]};
  scene.t_end = in[7];
  return scene;
}

/// The place at the end.
HardCase under_harmonic() {
  HardCase now;
  now.metric = "final_position";
  now.kernel = [](const Inputs<double>& in) {
    return forced_response({in[1], in[2], in[3]}, {0, in[0]}, Harmonic{in[4], in[5], in[6]},
                           {.t_end = in[7]})
        .final_position.value();
  };
  now.alike = true;
  now.exact = [](const Inputs<Exact>& in) {
    return Exact(test::run_forced(harmonic_scene(in)).state.u / in[1]);
  };
  return now;
}

/// Each input changed by a relative `spread` at most, with the same events as before.
std::function<Inputs<double>(Dice&)> around(const Inputs<double>& inputs, double spread) {
  const auto kinds = test::run_forced(harmonic_scene(inputs)).seen.kinds;
  return [=](Dice& dice) {
    while (true) {
      Inputs<double> in = inputs;
      for (double& value : in) {
        value *= 1 + spread * dice.uniform(-1, 1);
      }
      const auto run = test::run_forced(harmonic_scene(in));
      if (run.seen.kinds == kinds && run.state.margin.value() > 1e-9) {
        return in;
      }
    }
  };
}

/// Without friction, in closed form; right in 50 digits as long as the detuning leaves enough.
template <class Real>
Real divided(const Inputs<Real>& in) {
  using std::sin;
  const Real& p = in[1];
  const Real& lambda = in[5];
  const Real& t = in[7];
  const Real factor = in[4] / (p * p - lambda * lambda);
  const Real natural = sin(Real(p * t));
  return in[0] / p * natural - factor * (sin(Real(lambda * t)) - lambda / p * natural);
}

HardCase near_resonance(double detuning, const std::string& text) {
  HardCase now = under_harmonic();
  now.name = "near resonance, relative detuning " + text;
  now.why = "two large terms cancel";
  now.naive = "the closed form with p^2 - lambda^2 as a divisor";
  now.inputs = {0.5, 1, 0, 0, 0.2, 1 + detuning, 0, 200};
  now.neighbour = [detuning](Dice& dice) {
    const double p = dice.uniform(0.9, 1.1);
    return Inputs<double>{dice.uniform(0.4, 0.6),
                          p,
                          0,
                          0,
                          dice.uniform(0.1, 0.3),
                          p * (1 + detuning * dice.uniform(0.5, 2)),
                          0,
                          dice.uniform(180, 200)};
  };
  now.by_naive = divided<double>;
  now.exact = divided<Exact>;
  now.alike = false;
  return now;
}

HardCase fast_forcing() {
  HardCase now = under_harmonic();
  now.name = "forcing a million times faster than the spring";
  now.why = "the phase of the ripple must keep the digits that 1e6 cycles use up";
  now.naive = "the closed form with p^2 - lambda^2 as a divisor";
  now.inputs = {0.5, 1, 0, 0, 0.2, 1e6, 0, 10};
  now.neighbour = [](Dice& dice) {
    return Inputs<double>{
        dice.uniform(0.4, 0.6), dice.uniform(0.9, 1.1),    0, 0,
        dice.uniform(0.1, 0.3), dice.power_of_ten(5.5, 6), 0, dice.uniform(9, 10)};
  };
  now.by_naive = divided<double>;
  now.exact = divided<Exact>;
  now.alike = false;
  return now;
}

/// At rest under k sin(lambda tau) until it exceeds f; k barely exceeds f.
HardCase release_at_the_crest() {
  HardCase now;
  now.metric = "time of the release";
  now.name = "release where the load hardly exceeds friction";
  now.why = "the arc sine has no slope at 1";
  now.naive = "asin(f/k)/lambda";
  now.inputs = {0, 1, 0.2 * (1 - 1e-12), 0, 0.2, 0.35, 0, 5};
  now.neighbour = [](Dice& dice) {
    const double k = dice.uniform(0.1, 0.3);
    return Inputs<double>{
        0, dice.uniform(0.9, 1.1), k * (1 - dice.power_of_ten(-14, -8)), 0, k, 0.35, 0, 5};
  };
  now.kernel = [](const Inputs<double>& in) {
    const ForcedTrajectory path({in[1], in[2], 0}, {}, Harmonic{in[4], in[5], 0}, {in[7]});
    const auto release = std::ranges::find(path.events(), EventKind::release, &Event::kind);
    return release->state.tau;
  };
  now.exact = [](const Inputs<Exact>& in) { return Exact(asin(Exact(in[2] / in[4])) / in[5]); };
  now.by_naive = [](const Inputs<double>& in) { return std::asin(in[2] / in[4]) / in[5]; };
  return now;
}

/// A little after a release x grows with the cube of the time.
HardCase just_released() {
  HardCase now = under_harmonic();
  now.name = "a little after a release";
  now.why = "x grows with the cube of the time, so a sum of larger terms loses its digits";
  now.naive = "e + (x0 - e) cos(p h) + x_W(h), term by term";
  const auto at = [](double later) {
    return Inputs<double>{0, 1, 0.18, 0, 0.2, 0.35, 0, std::asin(0.9) / 0.35 + later};
  };
  now.inputs = at(1e-2);
  now.alike = false;
  now.neighbour = [at](Dice& dice) { return at(dice.power_of_ten(-3, -1)); };
  now.by_naive = [](const Inputs<double>& in) {
    const double begin = std::asin(in[2] / in[4]) / in[5];
    const double h = in[7] - begin;
    const double psi = in[5] * begin;
    const double e = in[2];  // sliding towards -x
    const double a = (1 + in[5]) / 2;
    const double b = (in[5] - 1) / 2;
    const auto sinc = [](double z) { return std::sin(z) / z; };
    const double wave = -in[4] * h / 2 *
                        (sinc(a * h) * std::cos(b * h + psi) - sinc(b * h) * std::cos(a * h + psi));
    return e - e * std::cos(h) + wave;
  };
  return now;
}

HardCase scene(const std::string& name, const std::string& why, const Inputs<double>& inputs,
               double spread, int neighbours) {
  HardCase now = under_harmonic();
  now.name = name;
  now.why = why;
  now.inputs = inputs;
  now.neighbour = around(inputs, spread);
  now.neighbours = neighbours;
  return now;
}

/// The record is fixed; the inputs are p and f.
HardCase short_stick() {
  HardCase now;
  now.metric = "stick_time";
  now.name = "scene S5: the stick of 0.029 that sign tests step over";
  now.why = "it lies between two samples, and the speeds before and after it are small";
  now.inputs = {1, 0.05};
  now.kernel = [](const Inputs<double>& in) {
    return forced_response({in[0], in[1], 0}, {}, test::rounded_record_s5(), {.t_end = 59.98})
        .stick_time;
  };
  now.exact = [](const Inputs<Exact>& in) {
    test::ForcedScene<Exact> scene;
    scene.motion = {Exact(0), Exact(0), in[0], in[1], Exact(0)};
    scene.excitation = Widen<Exact>()(test::rounded_record_s5());
    scene.t_end = Exact(59.98);
    const ForcedState<Exact> state = test::run_forced(scene).state;
    // A rest that the end cuts short counts, as in response_of_run.hpp.
    const bool rests = state.v == 0 && !state.fresh && !state.outcome;
    const Exact waited = rests ? state.now.minus(state.rest_begin) : Exact(0);
    return Exact((state.stuck.value() + waited) / in[0]);
  };
  now.neighbour = [](Dice& dice) {
    return Inputs<double>{1 + 1e-4 * dice.uniform(-1, 1), 0.05 * (1 + 1e-4 * dice.uniform(-1, 1))};
  };
  now.neighbours = 1000;
  now.alike = true;
  return now;
}

}  // namespace

std::vector<HardCase> forced_cases() {
  return {near_resonance(1e-3, "1e-3"),
          near_resonance(1e-6, "1e-6"),
          near_resonance(1e-9, "1e-9"),
          near_resonance(1e-12, "1e-12"),
          fast_forcing(),
          release_at_the_crest(),
          just_released(),
          scene("scene S3: resonance, both frictions, to 200", "64 passages and turns",
                {0.5, 1, 0.05, 0.01, 0.2, 1, 0, 200}, 1e-4, 2000),
          scene("scene S4: 22 sticks, to 200", "each stick ends where the load grows slowly",
                {0.5, 1, 0.18, 0, 0.2, 0.35, 0, 200}, 1e-4, 2000),
          scene("100 cycles of forcing", "any error of the phase shows",
                {0.5, 1, 0.05, 0.001, 0.2, 0.8, 0.3, 200 * std::numbers::pi / 0.8}, 1e-6, 1000),
          scene("1000 cycles of forcing", "any error of the phase shows",
                {0.5, 1, 0.05, 0.001, 0.2, 0.8, 0.3, 2000 * std::numbers::pi / 0.8}, 1e-6, 200),
          short_stick()};
}

}  // namespace stillpoint::accuracy
