// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::texts {

/// A file of data/help, data/shell or data/starters, which are embedded in the program:
/// "help/design.txt".
[[nodiscard]] std::string_view embedded(std::string_view file);

/// The same with each @name@ replaced by a text.
[[nodiscard]] std::string embedded(std::string_view file,
                                   const std::map<std::string_view, std::string>& texts);

/// The kinds of scene that `stillpoint init` prints, the default first.
[[nodiscard]] std::vector<std::string_view> starter_names();

/// A commented scene for `stillpoint design`. Throws InputError for another kind.
[[nodiscard]] std::string starter_scene(const std::optional<std::string>& kind);

}  // namespace stillpoint::texts
