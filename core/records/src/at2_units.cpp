// SPDX-License-Identifier: MIT
#include "acceleration_units.hpp"
#include "at2_parts.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace stillpoint::records {

namespace {

using std::string_view;

bool contains(string_view text, string_view part) {
  return text.find(part) != string_view::npos;
}

/// A word without the full stop of its sentence.
string_view without_stop(string_view word) {
  return word.substr(0, word.find_last_not_of('.') + 1);
}

/// The word for the units: the one after UNITS, or one that can only mean units.
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
    if (must_be_units(units)) {
      return units;
    }
  }
  return std::nullopt;
}

}  // namespace

bool names_quantity(string_view line) {
  const std::string text = upper_case(trimmed(line));
  const auto begins = [&text](string_view word) { return text.starts_with(word); };
  return contains(text, "TIME HISTORY") || contains(text, "TIME SERIES") ||
         contains(text, "UNITS") || begins("ACCEL") || begins("VELOC") || begins("DISPLAC");
}

std::optional<RecordUnits> at2_units(const RecordReader& reader) {
  const std::string text = normal_units(reader.line());
  for (const auto& [part, quantity] :
       {std::pair{"VELOC", "a velocity"}, std::pair{"DISPLAC", "a displacement"}}) {
    if (contains(text, part) && !contains(text, "ACCEL")) {
      reader.refuse(fmt::format("{} says that this is {}: {}", quoted(trimmed(reader.line())),
                                quantity, wanted_units));
    }
  }
  const auto word = units_word(words_of(text, " \t,;:=()[]"));
  return word ? std::optional(read_units(reader, *word)) : std::nullopt;
}

}  // namespace stillpoint::records
