// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/half_cycles.hpp>
#include <stillpoint/core/motion_energies.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/surface.hpp>
#include <stillpoint/core/traced_state.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace stillpoint {

/// One motion, and which results to compute.
struct SimulationRequest {
  Oscillator oscillator;
  Start start;
  Excitation excitation{};                 ///< none: a free motion
  Surface surface{};                       ///< under the mass
  std::optional<double> t_end{};           ///< of a forced run, and of any trajectory
  std::optional<double> half_cycle_limit;  ///< as in FreeOptions and ForcedOptions
  bool energies{true};
  std::int64_t max_half_cycles{1000};     ///< listed at most
  std::optional<std::int64_t> samples{};  ///< of the trajectory, >= 2; empty: no trajectory
};

/// The results.
struct Simulation {
  Response response;
  std::optional<ForcedResponse> forced;  ///< if there is an excitation; response is its part
  MotionEnergies energies;
  std::vector<HalfCycle> half_cycles;
  /// States at evenly spaced instants and at every event; a passage has two, before and after the
  /// notch. They go up to t_end, or without it to the end of the motion, or for ten periods if the
  /// motion never ends (a forced motion: ten periods after the excitation).
  std::vector<TracedState> trajectory;
  /// The tau where half-cycles and trajectory of a forced motion end; empty for a free one.
  std::optional<double> horizon{};
  bool cancelled{false};  ///< go_on returned false: the rest is incomplete
};

[[nodiscard]] bool is_forced(const SimulationRequest& request);
/// A free motion of the paper.
[[nodiscard]] bool has_closed_form(const SimulationRequest& request);

/// The energies alone.
[[nodiscard]] MotionEnergies energies_of(const SimulationRequest& request,
                                         const std::function<bool(double)>& go_on = {});

/// Metrics, energies, half-cycles and trajectory of the motion, which is run once: what is not
/// requested costs nothing. A forced run calls `go_on` now and then with the tau reached; false
/// ends it. Throws InputError as free_response and forced_response do, and about t_end if the
/// motion rests too late to be listed up to then; TooManyHalfCycles.
[[nodiscard]] Simulation simulate(const SimulationRequest& request,
                                  const std::function<bool(double)>& go_on = {});

}  // namespace stillpoint
