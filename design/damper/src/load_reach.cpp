// SPDX-License-Identifier: MIT
#include <stillpoint/design/load_reach.hpp>

#include <stillpoint/core/forced_motion.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace stillpoint::design {

namespace {

/// Not less than the integral of |W|.
double impulse(const Excitation& load, double lasts) {
  return std::visit(
      [lasts]<class Kind>(const Kind& kind) {
        double sum = 0;
        if constexpr (requires { kind.k; }) {
          sum = std::abs(kind.k) * lasts;
        } else if constexpr (requires { kind.values; }) {
          for (std::size_t i = 1; i < kind.values.size(); ++i) {
            const double step = kind.times.empty() ? kind.step : kind.times[i] - kind.times[i - 1];
            sum += (std::abs(kind.values[i - 1]) + std::abs(kind.values[i])) / 2 * step;
          }
        }
        return sum;
      },
      load);
}

}  // namespace

LoadReach load_reach(const Excitation& load, double p, const std::optional<double>& t_end,
                     const Scales& scales) {
  const auto* const harmonic = std::get_if<Harmonic>(&load);
  double reach = 0;
  if (harmonic != nullptr) {
    const double faster = std::max(p, harmonic->lambda);
    reach = std::abs(harmonic->k) / faster / faster;
  } else {
    // When the load is over it swings with its largest amplitude within a period.
    const double swung = duration(load).value_or(HUGE_VAL) + 2 * std::numbers::pi / p;
    const auto end = t_end && *t_end < swung ? t_end : std::nullopt;
    reach = forced_response({.p = p}, {}, load, {.t_end = end}).peak_amplitude;
  }
  const double lasts = std::min(duration(load).value_or(HUGE_VAL), t_end.value_or(HUGE_VAL));
  return {reach * scales.length_m, impulse(load, lasts) * scales.velocity_m_per_s,
          harmonic == nullptr && !std::holds_alternative<Record>(load)};
}

}  // namespace stillpoint::design
