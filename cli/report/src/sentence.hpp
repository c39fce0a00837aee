// SPDX-License-Identifier: MIT
#pragma once

#include <cctype>
#include <string>
#include <string_view>

namespace stillpoint::report {

/// "Locked at x = 0." of the clause "locked at x = 0"; nothing of nothing.
[[nodiscard]] inline std::string sentence(std::string_view clause) {
  std::string text(clause);
  if (!text.empty()) {
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    text += '.';
  }
  return text;
}

}  // namespace stillpoint::report
