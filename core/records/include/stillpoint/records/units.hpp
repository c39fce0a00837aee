// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/field.hpp>
#include <stillpoint/core/surface.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::records {

using stillpoint::Dimension;

/// A unit is a power of ten of the SI unit of its dimension, or of what that is multiplied by.
struct Unit {
  std::string_view name;
  Dimension dimension;
  int power_of_ten;
  double times{1};
};

/// One g where nothing else is given, that of the SI.
inline constexpr double standard_gravity_m_per_s2 = 9.80665;

/// Bounds of the positive values of anything that is built or recorded, in SI units and in g, with
/// room to spare. The dimensionless values that follow from them are valid as well.
inline constexpr double smallest_physical = 1e-30;
inline constexpr double largest_physical = 1e30;

/// The units of a dimension, the SI unit first; for gravities, g. None for a plain number.
[[nodiscard]] std::vector<Unit> units_of(Dimension dimension);

/// "m, cm or mm"; "" for a plain number.
[[nodiscard]] std::string unit_names(Dimension dimension);

/// "150mm" is 0.15 for a length: the number is scaled as decimal digits before it is rounded, so
/// 150mm and 0.15 are the same double. A bare number is in the SI unit. Throws InputError, which
/// names the field, the text and the units that it accepts, and ends in `instead`, what else may
/// have a unit.
[[nodiscard]] double parse_value(std::string_view field, Dimension dimension, std::string_view text,
                                 std::string_view instead = "");

/// Throws InputError, "velocity = -1 m/s: must be from 1e-30 to 1e+30 m/s", unless a value in the
/// first of its units is from `least` to largest_physical.
void require_physical(std::string_view field, Dimension dimension, double value,
                      double least = smallest_physical);

/// Whether `text` is a unit alone.
[[nodiscard]] bool is_unit(std::string_view text);

/// Whether something follows the number of `text`.
[[nodiscard]] bool has_unit(std::string_view text);
/// Whether that is one of inches, feet or pounds.
[[nodiscard]] bool is_customary(std::string_view text);
/// Whether that is a unit of this dimension.
[[nodiscard]] bool has_unit(std::string_view text, Dimension dimension);

/// The zones of "X:F,X:F,...", each an edge, which may have a unit if it has a dimension, and the
/// friction up to it. Throws InputError, which names the field and the zone.
[[nodiscard]] std::vector<FrictionZone> parse_zones(std::string_view field, Dimension edge,
                                                    std::string_view text);

}  // namespace stillpoint::records
