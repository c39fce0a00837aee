// SPDX-License-Identifier: MIT
#pragma once

// Metres and seconds beside dimensionless numbers, if the input was given in them; inches, pounds
// and kips where any of it was.

#include <stillpoint/core/field.hpp>
#include <stillpoint/design/physical.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace stillpoint::report {

using Physical = std::optional<design::PhysicalInput>;

/// A length, a tau and an acceleration in the usual units: "12.1 mm", "1.53 s",
/// "0.0947 g"; dimensionless without physical input.
[[nodiscard]] std::string length_shown(const Physical& physical, double length,
                                       std::optional<int> digits = {});
[[nodiscard]] std::string time_shown(const Physical& physical, double tau);
[[nodiscard]] std::string acceleration_shown(double acceleration);
/// A length that keeps a limit as printed, with five digits or, without physical input, six.
[[nodiscard]] std::string length_limit(const Physical& physical, double length, bool upwards,
                                       std::optional<int> digits = {});

/// A figure by its dimension, with its unit: "412 mm", "0.1991 g", "0.891 m/s"; "less than 0.001
/// mm" of what nobody can measure.
[[nodiscard]] std::string figure_shown(const Physical& physical, Dimension dimension, double value);
/// "412 mm where 400 mm is allowed", in enough digits to be told apart.
[[nodiscard]] std::string beyond(const Physical& physical, Dimension dimension, double value,
                                 double limit);
/// " mm" behind a number; nothing without a unit.
[[nodiscard]] std::string with_blank(const std::string& unit);
/// A value in that SI unit with a prefix, or as it is read in inches: "8.1 kN", "1.82 kip".
[[nodiscard]] std::string si_words(const Physical& physical, double value, std::string_view unit,
                                   int digits = 5);

/// What people read numbers in: "mm", of which a dimensionless one has so many.
struct Unit {
  double factor{1};
  std::string name{};  ///< empty without physical input

  /// "137 mm"; the value is dimensionless.
  [[nodiscard]] std::string words(double value) const;
};
[[nodiscard]] inline double operator*(double value, const Unit& unit) {
  return value * unit.factor;
}
/// "peak, mm"; the name alone without a unit.
[[nodiscard]] std::string in(std::string_view name, const Unit& unit);
/// An SI unit, or what is read in its place, for values up to `most`.
[[nodiscard]] Unit read_in(const Physical& physical, std::string_view unit, double most = 1);

/// The units of figures and tables, and the labels of axes.
struct FigureUnits {
  Unit length{};
  Unit time{};
  Unit velocity{};
  Unit energy{};
  Unit force{};  ///< over the weight, without a mass
  std::string f_label{"constant friction f"};
  std::string delta_label{in("point friction Δ", length)};
  std::string x_label{in("displacement x", length)};
  std::string time_label{time.name.empty() ? "time τ" : "time, s"};
  std::string velocity_label{velocity.name.empty() ? "velocity x′" : in("velocity", velocity)};
  std::string energy_label{in("energy", energy)};
  std::string force_label{force.name.empty() ? "force / weight" : in("force", force)};

  [[nodiscard]] Unit of(Dimension dimension) const;
  /// "0" alone of that x.
  [[nodiscard]] std::string place_words(double x) const;
  [[nodiscard]] std::string time_words(double value) const;
};
/// Those of a task.
[[nodiscard]] FigureUnits units_of(const Physical& physical);

}  // namespace stillpoint::report
