// SPDX-License-Identifier: MIT
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <cstring>
#include <utility>

namespace stillpoint::records {

namespace {

std::string shown(const FilePlace& place) {
  std::string text = fmt::format(
      "{} {}", place.kind, place.path.empty() ? R"("")" : shortened(place.path, longest_path));
  if (place.line) {
    text += fmt::format(", line {}", *place.line);
  }
  if (place.column) {
    text += fmt::format(", column {}", *place.column);
  }
  return text;
}

}  // namespace

FileError::FileError(FilePlace place, std::string_view message)
    : std::runtime_error(fmt::format("{}: {}", shown(place), message)), place_(std::move(place)) {}

FileError FileError::unreadable(FilePlace place, int error) {
  return {std::move(place), fmt::format("cannot be read: {}", std::strerror(error))};
}

}  // namespace stillpoint::records
