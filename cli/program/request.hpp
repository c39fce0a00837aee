// SPDX-License-Identifier: MIT
#pragma once

#include "excitation_input.hpp"
#include "settings.hpp"

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/design.hpp>
#include <stillpoint/design/physical.hpp>
#include <stillpoint/design/pulse.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace stillpoint::cli {

/// The scales, and what was given in metres and seconds, for a report in both.
struct PhysicalInput {
  design::Scales scales;
  double velocity_m_per_s{0};
  double period_s{0};
  bool by_stiffness{false};  ///< not by the period
  std::optional<double> max_displacement_m;
};

/// v0, p and x0 of a motion, however they were given.
struct MotionInput {
  double v0{0};
  double p{1};
  double x0{0};
  std::optional<PhysicalInput> physical;
};

struct DesignInput {
  design::DesignRequest request;         ///< without v0 where there is a pulse
  std::optional<design::Pulse> pulse;    ///< in place of the initial velocity
  std::optional<std::string> algorithm;  ///< as asked for
  std::optional<PhysicalInput> physical;
};

struct RegionInput {
  design::Problem problem;
  design::Limits limits;
  std::optional<double> f;
  std::optional<double> delta;
  std::optional<PhysicalInput> physical;
};

struct SimulateInput {
  Oscillator oscillator;
  Start start;
  std::optional<double> half_cycle_limit;
  std::int64_t max_half_cycles{1000};
  std::optional<ExcitationInput> excitation;  ///< empty: free motion
  std::optional<std::string> trajectory;
  std::int64_t samples{1000};
  std::optional<double> t_end;
  std::optional<PhysicalInput> physical;
};

/// Empty where not given. Throws InputError outside of 1 to 1e15.
[[nodiscard]] std::optional<double> half_cycle_limit(const Settings& settings);

/// Each throws UsageError for something missing or contradictory and InputError for a wrong value.
[[nodiscard]] DesignInput design_input(const Settings& settings);
[[nodiscard]] RegionInput region_input(const Settings& settings);
[[nodiscard]] SimulateInput simulate_input(const Settings& settings);

/// The options of those names, or their defaults. Throw InputError.
[[nodiscard]] design::Criterion criterion(const Settings& settings);
[[nodiscard]] design::Objective objective(const Settings& settings);

}  // namespace stillpoint::cli
