// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/units.hpp>

#include <cassert>
#include <cmath>
#include <numbers>

namespace stillpoint::sweep {

namespace {

std::string_view restoring_name(Restoring restoring) {
  switch (restoring) {
    case Restoring::period:
      return "period";
    case Restoring::natural_frequency:
      return "natural_frequency";
    case Restoring::stiffness:
      return "stiffness";
  }
  assert(false && "a Restoring outside its enumeration");
  return "";
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

double SweepUnits::velocity_m_per_s() const {
  return std::sqrt(gravity_m_per_s2);
}

double SweepUnits::plain(Quantity input, double value) const {
  switch (input) {
    case Quantity::v0:
      return value / velocity_m_per_s();
    case Quantity::p:
      return omega(restoring, value, mass_kg) * time_s();
    default:
      return value;  // a length, or without a unit
  }
}

double SweepUnits::unit(Quantity result) const {
  switch (result) {
    case Quantity::stop_time:
    case Quantity::end_time:
    case Quantity::stick_time:
      return time_s();
    case Quantity::final_velocity:
      return velocity_m_per_s();
    default:
      return 1;
  }
}

std::string_view name(Quantity quantity, const std::optional<SweepUnits>& units) {
  if (units) {
    switch (quantity) {
      case Quantity::v0:
        return "velocity";
      case Quantity::p:
        return restoring_name(units->restoring);
      case Quantity::x0:
        return "x0_m";
      case Quantity::beta:
        return "max_displacement";
      case Quantity::delta:
        return "delta_m";
      case Quantity::notch_width:
        return "notch_width_m";
      case Quantity::peak_amplitude:
        return "peak_m";
      case Quantity::stop_position:
        return "stop_position_m";
      case Quantity::stop_time:
        return "stop_time_s";
      case Quantity::end_time:
        return "end_time_s";
      case Quantity::final_position:
        return "final_position_m";
      case Quantity::final_velocity:
        return "final_velocity_m_per_s";
      case Quantity::stick_time:
        return "stick_time_s";
      default:
        break;  // has no unit
    }
  }
  return name(quantity);
}

}  // namespace stillpoint::sweep
