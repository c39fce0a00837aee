// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace stillpoint::cli {

/// The first `longest` bytes of a text at most, "..." behind them where it is cut; no UTF-8
/// sequence is cut in two.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t longest);

/// So much of a word that is wrong does a message quote.
inline constexpr std::size_t longest_word = 60;
/// So much of the name of a file.
inline constexpr std::size_t longest_path = 300;

/// Text from a file, fit for a terminal and for JSON: at most `longest` bytes ("..." where it is
/// cut), a '?' for each control byte and, where the text is no UTF-8, for each byte beyond ASCII.
[[nodiscard]] std::string printable(std::string_view text, std::size_t longest);

}  // namespace stillpoint::cli
