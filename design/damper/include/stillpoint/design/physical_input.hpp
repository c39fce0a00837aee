// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/physical.hpp>
#include <stillpoint/design/region.hpp>

#include <optional>
#include <string_view>

namespace stillpoint::design {

/// The scales, and what was given in metres and seconds: for a report in both.
struct PhysicalInput {
  Scales scales;
  double velocity_m_per_s{0};
  double period_s{0};
  bool by_stiffness{false};  ///< not by the period
  std::optional<double> max_displacement_m{};
};

/// The isolator with an initial velocity and displacement, either of which may be 0. Throws
/// InputError as physical_scales does.
[[nodiscard]] PhysicalInput physical_input(const PhysicalIsolator& isolator,
                                           double velocity_m_per_s, double x0_m);

/// The physical value of a mended input, by the name under which it was given; H, a mere unit of
/// length, stays.
struct PhysicalMend {
  std::string_view name;
  std::string_view unit;
  double value{0};
  bool upwards{false};
};

/// Empty for an input without a unit: f_max and the tolerance, and of a pulse k and lambda.
[[nodiscard]] std::optional<PhysicalMend> physical_mend(const PhysicalInput& physical,
                                                        const Mend& mend);

}  // namespace stillpoint::design
