// SPDX-License-Identifier: MIT
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace stillpoint::records {

namespace {

constexpr std::string_view blanks = " \t";

bool is_continuation(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// The length of the UTF-8 sequence that `text` begins with, 0 if there is none.
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  const std::size_t length = first < 0x80U                      ? 1
                             : first >= 0xC2U && first <= 0xDFU ? 2
                             : first >= 0xE0U && first <= 0xEFU ? 3
                             : first >= 0xF0U && first <= 0xF4U ? 4
                                                                : 0;
  if (length == 0 || length > text.size()) {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if (!is_continuation(text[i])) {
      return 0;
    }
  }
  // Overlong forms, surrogates and code points beyond U+10FFFF.
  const bool wrong =
      length > 2 && ((first == 0xE0U && byte(1) < 0xA0U) || (first == 0xEDU && byte(1) > 0x9FU) ||
                     (first == 0xF0U && byte(1) < 0x90U) || (first == 0xF4U && byte(1) > 0x8FU));
  return wrong ? 0 : length;
}

/// Of one UTF-8 sequence, or a stray byte.
unsigned code_point(std::string_view sequence) {
  constexpr unsigned low_bits = 0x3FU;
  const auto first = static_cast<unsigned char>(sequence.front());
  unsigned code = sequence.size() == 1 ? first : first & (0xFFU >> (sequence.size() + 1));
  for (const char c : sequence.substr(1)) {
    code = (code << 6U) | (static_cast<unsigned char>(c) & low_bits);
  }
  return code;
}

/// C0, DEL, C1, and the marks that are invisible or turn the direction of text.
bool is_control(unsigned code) {
  return code < 0x20U || (code >= 0x7FU && code < 0xA0U) || (code >= 0x200BU && code <= 0x200FU) ||
         (code >= 0x2028U && code <= 0x202EU) || (code >= 0x2066U && code <= 0x2069U);
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    if (length == 0) {
      return false;
    }
    text.remove_prefix(length);
  }
  return true;
}

constexpr std::size_t most_slips = 2;  // with more, short names all resemble each other

/// Levenshtein's distance, or a lower bound of it that is too far to suggest.
std::size_t slips(std::string_view a, std::string_view b) {
  const std::size_t least = std::max(a.size(), b.size()) - std::min(a.size(), b.size());
  if (least > most_slips) {
    return least;
  }
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);  // npos + 1 = 0: nothing but blanks
}

std::string_view take_word(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

std::vector<std::string_view> words_of(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> words;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(separators), text.size()));
    if (text.empty()) {
      return words;
    }
    words.push_back(text.substr(0, text.find_first_of(separators)));
    text.remove_prefix(words.back().size());
  }
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) {
      return parts;
    }
    text.remove_prefix(end + 1);
  }
}

std::string upper_case(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  return result;
}

std::string shortened(std::string_view text, std::size_t longest) {
  if (text.size() <= longest) {
    return std::string(text);
  }
  std::size_t length = longest;
  while (length > 0 && is_continuation(text[length])) {
    --length;
  }
  return std::string(text.substr(0, length)) + "...";
}

std::string with_controls_as(const std::function<std::string(unsigned code)>& instead,
                             std::string_view text) {
  const auto is_other = [](char c) { return c < ' ' || c >= '\x7F'; };
  std::string result;
  while (!text.empty()) {
    const auto* const end = std::ranges::find_if(text, is_other);
    result.append(text.begin(), end);
    text.remove_prefix(static_cast<std::size_t>(end - text.begin()));
    if (text.empty()) {
      break;
    }
    const std::string_view sequence =
        text.substr(0, std::max(sequence_length(text), std::size_t{1}));
    const unsigned code = code_point(sequence);
    result += is_control(code) ? instead(code) : std::string(sequence);
    text.remove_prefix(sequence.size());
  }
  return result;
}

std::string printable(std::string_view text, std::size_t longest) {
  std::string result = shortened(text, longest);
  if (!is_utf8(text)) {
    const auto is_beyond_ascii = [](char c) { return static_cast<unsigned char>(c) >= 0x80U; };
    std::replace_if(result.begin(), result.end(), is_beyond_ascii, '?');
  }
  return with_controls_as([](unsigned /*code*/) { return "?"; }, result);
}

std::string hyphened(std::string_view name) {
  std::string result(name);
  std::ranges::replace(result, '_', '-');
  return result;
}

std::string underscored(std::string_view name) {
  std::string result(name);
  std::ranges::replace(result, '-', '_');
  return result;
}

std::string listed(std::span<const std::string_view> words) {
  return fmt::format("{} or {}", fmt::join(words.first(words.size() - 1), ", "), words.back());
}

std::string suggestion(std::string_view wrong, std::span<const std::string_view> names,
                       std::string_view prefix) {
  const auto only = [&](const auto& is_meant) {
    const auto found = std::ranges::find_if(names, is_meant);
    return found != names.end() && std::ranges::count_if(names, is_meant) == 1 ? *found : "";
  };
  std::size_t least = most_slips;  // half of a short word may be slips, but no more
  for (const std::string_view name : names) {
    least = std::min({least, wrong.size() / 2, slips(wrong, name)});
  }
  std::string_view meant = only([&](std::string_view name) { return slips(wrong, name) <= least; });
  if (meant.empty() && wrong.size() > 1) {
    meant = only([&](std::string_view name) { return name.starts_with(wrong); });
  }
  return meant.empty() ? "" : fmt::format("; did you mean {}{}?", prefix, meant);
}

std::string must_be(std::string_view wrong, std::span<const std::string_view> names,
                    std::string_view where) {
  return fmt::format("must be {}{}{}", listed(names), where, suggestion(wrong, names));
}

std::string quoted(std::string_view text) {
  return '"' + printable(text, longest_word) + '"';
}

}  // namespace stillpoint::records
