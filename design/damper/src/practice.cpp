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

/// (45) for a first arrival that the notch stops: least_notch_width for the place where the mass
/// comes to rest.
std::optional<double> width_of_the_stop(const Oscillator& oscillator, double peak, double limit) {
  const double p = oscillator.p;
  const double f = oscillator.f;
  const double delta = oscillator.delta;
  const double t = p * peak * p - f;  // S - 2f
  const double excess = (limit - t) * (limit + t) + p * delta * p;
  const double square = excess + f * f;
  return excess > 0 ? finite(delta * (std::sqrt(square) + f) / excess) : std::nullopt;
}

/// Of those that exist.
std::optional<double> lesser(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b ? std::min(a, b) : std::max(a, b);
}

/// (45) for a hit after which the mass arrives at x = 0, at whichever arrival it stops there.
std::optional<double> least_width_of_hit(const Oscillator& oscillator, double peak, double limit) {
  return lesser(width_of_the_stop(oscillator, peak, limit),
                least_notch_width(oscillator.f, oscillator.delta, limit, oscillator.p));
}

void worsen(Practice& worst, const Practice& now) {
  if (now.base_shear > worst.base_shear) {
    worst.base_shear = now.base_shear;
    worst.restoring = now.restoring;
    worst.secant_stiffness = now.secant_stiffness;
  }
  worst.equivalent_damping = lesser(worst.equivalent_damping, now.equivalent_damping);
  worst.energy_ratio = lesser(worst.energy_ratio, now.energy_ratio);
  worst.residual_ratio = lesser(worst.residual_ratio, now.residual_ratio);
  worst.impulse_at_stop = std::max(worst.impulse_at_stop, now.impulse_at_stop);
  worst.impulse_largest = std::max(worst.impulse_largest, now.impulse_largest);
  worst.notch_used = std::max(worst.notch_used, now.notch_used);
  worst.notch_width_min = worst.notch_width_min && now.notch_width_min
                              ? std::max(worst.notch_width_min, now.notch_width_min)
                              : std::nullopt;  // no width is enough for all
}

}  // namespace

std::optional<FullCycle> full_cycle(const Oscillator& oscillator, double peak,
                                    const std::optional<double>& notch_width) {
  const auto& [p, all_f, all_delta, hold, zeta, breakaway] = oscillator;
  // A cycle inside a notch with a width crosses it nowhere, and has its friction everywhere.
  const bool inside = notch_width && 2 * peak < *notch_width;
  const double f = inside ? all_f + all_delta / *notch_width : all_f;
  const double delta = inside ? 0 : all_delta;
  const double stiffness = p * p + f / peak;
  if (!(peak > 0) || !std::isfinite(stiffness)) {
    return std::nullopt;
  }
  const double damped = zeta > 0 ? zeta * p / std::sqrt(stiffness) : 0;  // (74)
  const double ratio = (2 * f + delta / peak) / (std::numbers::pi * (f + p * peak * p)) + damped;
  return FullCycle{
      stiffness, 4 * f * peak + 2 * delta + 2 * std::numbers::pi * damped * stiffness * peak * peak,
      ratio <= 1 ? std::optional(ratio) : std::nullopt};
}

double notch_acceleration(double f, double delta, double width, double p) {
  return f + delta / width + p * p * width / 2;
}

std::optional<double> least_notch_width(double f, double delta, double limit, double p) {
  // p^2 w^2/2 - c w + Delta <= 0: from the lesser root on.
  const double c = limit - f;
  const double square = (c - p * std::sqrt(2 * delta)) * (c + p * std::sqrt(2 * delta));
  if (!(c > 0) || square < 0) {
    return std::nullopt;
  }
  double width = 2 * delta / (c + std::sqrt(square));
  constexpr int roundings = 100;  // the two roots may be one
  for (int i = 0; i < roundings && notch_acceleration(f, delta, width, p) > limit; ++i) {
    width = std::nextafter(width, HUGE_VAL);
  }
  return width;
}

std::optional<double> least_notch_width_from_rest(double f, double delta, double limit, double p,
                                                  double load) {
  const auto least = least_notch_width(f, delta, limit, p);
  if (!(load > f)) {
    return std::nullopt;
  }
  if (!least || delta == 0) {
    return least;
  }
  double width = std::max(*least, delta / (load - f));
  constexpr int roundings = 100;
  for (int i = 0; i < roundings && f + delta / width >= load; ++i) {
    width = std::nextafter(width, HUGE_VAL);
  }
  return notch_acceleration(f, delta, width, p) <= limit ? std::optional(width) : std::nullopt;
}

// From the last arrival on by (7) backwards: one with the speed w has the radius r, and v+^2 = r^2
// - phi^2.
std::vector<double> impulses(const Oscillator& oscillator, const Response& response) {
  if (!response.arrival_speed) {
    return {};
  }
  const double p = oscillator.p;
  const double f = oscillator.f;
  const double delta = oscillator.delta;
  const double phi = f / p;
  const auto departure_before = [phi](double w) {
    const double r = 2 * phi + elementary::hypot(w, phi);
    return std::sqrt((r - phi) * (r + phi));
  };
  const double w = *response.arrival_speed;
  double departure = departure_before(w);
  std::vector<double> all;
  if (response.stops_at_zero) {
    all.push_back(w);
  } else {
    departure = std::sqrt(std::max(0.0, w * w - 2 * delta));
  }
  constexpr double most_listed = 1000;  // as arrivals
  for (double left = response.zero_passages.value_or(0);
       left > 0 && static_cast<double>(all.size()) < most_listed; --left) {
    all.push_back(impulse_of_passage(delta, departure));
    departure = departure_before(std::sqrt(departure * departure + 2 * delta));
  }
  std::ranges::reverse(all);
  return all;
}

std::optional<Practice> practice(const Oscillator& oscillator, const Response& response,
                                 const std::optional<double>& acceleration_max,
                                 const std::optional<double>& load) {
  const double p = oscillator.p;
  const double f = oscillator.f;
  const double delta = oscillator.delta;
  const double peak = response.peak_amplitude;
  if (peak == 0) {
    return std::nullopt;
  }
  Practice lines;
  lines.restoring = p * peak * p;
  lines.base_shear = f + lines.restoring;
  if (const auto cycle = full_cycle(oscillator, peak)) {
    lines.secant_stiffness = cycle->secant_stiffness;
    lines.equivalent_damping = cycle->equivalent_damping;
  }
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
  lines.impulses = impulses(oscillator, response);
  if (!lines.impulses->empty()) {
    lines.impulse_largest = std::ranges::max(*lines.impulses);
  }
  if (acceleration_max) {
    const bool arrives = lines.impulse_largest.has_value();
    lines.notch_width_min = load
                                ? least_notch_width_from_rest(f, delta, *acceleration_max, p, *load)
                            : arrives ? least_width_of_hit(oscillator, peak, *acceleration_max)
                                      : least_notch_width(f, delta, *acceleration_max, p);
  }
  return lines;
}

std::optional<Practice> practice(const SimulationRequest& request, const Simulation& motion) {
  return has_closed_form(request) && request.start.x0 == 0
             ? practice(request.oscillator, motion.response, std::nullopt)
             : std::nullopt;
}

std::optional<Practice> worst_practice(const Problem& problem, const Limits& limits, double f,
                                       double delta) {
  std::optional<Practice> worst;
  for (const Problem& end : ends_of_ranges(problem)) {
    const Oscillator oscillator{end.p, f, delta};
    const auto now =
        practice(oscillator, free_response(oscillator, {0, end.v0}), limits.acceleration_max);
    if (worst && now) {
      worsen(*worst, *now);
    } else if (now) {
      worst = now;
    }
  }
  if (worst) {
    worst->impulses.reset();
  }
  if (worst && worst->notch_width_min && problem.has_caught_hits(delta)) {
    worst->notch_width_min =
        least_notch_width(f, delta, limits.acceleration_max.value(), problem.stiffest_p());
  }
  return worst;
}

}  // namespace stillpoint::design
