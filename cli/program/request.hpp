// SPDX-License-Identifier: MIT
#pragma once

#include "settings.hpp"

#include <stillpoint/core/simulation.hpp>
#include <stillpoint/design/catalogue.hpp>
#include <stillpoint/design/design.hpp>
#include <stillpoint/design/physical.hpp>
#include <stillpoint/design/region.hpp>
#include <stillpoint/report/report.hpp>
#include <stillpoint/sweep/spec.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stillpoint::cli {

/// A request, and what a report or a file needs beside it. `physical` where it was given in metres
/// and seconds.
template <class Request>
struct Input {
  Request request;
  std::optional<design::PhysicalInput> physical;
};
using DesignInput = Input<design::DesignRequest>;
using RegionInput = Input<design::RegionRequest>;

struct SimulateInput {
  SimulationRequest request;
  std::optional<report::RecordOrigin> record;
  std::optional<std::string> trajectory;  ///< the file
  std::optional<design::PhysicalInput> physical;
};

/// Empty where not given. Throws InputError outside of 1 to 1e15.
[[nodiscard]] std::optional<double> half_cycle_limit(const Settings& settings);

/// Each throws UsageError for something missing or contradictory and InputError for a wrong value.
[[nodiscard]] DesignInput design_input(const Settings& settings);
[[nodiscard]] RegionInput region_input(const Settings& settings);
/// The parts of --catalogue, in the units of the task; empty without. Throws records::FileError for
/// a wrong file.
[[nodiscard]] std::optional<std::vector<design::Part>> catalogue_input(
    const Settings& settings, double p, const std::optional<design::PhysicalInput>& physical);
/// The same for a sweep; the unit of length is a metre.
[[nodiscard]] std::vector<design::Part> catalogue_input(
    const Settings& settings, const std::optional<sweep::SweepUnits>& physical);
[[nodiscard]] SimulateInput simulate_input(const Settings& settings);

/// Opens the list and reads its header.
[[nodiscard]] sweep::SweepSpec sweep_request(const Settings& settings);

/// The box of --tolerance-f and --tolerance-delta around the tolerance of `limits`. Throws
/// InputError.
void shape_box(const Settings& settings, design::Limits& limits);

/// The options of those names, or their defaults. Throw InputError.
[[nodiscard]] design::Criterion criterion(const Settings& settings);
[[nodiscard]] design::Objective objective(const Settings& settings);

}  // namespace stillpoint::cli
