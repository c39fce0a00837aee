// SPDX-License-Identifier: MIT
#pragma once

// Metres and seconds beside dimensionless numbers, where the input was given in those.

#include <stillpoint/design/physical.hpp>

#include <optional>
#include <string>

namespace stillpoint::report {

using Physical = std::optional<design::PhysicalInput>;

/// " = 12.1 mm" behind a dimensionless length; "" without physical input and for 0.
[[nodiscard]] std::string in_metres(const Physical& physical, double length);

/// " = 1.53 s" behind a tau; "" without physical input.
[[nodiscard]] std::string in_seconds(const Physical& physical, double tau);

/// " = 62.8 rad/s" behind an angular frequency; "" without physical input.
[[nodiscard]] std::string in_rad_per_s(const Physical& physical, double lambda);

/// What figures multiply dimensionless numbers with, and the labels of their axes.
struct FigureUnits {
  double length{1};
  double time{1};
  double velocity{1};
  double energy{1};
  std::string delta_label{"point friction Δ"};
  std::string x_label{"displacement x"};
  std::string time_label{"time τ"};
  std::string velocity_label{"velocity x′"};
  std::string energy_label{"energy"};

  explicit FigureUnits(const Physical& physical);
};

}  // namespace stillpoint::report
