// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>

namespace stillpoint::report {

/// The file of the page with the program in it, if it is installed with this program.
[[nodiscard]] std::optional<std::string> installed_explorer();

/// That, or the one that ./dev explorer made in the folder where this program was built.
[[nodiscard]] std::optional<std::string> explorer();

/// A link to the page in the state of these options, name and value.
[[nodiscard]] std::string explorer_link(
    const std::string& page, std::span<const std::pair<std::string, std::string>> options);

}  // namespace stillpoint::report
