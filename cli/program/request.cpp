// SPDX-License-Identifier: MIT
#include "request.hpp"

#include "pulse_input.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/input_error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string_view>
#include <utility>

namespace stillpoint::cli {

namespace {

constexpr double unlimited = std::numeric_limits<double>::max();
/// As for the isolator's own figures: what these make dimensionless is then valid as well.
constexpr double smallest_physical = 1e-30;
constexpr double largest_physical = 1e30;
/// Of a limit of Delta, as problem.hpp has it.
constexpr double smallest_limit = 1e-300;

constexpr std::array physical_names{"velocity", "period",  "stiffness",
                                    "mass",     "gravity", "max-displacement",
                                    "x0-m",     "delta-m", "delta-max-m"};

void require_one_of(const Settings& settings, std::initializer_list<std::string_view> names) {
  std::string_view first;
  for (const std::string_view name : names) {
    if (!settings.has(name)) {
      continue;
    }
    if (!first.empty()) {
      throw UsageError(fmt::format("{} and {} exclude each other: give one of them", first, name));
    }
    first = name;
  }
}

/// The physical option that is set, if any; UsageError where dimensionless ones are set as well.
bool is_physical(const Settings& settings) {
  require_one_of(settings, {"v0", "velocity"});
  require_one_of(settings, {"p", "period", "stiffness"});
  require_one_of(settings, {"beta", "max-displacement"});
  require_one_of(settings, {"x0", "x0-m"});
  require_one_of(settings, {"delta", "delta-m"});
  require_one_of(settings, {"delta-max", "delta-max-m"});
  for (const std::string_view physical : physical_names) {
    // The gravity that turns a record's m/s2 into g says nothing of the motion.
    if (!settings.has(physical) ||
        (physical == std::string_view("gravity") && settings.has("record"))) {
      continue;
    }
    for (const std::string_view plain : {"v0", "p", "beta", "x0"}) {
      if (settings.has(plain)) {
        throw UsageError(fmt::format(
            "{} and {} exclude each other: give all in metres and seconds or all dimensionless",
            plain, physical));
      }
    }
    return true;
  }
  return false;
}

/// A motion needs a start, unless something shakes it out of rest.
bool starts_from_rest(const Settings& settings) {
  return settings.has("excitation") || settings.has("record") || settings.has("k");
}

double initial_velocity(const Settings& settings, std::string_view name, bool may_be_missing,
                        std::string_view hint) {
  return may_be_missing ? settings.number(name).value_or(0) : settings.required(name, hint);
}

MotionInput physical_motion(const Settings& settings, bool from_rest) {
  design::PhysicalIsolator isolator;
  isolator.period_s = settings.number("period");
  isolator.stiffness_n_per_m = settings.number("stiffness");
  isolator.mass_kg = settings.number("mass");
  isolator.gravity_m_per_s2 = settings.number("gravity").value_or(isolator.gravity_m_per_s2);
  const double x0_m = settings.number("x0-m").value_or(0);
  const double velocity = initial_velocity(settings, "velocity", x0_m != 0 || from_rest,
                                           "give the initial velocity in m/s");
  MotionInput motion;
  motion.physical = design::physical_input(isolator, velocity, x0_m);
  const design::Scales& scales = motion.physical->scales;
  motion.v0 = velocity / scales.velocity_m_per_s;
  motion.p = scales.p;
  motion.x0 = x0_m / scales.length_m;
  return motion;
}

/// `from_rest`: the velocity may be missing, because something else sets the mass off.
MotionInput motion_input(const Settings& settings, bool from_rest) {
  if (is_physical(settings)) {
    return physical_motion(settings, from_rest);
  }
  MotionInput motion;
  motion.x0 = settings.number("x0").value_or(0);
  motion.v0 = initial_velocity(settings, "v0", motion.x0 != 0 || from_rest,
                               "give --v0, or --velocity in m/s");
  motion.p = settings.required("p", "give --p, or --period in s");
  return motion;
}

/// A length of the damper that may be given in metres or dimensionless, then at least `least`.
std::optional<double> point_friction(const Settings& settings, std::string_view plain,
                                     std::string_view metres,
                                     const std::optional<design::PhysicalInput>& physical,
                                     double least = 0) {
  if (const auto value = settings.number(metres)) {
    const double unit = physical->scales.length_m;
    const double most = std::min(largest_square * unit, unlimited);
    if (!(*value >= least * unit && *value <= most)) {
      throw InputError(std::string(metres), *value,
                       fmt::format("must be a number from {:.3g} to {:.3g}", least * unit, most));
    }
    return *value / unit;
  }
  return settings.number(plain);
}

struct Task {
  design::Problem problem;
  design::Limits limits;
  std::optional<design::PhysicalInput> physical;
};

/// What design and region have in common; with a pulse, without a velocity.
Task task(const Settings& settings, bool pulse) {
  MotionInput motion = motion_input(settings, pulse);
  Task result;
  result.problem.v0 = motion.v0;
  result.problem.p = motion.p;
  if (motion.physical) {
    const double displacement =
        settings.required("max-displacement", "give the largest admissible displacement in m");
    if (!pulse) {
      require_within("velocity", motion.physical->velocity_m_per_s, smallest_physical,
                     largest_physical);
    }
    require_within("max-displacement", displacement, smallest_physical, largest_physical);
    motion.physical->max_displacement_m = displacement;
    result.problem.beta = displacement / motion.physical->scales.length_m;
  } else {
    result.problem.beta = settings.required("beta", "give --beta, or --max-displacement in m");
  }
  result.problem.criterion = criterion(settings);
  result.limits.f_max = settings.number("f-max");
  result.limits.delta_max =
      point_friction(settings, "delta-max", "delta-max-m", motion.physical, smallest_limit);
  result.limits.tolerance = settings.number("tolerance").value_or(0);
  result.physical = motion.physical;
  return result;
}

std::int64_t count(const Settings& settings, std::string_view name, std::int64_t fallback,
                   std::int64_t least, std::int64_t most) {
  const std::int64_t value = settings.integer(name).value_or(fallback);
  if (value < least || value > most) {
    throw InputError(std::string(name), fmt::format("{}", value),
                     fmt::format("must be a whole number from {} to {}", least, most));
  }
  return value;
}

}  // namespace

design::Criterion criterion(const Settings& settings) {
  const std::string wanted = settings.text("criterion").value_or("published");
  for (const auto value : {design::Criterion::published, design::Criterion::exact}) {
    if (wanted == name(value)) {
      return value;
    }
  }
  throw InputError("criterion", wanted, "must be published or exact");
}

design::Objective objective(const Settings& settings) {
  using enum design::Objective;
  const std::string wanted = settings.text("objective").value_or("robust");
  for (const auto value : {robust, amplitude, time, acceleration}) {
    if (wanted == name(value)) {
      return value;
    }
  }
  throw InputError("objective", wanted, "must be robust, amplitude, time or acceleration");
}

std::optional<double> half_cycle_limit(const Settings& settings) {
  const std::optional<double> limit = settings.number("half-cycle-limit");
  if (limit) {
    require_within("half-cycle-limit", *limit, 1, 1e15);
  }
  return limit;
}

DesignInput design_input(const Settings& settings) {
  require_one_of(settings, {"v0", "velocity", "pulse"});
  const std::optional<design::Pulse> pulse = pulse_input(settings);
  const Task given = task(settings, pulse.has_value());
  const std::optional<std::string> algorithm = settings.text("algorithm");
  DesignInput input{{given.problem, given.limits, {}, pulse}, given.physical};
  input.request.search.objective = objective(settings);
  input.request.search.algorithm = algorithm.value_or("");
  if (algorithm && algorithm->empty()) {
    throw InputError("algorithm", "\"\"", "must name an NLopt algorithm");
  }
  return input;
}

RegionInput region_input(const Settings& settings) {
  if (settings.has("pulse") && !settings.has("v0") && !settings.has("velocity")) {
    throw InputError::missing(
        "v0", "region needs a velocity, not a pulse: give --v0, or --velocity in m/s");
  }
  const Task given = task(settings, false);
  RegionInput input{{given.problem, given.limits, settings.number("f")}, given.physical};
  auto& [problem, limits, f, delta] = input.request;
  delta = point_friction(settings, "delta", "delta-m", given.physical);
  if (f) {
    require_valid(Oscillator{problem.p, *f, delta.value_or(0)});
  }
  if (delta && !f) {
    throw InputError::missing("f", "delta alone is no point of the region, give --f as well");
  }
  return input;
}

SimulateInput simulate_input(const Settings& settings) {
  const MotionInput motion = motion_input(settings, starts_from_rest(settings));
  SimulateInput input;
  SimulationRequest& request = input.request;
  input.physical = motion.physical;
  request.start = {motion.x0, motion.v0};
  request.oscillator.p = motion.p;
  request.oscillator.f = settings.required("f", "give --f, the constant friction (0 for none)");
  const auto delta = point_friction(settings, "delta", "delta-m", motion.physical);
  if (!delta) {
    throw InputError::missing("delta", "give --delta, the point friction (0 for none)");
  }
  request.oscillator.delta = *delta;
  request.half_cycle_limit = half_cycle_limit(settings);
  request.max_half_cycles = count(settings, "max-half-cycles", request.max_half_cycles, 0, 100'000);
  input.trajectory = settings.text("trajectory");
  const std::int64_t samples = count(settings, "samples", 1000, 2, 1'000'000);
  if (input.trajectory) {
    request.samples = samples;
  } else if (settings.has("samples")) {
    throw UsageError("samples is for a trajectory: give --trajectory FILE as well");
  }
  request.t_end = settings.number("t-end");
  require_valid(request.oscillator, request.start);
  const records::RecordClock clock =
      input.physical ? records::RecordClock{"s", input.physical->scales.time_s, motion.p}
                     : records::RecordClock{"tau", 1, motion.p};
  if (auto excitation = excitation_input(
          settings, clock,
          settings.number("gravity").value_or(design::Scales().gravity_m_per_s2))) {
    request.excitation = std::move(excitation->excitation);
    input.record = std::move(excitation->record);
  }
  const bool forced = is_forced(request);
  if (request.t_end && !input.trajectory && !forced) {
    throw UsageError(
        "t-end is for a trajectory or an excitation: give --trajectory FILE or --excitation as "
        "well");
  }
  if (request.t_end) {
    require_within("t-end", *request.t_end,
                   forced ? smallest_speed : std::numeric_limits<double>::min(),
                   forced ? largest_speed : unlimited);
  }
  if (forced) {
    if (!request.t_end && !duration(request.excitation)) {
      throw InputError::missing("t-end", "give --t-end, the excitation never ends");
    }
    require_valid(request.oscillator, request.start, request.excitation, request.t_end);
  }
  return input;
}

}  // namespace stillpoint::cli
