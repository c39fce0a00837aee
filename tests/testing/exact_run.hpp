// SPDX-License-Identifier: MIT
#pragma once

// The kernel's own template in another scalar: with 50 digits the reference of the tests of double.
// The rules, which it shares with double, are checked against data/reference instead.

#include "kernel/free_run.hpp"
#include "kernel/margin_keeper.hpp"
#include "kernel/phase_clock.hpp"
#include "testing/exact.hpp"
#include "testing/scene.hpp"

#include <stillpoint/core/state.hpp>

#include <optional>

namespace stillpoint::test {

/// The decisions of a motion: equal ends mean equal outcome and counts.
struct End {
  Outcome outcome{Outcome::never_stops};
  double half_cycles{0};
  double turning_points{0};
  double zero_passages{0};

  bool operator==(const End&) const = default;
};

inline std::ostream& operator<<(std::ostream& out, const End& end) {
  return out << name(end.outcome) << " with " << end.half_cycles << " half-cycles, "
             << end.turning_points << " turning points, " << end.zero_passages << " passages";
}

/// The continuous metrics, in the order of `metric_names`.
template <class Real>
using Metrics = std::array<std::optional<Real>, 5>;

inline constexpr std::array<const char*, 5> metric_names{
    "peak_amplitude", "peak_acceleration", "stop_time", "stop_position", "arrival_speed"};

template <class Real>
struct Run {
  End end;
  Metrics<Real> metrics;
  std::optional<Real> margin;
};

inline Run<double> as_run(const Response& response) {
  return {{response.outcome, response.half_cycles.value_or(0), response.turning_points.value_or(0),
           response.zero_passages.value_or(0)},
          {response.peak_amplitude, response.peak_acceleration, response.stop_time,
           response.stop_position, response.arrival_speed},
          response.decision_margin};
}

/// The metrics as stillpoint/core/free_motion.hpp defines them, in the scalar Real.
template <class Real>
Run<Real> run_in(const Scene<Real>& scene, double half_cycle_limit = 1e8) {
  using std::sqrt;
  PhaseClock<Real> clock;
  MarginKeeper<Real> keeper;
  const FreeRun<Real> run =
      free_run(scene.oscillator(), scene.start(), half_cycle_limit, clock, keeper);
  Run<Real> result;
  result.end.outcome = run.outcome;
  result.margin = keeper.margin();
  Metrics<Real>& metrics = result.metrics;
  metrics[0] = run.farthest / scene.p;
  metrics[1] = run.acceleration * scene.p;
  if (run.outcome == Outcome::never_stops) {
    return result;
  }
  result.end.zero_passages = static_cast<double>(run.passages);
  result.end.half_cycles = run.moves ? result.end.zero_passages + 1 : 0;
  result.end.turning_points = static_cast<double>(run.turning_points);
  metrics[2] = clock.phase() / scene.p;
  metrics[3] = run.rest / scene.p;
  if (run.arrival) {
    metrics[4] = sqrt(*run.arrival);
  }
  return result;
}

}  // namespace stillpoint::test
