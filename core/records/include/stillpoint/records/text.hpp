// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::records {

/// `text` without the blanks and tabs at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// Removes the first word, delimited by blanks and tabs, from `text` and returns it; "" if there is
/// none.
std::string_view take_word(std::string_view& text);

/// The parts of `text` between any of `separators`, none of them empty.
[[nodiscard]] std::vector<std::string_view> words_of(std::string_view text,
                                                     std::string_view separators);

/// All parts of `text` between `separator`, the empty ones too.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

/// Only ASCII letters change, so the locale does not matter.
[[nodiscard]] std::string upper_case(std::string_view text);

/// A name as options are spelled, with '-' for '_', and as fields are.
[[nodiscard]] std::string hyphened(std::string_view name);
[[nodiscard]] std::string underscored(std::string_view name);

/// How much of a wrong word a message quotes.
inline constexpr std::size_t longest_word = 60;
/// How much of a file's name.
inline constexpr std::size_t longest_path = 300;

/// The first `longest` bytes of a text, followed by "..." if it is longer. A UTF-8 sequence is
/// never cut in two.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t longest);

/// `text` with something else for each control character (C0, DEL, C1) and each mark that is
/// invisible or turns the direction of text (U+200B to 200F, 2028 to 202E, 2066 to 2069).
[[nodiscard]] std::string with_controls_as(const std::function<std::string(unsigned code)>& instead,
                                           std::string_view text);

/// Text from a file, made fit for a terminal and for JSON: shortened, with a '?' for each of these
/// and, if the text is not UTF-8, for each byte beyond ASCII.
[[nodiscard]] std::string printable(std::string_view text, std::size_t longest);

/// "robust, amplitude, time or acceleration"; of at least two.
[[nodiscard]] std::string listed(std::span<const std::string_view> words);

/// "; did you mean NAME?" for the name that is at most two slips away, or the only one that begins
/// so, else ""; the prefix is put before it.
[[nodiscard]] std::string suggestion(std::string_view wrong,
                                     std::span<const std::string_view> names,
                                     std::string_view prefix = "");

/// "must be robust, amplitude or time", `where` that is so, and a suggestion.
[[nodiscard]] std::string must_be(std::string_view wrong, std::span<const std::string_view> names,
                                  std::string_view where = "");

/// A part of a file as messages quote it.
[[nodiscard]] std::string quoted(std::string_view text);

}  // namespace stillpoint::records
