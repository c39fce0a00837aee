// SPDX-License-Identifier: MIT
#pragma once

// What a sweep without rows writes, and its parts, which are read back.

#include <nlohmann/json.hpp>

#include <string_view>

namespace stillpoint::report {

inline constexpr std::string_view reduction_schema = "stillpoint/sweep-reduction/1";

/// The digest of everything else in a part.
[[nodiscard]] nlohmann::ordered_json digest_json(const nlohmann::ordered_json& report);

}  // namespace stillpoint::report
