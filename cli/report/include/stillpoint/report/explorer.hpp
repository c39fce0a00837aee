// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace stillpoint::report {

/// The file of the page with the program in it, if it is installed with this program.
[[nodiscard]] std::optional<std::string> installed_explorer();

/// That, or the one that ./dev explorer made in the folder where this program was built. Throws
/// BrowserError if there is neither.
[[nodiscard]] std::string explorer();

/// A link to the page that shows a scene.
[[nodiscard]] std::string explorer_link(const std::string& page,
                                        const nlohmann::ordered_json& scene);

}  // namespace stillpoint::report
