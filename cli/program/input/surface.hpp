// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"

#include <stillpoint/core/surface.hpp>
#include <stillpoint/design/physical.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stillpoint::cli {

/// "x:f,x:f,...", as a scene's list of { "to": x, "f": f } reads in one text.
[[nodiscard]] std::string zones_text(const nlohmann::json& list);

/// The width of the notch, which may be given in metres. Empty where not given.
[[nodiscard]] std::optional<double> notch_width(
    const Settings& settings, const std::optional<design::PhysicalInput>& physical);

/// Edges are in metres with physical input. Throws InputError for a text that is no list of zones.
[[nodiscard]] std::vector<FrictionZone> friction_zones(
    const Settings& settings, const std::optional<design::PhysicalInput>& physical);

/// What the mass slides on.
[[nodiscard]] Surface surface_input(const Settings& settings,
                                    const std::optional<design::PhysicalInput>& physical);

}  // namespace stillpoint::cli
