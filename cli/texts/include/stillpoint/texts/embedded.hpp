// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace stillpoint::texts {

/// A file of data/help, data/shell or data/starters, which are embedded in the program:
/// "help/design.txt".
[[nodiscard]] std::string_view embedded(std::string_view file);

/// The same with each @name@ replaced by a text.
[[nodiscard]] std::string embedded(std::string_view file,
                                   const std::map<std::string_view, std::string>& texts);

}  // namespace stillpoint::texts
