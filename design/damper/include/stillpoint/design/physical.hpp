// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/interval.hpp>
#include <stillpoint/design/region.hpp>
#include <stillpoint/records/units.hpp>

#include <optional>
#include <string_view>

namespace stillpoint::design {

using records::largest_physical;
using records::smallest_physical;

/// The scales between metres, seconds and the paper's dimensionless numbers, its (5):
///   length H, time sqrt(H/g), velocity sqrt(g H), omega^2 = g p^2 / H.
/// Any H > 0 works; with a velocity the program uses H = velocity / omega, the amplitude without
/// friction.
struct Scales {
  double length_m{1};
  double time_s{1};
  double velocity_m_per_s{1};
  double gravity_m_per_s2{records::standard_gravity_m_per_s2};
  double omega_rad_per_s{1};
  double p{1};                    ///< omega sqrt(H/g)
  std::optional<double> mass_kg;  ///< needed for forces and energies only

  /// In SI units, by the table of dimensions: empty for what needs a mass that is not known; the
  /// value itself if no scale changes it.
  [[nodiscard]] std::optional<double> in_si(Dimension dimension, double value) const;
  [[nodiscard]] double delta_m(double delta) const { return delta * length_m; }
  /// The p of a spring with this period.
  [[nodiscard]] double p_of(double period_s) const;
  /// m f g, the constant friction force.
  [[nodiscard]] std::optional<double> friction_force_n(double f) const;
  /// m g delta_m, the energy lost at each passage through x = 0.
  [[nodiscard]] std::optional<double> energy_per_passage_j(double delta) const;
  /// m times the speed that the mass loses.
  [[nodiscard]] std::optional<double> impulse_n_s(double speed) const;
  /// m omega^2, the spring.
  [[nodiscard]] std::optional<double> stiffness_n_per_m() const;
};

/// What an engineer knows about an isolator. Exactly one of period_s, natural_frequency_hz and
/// stiffness_n_per_m; the last needs mass_kg. All positive.
struct PhysicalIsolator {
  std::optional<double> period_s;
  std::optional<double> natural_frequency_hz;
  std::optional<double> stiffness_n_per_m;
  std::optional<double> mass_kg;
  double gravity_m_per_s2{records::standard_gravity_m_per_s2};
  bool inches{false};  ///< and pounds: what the task was given in
};

/// Scales with H = reference_velocity / omega. Throws InputError, naming the field, for a value
/// that is not positive and finite, and for too few or too many values.
[[nodiscard]] Scales physical_scales(const PhysicalIsolator& isolator, double reference_velocity);

/// The scales, and what was given in metres and seconds: for a report in both.
struct PhysicalInput {
  Scales scales;
  double velocity_m_per_s{0};
  double period_s{0};
  bool by_stiffness{false};  ///< not by the period
  bool by_frequency{false};  ///< the same
  bool inches{false};        ///< and pounds, in which its report is read
  std::optional<double> max_displacement_m{};
};

/// The isolator with an initial velocity and displacement, either of which may be 0. Throws
/// InputError as physical_scales does.
[[nodiscard]] PhysicalInput physical_input(const PhysicalIsolator& isolator,
                                           double velocity_m_per_s, double x0_m);

/// The largest p of a range of the period, natural frequency or stiffness, whichever `physical` is
/// given by; the end with the smallest is in there. Throws InputError.
[[nodiscard]] double largest_p(const PhysicalInput& physical, const Interval& range);

/// Intervals of velocity and period, the ends moved inwards by the rounding of the conversion.
struct PhysicalWorksFor {
  ServedInterval velocity_m_per_s;
  ServedInterval period_s;  ///< the longest always exists; `low` is 0 if no p is too large
};
[[nodiscard]] PhysicalWorksFor physical_works_for(const Scales& scales, const WorksFor& served);

/// The physical value of a mended input, by the name under which it was given; H, only a unit of
/// length, stays.
struct PhysicalMend {
  std::string_view name;
  std::string_view unit;
  double value{0};
  bool upwards{false};
};

/// Empty for an input without a unit: f_max, the tolerance and k. lambda is the duration of its
/// pulse, if that is given.
[[nodiscard]] std::optional<PhysicalMend> physical_mend(const PhysicalInput& physical,
                                                        const Mend& mend,
                                                        const std::optional<Pulse>& pulse = {});

}  // namespace stillpoint::design
