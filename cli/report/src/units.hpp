// SPDX-License-Identifier: MIT
#pragma once

// Metres and seconds beside dimensionless numbers, if the input was given in them.

#include <stillpoint/core/field.hpp>
#include <stillpoint/design/physical.hpp>

#include <optional>
#include <string>
#include <utility>

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
/// Two of them, in enough digits to be told apart if the first is larger; and "412 mm where 400 mm
/// is allowed".
[[nodiscard]] std::pair<std::string, std::string> told_apart(const Physical& physical,
                                                             Dimension dimension, double value,
                                                             double limit);
[[nodiscard]] std::string beyond(const Physical& physical, Dimension dimension, double value,
                                 double limit);
/// "peak, mm"; the name alone without a unit.
[[nodiscard]] std::string in(const std::string& name, const std::string& unit);

/// " mm" behind a number; nothing without a unit.
[[nodiscard]] std::string with_blank(const std::string& unit);

/// The factors that figures apply to dimensionless numbers, and the labels of their axes.
struct FigureUnits {
  double length{1};
  double time{1};
  double velocity{1};
  double energy{1};
  std::string f_label{"constant friction f"};
  std::string delta_label{"point friction Δ"};
  std::string x_label{"displacement x"};
  std::string time_label{"time τ"};
  std::string velocity_label{"velocity x′"};
  std::string energy_label{"energy"};

  std::string length_unit;  ///< these as words, empty without physical input
  std::string time_unit;
  std::string velocity_unit;
  std::string energy_unit;

  explicit FigureUnits(const Physical& physical);
  /// The factor and the unit of a dimension; 1 and none of what has none here.
  [[nodiscard]] std::pair<double, std::string> of(Dimension dimension) const;

  /// "137 mm"; the value is dimensionless.
  [[nodiscard]] std::string words(Dimension dimension, double value) const;
  [[nodiscard]] std::string length_words(double value) const;
  /// The same of an x; "0" alone.
  [[nodiscard]] std::string place_words(double x) const;
  [[nodiscard]] std::string time_words(double value) const;
  [[nodiscard]] std::string velocity_words(double value) const;
  [[nodiscard]] std::string energy_words(double value) const;
};

}  // namespace stillpoint::report
