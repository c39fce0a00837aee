// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/axis.hpp>

#include <stillpoint/core/elementary.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace stillpoint::sweep {

namespace {

using records::parse_number;
using records::split;

/// Below 2^53, so a double counts them exactly.
constexpr std::int64_t most_values = 1'000'000'000'000'000;

Axis parse_steps(std::string_view field, std::string_view text, const NumberReader& number) {
  const auto wrong = [&](std::string_view bound) {
    return InputError(std::string(field), std::string(text), std::string(bound));
  };
  const std::vector<std::string_view> parts = split(text, ':');
  if (parts.size() < 3 || parts.size() > 4 || (parts.size() == 4 && parts[3] != "log")) {
    throw wrong("must be first:last:count or first:last:count:log");
  }
  const double first = number(parts[0]);
  const double last = number(parts[1]);
  const std::int64_t count = records::scan_integer(parts[2]).value_or(0);
  if (count < 1 || count > most_values) {
    throw wrong(
        fmt::format("must have a whole count from 1 to {:g}", static_cast<double>(most_values)));
  }
  if (count == 1 && first != last) {
    throw wrong("must have a count of 2 or more, or be one number");
  }
  if (!std::isfinite(last - first)) {
    throw wrong("must have a length that fits a double");
  }
  if (parts.size() == 3) {
    return {first, last, count, Axis::Spacing::linear};
  }
  if (!(first > 0 && last > 0)) {
    throw wrong("must have both ends above 0 because it is logarithmic");
  }
  return {first, last, count, Axis::Spacing::logarithmic};
}

}  // namespace

Axis::Axis(std::vector<double> values)
    : values_(std::move(values)), size_(static_cast<std::int64_t>(values_.size())), steps_(false) {
  assert(!values_.empty());
}

Axis::Axis(const std::vector<Interval>& ranges, RangeEnd standing) : size_(0), steps_(false) {
  assert(!ranges.empty() && standing != RangeEnd::none);
  values_.reserve(ranges.size());
  others_.reserve(ranges.size());
  for (const auto& [low, high] : ranges) {
    // Adding 0 turns -0 into 0, so equal ends compare equal.
    values_.push_back((standing == RangeEnd::low ? low : high) + 0.0);
    others_.push_back((standing == RangeEnd::low ? high : low) + 0.0);
  }
  size_ = static_cast<std::int64_t>(values_.size());
}

Axis::Axis(double first, double last, std::int64_t count, Spacing spacing)
    : values_{first, last}, size_(count), steps_(true), spacing_(spacing) {
  assert(count >= 1);
}

std::optional<Axis::Spacing> Axis::spacing() const {
  return steps_ ? std::optional(spacing_) : std::nullopt;
}

double Axis::operator[](std::int64_t i) const {
  if (!steps_) {
    return values_[static_cast<std::size_t>(i)];
  }
  const double first = values_[0];
  const double last = values_[1];
  if (i == 0) {
    return first;
  }
  if (i == size_ - 1) {
    return last;
  }
  if (spacing_ == Spacing::linear) {
    return static_cast<double>(i) * ((last - first) / static_cast<double>(size_ - 1)) + first;
  }
  return elementary::between(first, last, static_cast<double>(i), static_cast<double>(size_ - 1));
}

Axis Axis::over(double divisor) const {
  Axis all = *this;
  for (std::vector<double>* const values : {&all.values_, &all.others_}) {
    std::ranges::for_each(*values, [divisor](double& value) { value /= divisor; });
  }
  return all;
}

Interval Axis::ends() const {
  const auto [least, most] = std::ranges::minmax(values_);
  return {least, most};
}

std::string Axis::text() const {
  if (has_ranges()) {
    std::string text;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const auto [low, high] = std::minmax(values_[i], others_[i]);
      text += fmt::format("{}{}:{}", text.empty() ? "" : ",", low, high);
    }
    return text;
  }
  if (!steps_) {
    return fmt::format("{}", fmt::join(values_, ","));
  }
  return fmt::format("{}:{}:{}{}", values_[0], values_[1], size_,
                     spacing_ == Spacing::linear ? "" : ":log");
}

Axis parse_axis(std::string_view field, std::string_view text) {
  return parse_axis(field, text,
                    [field](std::string_view value) { return parse_number(field, value); });
}

Axis parse_axis(std::string_view field, std::string_view text, const NumberReader& number,
                RangeEnd standing) {
  const std::vector<std::string_view> parts = split(text, ',');
  const bool colons = text.find(':') != std::string_view::npos;
  const auto at_most_one = [](std::string_view part) { return std::ranges::count(part, ':') <= 1; };
  if (colons && standing != RangeEnd::none && std::ranges::all_of(parts, at_most_one)) {
    std::vector<Interval> ranges;
    ranges.reserve(parts.size());
    for (const std::string_view part : parts) {
      if (part.find(':') == std::string_view::npos) {
        const double value = number(part);
        ranges.push_back({value, value});
      } else {
        ranges.push_back(parse_range(field, part, number));
      }
    }
    return {ranges, standing};
  }
  if (colons) {
    return parse_steps(field, text, number);
  }
  std::vector<double> values;
  values.reserve(parts.size());
  for (const std::string_view part : parts) {
    values.push_back(number(part));
  }
  return Axis(std::move(values));
}

Interval parse_range(std::string_view field, std::string_view text, const NumberReader& number) {
  const std::vector<std::string_view> ends = split(text, ':');
  if (ends.size() != 2 || ends[0].empty() || ends[1].empty()) {
    throw InputError(std::string(field), std::string(text),
                     "must be a number, or a range LOW:HIGH");
  }
  const Interval range{number(ends[0]), number(ends[1])};
  if (!(range.low <= range.high && range.low >= 0)) {
    throw InputError(std::string(field), std::string(text),
                     "must be a range LOW:HIGH with 0 <= LOW <= HIGH, each with its unit, if any");
  }
  return range;
}

}  // namespace stillpoint::sweep
