// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace stillpoint::texts {

/// A file of data/help, data/shell, data/starters or data/words, which are embedded in the program:
/// "help/design.txt".
[[nodiscard]] std::string_view embedded(std::string_view file);

/// The same with each @name@ replaced by a text.
[[nodiscard]] std::string embedded(std::string_view file,
                                   const std::map<std::string_view, std::string>& texts);

/// What stands behind "name: " in the line of such a file that begins with that.
[[nodiscard]] std::string_view line_of(std::string_view file, std::string_view name);

}  // namespace stillpoint::texts
