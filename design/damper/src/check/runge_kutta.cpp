// SPDX-License-Identifier: MIT
#include "check/runge_kutta.hpp"

#include "pulse/first_return.hpp"
#include "record/suite.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/peers/load.hpp>
#include <stillpoint/peers/methods.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <variant>

namespace stillpoint::design {

namespace {

using std::numbers::pi;

/// Of the phase p t. The error of a step is (p h)^5/120 of the motion, so 5e-16 for each radian:
/// close decisions amplify it up to a millionfold. A slip as short as a step is off by
/// (p h)^2/20 of itself, so 1e-8. Of a pulse, a part of its length.
constexpr double phase_step = 1.0 / 2000;

/// The largest |W| after tau = `from`, which a mass held for ever feels.
double largest_load_after(const Excitation& excitation, double from) {
  return peers::with_load(excitation, [from](auto load) {
    double most = 0;
    for (; load.stretch_end() < peers::for_ever; load.next_stretch()) {
      const double end = load.stretch_end();
      for (double t = load.next_look(from); t < end; t = load.next_look(t)) {
        most = std::max(most, std::abs(load(t)));
      }
      most = end > from ? std::max(most, std::abs(load(end))) : most;
    }
    return most;
  });
}

}  // namespace

IntegratedMotion integrate_free_motion(const Oscillator& oscillator, double v0, double tolerance,
                                       double max_half_cycles) {
  require_valid(oscillator, {0, v0});
  require_within("v0", v0, smallest_speed, largest_speed);
  require_within("tolerance", tolerance, std::numeric_limits<double>::epsilon(), 1e-2);
  const double p = oscillator.p;
  const double f = oscillator.f;
  const double delta = oscillator.delta;
  if (f == 0 && delta == 0) {
    throw InputError("f, delta", "0", "some friction is needed for the motion to stop");
  }
  IntegratedMotion motion;
  motion.stopped = true;
  motion.half_cycles = 0;
  // Not scaled by v0, which could move an exact tie to the other side.
  if (holds_at_start(delta, v0)) {
    return motion;
  }
  // In units of V0 and p, where no half-cycle takes more than pi. A notch that no digit shows makes
  // x = 0 an event, whose speed counts.
  constexpr double unfelt = 1e-300;
  const Oscillator unit{1, f / p / v0, std::max(delta / v0 / v0, unfelt)};
  const peers::Result result =
      peers::dopri5({unit, {0, 1}, NoExcitation{}, max_half_cycles * pi}, tolerance);
  motion.stopped = result.outcome != Outcome::running;
  motion.half_cycles = std::min(static_cast<double>(result.passages) + 1, max_half_cycles);
  motion.peak_amplitude = result.peak * v0 / p;
  motion.peak_acceleration = result.acceleration * v0 * p;
  motion.stop_time = result.end_time / p;
  motion.arrival_speed = result.arrival_speed * v0;
  motion.stop_position = motion.stopped ? result.x * v0 / p : 0;
  return motion;
}

IntegratedMotion integrate_under_pulse(const Oscillator& oscillator, const Pulse& pulse,
                                       double size, double tolerance) {
  const double p = oscillator.p;
  const double f = oscillator.f;
  const double delta = oscillator.delta;
  const double k = peak_load(pulse);
  const double length = k / p / p;
  // In units of k and p. The mass arrives or rests within a turn of the phase after the pulse.
  const Excitation load = excitation(unit_pulse(pulse, p));
  const double ends = duration(load).value();
  constexpr double first_step = 1e-2;  // of the time below; the controller corrects it at once
  const peers::Result result =
      peers::dopri5({{1, f / k, unpassable}, {}, load, ends + 3 * pi}, tolerance,
                    {size / length, size / length, first_step * std::min(1.0, ends)});
  const double speed = result.arrival_speed;
  const bool passes = speed * speed > 2 * delta / length / k;
  IntegratedMotion motion;
  motion.stopped = !passes && result.outcome != Outcome::running;
  motion.half_cycles = passes ? 2 : 1;
  motion.peak_amplitude = result.peak * length;
  motion.peak_acceleration = result.relative_acceleration * k;
  motion.stop_time = result.end_time / p;
  motion.arrival_speed = speed * k / p;
  motion.stop_position = result.x * length;
  return motion;
}

SuiteFigures integrate_to_rest(const Oscillator& oscillator, const Surface& surface,
                               const Excitation& load, const Start& start) {
  const double p = oscillator.p;
  const double t_end = duration(load).value_or(0) + most_suite_half_cycles * pi / p;
  const double step = phase_step / p;
  std::optional<double> under_load;  // a record has steps of its own
  if (const auto length = duration(load); length > 0.0 && !std::holds_alternative<Record>(load)) {
    under_load = std::min(step, phase_step * *length);
  }
  const peers::Result result = peers::runge_kutta4({oscillator, start, load, t_end, surface}, step,
                                                   peers::any_effort, under_load);
  return {.peak = result.peak,
          .acceleration = std::max(result.acceleration, largest_load_after(load, result.end_time)),
          .residual = std::abs(result.x),
          .passages = static_cast<double>(result.passages),
          .settled = result.outcome != Outcome::running};
}

}  // namespace stillpoint::design
