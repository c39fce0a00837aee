// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::cli {

/// The values that one input of a sweep takes, in order: numbers one by one, or a range of which
/// only the ends and the count are kept.
class Axis {
 public:
  enum class Spacing { linear, logarithmic };

  /// At least one number.
  explicit Axis(std::vector<double> values);
  /// `count` values, both ends among them; a single one is the first. Logarithmic: both ends > 0.
  Axis(double first, double last, std::int64_t count, Spacing spacing);

  [[nodiscard]] std::int64_t size() const { return size_; }
  /// Value i, 0 <= i < size(). Of a linear range what numpy.linspace gives, to the last bit.
  [[nodiscard]] double operator[](std::int64_t i) const;
  /// The least and the largest value.
  [[nodiscard]] std::pair<double, double> ends() const;
  /// How a range is divided; empty for numbers one by one.
  [[nodiscard]] std::optional<Spacing> spacing() const;
  /// As on the command line, with every digit.
  [[nodiscard]] std::string text() const;

 private:
  std::vector<double> values_;  ///< of a range: first and last
  std::int64_t size_;
  bool range_;
  Spacing spacing_{Spacing::linear};
};

/// "3", "first:last:count", "first:last:count:log" or "3,4,7". Throws InputError that names the
/// field.
[[nodiscard]] Axis parse_axis(std::string_view field, std::string_view text);

}  // namespace stillpoint::cli
