// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace stillpoint::sweep {

/// Of a file that the program wrote itself, or that somebody else did. The library prints a value
/// by recursion, so a deep one would exhaust the stack: it throws, as for what is no JSON.
[[nodiscard]] nlohmann::ordered_json parse_shallow(const std::string& text);

}  // namespace stillpoint::sweep
