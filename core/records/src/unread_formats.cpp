// SPDX-License-Identifier: MIT

// Formats that are known by the first bytes of a file and not read.

#include "record_reader.hpp"

#include <stillpoint/records/text.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace stillpoint::records {

namespace {

using std::string_view;

constexpr string_view sac =
    "is a SAC file, which is not read: export it as columns of time and acceleration";
constexpr string_view mini_seed =
    "is a miniSEED file, which is not read: export it as columns of time and acceleration";

constexpr std::array<std::pair<string_view, string_view>, 6> beginnings{{
    {"PK\x03\x04", "is a zip archive: take the record out of it"},
    {"\x1F\x8B", "is compressed: unpack it"},
    {"\xFF\xFE", "is UTF-16 text: save it as UTF-8"},
    {"\xFE\xFF", "is UTF-16 text: save it as UTF-8"},
    {"MS\x03", mini_seed},
    {"WID2 ", "is a GSE2 file, which is not read: export it as columns of time and acceleration"},
}};

/// In the first line, in capitals.
constexpr std::array<std::pair<string_view, string_view>, 2> titles{{
    {"RESPONSE AND FOURIER AMPLITUDE SPECTRA",
     "holds spectra (volume 3): the accelerations are in volume 2"},
    {"UNCORRECTED ACCELEROGRAM DATA",
     "is an uncorrected record (volume 1), which is not read: take volume 2"},
}};

/// The version of the header, a whole number of four bytes in either order, is 6 or 7.
bool is_sac(string_view bytes) {
  constexpr std::size_t version = 304;
  constexpr std::size_t header = 632;
  const string_view four = bytes.size() < header ? "" : bytes.substr(version, 4);
  return std::ranges::count(four, '\0') == 3 && std::max(four.front(), four.back()) >= 6 &&
         std::max(four.front(), four.back()) <= 7;
}

/// A number of six digits, the quality and a blank.
bool is_mini_seed(string_view bytes) {
  constexpr std::size_t digits = 6;
  return bytes.find_first_not_of("0123456789") == digits && bytes.size() > digits + 1 &&
         string_view("DRQM").find(bytes[digits]) != string_view::npos &&
         (bytes[digits + 1] == ' ' || bytes[digits + 1] == '\0');
}

}  // namespace

string_view unread_format(string_view bytes) {
  constexpr std::size_t longest_title = 200;
  const std::string title =
      upper_case(bytes.substr(0, std::min(bytes.find_first_of("\r\n"), longest_title)));
  for (const auto& [beginning, form] : beginnings) {
    if (bytes.starts_with(beginning)) {
      return form;
    }
  }
  for (const auto& [words, form] : titles) {
    if (title.find(words) != std::string::npos) {
      return form;
    }
  }
  return is_mini_seed(bytes) ? mini_seed : is_sac(bytes) ? sac : "";
}

}  // namespace stillpoint::records
