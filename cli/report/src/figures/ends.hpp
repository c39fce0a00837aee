// SPDX-License-Identifier: MIT
#pragma once

// The figure of how the motion ends over the strength of what sets it off, a hit or a pulse.

#include <stillpoint/core/interval.hpp>
#include <stillpoint/design/hits.hpp>
#include <stillpoint/design/works_for.hpp>
#include <stillpoint/figures/figure.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::report {

struct DrawnEnds {
  std::string_view noun;      ///< "hit"
  std::string_view measured;  ///< "hits"
  std::string symbol;         ///< of the strength
  double scale{1};            ///< from a strength to its place on the axis
  std::string unit;           ///< there, may be empty
  std::vector<design::Hits> list;
  Interval asked;      ///< the strengths of the task
  double arrivals{1};  ///< at which it may rest
  bool has_range{false};
  std::optional<design::ServedInterval> works;
  /// Why the damper works for none, if no end says so.
  std::string refusal{};
  /// By what stronger ones fail that stop within beta.
  std::optional<double> acceleration_max{};
  bool fail_by_criterion{false};
};

/// Without its title and the name of its axis.
[[nodiscard]] figures::Figure ends_figure(const DrawnEnds& drawn);

}  // namespace stillpoint::report
