// SPDX-License-Identifier: MIT
#pragma once

// Parts that are JSON: of a sweep without rows and of a design under records.

#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/records/text_file.hpp>
#include <stillpoint/sweep/json_text.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <exception>
#include <string>
#include <string_view>

namespace stillpoint::report {

/// The digest of everything else in a part.
[[nodiscard]] nlohmann::ordered_json digest_json(const nlohmann::ordered_json& report);

/// The part of a `whole` in a file, which `part_from` makes of its JSON. Throws records::FileError
/// if it is not whole.
template <class Part>
[[nodiscard]] Part read_part(const std::string& path, std::string_view whole,
                             Part (*part_from)(nlohmann::ordered_json)) {
  constexpr std::size_t largest_file = std::size_t{1} << 30U;
  const std::string text = records::read_text_file("part", path, largest_file);
  try {
    sweep::require_json_object(text, {.kind = "part", .path = path});
    Part part = part_from(nlohmann::ordered_json::parse(text));
    part.label.path = path;
    return part;
  } catch (const std::exception&) {
    throw records::FileError(
        {.kind = "part", .path = path},
        fmt::format("is not a complete part of {}: it was cut short or has changed", whole));
  }
}

}  // namespace stillpoint::report
