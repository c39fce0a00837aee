// SPDX-License-Identifier: MIT
#pragma once

#include "request.hpp"

#include <optional>
#include <string>

namespace stillpoint::cli {

/// What figures multiply dimensionless numbers with, and the labels of their axes: metres and
/// seconds where those were given.
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

  explicit FigureUnits(const std::optional<design::PhysicalInput>& physical) {
    if (!physical) {
      return;
    }
    const design::Scales& scales = physical->scales;
    const bool large = scales.length_m > 10;
    length = scales.length_m * (large ? 1 : 1e3);
    time = scales.time_s;
    velocity = scales.velocity_m_per_s;
    energy = scales.velocity_m_per_s * scales.velocity_m_per_s * scales.mass_kg.value_or(1);
    const std::string unit = large ? "m" : "mm";
    delta_label += ", " + unit;
    x_label += ", " + unit;
    time_label = "time, s";
    velocity_label = "velocity, m/s";
    energy_label += scales.mass_kg ? ", J" : ", J/kg";
  }
};

}  // namespace stillpoint::cli
