// SPDX-License-Identifier: MIT
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/design/limit_kinds.hpp>
#include <stillpoint/design/physical.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace stillpoint::design {

namespace {

using records::Dimension;
using records::require_physical;

/// A conversion rounds a few times; this much to the safe side keeps the converted input feasible.
constexpr double conversion_safety = 1e-14;

double omega_of(const PhysicalIsolator& isolator) {
  if (isolator.mass_kg) {
    require_physical("mass", Dimension::mass, *isolator.mass_kg);
  }
  if (isolator.natural_frequency_hz && (isolator.period_s || isolator.stiffness_n_per_m)) {
    throw InputError("natural-frequency", *isolator.natural_frequency_hz,
                     "give only one of period, natural frequency and stiffness");
  }
  if (isolator.period_s && isolator.stiffness_n_per_m) {
    throw InputError("stiffness", *isolator.stiffness_n_per_m,
                     "give only one of period and stiffness");
  }
  if (isolator.period_s) {
    require_physical("period", Dimension::time, *isolator.period_s);
    return 2 * std::numbers::pi / *isolator.period_s;
  }
  if (isolator.natural_frequency_hz) {
    require_physical("natural-frequency", Dimension::frequency, *isolator.natural_frequency_hz);
    return 2 * std::numbers::pi * *isolator.natural_frequency_hz;
  }
  if (!isolator.stiffness_n_per_m) {
    throw InputError::missing(
        "period", "give the period, the natural frequency, or the stiffness with the mass");
  }
  require_physical("stiffness", Dimension::stiffness, *isolator.stiffness_n_per_m);
  if (!isolator.mass_kg) {
    throw InputError::missing("mass", "stiffness needs a mass as well");
  }
  return std::sqrt(*isolator.stiffness_n_per_m / *isolator.mass_kg);
}

/// H = velocity / omega. Without a velocity, the initial displacement; without that, g / omega^2,
/// which makes p = 1.
double reference_velocity(const PhysicalIsolator& isolator, double velocity, double x0_m) {
  if (velocity != 0) {
    return std::abs(velocity);
  }
  const double omega = physical_scales(isolator, 1).omega_rad_per_s;
  return x0_m != 0 ? std::abs(x0_m) * omega : isolator.gravity_m_per_s2 / omega;
}

}  // namespace

Scales physical_scales(const PhysicalIsolator& isolator, double reference_velocity) {
  require_physical("velocity", Dimension::velocity, reference_velocity);
  require_physical("gravity", Dimension::acceleration, isolator.gravity_m_per_s2);
  Scales scales;
  scales.gravity_m_per_s2 = isolator.gravity_m_per_s2;
  scales.omega_rad_per_s = omega_of(isolator);
  scales.length_m = reference_velocity / scales.omega_rad_per_s;
  scales.time_s = std::sqrt(scales.length_m / scales.gravity_m_per_s2);
  scales.velocity_m_per_s = std::sqrt(scales.length_m * scales.gravity_m_per_s2);
  scales.p = scales.omega_rad_per_s * scales.time_s;
  scales.mass_kg = isolator.mass_kg;
  return scales;
}

std::optional<double> Scales::in_si(Dimension dimension, double value) const {
  switch (dimension) {
    case Dimension::length:
      return value * length_m;
    case Dimension::velocity:
      return value * velocity_m_per_s;
    case Dimension::time:
      return value * time_s;
    case Dimension::gravities:
      return value * gravity_m_per_s2;
    case Dimension::force:
      return friction_force_n(value);
    case Dimension::energy:
      return energy_per_passage_j(value);
    case Dimension::impulse:
      return impulse_n_s(value);
    default:
      return value;
  }
}

double Scales::p_of(double period_s) const {
  return 2 * std::numbers::pi * time_s / period_s;
}

std::optional<double> Scales::friction_force_n(double f) const {
  return mass_kg ? std::optional(*mass_kg * f * gravity_m_per_s2) : std::nullopt;
}

std::optional<double> Scales::energy_per_passage_j(double delta) const {
  return mass_kg ? std::optional(*mass_kg * gravity_m_per_s2 * delta_m(delta)) : std::nullopt;
}

std::optional<double> Scales::impulse_n_s(double speed) const {
  return mass_kg ? std::optional(*mass_kg * velocity_m_per_s * speed) : std::nullopt;
}

std::optional<double> Scales::stiffness_n_per_m() const {
  return mass_kg ? std::optional(*mass_kg * omega_rad_per_s * omega_rad_per_s) : std::nullopt;
}

PhysicalInput physical_input(const PhysicalIsolator& isolator, double velocity_m_per_s,
                             double x0_m) {
  const Scales scales =
      physical_scales(isolator, reference_velocity(isolator, velocity_m_per_s, x0_m));
  return {.scales = scales,
          .velocity_m_per_s = velocity_m_per_s,
          .period_s = 2 * std::numbers::pi / scales.omega_rad_per_s,
          .by_stiffness = isolator.stiffness_n_per_m.has_value(),
          .by_frequency = isolator.natural_frequency_hz.has_value(),
          .inches = isolator.inches};
}

double largest_p(const PhysicalInput& physical, const Interval& range) {
  const auto [name, dimension] =
      physical.by_stiffness   ? std::pair{"stiffness", Dimension::stiffness}
      : physical.by_frequency ? std::pair{"natural-frequency", Dimension::frequency}
                              : std::pair{"period", Dimension::time};
  require_physical(name, dimension, range.low);
  const double ratio = range.high / range.low;
  return physical.scales.p * (physical.by_stiffness ? std::sqrt(ratio) : ratio);
}

PhysicalWorksFor physical_works_for(const Scales& scales, const WorksFor& served) {
  const double velocity = scales.velocity_m_per_s;
  const double period = 2 * std::numbers::pi * scales.time_s;
  PhysicalWorksFor physical;
  physical.velocity_m_per_s = {served.hit.low * velocity * (1 + conversion_safety),
                               *served.hit.high * velocity * (1 - conversion_safety),
                               served.hit.ends_search};
  physical.period_s = {served.p.high ? period / *served.p.high * (1 + conversion_safety) : 0,
                       period / served.p.low * (1 - conversion_safety), served.p.ends_search};
  for (ServedInterval* const interval : {&physical.velocity_m_per_s, &physical.period_s}) {
    interval->low = std::min(interval->low, *interval->high);  // of a single value
  }
  return physical;
}

std::optional<PhysicalMend> physical_mend(const PhysicalInput& physical, const Mend& mend,
                                          const std::optional<Pulse>& pulse) {
  const Scales& scales = physical.scales;
  const auto mended = [](std::string_view name, std::string_view unit, double value, bool up) {
    return PhysicalMend{name, unit, value * (up ? 1 + conversion_safety : 1 - conversion_safety),
                        up};
  };
  const bool up = mend.upwards;
  // The ends of a range are those of the input itself; the softest spring has the longest period.
  const auto ends_of = [&](std::string_view whole) { return mend.field.starts_with(whole); };
  if (ends_of("v0")) {
    return mended("velocity", "m/s", mend.value * scales.velocity_m_per_s, up);
  }
  const bool spring = mend.field == "p" || ends_of("p_");
  if (spring && physical.by_stiffness && scales.mass_kg) {
    const double omega = mend.value / scales.time_s;
    return mended("stiffness", "N/m", *scales.mass_kg * omega * omega, up);
  }
  if (spring && physical.by_frequency) {
    return mended("natural_frequency", "Hz", mend.value / (2 * std::numbers::pi * scales.time_s),
                  up);
  }
  if (spring) {
    return mended("period", "s", 2 * std::numbers::pi * scales.time_s / mend.value, !up);
  }
  if (pulse && ends_of("lambda")) {
    const double angle = duration(excitation(*pulse)).value() * angular_frequency(*pulse);
    return mended("pulse_duration", "s", angle / mend.value * scales.time_s, !up);
  }
  if (mend.field == "jump_max") {
    return mended(mend.field, "m/s", mend.value * scales.velocity_m_per_s, up);
  }
  const auto kinds = limit_kinds();
  const auto limit = std::ranges::find(kinds, mend.field, &LimitKind::field);
  const std::string_view length = mend.field == "beta"       ? "max_displacement"
                                  : mend.field == "residual" ? "residual_m"
                                  : limit != kinds.end()     ? limit->in_metres
                                                             : "";
  return length.empty() ? std::nullopt
                        : std::optional(mended(length, "m", scales.delta_m(mend.value), up));
}

}  // namespace stillpoint::design
