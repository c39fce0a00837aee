// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/checkpoint.hpp>

#include <stillpoint/core/field.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/sweep/json_text.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <system_error>
#include <type_traits>
#include <utility>

namespace stillpoint::sweep {

namespace {

using nlohmann::ordered_json;

constexpr auto schema = "stillpoint/sweep-checkpoint/3";
constexpr std::string_view mark = "#stillpoint-part ";
constexpr std::int64_t longest_seal = std::int64_t{1} << 26U;  // a task has axes, maybe long ones
constexpr std::int64_t number_digits = 20;
constexpr std::int64_t largest_count = std::int64_t{1} << 60U;  // some of them can be added

/// The keys of a struct, each with its member.
template <class Struct>
constexpr auto keys = nullptr;
template <class Value>
constexpr bool has_keys = !std::is_null_pointer_v<std::remove_const_t<decltype(keys<Value>)>>;

template <>
constexpr std::tuple keys<SweepPart>{Field{"number", &SweepPart::number},
                                     Field{"count", &SweepPart::count}};
template <>
constexpr std::tuple keys<ListExtent>{Field{"entries", &ListExtent::entries},
                                      Field{"list", &ListExtent::digest}};
template <>
constexpr std::tuple keys<RowColumn>{Field{"name", &RowColumn::name},
                                     Field{"form", &RowColumn::form}};
template <>
constexpr std::tuple keys<ReducedRow>{Field{"entry", &ReducedRow::entry},
                                      Field{"values", &ReducedRow::values}};
template <>
constexpr std::tuple keys<ReducedColumn>{
    Field{"column", &ReducedColumn::column}, Field{"count", &ReducedColumn::count},
    Field{"absent", &ReducedColumn::absent}, Field{"infinite", &ReducedColumn::infinite},
    Field{"least", &ReducedColumn::least},   Field{"largest", &ReducedColumn::largest}};
template <>
constexpr std::tuple keys<Histogram>{
    Field{"column", &Histogram::column}, Field{"edges", &Histogram::edges},
    Field{"counts", &Histogram::counts}, Field{"below", &Histogram::below},
    Field{"above", &Histogram::above}};
template <>
constexpr std::tuple keys<Reduction>{Field{"row", &Reduction::row},
                                     Field{"columns", &Reduction::columns},
                                     Field{"histograms", &Reduction::histograms}};
template <>
constexpr std::tuple keys<SweepState>{
    Field{"rows", &SweepState::rows},         Field{"bytes", &SweepState::bytes},
    Field{"header", &SweepState::header},     Field{"digest", &SweepState::digest},
    Field{"outcomes", &SweepState::outcomes}, Field{"locked", &SweepState::locked_outcomes},
    Field{"feasible", &SweepState::feasible}, Field{"reduction", &SweepState::reduction}};
/// But for its state, whose keys stand beside these, and its task.
template <>
constexpr std::tuple keys<Checkpoint>{Field{"kind", &Checkpoint::kind},
                                      Field{"part", &Checkpoint::part},
                                      Field{"whole", &Checkpoint::whole}};

template <class Value>
concept Sequence = requires(Value& list) {
  list.size();
}
&&!std::is_same_v<Value, std::string>;

/// A double that is not finite becomes null.
template <class Value>
ordered_json json_of(const Value& value) {
  if constexpr (has_keys<Value>) {
    ordered_json object;
    for_each_field(keys<Value>, [&](const auto& key) {
      object[std::string(key.name)] = json_of(value.*key.get);
    });
    return object;
  } else if constexpr (Sequence<Value>) {
    ordered_json list = ordered_json::array();
    std::ranges::for_each(value, [&](const auto& one) { list.push_back(json_of(one)); });
    return list;
  } else if constexpr (std::is_same_v<Value, double>) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json();
  } else {
    return value;
  }
}

/// Throws std::exception for what json_of cannot have made: nlohmann's get casts a number beyond an
/// integer, which for a double is undefined.
template <class Value>
void read(const ordered_json& from, Value& to) {
  if constexpr (has_keys<Value>) {
    for_each_field(keys<Value>,
                   [&](const auto& key) { read(from.at(std::string(key.name)), to.*key.get); });
  } else if constexpr (Sequence<Value>) {
    if constexpr (requires { to.resize(1); }) {
      to.resize(from.is_array() ? from.size() : 0);
    }
    if (!from.is_array() || from.size() != to.size()) {
      throw std::runtime_error("not a list of that length");
    }
    for (std::size_t i = 0; i < to.size(); ++i) {
      read(from[i], to[i]);
    }
  } else if constexpr (std::is_enum_v<Value>) {
    std::uint8_t number = 0;
    read(from, number);
    to = static_cast<Value>(number);
  } else if constexpr (std::is_same_v<Value, double>) {
    to = from.is_null() ? std::numeric_limits<double>::quiet_NaN() : from.get<double>();
  } else if constexpr (std::is_integral_v<Value> && !std::is_same_v<Value, bool>) {
    if (!(from.is_number_unsigned()
              ? std::in_range<Value>(from.get<std::uint64_t>())
              : from.is_number_integer() && std::in_range<Value>(from.get<std::int64_t>()))) {
      throw std::runtime_error("not an integer of that size");
    }
    from.get_to(to);
    if constexpr (std::is_signed_v<Value>) {
      if (to > largest_count) {
        throw std::runtime_error("too large to be added");
      }
    }
  } else {
    from.get_to(to);
  }
}

std::string digest_of(std::string_view text) {
  Digest digest;
  for (const char byte : text) {
    digest.add(std::uint64_t{static_cast<unsigned char>(byte)});
  }
  return fmt::format("{:0{}}", digest.value(), number_digits);
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
  constexpr std::int64_t tail = 2 * number_digits + 3;  // " ", the digest, " ", digits, "\n"
  const std::string end = size < tail ? "" : bytes_of(file, size - tail, size);
  const std::string_view numbers =
      std::string_view(end).substr(std::min<std::size_t>(1, end.size()));
  const std::int64_t place =
      records::scan_integer(
          numbers.substr(std::min<std::size_t>(number_digits + 1, numbers.size()), number_digits))
          .value_or(-1);
  if (place < 0 || place > size - tail || size - tail - place > longest_seal) {
    throw std::runtime_error("no place of a seal");
  }
  const std::string line = bytes_of(file, place, size - tail);
  if (!file || !line.starts_with(mark) || !numbers.starts_with(digest_of(line))) {
    throw std::runtime_error("no seal");
  }
  return {line.substr(mark.size()), place};
}

}  // namespace

std::optional<std::int64_t> Checkpoint::rows() const {
  const bool exists = 1 <= part.number && part.number <= part.count &&
                      part.count <= most_sweep_parts && whole.entries >= 0;
  return exists ? std::optional(range_of(part, whole.entries).count) : std::nullopt;
}

std::string text(const Checkpoint& checkpoint) {
  ordered_json document{{"schema", schema}};
  document.update(json_of(checkpoint));
  document.update(json_of(checkpoint.state));
  document["task"] = ordered_json::parse(checkpoint.task);
  return document.dump();
}

Checkpoint parse_checkpoint(std::string_view text) {
  require_json_object(text, {.kind = "checkpoint", .path = ""});
  const auto document = ordered_json::parse(text);
  Checkpoint checkpoint;
  read(document, checkpoint);
  read(document, checkpoint.state);
  checkpoint.task = document.at("task").dump();
  const SweepState& state = checkpoint.state;
  const auto all = checkpoint.rows();
  const bool counted = checkpoint.whole.entries > 0;
  if (document.at("schema") != schema || !document.at("task").is_object() || !all ||
      std::min({state.rows, state.header, state.bytes - state.header}) < 0 ||
      (counted && state.rows > *all) || checkpoint.kind > SweepKind::design ||
      !is_sound(state.reduction)) {
    throw std::runtime_error("not a checkpoint");
  }
  return checkpoint;
}

std::string seal(const Checkpoint& checkpoint) {
  const std::string line = fmt::format("{}{}", mark, text(checkpoint));
  return fmt::format("{} {} {:0{}}\n", line, digest_of(line), checkpoint.state.bytes,
                     number_digits);
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
    checkpoint.path = path;
    if (checkpoint.state.bytes != before || checkpoint.rows() != checkpoint.state.rows) {
      throw std::runtime_error("not that of a complete part");
    }
    return checkpoint;
  } catch (const std::exception&) {
    throw records::FileError(place,
                             "is not a complete part of a sweep: it is another kind of file or of "
                             "another version, or was cut short");
  }
}

}  // namespace stillpoint::sweep
