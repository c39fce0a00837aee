// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"

#include <stillpoint/core/surface.hpp>
#include <stillpoint/design/physical.hpp>

namespace stillpoint::cli {

using design::largest_physical;
using design::smallest_physical;

/// Empty for a task given without units.
using Physical = std::optional<design::PhysicalInput>;

/// v0, p and x0 of a motion, however they were given.
struct MotionInput {
  double v0{0};
  double p{1};
  double x0{0};
  std::optional<double> v0_low{};  ///< these two of a range
  std::optional<double> p_high{};
  Physical physical{};
};

/// Whether the task is given in metres and seconds. Throws UsageError for options that cannot be
/// combined.
[[nodiscard]] bool is_physical(const Settings& settings, Command command);

/// `from_rest`: the velocity may be missing, because something else moves the mass. Throws
/// UsageError for options that cannot be combined and InputError for a missing or wrong value.
[[nodiscard]] MotionInput motion_input(const Settings& settings, Command command, bool from_rest);

/// The option with a unit that is given in place of `plain`; null if there is none.
[[nodiscard]] const Option* with_unit(const Settings& settings, std::string_view plain);

/// The option `plain`, or the one of its rivals that has a unit; then it must be from `least` to
/// largest_physical, and is `unit` times as large. Empty if neither is given.
[[nodiscard]] std::optional<double> in_either(const Settings& settings, std::string_view plain,
                                              double unit, double least);

/// What moves, without friction yet.
[[nodiscard]] Oscillator mass_input(const Settings& settings, double p);

/// What moves, with its damper. Throws InputError for a missing or wrong value.
[[nodiscard]] Oscillator oscillator_input(const Settings& settings, const MotionInput& motion);

/// The same of a point friction or a residual.
[[nodiscard]] std::optional<double> point_friction(const Settings& settings, std::string_view plain,
                                                   const Physical& physical);

/// "x:f,x:f,...", as a scene's list of { "to": x, "f": f } reads in one text.
[[nodiscard]] std::string zones_text(const nlohmann::json& list);

/// The width of the notch, which may be given in metres. Empty if not given.
[[nodiscard]] std::optional<double> notch_width(const Settings& settings, const Physical& physical);

/// Edges are in metres with physical input. Throws InputError for a text that is not a list of
/// zones.
[[nodiscard]] std::vector<FrictionZone> friction_zones(const Settings& settings,
                                                       const Physical& physical);

/// What the mass slides on.
[[nodiscard]] Surface surface_input(const Settings& settings, const Physical& physical);

}  // namespace stillpoint::cli
