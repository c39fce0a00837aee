// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/list.hpp>

#include "line_reader.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/names.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/records/units.hpp>
#include <stillpoint/sweep/json_text.hpp>
#include <stillpoint/sweep/output_file.hpp>
#include <stillpoint/sweep/state.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace stillpoint::sweep {

namespace {

using records::longest_word;
using records::printable;
using records::trimmed;

using enum Quantity;
constexpr std::array listed_inputs{v0,    v0_low, p,           p_high,     x0,       k,
                                   k_low, lambda, lambda_high, beta,       residual, arrivals,
                                   f,     delta,  hold,        notch_width};

std::string not_a(std::string_view what, std::string_view found,
                  const std::optional<SweepUnits>& units) {
  return fmt::format("\"{}\" is not a {} of a list; its {}s may be {}",
                     printable(found, longest_word), what, what, names(listed_inputs, units));
}

/// "1 value", "2 values"
std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

}  // namespace

std::span<const Named<ListFormat>> enumerators(ListFormat) noexcept {
  static constexpr auto rows =
      std::to_array<Named<ListFormat>>({{ListFormat::csv, "csv"}, {ListFormat::jsonl, "jsonl"}});
  return rows;
}

List::List(const std::string& path, std::optional<ListFormat> format,
           const std::optional<SweepUnits>& units)
    : path_(path), lines_(std::make_unique<LineReader>(path)), units_(units) {
  std::string_view line;
  if (!lines_->next(line, {})) {
    lines_->refuse({}, "is empty: it must have a header, or JSON objects");
  }
  format_ = format.value_or(trimmed(line).starts_with('{') ? ListFormat::jsonl : ListFormat::csv);
  if (format_ == ListFormat::csv) {
    read_header(line);
  } else {
    read_object(line, first_.emplace());
  }
}

List::List(std::shared_ptr<const ListColumns> held, const std::optional<SweepUnits>& units)
    : path_("arrays"), units_(units), held_(std::move(held)) {
  for (const auto& [name, values] : *held_) {
    add_column(name);
    if (values.size() != held_->front().second.size()) {
      refuse(fmt::format("{} has {}, but {} has {}", name, counted(values.size(), "value"),
                         held_->front().first, held_->front().second.size()));
    }
  }
  if (held_->empty()) {
    refuse("has no columns");
  }
}

List::~List() = default;

bool List::has(Quantity column) const {
  return contains(columns_, column);
}

const std::string& List::source() const {
  return lines_ ? lines_->source() : path_;
}

std::int64_t List::line() const {
  return lines_ ? lines_->number() : given_;
}

void List::refuse(std::int64_t line, std::string_view what) const {
  if (lines_) {
    lines_->refuse(line, what);
  }
  records::FilePlace place{.kind = "list", .path = path_};
  if (line > 0) {
    place.line = static_cast<std::size_t>(line);
  }
  throw records::FileError(std::move(place), what);
}

void List::refuse(std::string_view what) const {
  refuse(line(), what);
}

void List::add_column(std::string_view field) {
  const auto quantity = find_named(listed_inputs, field, units_);
  if (!quantity) {
    refuse(not_a("column", field, units_));
  }
  if (has(*quantity)) {
    refuse(fmt::format("the column {} appears twice", name(*quantity, units_)));
  }
  columns_.push_back(*quantity);
}

void List::read_header(std::string_view line) {
  for (const std::string& name_of : lines_->fields(line, row_)) {
    add_column(trimmed(name_of));
  }
}

void List::read_row(std::string_view line, std::vector<double>& values) {
  const std::span<const std::string> fields = lines_->fields(line, row_);
  if (fields.size() != columns_.size()) {
    refuse(fmt::format("has {}, but the header names {}", counted(fields.size(), "value"),
                       counted(columns_.size(), "column")));
  }
  values.resize(fields.size());
  for (std::size_t i = 0; i < fields.size(); ++i) {
    try {
      values[i] = records::parse_number(name(columns_[i], units_), trimmed(fields[i]));
    } catch (const InputError& error) {
      const bool has_unit = dimension(columns_[i], units_) != records::Dimension::none;
      refuse(printable(error.what(), 4 * longest_word) + (has_unit ? " in SI units" : ""));
    }
  }
}

void List::read_object(std::string_view line, std::vector<double>& values) {
  require_json_object(
      line, {.kind = "list", .path = source(), .line = static_cast<std::size_t>(lines_->number())});
  const auto row = nlohmann::ordered_json::parse(line, nullptr, true, true);
  constexpr double absent = std::numeric_limits<double>::quiet_NaN();
  const bool is_first = columns_.empty();
  values.assign(std::max(row.size(), columns_.size()), absent);
  for (const auto& [key, value] : row.items()) {
    const auto quantity = find_named(listed_inputs, key, units_);
    if (!quantity) {
      refuse(not_a("key", key, units_));
    }
    if (!value.is_number()) {
      refuse(fmt::format("{} is a JSON {}: must be a number", key, value.type_name()));
    }
    const auto place =
        static_cast<std::size_t>(std::ranges::find(columns_, *quantity) - columns_.begin());
    const bool is_new = place == columns_.size();
    if (is_new && !is_first) {
      refuse(fmt::format("has the key {}, but the first object does not", name(*quantity, units_)));
    }
    if (is_new) {
      columns_.push_back(*quantity);
    } else if (!std::isnan(values[place])) {
      refuse(fmt::format("the key {} appears twice", name(*quantity, units_)));
    }
    values[place] = value;
  }
  if (row.empty() || row.size() != columns_.size()) {
    refuse(fmt::format("has {}, but {}", counted(row.size(), "key"),
                       row.empty() ? "must have the inputs that vary"
                                   : fmt::format("the first object has {}", columns_.size())));
  }
}

bool List::next(std::vector<double>& values, const std::stop_token& stop) {
  if (held_) {
    const auto entry = static_cast<std::size_t>(given_);
    if (entry == held_->front().second.size()) {
      return false;
    }
    ++given_;
    values.resize(columns_.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = (*held_)[i].second[entry];
      if (!std::isfinite(values[i])) {
        refuse(fmt::format("{} = {}: must be finite", name(columns_[i], units_), values[i]));
      }
    }
    return true;
  }
  if (first_) {
    values = *first_;
    first_.reset();
    return true;
  }
  std::string_view line;
  if (!lines_->next(line, stop)) {
    return false;
  }
  if (format_ == ListFormat::csv) {
    read_row(line, values);
  } else {
    read_object(line, values);
  }
  return true;
}

ListExtent List::whole() const {
  if (held_) {
    List again(held_, units_);
    return read_to_end(again);
  }
  if (path_ == "-" || is_special_file(path_)) {
    lines_->refuse({}, "must be a file to be split into parts: it is read twice");
  }
  List again(path_, format_, units_);
  return read_to_end(again);
}

ListExtent read_to_end(List& list) {
  ListExtent extent;
  Digest digest;
  for (std::vector<double> values; list.next(values); ++extent.entries) {
    std::ranges::for_each(values, [&](double value) { digest.add(value); });
  }
  extent.digest = digest.value();
  return extent;
}

}  // namespace stillpoint::sweep
