// SPDX-License-Identifier: MIT
#include "request.hpp"

#include "choices.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/input_error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <string_view>

namespace stillpoint::cli {

namespace {

constexpr double unlimited = std::numeric_limits<double>::max();
/// As for the isolator's own figures: what these make dimensionless is then valid as well.
constexpr double smallest_physical = 1e-30;
constexpr double largest_physical = 1e30;
/// Of a limit of Delta, as problem.hpp has it.
constexpr double smallest_limit = 1e-300;

/// UsageError where more than one option of a set of rivals is given. Of the hits a command looks
/// only at those that it has: a scene's pulse is for design.
void require_no_rivals(const Settings& settings, Command command) {
  std::map<Rivals, std::string_view> given;
  for (const Option& option : options()) {
    if (option.traits.rivals == Rivals::none || !settings.has(option.name) ||
        (option.traits.rivals == Rivals::hit && !option.serves(command))) {
      continue;
    }
    const auto [first, alone] = given.emplace(option.traits.rivals, option.name);
    if (!alone) {
      throw UsageError(fmt::format("{} and {} exclude each other: give one of them", first->second,
                                   option.name));
    }
  }
}

/// The first option that is set of those in these units; null where there is none.
const Option* first_in(const Settings& settings, Units units) {
  for (const Option& option : options()) {
    // The gravity that turns a record's m/s2 into g says nothing of the motion.
    const bool of_a_record = option.name == "gravity" && settings.has("record");
    if (option.traits.units == units && settings.has(option.name) && !of_a_record) {
      return &option;
    }
  }
  return nullptr;
}

/// Whether physical options are set; UsageError where dimensionless ones are set as well.
bool is_physical(const Settings& settings) {
  const Option* const plain = first_in(settings, Units::dimensionless);
  const Option* const physical = first_in(settings, Units::physical);
  if (plain != nullptr && physical != nullptr) {
    throw UsageError(fmt::format(
        "{} and {} exclude each other: give all in metres and seconds or all dimensionless",
        plain->name, physical->name));
  }
  return physical != nullptr;
}

/// A motion needs a start, unless something shakes it out of rest.
bool starts_from_rest(const Settings& settings) {
  return excitation_type(settings) || settings.has("k");
}

double initial_velocity(const Settings& settings, std::string_view name, bool may_be_missing,
                        std::string_view hint) {
  return may_be_missing ? settings.number(name).value_or(0) : settings.required(name, hint);
}

/// H = velocity / omega. Where there is no velocity, the initial displacement; and without that
/// g / omega^2, which makes p = 1.
double reference_velocity(double velocity, double x0_m, const design::PhysicalIsolator& isolator) {
  if (velocity != 0) {
    return velocity;
  }
  const double omega = design::physical_scales(isolator, 1).omega_rad_per_s;
  return x0_m != 0 ? std::abs(x0_m) * omega : isolator.gravity_m_per_s2 / omega;
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
  PhysicalInput physical;
  physical.scales =
      design::physical_scales(isolator, reference_velocity(std::abs(velocity), x0_m, isolator));
  physical.velocity_m_per_s = velocity;
  physical.by_stiffness = isolator.stiffness_n_per_m.has_value();
  physical.period_s = 2 * std::numbers::pi / physical.scales.omega_rad_per_s;
  motion.v0 = velocity / physical.scales.velocity_m_per_s;
  motion.p = physical.scales.p;
  motion.x0 = x0_m / physical.scales.length_m;
  motion.physical = physical;
  return motion;
}

/// `from_rest`: the velocity may be missing, because something else sets the mass off.
MotionInput motion_input(const Settings& settings, Command command, bool from_rest) {
  require_no_rivals(settings, command);
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
                                     const std::optional<PhysicalInput>& physical,
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
  std::optional<PhysicalInput> physical;
};

/// What design and region have in common; with a pulse, without a velocity.
Task task(const Settings& settings, Command command, bool pulse) {
  MotionInput motion = motion_input(settings, command, pulse);
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
  return chosen(settings, "criterion", criteria);
}

design::Objective objective(const Settings& settings) {
  return chosen(settings, "objective", objectives);
}

std::optional<double> half_cycle_limit(const Settings& settings) {
  const std::optional<double> limit = settings.number("half-cycle-limit");
  if (limit) {
    require_within("half-cycle-limit", *limit, 1, 1e15);
  }
  return limit;
}

DesignInput design_input(const Settings& settings) {
  DesignInput input;
  input.pulse = pulse_input(settings);
  const Task given = task(settings, Command::design, input.pulse.has_value());
  input.request.problem = given.problem;
  input.request.limits = given.limits;
  input.request.search.objective = objective(settings);
  input.algorithm = settings.text("algorithm");
  input.request.search.algorithm = input.algorithm.value_or("");
  input.physical = given.physical;
  if (input.algorithm && input.algorithm->empty()) {
    throw InputError("algorithm", "\"\"", "must name an NLopt algorithm");
  }
  return input;
}

RegionInput region_input(const Settings& settings) {
  if (settings.has("pulse") && !settings.has("v0") && !settings.has("velocity")) {
    throw InputError::missing(
        "v0", "region needs a velocity, not a pulse: give --v0, or --velocity in m/s");
  }
  const Task given = task(settings, Command::region, false);
  RegionInput input{given.problem, given.limits, settings.number("f"), {}, given.physical};
  input.delta = point_friction(settings, "delta", "delta-m", given.physical);
  if (input.f) {
    require_valid(Oscillator{given.problem.p, *input.f, input.delta.value_or(0)});
  }
  if (input.delta && !input.f) {
    throw InputError::missing("f", "delta alone is no point of the region, give --f as well");
  }
  return input;
}

SimulateInput simulate_input(const Settings& settings) {
  const MotionInput motion = motion_input(settings, Command::simulate, starts_from_rest(settings));
  SimulateInput input;
  input.physical = motion.physical;
  input.start = {motion.x0, motion.v0};
  input.oscillator.p = motion.p;
  input.oscillator.f = settings.required("f", "give --f, the constant friction (0 for none)");
  const auto delta = point_friction(settings, "delta", "delta-m", motion.physical);
  if (!delta) {
    throw InputError::missing("delta", "give --delta, the point friction (0 for none)");
  }
  input.oscillator.delta = *delta;
  input.half_cycle_limit = half_cycle_limit(settings);
  input.max_half_cycles = count(settings, "max-half-cycles", input.max_half_cycles, 0, 100'000);
  input.trajectory = settings.text("trajectory");
  input.samples = count(settings, "samples", input.samples, 2, 1'000'000);
  input.t_end = settings.number("t-end");
  if (settings.has("samples") && !input.trajectory) {
    throw UsageError("samples is for a trajectory: give --trajectory FILE as well");
  }
  require_valid(input.oscillator, input.start);
  const records::RecordClock clock =
      input.physical ? records::RecordClock{"s", input.physical->scales.time_s, motion.p}
                     : records::RecordClock{"tau", 1, motion.p};
  input.excitation = excitation_input(
      settings, clock, settings.number("gravity").value_or(design::Scales().gravity_m_per_s2));
  if (input.t_end && !input.trajectory && !input.excitation) {
    throw UsageError(
        "t-end is for a trajectory or an excitation: give --trajectory FILE or --excitation as "
        "well");
  }
  if (input.t_end) {
    const bool forced = input.excitation.has_value();
    require_within("t-end", *input.t_end,
                   forced ? smallest_speed : std::numeric_limits<double>::min(),
                   forced ? largest_speed : unlimited);
  }
  if (input.excitation) {
    if (!input.t_end && std::isinf(duration(input.excitation->excitation))) {
      throw InputError::missing("t-end", "give --t-end, the excitation never ends");
    }
    require_valid(input.oscillator, input.start, input.excitation->excitation, input.t_end);
  }
  return input;
}

}  // namespace stillpoint::cli
