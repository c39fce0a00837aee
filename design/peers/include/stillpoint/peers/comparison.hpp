// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/simulation.hpp>
#include <stillpoint/peers/exact.hpp>
#include <stillpoint/peers/measure.hpp>
#include <stillpoint/peers/scene.hpp>

#include <optional>
#include <string_view>
#include <vector>

namespace stillpoint::peers {

/// For a free motion; this many take about a second in 50 digits.
inline constexpr double most_half_cycles = 1e5;

/// The scene for the comparison: the requested motion up to its t_end or, without one, until past
/// its rest, so that integrators have room to miss it. Throws InputError for a motion that never
/// stops, and for one that is too long for 50 digits; and what free_response and forced_response
/// throw, for wrong input and for more than `most_half_cycles`.
[[nodiscard]] Scene comparison_scene(const SimulationRequest& request);

enum class Run {
  done,
  nothing_moves,  ///< not run: the mass never moves, so there is nothing to integrate
  too_long,       ///< not run to its end: it would take too long
};

/// "tolerance", 1e-9.
struct Setting {
  std::string_view name;
  double value{0};
};

/// A method with one setting on a scene; what follows `run` is empty unless that is `done`.
struct MethodRow {
  std::string_view name;
  std::optional<Setting> setting{};
  Run run{Run::done};
  Timing time{};
  Result result{};
  double peak_error{0};  ///< relative to the peak
  /// The larger of two errors: that of x, relative to the peak; and that of the stop time, relative
  /// to itself, or if the motion goes on at the end that of v, relative to p times the peak.
  double end_error{0};
  bool counts_right{false};
};

struct Comparison {
  ExactResult exact;            ///< 50 digits
  std::vector<MethodRow> rows;  ///< this project's kernel first
};

/// This project's kernel and the methods that others would use, each with settings from coarse to
/// fine. Every method gives up after an effort of about a second at most.
[[nodiscard]] Comparison compare(const Scene& scene);

}  // namespace stillpoint::peers
