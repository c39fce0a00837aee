// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

namespace stillpoint::design {

/// The scales between metres, seconds and the paper's dimensionless numbers, its (5):
///   length H, time sqrt(H/g), velocity sqrt(g H), omega^2 = g p^2 / H.
/// Any H > 0 works; with a velocity the program uses H = velocity / omega, the amplitude without
/// friction.
struct Scales {
  double length_m{1};
  double time_s{1};
  double velocity_m_per_s{1};
  double gravity_m_per_s2{9.80665};
  double omega_rad_per_s{1};
  double p{1};                    ///< omega sqrt(H/g)
  std::optional<double> mass_kg;  ///< needed for forces and energies only

  [[nodiscard]] double delta_m(double delta) const { return delta * length_m; }
  /// m f g, the constant friction force.
  [[nodiscard]] std::optional<double> friction_force_n(double f) const;
  /// m g delta_m, the energy lost at each passage through x = 0.
  [[nodiscard]] std::optional<double> energy_per_passage_j(double delta) const;
  /// m omega^2, the spring.
  [[nodiscard]] std::optional<double> stiffness_n_per_m() const;
};

/// What an engineer knows about an isolator. Exactly one of period_s and stiffness_n_per_m; the
/// latter needs mass_kg. All positive.
struct PhysicalIsolator {
  std::optional<double> period_s;
  std::optional<double> stiffness_n_per_m;
  std::optional<double> mass_kg;
  double gravity_m_per_s2{9.80665};
};

/// Scales with H = reference_velocity / omega. Throws InputError, naming the field, for a value
/// that is not positive and finite and for too few or too many of them.
[[nodiscard]] Scales physical_scales(const PhysicalIsolator& isolator, double reference_velocity);

}  // namespace stillpoint::design
