// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/interval.hpp>
#include <stillpoint/sweep/quantity.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::sweep {

/// Which end of a range LOW:HIGH stands for it, for example as the motion that is shown.
enum class RangeEnd { none, low, high };

/// The values of one input of a sweep, in order: single numbers, or steps from a first to a last,
/// of which only the ends and the count are kept. A value may be a range LOW:HIGH, of which one end
/// stands for it.
class Axis {
 public:
  enum class Spacing { linear, logarithmic };

  /// At least one number.
  explicit Axis(std::vector<double> values);
  /// At least one range; for a number both ends are the same.
  Axis(const std::vector<Interval>& ranges, RangeEnd standing);
  /// `count` values including both ends, at least 1; a single one is `first`. A logarithmic range
  /// has both ends above 0.
  Axis(double first, double last, std::int64_t count, Spacing spacing);

  [[nodiscard]] std::int64_t size() const { return size_; }
  /// Value i, 0 <= i < size(). A linear range has the values of numpy.linspace, to the last bit.
  [[nodiscard]] double operator[](std::int64_t i) const;
  /// The smallest and the largest value.
  [[nodiscard]] Interval ends() const;
  /// One number, not a range.
  [[nodiscard]] bool is_number() const { return size_ == 1 && !has_ranges(); }
  /// The other ends of the values, if some of them are ranges.
  [[nodiscard]] bool has_ranges() const { return !others_.empty(); }
  [[nodiscard]] Axis other_ends() const { return Axis(others_); }
  /// Each value divided by this positive number.
  [[nodiscard]] Axis over(double divisor) const;
  /// The spacing of the steps; empty for single numbers.
  [[nodiscard]] std::optional<Spacing> spacing() const;
  /// Text that parse_axis reads back, with every digit.
  [[nodiscard]] std::string text() const;

 private:
  std::vector<double> values_;    ///< for steps: first and last
  std::vector<double> others_{};  ///< of ranges
  std::int64_t size_;
  bool steps_;
  Spacing spacing_{Spacing::linear};
};

/// What one input of a sweep may be.
struct SweepAxis {
  Quantity quantity{};
  Axis axis;
};

/// "3", "first:last:count", "first:last:count:log" or "3,4,7". Throws InputError, which names the
/// field.
[[nodiscard]] Axis parse_axis(std::string_view field, std::string_view text);

/// The same; `number` reads each number, which may have a unit. If an end stands for it, a number
/// may be a range: "0.9:1.1", "1,0.9:1.1,0.8:1.2".
using NumberReader = std::function<double(std::string_view text)>;
[[nodiscard]] Axis parse_axis(std::string_view field, std::string_view text,
                              const NumberReader& number, RangeEnd standing = RangeEnd::none);

/// "0.9:1.1". Throws InputError unless 0 <= LOW <= HIGH.
[[nodiscard]] Interval parse_range(std::string_view field, std::string_view text,
                                   const NumberReader& number);

}  // namespace stillpoint::sweep
