// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/physical.hpp>
#include <stillpoint/design/wave_clock.hpp>
#include <stillpoint/records/units.hpp>
#include <stillpoint/sweep/quantity.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace stillpoint::sweep {

/// The input that stands for p in metres and seconds.
enum class Restoring { period, natural_frequency, stiffness };

/// A sweep in metres, seconds and kilograms: what its quantities are then. The length unit is H =
/// 1 m for all entries, so every input is converted by itself, and lengths are already in metres.
struct SweepUnits {
  Restoring restoring{Restoring::period};
  double mass_kg{1};                ///< for a stiffness
  design::WaveClock pulse_clock{};  ///< for the lambda of a pulse
  double pulse_angle{0};            ///< lambda times the duration of the pulse
  double gravity_m_per_s2{records::standard_gravity_m_per_s2};

  [[nodiscard]] double time_s() const;                   ///< of one tau
  [[nodiscard]] double velocity_m_per_s() const;         ///< of one x'
  [[nodiscard]] design::PhysicalInput physical() const;  ///< the scales of an excitation
  /// An input made dimensionless.
  [[nodiscard]] double plain(Quantity input, double value) const;
  /// The factor that gives a dimensionless result its unit.
  [[nodiscard]] double unit(Quantity result) const;
};

/// The name of a column: "stop_time", and with units "stop_time_s".
[[nodiscard]] std::string_view name(Quantity quantity, const std::optional<SweepUnits>& units);

/// The same as an option and in messages: "stop-time-s".
[[nodiscard]] std::string option_name(Quantity quantity, const std::optional<SweepUnits>& units);

/// The quantity of that name among these; '-' and '_' are the same.
[[nodiscard]] std::optional<Quantity> find_named(std::span<const Quantity> quantities,
                                                 std::string_view written,
                                                 const std::optional<SweepUnits>& units);

/// Their names: "f, delta, stop_time".
[[nodiscard]] std::string names(std::span<const Quantity> quantities,
                                const std::optional<SweepUnits>& units);

/// The dimension of the quantity; none without units.
[[nodiscard]] records::Dimension dimension(Quantity quantity,
                                           const std::optional<SweepUnits>& units);

}  // namespace stillpoint::sweep
