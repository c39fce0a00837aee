// SPDX-License-Identifier: MIT
#include "seal.hpp"

#include "rows.hpp"

#include <stillpoint/records/file_error.hpp>
#include <stillpoint/sweep/json_text.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

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
constexpr std::int64_t longest_seal = std::int64_t{1} << 26U;  // as for a checkpoint
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
  read_integers(document.at("part"), seal.label.part.number);
  read_integers(document.at("parts"), seal.label.part.count);
  read_integers(document.at("entries"), seal.label.whole.entries);
  read_integers(document.at("list"), seal.label.whole.digest);
  seal.format = document.at("format") == name(RowFormat::npy) ? RowFormat::npy : RowFormat::csv;
  document.at("fields").get_to(seal.npy_fields);
  read_integers(document.at("header"), seal.header);
  read_counts(document, seal.state);
  read_integers(document.at("digest"), seal.state.bytes.words);
  read_integers(document.at("rest"), seal.state.bytes.rest);
  seal.label.task = document.at("task").dump();
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

void read_counts(const ordered_json& document, SweepState& state) {
  read_integers(document.at("rows"), state.rows);
  read_integers(document.at("outcomes"), state.outcomes);
  read_integers(document.at("locked"), state.locked_outcomes);
  read_integers(document.at("feasible"), state.feasible);
}

std::string text(const Seal& seal) {
  const SweepState& state = seal.state;
  const ordered_json document{{"schema", seal_schema},
                              {"part", seal.label.part.number},
                              {"parts", seal.label.part.count},
                              {"entries", seal.label.whole.entries},
                              {"list", seal.label.whole.digest},
                              {"format", name(seal.format)},
                              {"fields", seal.npy_fields},
                              {"header", seal.header},
                              {"rows", state.rows},
                              {"outcomes", state.outcomes},
                              {"locked", state.locked_outcomes},
                              {"feasible", state.feasible},
                              {"digest", state.bytes.words},
                              {"rest", state.bytes.rest},
                              {"task", ordered_json::parse(seal.label.task)}};
  return fmt::format("{}{} {:0{}}\n", seal_mark, document.dump(), state.bytes.size, place_digits);
}

Seal seal_of(const SweepSpec& spec, const SweepState& state) {
  const RowWriter rows(spec);
  return {.label = label_of(spec),
          .format = spec.format,
          .npy_fields = rows.npy_fields(),
          .header = static_cast<std::int64_t>(rows.header(state.rows).size()),
          .state = state};
}

Seal read_seal(const std::string& path) {
  const records::FilePlace place{.kind = "part", .path = path};
  const auto refuse = [&place]() -> records::FileError {
    return {place,
            "is not a complete part of a sweep: it is another kind of file, or was cut short"};
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
    const std::string_view document = std::string_view(line).substr(seal_mark.size());
    require_json_object(document, place);
    Seal seal = seal_from(ordered_json::parse(document));
    seal.state.bytes.size = seal_place;
    seal.label.path = path;
    if (!seal.label.is_whole(seal.state.rows) || seal.header < 0 || seal.header > seal_place) {
      throw refuse();
    }
    return seal;
  } catch (const std::exception&) {
    throw refuse();
  }
}

}  // namespace stillpoint::sweep
