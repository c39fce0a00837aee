// SPDX-License-Identifier: MIT
#include "list_reader.hpp"

#include "json_row.hpp"
#include "settings.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace stillpoint::cli {

namespace {

constexpr std::size_t longest_quoted = 60;

constexpr std::string_view column_names = "v0, p, x0, beta, f and delta";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::string_view without_quotes(std::string_view text) {
  return text.size() >= 2 && text.front() == '"' && text.back() == '"'
             ? trimmed(text.substr(1, text.size() - 2))
             : text;
}

/// Takes the field before the next comma off `rest`; false after the last. It may stand in quotes,
/// and then a comma between them is its own (RFC 4180).
bool take_field(std::string_view& rest, bool& more, std::string_view& field) {
  if (!more) {
    return false;
  }
  const bool in_quotes = trimmed(rest).starts_with('"');
  const std::size_t quote = in_quotes ? rest.find('"', rest.find('"') + 1) : 0;
  const std::size_t comma = rest.find(',', quote);  // none behind npos
  more = comma != std::string_view::npos;
  field = without_quotes(trimmed(rest.substr(0, comma)));
  rest = more ? rest.substr(comma + 1) : std::string_view();
  return true;
}

bool is_input(Quantity quantity) {
  using enum Quantity;
  return quantity == v0 || quantity == p || quantity == x0 || quantity == beta || quantity == f ||
         quantity == delta;
}

}  // namespace

ListReader::ListReader(const std::string& path, std::optional<ListFormat> format) : lines_(path) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  std::string_view line;
  if (!next_line(line)) {
    throw UsageError(
        fmt::format("list {}: is empty: must have a header, or JSON objects", lines_.source()));
  }
  if (lines_.number() == 1 && line.starts_with(byte_order_mark)) {
    line.remove_prefix(byte_order_mark.size());
  }
  format_ = format.value_or(trimmed(line).starts_with('{') ? ListFormat::jsonl : ListFormat::csv);
  if (format_ == ListFormat::csv) {
    read_header(line);
  } else {
    read_object(line, first_.emplace());
  }
}

void ListReader::refuse(std::string_view what) const {
  throw UsageError(fmt::format("list {}: line {}: {}", lines_.source(), lines_.number(), what));
}

bool ListReader::next_line(std::string_view& line) {
  while (lines_.next(line)) {
    if (!trimmed(line).empty()) {
      return true;
    }
  }
  return false;
}

void ListReader::read_header(std::string_view line) {
  std::string_view field;
  for (bool more = true; take_field(line, more, field);) {
    const auto quantity = find_quantity(field);
    if (!quantity || !is_input(*quantity)) {
      refuse(fmt::format("\"{}\" is no column of a list: it may have {}",
                         records::printable(field, longest_quoted), column_names));
    }
    if (std::ranges::find(columns_, *quantity) != columns_.end()) {
      refuse(fmt::format("the column {} stands twice", name(*quantity)));
    }
    columns_.push_back(*quantity);
  }
}

void ListReader::read_row(std::string_view line, std::vector<double>& values) {
  values.clear();
  std::string_view field;
  std::size_t count = 0;
  for (bool more = true; take_field(line, more, field); ++count) {
    if (count < columns_.size()) {
      try {
        values.push_back(parse_number(name(columns_[count]), field));
      } catch (const InputError& error) {
        refuse(records::printable(error.what(), 4 * longest_quoted));
      }
    }
  }
  if (count != columns_.size()) {
    refuse(fmt::format("has {} values, the header names {} columns", count, columns_.size()));
  }
}

void ListReader::read_object(std::string_view line, std::vector<double>& values) {
  const JsonRow row = parse_json_row(line);
  if (!row.error.empty()) {
    refuse(row.error);
  }
  const bool is_first = columns_.empty();
  values.resize(row.fields.size());
  for (std::size_t i = 0; i < row.fields.size(); ++i) {
    const auto& [key, value] = row.fields[i];
    const auto quantity = find_quantity(key);
    if (!quantity || !is_input(*quantity)) {
      refuse(fmt::format("\"{}\" is no key of a list: it may have {}",
                         records::printable(key, longest_quoted), column_names));
    }
    const auto place = std::ranges::find(columns_, *quantity);
    if (is_first && place == columns_.end()) {
      columns_.push_back(*quantity);
      values[i] = value;
    } else if (is_first) {
      refuse(fmt::format("the key {} stands twice", name(*quantity)));
    } else if (place == columns_.end()) {
      refuse(fmt::format("has the key {}, which the first object has not", name(*quantity)));
    } else if (row.fields.size() == columns_.size()) {
      values[static_cast<std::size_t>(place - columns_.begin())] = value;
    }
  }
  if (row.fields.size() != columns_.size()) {
    refuse(fmt::format("has {} keys, the first object has {}", row.fields.size(), columns_.size()));
  }
}

bool ListReader::next(std::vector<double>& values) {
  if (first_) {
    values = *first_;
    first_.reset();
    return true;
  }
  std::string_view line;
  if (!next_line(line)) {
    return false;
  }
  if (format_ == ListFormat::csv) {
    read_row(line, values);
  } else {
    read_object(line, values);
  }
  return true;
}

}  // namespace stillpoint::cli
