// SPDX-License-Identifier: MIT
#pragma once

// The table of limits. Its functions are those of (33) and (34) in docs/theory.md.

#include "pulse/first_return.hpp"

#include <stillpoint/design/limit_kinds.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace stillpoint::design {

/// (33): the f with S = sqrt(f^2 + p^2 V0^2) = limit. Where p V0 alone is above the limit, minus
/// the root of the opposite: no f >= 0 meets that.
[[nodiscard]] double acceleration_edge(const Problem& problem, double limit);
[[nodiscard]] double least_acceleration(const Problem& problem);
/// The root of (34).
[[nodiscard]] double roomiest_p(const Problem& problem, const Limits& limits, double limit);

inline constexpr std::array limit_table{
    LimitKind{.field = "f_max",
              .value = &Limits::f_max,
              .constraint = "f_max",
              .bounds = Bounded::f,
              .quantity = "f",
              .beyond = "above the largest f"},
    LimitKind{.field = "delta_max",
              .value = &Limits::delta_max,
              .constraint = "delta_max",
              .bounds = Bounded::delta,
              .quantity = "delta",
              .in_metres = "delta_max_m",
              .beyond = "above the largest Δ"},
    LimitKind{.field = "acceleration_max",
              .value = &Limits::acceleration_max,
              .constraint = "acceleration",
              .bounds = Bounded::f,
              .quantity = "transmitted acceleration",
              .unit = " g",
              .beyond = "too strong: acceleration",
              .figure = LimitedFigure{acceleration_edge, least_acceleration, roomiest_p,
                                      &FirstReturn::acceleration}},
};

/// The rows that limit a figure.
inline constexpr std::size_t figure_count = static_cast<std::size_t>(std::ranges::count_if(
    limit_table, [](const LimitKind& kind) { return kind.figure.has_value(); }));
inline constexpr auto limited_figures = [] {
  std::array<const LimitKind*, figure_count> rows{};
  std::size_t next = 0;
  for (const LimitKind& kind : limit_table) {
    if (kind.figure) {
      rows[next++] = &kind;
    }
  }
  return rows;
}();

/// The limit, infinite if it is not given.
[[nodiscard]] inline double limit_or_infinity(const LimitKind& kind, const Limits& limits) {
  return (limits.*kind.value).value_or(HUGE_VAL);
}

/// The least of the limits of f itself, or of Delta; infinite without one.
[[nodiscard]] inline double least_limit(Bounded variable, const Limits& limits) {
  double least = HUGE_VAL;
  for (const LimitKind& kind : limit_table) {
    if (kind.bounds == variable && !kind.figure) {
      least = std::min(least, limit_or_infinity(kind, limits));
    }
  }
  return least;
}

/// The least edge of the limits of a figure; infinite without one.
[[nodiscard]] double figures_edge(const Problem& problem, const Limits& limits);

}  // namespace stillpoint::design
