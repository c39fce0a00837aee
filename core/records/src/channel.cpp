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
  if (channels.empty()) {
    reader.refuse("the file ends here without a line that says how many accelerations follow");
  }
  const bool asked = reader.options().channel.has_value();
  reader = channels[chosen_channel(
      asked || channels.size() == 1 ? channels.back() : channels[1], channels.size(),
      fmt::format("the second of {} channels begins here", channels.size()))];
}

std::size_t chosen_channel(const RecordReader& reader, std::size_t count,
                           std::string_view several) {
  const std::optional<std::size_t> wanted = reader.options().channel;
  if (!wanted && count > 1) {
    reader.refuse(fmt::format("{}: choose one by its number, {}#1 to #{}", several,
                              shortened(reader.path(), longest_word), count));
  }
  if (wanted > count) {
    reader.refuse(fmt::format("there is no channel {}: the last is number {}", *wanted, count));
  }
  return wanted.value_or(1) - 1;
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

HeaderText header_number(const RecordReader& reader, std::size_t lines, std::size_t width,
                         std::size_t wanted) {
  const auto fields = fields_below(reader, reader.number() + lines, width);
  if (wanted > fields.size()) {
    (fields.empty() ? reader : fields.back().reader)
        .refuse(fmt::format("the header has only {} numbers: number {} is missing", fields.size(),
                            wanted));
  }
  return fields[wanted - 1];
}

double value_of(const HeaderText& number) {
  return number.reader.parse_number(number.text);
}

void skip(RecordReader& reader, std::size_t lines) {
  for (std::size_t i = 0; i < lines; ++i) {
    if (!reader.next()) {
      reader.refuse("the file ends within its header");
    }
  }
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

std::string_view after_colon(std::string_view text) {
  return trimmed(text.substr(text.find(':') + 1));  // npos + 1 = 0
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

RecordFile read_described(RecordReader& reader, const HeaderNumber& count, const HeaderNumber& step,
                          RecordUnits units, std::size_t units_line, const Table& table,
                          std::string_view description) {
  const auto& [text, line] = count.given;
  ValueBlock block{std::string(count.name),
                   whole_count(line, count.name, text, value_of(count.given)), line.number(),
                   table.width, table.others_follow};
  const double tau = reader.file_step(step.given.reader.number(), step.name,
                                      step.value ? *step.value : value_of(step.given));
  reader.set_units(units, units_line);
  if (table.columns > 1) {
    block.count_name = fmt::format("{} columns times {}", table.columns, block.count_name);
    block.count *= table.columns;
  }
  std::vector<double> values;
  std::size_t column = 0;
  read_block(reader, block, [&](const RecordReader& at, std::string_view field) {
    if (column == table.column) {
      values.push_back(at.parse_acceleration(field));
    }
    column = (column + 1) % table.columns;
    return 0.0;
  });
  return {{std::move(values), tau, {}}, printable(description, longest_description), units};
}

std::string described(const RecordReader& start, const RecordReader& end,
                      std::string_view station_key, std::string_view channel_key) {
  return last_line_with(start, end, station_key) + "; " + last_line_with(start, end, channel_key);
}

}  // namespace stillpoint::records
