// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace stillpoint::report {

/// The text with lines of at most `width` characters, broken at blanks, where
/// possible not between a number and its unit or an option and its value. What follows a break is
/// indented: in the list of options like the help above it, in a command after a backslash. A word
/// longer than the width stays whole.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width);

}  // namespace stillpoint::report
