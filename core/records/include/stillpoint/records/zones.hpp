// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/surface.hpp>
#include <stillpoint/records/units.hpp>

#include <string_view>
#include <vector>

namespace stillpoint::records {

/// The zones of "X:F,X:F,...", each an edge, which may have a unit if it has a dimension, and the
/// friction up to it. Throws InputError, which names the field and the zone.
[[nodiscard]] std::vector<FrictionZone> parse_zones(std::string_view field, Dimension edge,
                                                    std::string_view text);

}  // namespace stillpoint::records
