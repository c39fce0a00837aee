// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/list.hpp>

#include "csv_file.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/records/units.hpp>
#include <stillpoint/sweep/output_file.hpp>
#include <stillpoint/sweep/state.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stillpoint::sweep {

namespace {

using records::longest_word;
using records::printable;

using enum Quantity;
constexpr std::array listed_inputs{v0,    v0_low, p,           p_high,      x0,       k,
                                   k_low, lambda, lambda_high, beta,        residual, arrivals,
                                   f,     delta,  hold,        notch_width, damping,  breakaway};

}  // namespace

List::List(const std::string& path, const std::optional<SweepUnits>& units)
    : path_(path), file_(std::make_unique<CsvFile>(path, "list", "")), units_(units) {
  std::ranges::for_each(file_->names(), [this](const std::string& name) { add_column(name); });
}

List::List(std::shared_ptr<const ListColumns> held, const std::optional<SweepUnits>& units)
    : path_("arrays"), units_(units), held_(std::move(held)) {
  for (const auto& [name, values] : *held_) {
    const auto& [first, others] = held_->front();
    add_column(name);
    if (values.size() != others.size()) {
      refuse(fmt::format("{} has {} values, but {} has {}", name, values.size(), first,
                         others.size()));
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
  return file_ ? file_->source() : path_;
}

std::int64_t List::line() const {
  return file_ ? file_->line() : given_;
}

void List::refuse(std::int64_t line, std::string_view what) const {
  if (file_) {
    file_->refuse(line, what);
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
    refuse(fmt::format("\"{}\" is not a column of a list; its columns may be {}",
                       printable(field, longest_word), names(listed_inputs, units_)));
  }
  if (has(*quantity)) {
    refuse(fmt::format("the column {} appears twice", name(*quantity, units_)));
  }
  columns_.push_back(*quantity);
}

double List::value(std::size_t column) const {
  const Quantity quantity = columns_[column];
  const std::string_view field = name(quantity, units_);
  if (held_) {
    const double value = (*held_)[column].second[static_cast<std::size_t>(given_ - 1)];
    if (!std::isfinite(value)) {
      refuse(fmt::format("{} = {}: must be finite", field, value));
    }
    return value;
  }
  try {
    return records::parse_number(field, records::trimmed(file_->text(column)));
  } catch (const InputError& error) {
    const bool has_unit = dimension(quantity, units_) != records::Dimension::none;
    refuse(printable(error.what(), 4 * longest_word) + (has_unit ? " in SI units" : ""));
  }
}

bool List::next(std::vector<double>& values, const std::stop_token& stop) {
  const bool found = held_ ? given_ < std::ssize(held_->front().second) : file_->next(stop);
  if (!found) {
    return false;
  }
  ++given_;
  values.resize(columns_.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = value(i);
  }
  return true;
}

ListExtent List::whole() const {
  if (held_) {
    List again(held_, units_);
    return read_to_end(again);
  }
  if (path_ == "-" || is_special_file(path_)) {
    file_->refuse({}, "must be a file to be split into parts: it is read twice");
  }
  List again(path_, units_);
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
