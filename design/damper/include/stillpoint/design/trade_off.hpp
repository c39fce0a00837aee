// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/search.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace stillpoint::design {

/// A damper of the front and its motion after the hit.
struct TradeOff {
  DesignPoint damper;
  double peak_amplitude{0};
  double transmitted{0};  ///< acceleration
  double stop_time{0};
};

inline constexpr std::int64_t least_trade_offs = 2;
inline constexpr std::int64_t most_trade_offs = 1000;

/// The front of stroke, transmitted acceleration and tolerance: dampers none of which can be
/// improved in one of the three without loss in another. It has every feasible f, each with the
/// most tolerant Delta; these are `count` of them at equal steps of f, from the largest stroke to
/// the least. docs/theory.md section 14 says why that is the whole front. Fewer if the feasible f
/// lie closer than rounding; none if the region is empty. Throws InputError for a wrong problem and
/// unless least_trade_offs <= count <= most_trade_offs.
[[nodiscard]] std::vector<TradeOff> trade_off(const Problem& problem, const Limits& limits,
                                              std::int64_t count);

/// Number `place`, from 1, of these `count` dampers; equal f are not left out. Empty if the region
/// is. Throws InputError as above and unless 1 <= place <= count.
[[nodiscard]] std::optional<DesignPoint> trade_off_at(const Problem& problem, const Limits& limits,
                                                      std::int64_t count, std::int64_t place);

}  // namespace stillpoint::design
