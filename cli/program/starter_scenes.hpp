// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::cli {

/// The kinds of scene that `stillpoint init` prints, the default first.
[[nodiscard]] std::vector<std::string_view> starter_names();

/// A commented scene for `stillpoint design`. Throws InputError for another kind.
[[nodiscard]] std::string starter_scene(const std::optional<std::string>& kind);

}  // namespace stillpoint::cli
