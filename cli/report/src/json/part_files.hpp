// SPDX-License-Identifier: MIT
#pragma once

// Parts that are JSON: of a sweep without rows and of a design under records.

#include <stillpoint/core/cancellation.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/records/text_file.hpp>
#include <stillpoint/sweep/json_text.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

namespace stillpoint::report {

inline constexpr std::string_view reduction_schema = "stillpoint/sweep-reduction/1";

/// The digest of everything else in a part.
[[nodiscard]] nlohmann::ordered_json digest_json(const nlohmann::ordered_json& report);

/// The part of a `whole` in a file of this schema. `part_from` makes it of its JSON, less what
/// every label has; `rows` counts what it holds. Throws records::FileError if it is not whole.
template <class Part, class Rows>
[[nodiscard]] Part read_part(const std::string& path, std::string_view schema,
                             std::string_view whole,
                             Part (*part_from)(const nlohmann::ordered_json&), const Rows& rows) {
  constexpr std::size_t largest_file = std::size_t{1} << 30U;
  cancellation_point();
  const std::string text = records::read_text_file("part", path, largest_file);
  try {
    sweep::require_json_object(text, {.kind = "part", .path = path});
    auto document = nlohmann::ordered_json::parse(text);
    const nlohmann::ordered_json digest = document.at("digest");
    document.erase("digest");
    if (document.at("schema") != schema || digest != digest_json(document)) {
      throw std::runtime_error("not a part");
    }
    Part part = part_from(document);
    part.label.path = path;
    part.label.task = document.at("task").dump();
    sweep::read_integers(document.at("part").at("number"), part.label.part.number);
    sweep::read_integers(document.at("part").at("count"), part.label.part.count);
    if (!part.label.is_whole(rows(part))) {
      throw std::runtime_error("not that part");
    }
    return part;
  } catch (const std::exception&) {
    throw records::FileError({.kind = "part", .path = path},
                             fmt::format("is not a complete part of {}: it is another kind of "
                                         "file, was cut short, or has changed",
                                         whole));
  }
}

}  // namespace stillpoint::report
