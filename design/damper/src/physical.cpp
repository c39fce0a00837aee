// SPDX-License-Identifier: MIT
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/design/physical.hpp>

#include <cmath>
#include <numbers>

namespace stillpoint::design {

namespace {

/// Metres, seconds, kilograms and newtons of anything that is built, with room to spare.
constexpr double smallest = 1e-30;
constexpr double largest = 1e30;

double angular_frequency(const PhysicalIsolator& isolator) {
  if (isolator.mass_kg) {
    require_within("mass", *isolator.mass_kg, smallest, largest);
  }
  if (isolator.period_s && isolator.stiffness_n_per_m) {
    throw InputError("stiffness", *isolator.stiffness_n_per_m,
                     "give either period or stiffness, not both");
  }
  if (isolator.period_s) {
    require_within("period", *isolator.period_s, smallest, largest);
    return 2 * std::numbers::pi / *isolator.period_s;
  }
  if (!isolator.stiffness_n_per_m) {
    throw InputError::missing("period", "give period, or stiffness with mass");
  }
  require_within("stiffness", *isolator.stiffness_n_per_m, smallest, largest);
  if (!isolator.mass_kg) {
    throw InputError::missing("mass", "stiffness needs a mass as well");
  }
  return std::sqrt(*isolator.stiffness_n_per_m / *isolator.mass_kg);
}

}  // namespace

Scales physical_scales(const PhysicalIsolator& isolator, double reference_velocity) {
  require_within("velocity", reference_velocity, smallest, largest);
  require_within("gravity", isolator.gravity_m_per_s2, smallest, largest);
  Scales scales;
  scales.gravity_m_per_s2 = isolator.gravity_m_per_s2;
  scales.omega_rad_per_s = angular_frequency(isolator);
  scales.length_m = reference_velocity / scales.omega_rad_per_s;
  scales.time_s = std::sqrt(scales.length_m / scales.gravity_m_per_s2);
  scales.velocity_m_per_s = std::sqrt(scales.length_m * scales.gravity_m_per_s2);
  scales.p = scales.omega_rad_per_s * scales.time_s;
  scales.mass_kg = isolator.mass_kg;
  return scales;
}

std::optional<double> Scales::friction_force_n(double f) const {
  return mass_kg ? std::optional(*mass_kg * f * gravity_m_per_s2) : std::nullopt;
}

std::optional<double> Scales::energy_per_passage_j(double delta) const {
  return mass_kg ? std::optional(*mass_kg * gravity_m_per_s2 * delta_m(delta)) : std::nullopt;
}

std::optional<double> Scales::stiffness_n_per_m() const {
  return mass_kg ? std::optional(*mass_kg * omega_rad_per_s * omega_rad_per_s) : std::nullopt;
}

}  // namespace stillpoint::design
