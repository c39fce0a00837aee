// SPDX-License-Identifier: MIT
#include <stillpoint/core/elementary.hpp>
#include <stillpoint/design/practice.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stillpoint::design {

namespace {

std::optional<double> finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// v- - v+ = 2 Delta / (v- + v+) of a passage that leaves with v+. It grows as the motion slows
/// down.
double impulse_of_passage(double delta, double departure) {
  const double arrival = std::sqrt(departure * departure + 2 * delta);
  return arrival > 0 ? 2 * delta / (arrival + departure) : 0;
}

/// Of the last passage, if there was one.
std::optional<double> last_passage(const Oscillator& oscillator, const Response& response) {
  if (!response.arrival_speed || response.zero_passages.value_or(0) == 0) {
    return std::nullopt;
  }
  const double w = *response.arrival_speed;
  const double delta = oscillator.delta;
  if (!response.stops_at_zero) {
    return impulse_of_passage(delta, std::sqrt(std::max(0.0, w * w - 2 * delta)));
  }
  // (7) backwards: the arrival that stops has the radius r, and v+^2 = r^2 - phi^2.
  const double phi = oscillator.f / oscillator.p;
  const double r = 2 * phi + elementary::hypot(w, phi);
  return impulse_of_passage(delta, std::sqrt((r - phi) * (r + phi)));
}

}  // namespace

double notch_acceleration(double f, double delta, double width) {
  return f + delta / width;
}

std::optional<double> least_notch_width(double f, double delta, double limit) {
  if (!(limit > f)) {
    return std::nullopt;
  }
  double width = delta / (limit - f);
  while (notch_acceleration(f, delta, width) > limit) {
    width = std::nextafter(width, HUGE_VAL);
  }
  return width;
}

std::optional<Practice> practice(const Oscillator& oscillator, const Response& response,
                                 const std::optional<double>& acceleration_max) {
  const auto& [p, f, delta, hold] = oscillator;
  const double peak = response.peak_amplitude;
  if (peak == 0) {
    return std::nullopt;
  }
  Practice lines;
  lines.restoring = p * peak * p;
  lines.base_shear = f + lines.restoring;
  lines.secant_stiffness = finite(p * p + f / peak);
  // (43), (2 f A + Delta)/(pi A (p^2 A + f)).
  lines.equivalent_damping = finite((2 * f + delta / peak) / (std::numbers::pi * lines.base_shear));
  lines.energy_ratio = finite(lines.restoring / f / 2);
  lines.residual_ratio = finite(lines.restoring / f);
  lines.notch_capacity = delta;
  if (response.stops_at_zero && response.arrival_speed) {
    const double w = *response.arrival_speed;
    lines.impulse_at_stop = w;
    if (delta > 0) {
      lines.notch_used = finite(w / delta * w / 2);
    }
  }
  lines.impulse_largest = lines.impulse_at_stop;
  if (const auto last = last_passage(oscillator, response)) {
    lines.impulse_largest = std::max(*last, lines.impulse_at_stop.value_or(0));
  }
  if (acceleration_max) {
    lines.notch_width_min = least_notch_width(f, delta, *acceleration_max);
  }
  return lines;
}

}  // namespace stillpoint::design
