// SPDX-License-Identifier: MIT
#include "acceleration_units.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace stillpoint::records {

namespace {

using std::string_view;

// Units as `normal_units` leaves them.
constexpr std::array<std::pair<string_view, RecordUnits>, 11> accelerations{{
    {"G", RecordUnits::g},
    {"GS", RecordUnits::g},
    {"G'S", RecordUnits::g},
    {"GAL", RecordUnits::cm_per_s2},
    {"GALS", RecordUnits::cm_per_s2},
    {"CM/S/S", RecordUnits::cm_per_s2},
    {"CM/S2", RecordUnits::cm_per_s2},
    {"MM/S/S", RecordUnits::mm_per_s2},
    {"MM/S2", RecordUnits::mm_per_s2},
    {"M/S/S", RecordUnits::m_per_s2},
    {"M/S2", RecordUnits::m_per_s2},
}};
constexpr std::array<string_view, 5> velocities{"CM/S", "M/S", "MM/S", "IN/S", "FT/S"};
constexpr std::array<string_view, 5> displacements{"CM", "M", "MM", "IN", "FT"};

/// `now` is shorter than `old`, so this ends.
void replace_all(std::string& text, string_view old, string_view now) {
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old)) {
    text.replace(at, old.size(), now);
  }
}

}  // namespace

std::optional<RecordUnits> acceleration_units(string_view word) {
  word = word.substr(0, word.find_last_not_of('.') + 1);
  const auto* const found =
      std::ranges::find(accelerations, word, &std::pair<string_view, RecordUnits>::first);
  return found == accelerations.end() ? std::nullopt : std::optional(found->second);
}

std::string normal_units(string_view line) {
  std::string text = upper_case(line);
  for (const char blank : {' ', '\t'}) {
    replace_all(text, std::string{blank, '/'}, "/");
    replace_all(text, std::string{'/', blank}, "/");
  }
  std::erase_if(text, [](char c) { return c == '*' || c == '^'; });
  for (const string_view second : {"/SECONDS", "/SECOND", "/SECS", "/SEC", "/SEG"}) {
    replace_all(text, second, "/S");
  }
  return text;
}

bool must_be_units(string_view word) {
  return acceleration_units(word) || std::ranges::count(velocities, word) > 0;
}

RecordUnits read_units(const RecordReader& reader, string_view word) {
  const std::string units = normal_units(word);
  if (const auto found = acceleration_units(units)) {
    return *found;
  }
  const string_view fault = std::ranges::count(velocities, units) > 0 ? "are those of a velocity"
                            : std::ranges::count(displacements, units) > 0
                                ? "are those of a displacement"
                                : "are unknown";
  reader.refuse(fmt::format("the units {} {}: {}", quoted(word), fault, wanted_units));
}

}  // namespace stillpoint::records
