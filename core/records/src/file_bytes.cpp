// SPDX-License-Identifier: MIT
#include "file_bytes.hpp"

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

constexpr std::array<std::pair<string_view, string_view>, 7> beginnings{{
    {"PK\x03\x04", "is a zip archive: take the record out of it"},
    {"\x1F\x8B", "is compressed: unpack it"},
    {"\x89HDF", "is an HDF5 file, which is not read"},
    {"\xFF\xFE", "is UTF-16 text: save it as UTF-8"},
    {"\xFE\xFF", "is UTF-16 text: save it as UTF-8"},
    {"MS\x03", mini_seed},
    {"WID2 ", "is a GSE2 file, which is not read: export it as columns of time and acceleration"},
}};

/// In the first line, in capitals.
constexpr std::array<std::pair<string_view, string_view>, 2> titles{{
    {"RESPONSE AND FOURIER AMPLITUDE SPECTRA",
     "holds spectra (volume 3): the accelerations are in volume 2"},
    {"OF UNCORRECTED ACCELEROGRAM DATA OF",
     "is a volume 1 of USC, which is not read: take the corrected record, volume 2"},
}};

/// The version of the header, 6 or 7, in either order of its bytes; or text with the number that
/// stands for what is unknown.
bool is_sac(string_view bytes) {
  constexpr std::size_t version = 304;
  constexpr std::size_t header = 632;
  const auto is_version = [](char c) { return c == 6 || c == 7; };
  const string_view four = bytes.size() >= header ? bytes.substr(version, 4) : "";
  const auto zeros = std::ranges::count(four, '\0');
  const string_view line = bytes.substr(0, bytes.find('\n'));
  constexpr string_view unknown = "-12345.0";
  return (zeros == 3 && (is_version(four.front()) || is_version(four.back()))) ||
         (bytes.size() < header || zeros == 0) && words_of(line, " \r").size() == 5 &&
             bytes.substr(0, header).find(unknown) != string_view::npos;
}

/// A number of six digits, the quality and a blank.
bool is_mini_seed(string_view bytes) {
  constexpr std::size_t digits = 6;
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return bytes.size() > digits + 1 && std::ranges::all_of(bytes.substr(0, digits), is_digit) &&
         string_view("DRQM").find(bytes[digits]) != string_view::npos &&
         (bytes[digits + 1] == ' ' || bytes[digits + 1] == '\0');
}

bool is_header_line(string_view line) {
  return std::ranges::any_of(line, [](char c) {
    const char upper = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return upper >= 'A' && upper <= 'Z' && upper != 'E' && upper != 'D';
  });
}

bool needs_plain_lines(string_view bytes) {
  if (bytes.find('\0') != string_view::npos) {
    return true;
  }
  for (std::size_t at = bytes.find('\r'); at != string_view::npos; at = bytes.find('\r', at + 1)) {
    if (bytes.substr(at + 1, 1) != "\n") {
      return true;
    }
  }
  return false;
}

}  // namespace

string_view unread_form(string_view bytes) {
  for (const auto& [beginning, form] : beginnings) {
    if (bytes.starts_with(beginning)) {
      return form;
    }
  }
  const std::string title = upper_case(bytes.substr(0, std::min<std::size_t>(bytes.find('\n'), 200)));
  for (const auto& [words, form] : titles) {
    if (title.find(words) != std::string::npos) {
      return form;
    }
  }
  return is_mini_seed(bytes) ? mini_seed : is_sac(bytes) ? sac : "";
}

string_view with_plain_lines(string_view bytes, std::string& own) {
  if (!needs_plain_lines(bytes)) {
    return bytes;
  }
  own.reserve(bytes.size());
  while (!bytes.empty()) {
    const std::size_t begin = own.size();
    own += bytes.substr(0, bytes.find_first_of("\r\n"));
    bytes.remove_prefix(own.size() - begin);
    if (is_header_line(std::string_view(own).substr(begin))) {
      std::replace(own.begin() + static_cast<std::ptrdiff_t>(begin), own.end(), '\0', ' ');
    }
    const std::size_t returns = std::min(bytes.find_first_not_of('\r'), bytes.size());
    const bool with_feed = bytes.substr(returns, 1) == "\n";
    if (!bytes.empty()) {
      own += '\n';
      bytes.remove_prefix(with_feed ? returns + 1 : 1);
    }
  }
  return own;
}

}  // namespace stillpoint::records
