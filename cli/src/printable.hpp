// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace stillpoint::cli {

/// Text from a file, fit for a terminal and for JSON: at most `longest` bytes ("..." where it is
/// cut), a '?' for each control byte and, where the text is no UTF-8, for each byte beyond ASCII.
[[nodiscard]] std::string printable(std::string_view text, std::size_t longest);

}  // namespace stillpoint::cli
