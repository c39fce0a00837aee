// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <utility>

namespace stillpoint::report {

/// fmt::format without its namespace. An object, because a function of that name would compete with
/// std::format wherever an argument is a std::string and the library has it.
inline constexpr auto format = []<class... Values>(fmt::format_string<Values...> text,
                                                   Values&&... values) {
  return fmt::format(text, std::forward<Values>(values)...);
};

}  // namespace stillpoint::report
