// SPDX-License-Identifier: MIT
#include "checkpoint.hpp"

#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/sweep/json_text.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace stillpoint::sweep {

namespace {

using nlohmann::ordered_json;

constexpr auto schema = "stillpoint/sweep-checkpoint/2";
constexpr std::string_view mark = "#stillpoint-part ";
constexpr std::int64_t longest_seal = std::int64_t{1} << 26U;  // a task has axes, maybe long ones
constexpr std::size_t place_digits = 20;

/// Each number with its key.
template <class Numbers, class Each>
void for_each_number(Numbers& checkpoint, const Each& each) {
  auto& [label, state] = checkpoint;
  each("part", label.part.number);
  each("parts", label.part.count);
  each("entries", label.whole.entries);
  each("list", label.whole.digest);
  each("rows", state.rows);
  each("bytes", state.bytes);
  each("digest", state.digest);
  each("outcomes", state.outcomes);
  each("locked", state.locked_outcomes);
  each("feasible", state.feasible);
}

/// The bytes from..to of a file.
std::string bytes_of(std::ifstream& file, std::int64_t from, std::int64_t to) {
  std::string bytes(static_cast<std::size_t>(to - from), '\0');
  file.seekg(from);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

/// What the last line of a file says behind its mark, and how many bytes are before that line.
std::pair<std::string, std::int64_t> sealed(std::ifstream& file, std::int64_t size) {
  constexpr std::int64_t tail = place_digits + 2;  // before the digits " ", then "\n"
  const std::string end = size < tail ? "" : bytes_of(file, size - tail, size);
  const std::string_view digits =
      std::string_view(end).substr(std::min<std::size_t>(1, end.size()));
  const std::int64_t place = records::scan_integer(digits.substr(0, place_digits)).value_or(-1);
  if (place < 0 || place > size - tail || size - tail - place > longest_seal) {
    throw std::runtime_error("no place of a seal");
  }
  const std::string line = bytes_of(file, place, size - tail);
  if (!file || !line.starts_with(mark)) {
    throw std::runtime_error("no seal");
  }
  return {line.substr(mark.size()), place};
}

}  // namespace

std::string text(const Checkpoint& checkpoint) {
  ordered_json document{{"schema", schema}};
  for_each_number(checkpoint, [&](const char* key, const auto& number) { document[key] = number; });
  document["task"] = ordered_json::parse(checkpoint.label.task);
  return document.dump();
}

Checkpoint parse_checkpoint(std::string_view text) {
  require_json_object(text, {.kind = "checkpoint", .path = ""});
  const auto document = ordered_json::parse(text);
  Checkpoint checkpoint;
  for_each_number(checkpoint,
                  [&](const char* key, auto& number) { read_integers(document.at(key), number); });
  checkpoint.label.task = document.at("task").dump();
  const SweepState& state = checkpoint.state;
  const auto all = checkpoint.label.rows();
  const bool counted = checkpoint.label.whole.entries > 0;
  if (document.at("schema") != schema || !document.at("task").is_object() || !all ||
      std::min(state.rows, state.bytes) < 0 || (counted && state.rows > *all)) {
    throw std::runtime_error("not a checkpoint");
  }
  return checkpoint;
}

std::string seal(const Checkpoint& checkpoint) {
  return fmt::format("{}{} {:0{}}\n", mark, text(checkpoint), checkpoint.state.bytes, place_digits);
}

Checkpoint read_seal(const std::string& path) {
  const records::FilePlace place{.kind = "part", .path = path};
  std::error_code unknown;
  const auto size = static_cast<std::int64_t>(std::filesystem::file_size(path, unknown));
  if (unknown) {
    throw records::FileError::unreadable(place, unknown.value());
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw records::FileError::unreadable(place, errno);
  }
  try {
    const auto [line, before] = sealed(file, size);
    Checkpoint checkpoint = parse_checkpoint(line);
    checkpoint.label.path = path;
    if (checkpoint.state.bytes != before || checkpoint.label.rows() != checkpoint.state.rows) {
      throw std::runtime_error("not that of a complete part");
    }
    return checkpoint;
  } catch (const std::exception&) {
    throw records::FileError(
        place, "is not a complete part of a sweep: it is another kind of file, or was cut short");
  }
}

}  // namespace stillpoint::sweep
