// SPDX-License-Identifier: MIT
#include "input/motion.hpp"

#include <stillpoint/core/oscillator.hpp>

#include <cmath>
#include <limits>

namespace stillpoint::cli {

namespace {

/// The first option in these units that is set; null if there is none.
const Option* first_in(Units units, const Settings& settings) {
  const bool records = asks_for_records(settings);
  return settings.first([&](const Option& option) {
    return option.traits.units == units ||
           (option.traits.units == Units::physical_without_records && units == Units::physical &&
            !records);
  });
}

/// Without a load.
std::string missing_load(Command command, std::string_view hit) {
  return fmt::format("give {}{}", hit,
                     command == Command::design || command == Command::region
                         ? "; other loads are --pulse and --record"
                         : "");
}

MotionInput physical_motion(const Settings& settings, Command command, bool from_rest) {
  design::PhysicalIsolator isolator;
  isolator.period_s = settings.number("period");
  isolator.natural_frequency_hz = settings.number("natural-frequency");
  isolator.stiffness_n_per_m = settings.number("stiffness");
  isolator.mass_kg = settings.number("mass");
  isolator.gravity_m_per_s2 = settings.number("gravity").value_or(isolator.gravity_m_per_s2);
  isolator.inches = settings.in_inches();
  const double x0_m = settings.number("x0-m").value_or(0);
  const double velocity =
      x0_m != 0 || from_rest
          ? settings.number("velocity").value_or(0)
          : settings.required("velocity",
                              missing_load(command, "--velocity, the initial velocity in m/s"));
  const design::PhysicalInput physical = design::physical_input(isolator, velocity, x0_m);
  const design::Scales& scales = physical.scales;
  MotionInput motion;
  motion.v0 = velocity / scales.velocity_m_per_s;
  motion.p = scales.p;
  motion.x0 = x0_m / scales.length_m;
  motion.physical = physical;
  if (const auto range = settings.range("velocity")) {
    motion.v0_low = range->low == range->high ? motion.v0 : range->low / scales.velocity_m_per_s;
  }
  const Option* const spring = settings.given(Rivals::stiffness);
  if (const auto range = spring != nullptr ? settings.range(spring->name) : std::nullopt) {
    motion.p_high = design::largest_p(physical, *range);
  }
  return motion;
}

}  // namespace

const Option* with_unit(const Settings& settings, std::string_view plain) {
  const Option* const given = settings.given(find_option(plain)->traits.rivals);
  return given != nullptr && given->traits.dimension != Dimension::none ? given : nullptr;
}

bool is_physical(const Settings& settings, Command command) {
  require_together(settings, command);
  const Option* const plain = first_in(Units::dimensionless, settings);
  const Option* const physical = first_in(Units::physical, settings);
  if (plain != nullptr && physical != nullptr) {
    const std::string in_metres = fmt::format("{}-m", plain->name);
    throw UsageError(fmt::format(
        "{} and {} cannot be combined: give {}", plain->name, physical->name,
        find_option(in_metres) != nullptr
            ? fmt::format("{}, or everything dimensionless", in_metres)
            : std::string("everything in metres and seconds, or everything dimensionless")));
  }
  return physical != nullptr;
}

MotionInput motion_input(const Settings& settings, Command command, bool from_rest) {
  if (is_physical(settings, command)) {
    return physical_motion(settings, command, from_rest);
  }
  MotionInput motion;
  motion.x0 = settings.number("x0").value_or(0);
  motion.v0 = motion.x0 != 0 || from_rest
                  ? settings.number("v0").value_or(0)
                  : settings.required("v0", missing_load(command, "--v0, or --velocity in m/s"));
  motion.p = settings.required("p", "give --p, or --period in s");
  if (const auto range = settings.range("v0")) {
    motion.v0_low = range->low;
  }
  if (const auto range = settings.range("p")) {
    motion.p_high = range->high;
  }
  return motion;
}

Oscillator mass_input(const Settings& settings, double p) {
  const double zeta = settings.number("damping").value_or(0);
  if (zeta >= 1) {
    throw InputError("damping", zeta,
                     fmt::format("must be a number from 0 to {}, as a share of critical damping: "
                                 "5 % is 5% or 0.05",
                                 largest_zeta));
  }
  return {.p = p,
          .hold = settings.number("hold"),
          .zeta = zeta,
          .breakaway = settings.number("breakaway").value_or(1)};
}

Oscillator oscillator_input(const Settings& settings, const MotionInput& motion) {
  const double f = settings.required("f", "give --f, the constant friction (0 for none)");
  const auto delta = point_friction(settings, "delta", motion.physical);
  if (!delta) {
    throw motion.physical
        ? InputError::missing("delta-m", "give --delta-m, the point friction in m (0 for none)")
        : InputError::missing("delta", "give --delta, the point friction (0 for none)");
  }
  Oscillator oscillator = mass_input(settings, motion.p);
  oscillator.f = f;
  oscillator.delta = *delta;
  return oscillator;
}

std::optional<double> in_either(const Settings& settings, std::string_view plain, double unit,
                                double least) {
  const Option* const physical = with_unit(settings, plain);
  if (physical == nullptr) {
    return settings.number(plain);
  }
  const double value = *settings.number(physical->name);
  records::require_physical(physical->name, physical->traits.dimension, value, least);
  return value / unit;
}

std::optional<double> point_friction(const Settings& settings, std::string_view plain,
                                     const Physical& physical) {
  const Option* const metres = with_unit(settings, plain);
  if (metres == nullptr) {
    return settings.number(plain);
  }
  const double value = *settings.number(metres->name);
  const double unit = physical->scales.length_m;
  const double most = std::min(largest_square * unit, std::numeric_limits<double>::max());
  if (!(value >= 0 && value <= most)) {
    throw InputError(std::string(metres->name), value,
                     fmt::format("must be a number from 0 to {:.3g}", most));
  }
  return value / unit;
}

}  // namespace stillpoint::cli
