// SPDX-License-Identifier: MIT
#include "at2_parts.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace stillpoint::records {

namespace {

using std::string_view;

// Units as `normal` leaves them.
constexpr std::array<std::pair<string_view, RecordUnits>, 9> accelerations{{
    {"G", RecordUnits::g},
    {"GS", RecordUnits::g},
    {"G'S", RecordUnits::g},
    {"GAL", RecordUnits::cm_per_s2},
    {"GALS", RecordUnits::cm_per_s2},
    {"CM/S/S", RecordUnits::cm_per_s2},
    {"CM/S2", RecordUnits::cm_per_s2},
    {"M/S/S", RecordUnits::m_per_s2},
    {"M/S2", RecordUnits::m_per_s2},
}};
constexpr std::array<string_view, 5> velocities{"CM/S", "M/S", "MM/S", "IN/S", "FT/S"};
constexpr std::array<string_view, 5> displacements{"CM", "M", "MM", "IN", "FT"};

bool contains(string_view text, string_view part) {
  return text.find(part) != string_view::npos;
}

/// `now` is shorter than `old`, so this ends.
void replace_all(std::string& text, string_view old, string_view now) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old)) {
    text.replace(at, old.size(), now);
  }
}

/// In upper case without blanks around a '/'; CM/SEC/SEC as CM/S/S, CM/S**2 and CM/S^2 as CM/S2.
std::string normal(string_view line) {
  std::string text = upper_case(line);
  for (const char blank : {' ', '\t'}) {
    replace_all(text, std::string{blank, '/'}, "/");
    replace_all(text, std::string{'/', blank}, "/");
  }
  std::erase_if(text, [](char c) { return c == '*' || c == '^'; });
  for (const string_view second : {"/SECONDS", "/SECOND", "/SECS", "/SEC"}) {
    replace_all(text, second, "/S");
  }
  return text;
}

std::optional<RecordUnits> acceleration_units(string_view word) {
  const auto* const found =
      std::ranges::find(accelerations, word, &std::pair<string_view, RecordUnits>::first);
  return found == accelerations.end() ? std::nullopt : std::optional(found->second);
}

/// A word without the full stop of its sentence.
string_view without_stop(string_view word) {
  while (word.ends_with('.')) {
    word.remove_suffix(1);
  }
  return word;
}

/// The word for the units: the one after UNITS, or one that can mean nothing else.
std::optional<string_view> units_word(const std::vector<string_view>& words) {
  const auto says_units = std::ranges::find_if(
      words, [](string_view word) { return word == "UNITS" || word == "UNIT"; });
  if (says_units != words.end()) {
    const auto units = std::find_if(says_units + 1, words.end(), [](string_view word) {
      return word != "OF" && word != "IN" && word != "ARE" && word != "IS";
    });
    return units == words.end() ? std::nullopt : std::optional(without_stop(*units));
  }
  for (const string_view word : words) {
    const string_view units = without_stop(word);
    if (acceleration_units(units) || std::ranges::count(velocities, units) > 0) {
      return units;
    }
  }
  return std::nullopt;
}

constexpr string_view wanted = "an acceleration is needed, in G, CM/S2 or M/S2";

}  // namespace

bool names_quantity(string_view line) {
  const std::string text = upper_case(trimmed(line));
  const auto begins = [&text](string_view word) { return text.starts_with(word); };
  return contains(text, "TIME HISTORY") || contains(text, "TIME SERIES") ||
         contains(text, "UNITS") || begins("ACCEL") || begins("VELOC") || begins("DISPLAC");
}

std::optional<RecordUnits> at2_units(const RecordReader& reader) {
  const std::string text = normal(reader.line());
  for (const auto& [part, quantity] :
       {std::pair{"VELOC", "a velocity"}, std::pair{"DISPLAC", "a displacement"}}) {
    if (contains(text, part) && !contains(text, "ACCEL")) {
      reader.refuse(fmt::format("{} says that this is {}: {}", quoted(trimmed(reader.line())),
                                quantity, wanted));
    }
  }
  const auto word = units_word(words_of(text, " \t,;:=()[]"));
  if (!word) {
    return std::nullopt;
  }
  if (const auto units = acceleration_units(*word)) {
    return units;
  }
  const string_view fault = std::ranges::count(velocities, *word) > 0 ? "are those of a velocity"
                            : std::ranges::count(displacements, *word) > 0
                                ? "are those of a displacement"
                                : "are unknown";
  reader.refuse(fmt::format("the units {} {}: {}", quoted(*word), fault, wanted));
}

}  // namespace stillpoint::records
