// SPDX-License-Identifier: MIT
// The requests of design and region, which share their task.

#include "excitation_input.hpp"
#include "motion_input.hpp"
#include "request.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/sweep/catalogue_file.hpp>

namespace stillpoint::cli {

namespace {

/// Of a limit of Delta, as problem.hpp has it.
constexpr double smallest_limit = 1e-300;

struct Task {
  design::Problem problem;
  design::Limits limits;
  std::optional<design::PhysicalInput> physical;
};

/// The stroke beta. Says in `motion` what it is in metres.
double stroke(const Settings& settings, MotionInput& motion) {
  if (!motion.physical) {
    return settings.required("beta", "give --beta, or --max-displacement in m");
  }
  const double displacement =
      settings.required("max-displacement", "give the largest admissible displacement in m");
  require_within("max-displacement", displacement, smallest_physical, largest_physical);
  motion.physical->max_displacement_m = displacement;
  return displacement / motion.physical->scales.length_m;
}

/// With a pulse, without a velocity.
Task task(const Settings& settings, Command command, bool pulse) {
  MotionInput motion = motion_input(settings, command, pulse);
  const double beta = stroke(settings, motion);
  if (motion.physical && !pulse) {
    require_within("velocity", motion.physical->velocity_m_per_s, smallest_physical,
                   largest_physical);
  }
  return {
      {motion.v0, motion.p, beta, criterion(settings), settings.integer("arrivals").value_or(1)},
      {settings.number("f-max"),
       point_friction(settings, "delta-max", "delta-max-m", motion.physical, smallest_limit),
       settings.number("tolerance").value_or(0), settings.number("acceleration-max")},
      motion.physical};
}

}  // namespace

design::Criterion criterion(const Settings& settings) {
  const auto wanted = settings.known("criterion");
  return wanted ? *design::parse_criterion(*wanted) : design::Problem().criterion;
}

design::Objective objective(const Settings& settings) {
  const auto wanted = settings.known("objective");
  return wanted ? *design::parse_objective(*wanted) : design::SearchOptions().objective;
}

DesignInput design_input(const Settings& settings) {
  const Task given = task(settings, Command::design, settings.has("pulse"));
  const std::optional<design::Pulse> pulse = pulse_input(settings, given.physical);
  const std::optional<std::string> algorithm = settings.text("algorithm");
  if (algorithm && algorithm->empty()) {
    throw InputError("algorithm", "\"\"", "must name an NLopt algorithm");
  }
  DesignInput input{{given.problem, given.limits, {}, pulse}, given.physical};
  input.request.search.objective = objective(settings);
  input.request.search.algorithm = algorithm.value_or("");
  return input;
}

RegionInput region_input(const Settings& settings) {
  if (settings.has("pulse") && !settings.has("v0") && !settings.has("velocity")) {
    throw InputError::missing(
        "v0", "region needs a velocity, not a pulse: give --v0, or --velocity in m/s");
  }
  const Task given = task(settings, Command::region, false);
  RegionInput input{{given.problem, given.limits, settings.number("f")}, given.physical};
  auto& [problem, limits, f, delta] = input.request;
  delta = point_friction(settings, "delta", "delta-m", given.physical);
  if (f) {
    require_valid(Oscillator{problem.p, *f, delta.value_or(0)});
  }
  if (delta && !f) {
    throw InputError::missing("f", "delta alone is not a point of the region, give --f as well");
  }
  return input;
}

std::optional<std::vector<design::Part>> catalogue_input(
    const Settings& settings, const std::optional<design::PhysicalInput>& physical) {
  const auto path = settings.text("catalogue");
  if (!path) {
    return std::nullopt;
  }
  if (settings.has("pulse")) {
    throw UsageError("catalogue and pulse exclude each other: parts are chosen for a velocity");
  }
  sweep::CatalogueUnits units;
  if (physical) {
    units.length_m = physical->scales.length_m;
  }
  const Option& in_metres = *find_option("delta-m");
  units.parse_metres = [&in_metres](std::string_view text) { return parse_value(in_metres, text); };
  return sweep::read_catalogue(*path, units);
}

}  // namespace stillpoint::cli
