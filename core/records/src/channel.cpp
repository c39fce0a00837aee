// SPDX-License-Identifier: MIT
#include "channel.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>

namespace stillpoint::records {

namespace {

/// The last line up to that of `end` that begins with `key`; "" without one.
std::string last_line_with(RecordReader start, const RecordReader& end, std::string_view key) {
  std::string found;
  while (start.number() < end.number() && start.next()) {
    if (trimmed(start.line()).starts_with(key)) {
      found = single_spaced(start.line());
    }
  }
  return found;
}

}  // namespace

void go_to_channel(RecordReader& reader, bool (*begins)(std::string_view line)) {
  std::vector<RecordReader> channels;
  for (RecordReader ahead = reader; ahead.next();) {
    if (begins(ahead.line())) {
      channels.push_back(ahead);
    } else if (channels.empty()) {
      reader = ahead;
    }
  }
  const std::optional<std::size_t> wanted = reader.options().channel;
  if (channels.empty()) {
    reader.refuse("the file ends here without a line that says how many accelerations follow");
  }
  if (!wanted && channels.size() > 1) {
    channels[1].refuse(
        fmt::format("the second of {} channels begins here: choose one by its number, {}#1 to #{}",
                    channels.size(), shortened(reader.path(), longest_word), channels.size()));
  }
  if (wanted && *wanted > channels.size()) {
    channels.back().refuse(
        fmt::format("there is no channel {}: the last is number {}", *wanted, channels.size()));
  }
  reader = channels[wanted.value_or(1) - 1];
}

std::string single_spaced(std::string_view line) {
  return fmt::format("{}", fmt::join(words_of(line, " \t"), " "));
}

std::vector<HeaderText> fields_below(RecordReader reader, std::size_t last, std::size_t width) {
  constexpr std::size_t most = 100;  // a wrong file may have any number
  std::vector<HeaderText> fields;
  while (fields.size() < most && reader.number() < last && reader.next()) {
    for (const std::string_view field : fields_of(reader.line(), width)) {
      fields.push_back({field, reader});
    }
  }
  return fields;
}

std::optional<HeaderText> find_key(const std::vector<RecordReader>& header, std::string_view key) {
  for (const RecordReader& line : header) {
    const std::string_view text =
        trimmed(line.line().substr(std::min(key.size(), line.line().size())));
    if (line.line().starts_with(key) && !text.empty()) {
      return HeaderText{text, line};
    }
  }
  return std::nullopt;
}

HeaderText text_of(const std::vector<RecordReader>& header, std::string_view key) {
  const auto found = find_key(header, key);
  if (!found) {
    header.back().refuse(fmt::format("the header ends here without {}", key));
  }
  return *found;
}

std::string described(const std::vector<RecordReader>& header,
                      std::initializer_list<std::string_view> keys) {
  std::string all;
  for (const std::string_view key : keys) {
    const auto found = find_key(header, key);
    all += found ? std::string(found->text) + " " : "";
  }
  return single_spaced(all);
}

ValueBlock points_below(const RecordReader& reader, std::string_view count) {
  return {"the count of points", whole_count(reader, "points", count, reader.parse_number(count)),
          reader.number(), field_width(reader.line())};
}

RecordFile read_channel(const RecordReader& start, RecordReader& reader, const Channel& channel,
                        std::string_view station_key, std::string_view channel_key) {
  reader.set_units(channel.units, reader.number());
  const std::string description = last_line_with(start, reader, station_key) + "; " +
                                  last_line_with(start, reader, channel_key);
  return {{read_block(reader, channel.block, acceleration_field), channel.step, {}},
          printable(description, longest_description),
          channel.units};
}

}  // namespace stillpoint::records
