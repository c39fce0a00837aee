// SPDX-License-Identifier: MIT
// The requests of design and region, which share their task.

#include "input/excitation.hpp"
#include "input/request.hpp"

namespace stillpoint::cli {

namespace {

struct Task {
  design::Problem problem;
  design::Limits limits;
  std::optional<design::PhysicalInput> physical;
  std::optional<design::Pulse> pulse{};
  design::PulseRanges ranges{};
};

/// The stroke beta. Says in `motion` what it is in metres.
double stroke(const Settings& settings, MotionInput& motion) {
  if (!motion.physical) {
    return settings.required("beta", "give --beta, or --max-displacement in m");
  }
  const double displacement =
      settings.required("max-displacement", "give --max-displacement in m, the largest admissible");
  records::require_physical("max-displacement", Dimension::length, displacement);
  motion.physical->max_displacement_m = displacement;
  return displacement / motion.physical->scales.length_m;
}

/// With a pulse, without a velocity.
Task read_task(const Settings& settings, Command command) {
  const bool pulse = settings.has("pulse");
  MotionInput motion = motion_input(settings, command, pulse);
  const double beta = stroke(settings, motion);
  if (motion.physical && !pulse) {
    records::require_physical("velocity", Dimension::velocity, motion.physical->velocity_m_per_s);
  }
  Task task{
      {motion.v0, motion.p, beta, criterion(settings), settings.integer("arrivals").value_or(1)},
      {.tolerance = tolerance_of_hit(settings)},
      motion.physical};
  for (const design::LimitKind& kind : design::limit_kinds()) {
    const std::string name = records::hyphened(kind.field);
    task.limits.*kind.value = kind.in_metres.empty()
                                  ? settings.number(name)
                                  : point_friction(settings, name, motion.physical);
  }
  task.problem.v0_low = motion.v0_low;
  task.problem.p_high = motion.p_high;
  task.problem.residual = point_friction(settings, "residual", motion.physical);
  shape_box(settings, task.limits);
  task.pulse = pulse_input(settings, task.physical);
  task.ranges = pulse_ranges(settings, task.pulse);
  return task;
}

/// The parts of --catalogue, in the units of the task; empty without it.
std::optional<answers::PartsOfFile> catalogue(const Settings& settings, const Task& task) {
  if (!settings.has("catalogue")) {
    return std::nullopt;
  }
  return answers::PartsOfFile{
      *settings.text("catalogue"),
      catalogue_input(settings, units_of_parts(task.problem.p, task.physical))};
}

/// A notch that is not the paper's.
std::optional<design::NotchShape> notch_shape(const Settings& settings, const Task& task) {
  const Oscillator oscillator = mass_input(settings, task.problem.p);
  const design::NotchShape shape{notch_width(settings, task.physical), oscillator.hold};
  require_valid(oscillator);
  require_valid(oscillator, Surface{shape.width, {}});
  return shape.width || shape.hold ? std::optional(shape) : std::nullopt;
}

}  // namespace

std::optional<design::Spread> spread(const Settings& settings, const char* name) {
  if (const auto range = settings.range(name)) {
    return design::spread_of_factors(name, range->low, range->high);
  }
  const auto value = settings.number(name);
  return value ? std::optional(design::spread_of_tolerance(name, *value)) : std::nullopt;
}

double tolerance_of_hit(const Settings& settings) {
  return settings.range("tolerance") ? 0 : settings.number("tolerance").value_or(0);
}

void shape_box(const Settings& settings, design::Limits& limits) {
  const auto both = settings.range("tolerance") ? spread(settings, "tolerance") : std::nullopt;
  const auto of = [&](const char* name) {
    const auto own = spread(settings, name);
    return own ? own : both;
  };
  shape_box(limits, of("tolerance-f"), of("tolerance-delta"));
}

design::Criterion criterion(const Settings& settings) {
  return settings.named<design::Criterion>("criterion").value_or(design::Problem().criterion);
}

design::Objective objective(const Settings& settings) {
  const bool of_records =
      parse<design::SuiteObjective>(settings.text("objective").value_or("")).has_value();
  return objective_of(settings, design::SearchOptions().objective,
                      of_records ? " without records" : "");
}

answers::DesignTask design_input(const Settings& asked) {
  const Settings settings = asked.over_weight();
  require_options_for(settings, DesignFor::hit);
  const Task given = read_task(settings, Command::design);
  answers::DesignTask task{{given.problem,
                            given.limits,
                            {objective(settings), settings.text("algorithm")},
                            given.pulse,
                            given.ranges},
                           given.physical};
  task.notch = notch_shape(settings, given);
  task.catalogue = catalogue(settings, given);
  task.trade_offs = settings.integer("trade-off");
  return task;
}

answers::RegionTask region_input(const Settings& asked) {
  const Settings settings = asked.over_weight();
  require_options_for(settings, DesignFor::hit);
  if (const Option* const notch = settings.given(Rivals::notch)) {
    throw UsageError(fmt::format(
        "{} needs records or cases, a pulse with a residual, or damping: otherwise region is for "
        "an ideal notch, without a width, that holds any load; design checks a real one",
        notch->name));
  }
  const Task given = read_task(settings, Command::region);
  return {{given.problem, given.limits, settings.number("f"),
           point_friction(settings, "delta", given.physical), given.pulse, given.ranges},
          given.physical,
          catalogue(settings, given)};
}

sweep::CatalogueUnits units_of_parts(double p,
                                     const std::optional<design::PhysicalInput>& physical) {
  sweep::CatalogueUnits units;
  units.p = p;
  if (physical) {
    units.length_m = physical->scales.length_m;
  }
  return units;
}

std::vector<design::Part> catalogue_input(const Settings& settings, sweep::CatalogueUnits units) {
  const Option& in_metres = *find_option("delta-m");
  units.parse_metres = [&in_metres](std::string_view text) { return parse_value(in_metres, text); };
  return sweep::read_catalogue(*settings.text("catalogue"), units);
}

}  // namespace stillpoint::cli
