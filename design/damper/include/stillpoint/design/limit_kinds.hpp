// SPDX-License-Identifier: MIT
#pragma once

// The limits that a user may give. A new one is a member of Limits and a row of the table
// (src/region/limit_table.hpp): the region, the search, the mends, the catalogue, the task under a
// pulse, and the words and the input of a report follow from it.

#include <stillpoint/design/problem.hpp>

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace stillpoint::design {

struct FirstReturn;

/// A figure of the motion that a limit keeps small. It grows with f and with V0.
struct LimitedFigure {
  /// The largest f that keeps it for the strongest hit and the stiffest spring; negative if none
  /// does.
  double (*edge)(const Problem& problem, double limit);
  double (*least)(const Problem& problem);  ///< without friction
  /// The p at which a box has the most room between f2 and the edge.
  double (*roomiest_p)(const Problem& problem, const Limits& limits, double limit);
  double FirstReturn::*under_pulse;  ///< in units of k
};

enum class Bounded { f, delta };

/// An upper limit of f, of Delta, or of a figure of the motion, which is one of f as well.
struct LimitKind {
  std::string_view field;  ///< in Limits, in messages and in reports
  std::optional<double> Limits::*value;
  std::string_view constraint;  ///< its name there
  Bounded bounds;
  std::string_view quantity;     ///< what it limits
  std::string_view unit{};       ///< of that, with a blank before it
  std::string_view in_metres{};  ///< the field of a limit of Delta, if that is a length
  std::string_view beyond;       ///< what a figure says of the dampers beyond it
  std::optional<LimitedFigure> figure{};

  [[nodiscard]] bool bounds_f() const { return bounds == Bounded::f; }
  /// The least that may be given; without any notch the damper is constant friction alone.
  [[nodiscard]] double least() const { return bounds == Bounded::delta ? 0 : smallest_limit; }
};

[[nodiscard]] std::span<const LimitKind> limit_kinds();

/// A limit that is given, and the largest f or Delta that meets it.
struct LimitEdge {
  const LimitKind* kind;
  double limit;
  double edge;
};
[[nodiscard]] std::vector<LimitEdge> limit_edges(const Problem& problem, const Limits& limits);

/// The least of those edges, of f or of Delta; infinite without one.
[[nodiscard]] double largest_f_allowed(const Problem& problem, const Limits& limits);
[[nodiscard]] double largest_delta_allowed(const Limits& limits);

}  // namespace stillpoint::design
