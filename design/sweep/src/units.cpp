// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/units.hpp>

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace stillpoint::sweep {

namespace {

using records::Dimension;

/// What a quantity is called, and its dimension.
struct Label {
  std::string_view name;
  Dimension dimension;
};

/// Of p or p_high.
Label restoring_label(bool high, Restoring restoring) {
  switch (restoring) {
    case Restoring::period:
      return {high ? "period_low" : "period", Dimension::time};
    case Restoring::natural_frequency:
      return {high ? "natural_frequency_high" : "natural_frequency", Dimension::frequency};
    case Restoring::stiffness:
      return {high ? "stiffness_high" : "stiffness", Dimension::stiffness};
  }
  assert(false && "a Restoring outside its enumeration");
  return {};
}

/// Of lambda or lambda_high.
Label pulse_label(bool high, design::WaveClock clock) {
  return clock == design::WaveClock::duration
             ? Label{high ? "pulse_duration_low" : "pulse_duration", Dimension::time}
             : Label{high ? "excitation_frequency_high" : "excitation_frequency",
                     Dimension::frequency};
}

/// Dimensionless if there are no units.
Label label_of(Quantity quantity, const std::optional<SweepUnits>& units) {
  const QuantityForm& form = quantity_forms[index(quantity)];
  if (!units) {
    return {form.name, Dimension::none};
  }
  switch (quantity) {
    case Quantity::p:
    case Quantity::p_high:
      return restoring_label(quantity == Quantity::p_high, units->restoring);
    case Quantity::lambda:
    case Quantity::lambda_high:
      return pulse_label(quantity == Quantity::lambda_high, units->pulse_clock);
    default:
      return {form.physical.empty() ? form.name : form.physical, form.dimension};
  }
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
      return design::lambda_of(pulse_clock, value, pulse_angle, time_s());
    default:
      return value;  // a length, or without a unit
  }
}

double SweepUnits::unit(Quantity result) const {
  switch (label_of(result, *this).dimension) {
    case Dimension::time:
      return time_s();
    case Dimension::velocity:
      return velocity_m_per_s();
    default:
      return 1;  // a length, or without a unit
  }
}

std::string_view name(Quantity quantity, const std::optional<SweepUnits>& units) {
  return label_of(quantity, units).name;
}

records::Dimension dimension(Quantity quantity, const std::optional<SweepUnits>& units) {
  return label_of(quantity, units).dimension;
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
