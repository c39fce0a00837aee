// SPDX-License-Identifier: MIT
#include <stillpoint/design/physical_input.hpp>

#include <cmath>
#include <numbers>

namespace stillpoint::design {

namespace {

/// H = velocity / omega. Where there is no velocity, the initial displacement; and without that
/// g / omega^2, which makes p = 1.
double reference_velocity(const PhysicalIsolator& isolator, double velocity, double x0_m) {
  if (velocity != 0) {
    return std::abs(velocity);
  }
  const double omega = physical_scales(isolator, 1).omega_rad_per_s;
  return x0_m != 0 ? std::abs(x0_m) * omega : isolator.gravity_m_per_s2 / omega;
}

}  // namespace

PhysicalInput physical_input(const PhysicalIsolator& isolator, double velocity_m_per_s,
                             double x0_m) {
  PhysicalInput physical;
  physical.scales = physical_scales(isolator, reference_velocity(isolator, velocity_m_per_s, x0_m));
  physical.velocity_m_per_s = velocity_m_per_s;
  physical.period_s = 2 * std::numbers::pi / physical.scales.omega_rad_per_s;
  physical.by_stiffness = isolator.stiffness_n_per_m.has_value();
  return physical;
}

std::optional<PhysicalMend> physical_mend(const PhysicalInput& physical, const Mend& mend) {
  const Scales& scales = physical.scales;
  // The conversion rounds a few times; so much to the safe side keeps the mended input feasible.
  constexpr double safety = 1e-14;
  const auto outward = [&](double value, bool upwards) {
    return value * (upwards ? 1 + safety : 1 - safety);
  };
  const bool up = mend.upwards;
  if (mend.field == "v0") {
    return PhysicalMend{"velocity", "m/s", outward(mend.value * scales.velocity_m_per_s, up), up};
  }
  if (mend.field == "p" && physical.by_stiffness && scales.mass_kg) {
    const double omega = mend.value / scales.time_s;
    return PhysicalMend{"stiffness", "N/m", outward(*scales.mass_kg * omega * omega, up), up};
  }
  if (mend.field == "p") {
    const double period = 2 * std::numbers::pi * scales.time_s / mend.value;
    return PhysicalMend{"period", "s", outward(period, !up), !up};
  }
  if (mend.field == "beta") {
    return PhysicalMend{"max_displacement", "m", outward(mend.value * scales.length_m, up), up};
  }
  if (mend.field == "delta_max") {
    return PhysicalMend{"delta_max", "m", outward(scales.delta_m(mend.value), up), up};
  }
  return std::nullopt;
}

}  // namespace stillpoint::design
