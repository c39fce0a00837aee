// SPDX-License-Identifier: MIT
#include "seal.hpp"

#include "posix/part_file.hpp"
#include "rows.hpp"
#include "shallow_json.hpp"

#include <stillpoint/records/file_error.hpp>

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace stillpoint::sweep {

namespace {

using nlohmann::ordered_json;

constexpr auto seal_schema = "stillpoint/sweep-part/1";
constexpr std::string_view seal_mark = "#stillpoint-part ";
constexpr std::int64_t longest_seal = std::int64_t{1} << 26U;  // as of a checkpoint
constexpr std::size_t place_digits = 20;

/// The value of the 20 digits with which a seal ends, before " " and after "\n".
std::int64_t place_of_seal(std::string_view end) {
  std::int64_t place = -1;
  if (end.size() == place_digits + 2 && end.front() == ' ' && end.back() == '\n') {
    const char* const last = end.data() + end.size() - 1;
    const auto [rest, fault] = std::from_chars(end.data() + 1, last, place);
    place = rest == last && fault == std::errc() ? place : -1;
  }
  return place;
}

Seal seal_from(const ordered_json& document) {
  if (document.at("schema") != seal_schema) {
    throw std::runtime_error("not a seal");
  }
  Seal seal;
  document.at("part").get_to(seal.part.number);
  document.at("parts").get_to(seal.part.count);
  document.at("entries").get_to(seal.whole.entries);
  document.at("list").get_to(seal.whole.digest);
  seal.format = document.at("format") == name(RowFormat::npy) ? RowFormat::npy : RowFormat::csv;
  document.at("fields").get_to(seal.npy_fields);
  document.at("header").get_to(seal.header);
  document.at("rows").get_to(seal.state.rows);
  document.at("outcomes").get_to(seal.state.outcomes);
  document.at("feasible").get_to(seal.state.feasible);
  document.at("digest").get_to(seal.state.bytes.words);
  document.at("rest").get_to(seal.state.bytes.rest);
  seal.task = document.at("task").dump();
  return seal;
}

/// The bytes from..to of a file.
std::string bytes_of(std::ifstream& file, std::int64_t from, std::int64_t to) {
  std::string bytes(static_cast<std::size_t>(to - from), '\0');
  file.seekg(from);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

}  // namespace

std::string text(const Seal& seal) {
  const SweepState& state = seal.state;
  const ordered_json document{
      {"schema", seal_schema},      {"part", seal.part.number},
      {"parts", seal.part.count},   {"entries", seal.whole.entries},
      {"list", seal.whole.digest},  {"format", name(seal.format)},
      {"fields", seal.npy_fields},  {"header", seal.header},
      {"rows", state.rows},         {"outcomes", state.outcomes},
      {"feasible", state.feasible}, {"digest", state.bytes.words},
      {"rest", state.bytes.rest},   {"task", ordered_json::parse(seal.task)}};
  return fmt::format("{}{} {:0{}}\n", seal_mark, document.dump(), state.bytes.size, place_digits);
}

Seal seal_of(const SweepSpec& spec, const SweepState& state) {
  const RowWriter rows(spec);
  const ListExtent grid{entries(spec).value_or(0), 0};
  return {.part = *spec.part,
          .task = spec.identity,
          .whole = spec.listed.value_or(grid),
          .format = spec.format,
          .npy_fields = rows.npy_fields(),
          .header = static_cast<std::int64_t>(rows.header(state.rows).size()),
          .state = state};
}

Seal read_seal(const std::string& path) {
  const records::FilePlace place{.kind = "part", .path = path};
  const auto refuse = [&place]() -> records::FileError {
    return {place, "is no whole part of a sweep: it does not end as one, or was cut short"};
  };
  std::error_code unknown;
  const auto size = static_cast<std::int64_t>(std::filesystem::file_size(path, unknown));
  if (unknown) {
    throw records::FileError::unreadable(place, unknown.value());
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw records::FileError::unreadable(place, errno);
  }
  constexpr std::int64_t tail = place_digits + 2;
  const std::int64_t seal_place =
      size < tail ? -1 : place_of_seal(bytes_of(file, size - tail, size));
  if (seal_place < 0 || seal_place > size - tail || size - tail - seal_place > longest_seal) {
    throw refuse();
  }
  const std::string line = bytes_of(file, seal_place, size - tail);
  if (!file || !line.starts_with(seal_mark)) {
    throw refuse();
  }
  try {
    Seal seal = seal_from(parse_shallow(line.substr(seal_mark.size())));
    seal.state.bytes.size = seal_place;
    const auto& [number, count] = seal.part;
    if (number < 1 || number > count || count > most_sweep_parts || seal.header < 0 ||
        seal.header > seal_place ||
        seal.state.rows != range_of(seal.part, seal.whole.entries).count) {
      throw refuse();
    }
    return seal;
  } catch (const nlohmann::json::exception&) {
    throw refuse();
  } catch (const std::runtime_error&) {
    throw refuse();
  }
}

std::string difference(const Seal& one, const Seal& other) {
  const auto differs = [](std::string_view what, auto was, auto is) {
    return fmt::format("{} was {}, is {}", what, was, is);
  };
  const std::string of_tasks = difference(one.task, other.task);
  return !of_tasks.empty() ? of_tasks
         : one.whole.entries != other.whole.entries
             ? differs("the number of entries", one.whole.entries, other.whole.entries)
         : one.whole.digest != other.whole.digest ? "the list has changed"
         : one.npy_fields != other.npy_fields
             ? differs("the layout", one.npy_fields, other.npy_fields)
             : "";
}

}  // namespace stillpoint::sweep
