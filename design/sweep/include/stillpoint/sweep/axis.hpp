// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/quantity.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::sweep {

/// The values of one input of a sweep, in order: single numbers, or a range, of which only the ends
/// and the count are kept.
class Axis {
 public:
  enum class Spacing { linear, logarithmic };

  /// At least one number.
  explicit Axis(std::vector<double> values);
  /// `count` values including both ends, at least 1; a single one is `first`. A logarithmic range
  /// has both ends above 0.
  Axis(double first, double last, std::int64_t count, Spacing spacing);

  [[nodiscard]] std::int64_t size() const { return size_; }
  /// Value i, 0 <= i < size(). A linear range has the values of numpy.linspace, to the last bit.
  [[nodiscard]] double operator[](std::int64_t i) const;
  /// The smallest and the largest value.
  [[nodiscard]] std::pair<double, double> ends() const;
  /// How a range is divided; empty for single numbers.
  [[nodiscard]] std::optional<Spacing> spacing() const;
  /// What parse_axis reads back, with every digit.
  [[nodiscard]] std::string text() const;

 private:
  std::vector<double> values_;  ///< of a range: first and last
  std::int64_t size_;
  bool range_;
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

/// The same where `number` reads each number, which may carry a unit.
using NumberReader = std::function<double(std::string_view text)>;
[[nodiscard]] Axis parse_axis(std::string_view field, std::string_view text,
                              const NumberReader& number);

}  // namespace stillpoint::sweep
