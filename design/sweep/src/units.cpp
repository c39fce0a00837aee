// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/units.hpp>

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace stillpoint::sweep {

namespace {

using records::Dimension;

/// The names of quantities in metres and seconds; quantities not listed have no unit.
struct PhysicalForm {
  Quantity quantity;
  std::string_view name;
  Dimension dimension;
};

constexpr std::array physical_forms{
    PhysicalForm{Quantity::v0, "velocity", Dimension::velocity},
    PhysicalForm{Quantity::v0_low, "velocity_low", Dimension::velocity},
    PhysicalForm{Quantity::x0, "x0_m", Dimension::length},
    PhysicalForm{Quantity::beta, "max_displacement", Dimension::length},
    PhysicalForm{Quantity::residual, "residual_m", Dimension::length},
    PhysicalForm{Quantity::delta, "delta_m", Dimension::length},
    PhysicalForm{Quantity::notch_width, "notch_width_m", Dimension::length},
    PhysicalForm{Quantity::peak_amplitude, "peak_m", Dimension::length},
    PhysicalForm{Quantity::stop_position, "stop_position_m", Dimension::length},
    PhysicalForm{Quantity::stop_time, "stop_time_s", Dimension::time},
    PhysicalForm{Quantity::end_time, "end_time_s", Dimension::time},
    PhysicalForm{Quantity::final_position, "final_position_m", Dimension::length},
    PhysicalForm{Quantity::final_velocity, "final_velocity_m_per_s", Dimension::velocity},
    PhysicalForm{Quantity::stick_time, "stick_time_s", Dimension::time},
    PhysicalForm{Quantity::locked_from, "locked_from_s", Dimension::time},
};

/// Of p or p_high.
PhysicalForm restoring_form(Quantity quantity, Restoring restoring) {
  const bool range = quantity == Quantity::p_high;
  switch (restoring) {
    case Restoring::period:
      return {quantity, range ? "period_low" : "period", Dimension::time};
    case Restoring::natural_frequency:
      return {quantity, range ? "natural_frequency_high" : "natural_frequency",
              Dimension::frequency};
    case Restoring::stiffness:
      return {quantity, range ? "stiffness_high" : "stiffness", Dimension::stiffness};
  }
  assert(false && "a Restoring outside its enumeration");
  return {};
}

/// Of lambda or lambda_high.
PhysicalForm pulse_form(Quantity quantity, PulseClock clock) {
  const bool range = quantity == Quantity::lambda_high;
  return clock == PulseClock::duration
             ? PhysicalForm{quantity, range ? "pulse_duration_low" : "pulse_duration",
                            Dimension::time}
             : PhysicalForm{quantity, range ? "excitation_frequency_high" : "excitation_frequency",
                            Dimension::frequency};
}

/// Dimensionless if there are no units.
PhysicalForm form_of(Quantity quantity, const std::optional<SweepUnits>& units) {
  if (units && (quantity == Quantity::p || quantity == Quantity::p_high)) {
    return restoring_form(quantity, units->restoring);
  }
  if (units && (quantity == Quantity::lambda || quantity == Quantity::lambda_high)) {
    return pulse_form(quantity, units->pulse_clock);
  }
  const auto* const found = std::ranges::find(physical_forms, quantity, &PhysicalForm::quantity);
  return units && found != physical_forms.end()
             ? *found
             : PhysicalForm{quantity, name(quantity), Dimension::none};
}

double omega(Restoring restoring, double value, double mass_kg) {
  switch (restoring) {
    case Restoring::period:
      return 2 * std::numbers::pi / value;
    case Restoring::natural_frequency:
      return 2 * std::numbers::pi * value;
    case Restoring::stiffness:
      return std::sqrt(value / mass_kg);
  }
  assert(false && "a Restoring outside its enumeration");
  return 0;
}

}  // namespace

double SweepUnits::time_s() const {
  return std::sqrt(1 / gravity_m_per_s2);
}

design::PhysicalInput SweepUnits::physical() const {
  design::PhysicalInput physical;
  physical.scales.time_s = time_s();
  physical.scales.gravity_m_per_s2 = gravity_m_per_s2;
  return physical;
}

double SweepUnits::velocity_m_per_s() const {
  return std::sqrt(gravity_m_per_s2);
}

double SweepUnits::plain(Quantity input, double value) const {
  switch (input) {
    case Quantity::v0:
    case Quantity::v0_low:
      return value / velocity_m_per_s();
    case Quantity::p:
    case Quantity::p_high:
      return omega(restoring, value, mass_kg) * time_s();
    case Quantity::lambda:
    case Quantity::lambda_high:
      return pulse_clock == PulseClock::duration ? pulse_angle * time_s() / value
                                                 : 2 * std::numbers::pi * value * time_s();
    default:
      return value;  // a length, or without a unit
  }
}

double SweepUnits::unit(Quantity result) const {
  switch (form_of(result, *this).dimension) {
    case Dimension::time:
      return time_s();
    case Dimension::velocity:
      return velocity_m_per_s();
    default:
      return 1;  // a length, or without a unit
  }
}

std::string_view name(Quantity quantity, const std::optional<SweepUnits>& units) {
  return form_of(quantity, units).name;
}

records::Dimension dimension(Quantity quantity, const std::optional<SweepUnits>& units) {
  return form_of(quantity, units).dimension;
}

std::optional<Quantity> find_named(std::span<const Quantity> quantities, std::string_view written,
                                   const std::optional<SweepUnits>& units) {
  const auto found = std::ranges::find(quantities, records::underscored(written),
                                       [&](Quantity quantity) { return name(quantity, units); });
  return found == quantities.end() ? std::nullopt : std::optional(*found);
}

std::string names(std::span<const Quantity> quantities, const std::optional<SweepUnits>& units) {
  std::string names;
  for (const Quantity quantity : quantities) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", name(quantity, units));
  }
  return names;
}

std::string option_name(Quantity quantity, const std::optional<SweepUnits>& units) {
  return records::hyphened(name(quantity, units));
}

}  // namespace stillpoint::sweep
