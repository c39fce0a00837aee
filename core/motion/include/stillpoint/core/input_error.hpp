// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace stillpoint {

/// Wrong input, found where it enters. The message names the field, the value and the bound, e.g.
/// "p = -1: must be a number from 1e-150 to 1e+150". It quotes only the beginning of a long value.
class InputError : public std::invalid_argument {
 public:
  InputError(std::string field, const std::string& value, const std::string& bound);
  InputError(std::string field, double value, const std::string& bound);

  /// "FIELD is missing: HINT"
  [[nodiscard]] static InputError missing(const std::string& field, const std::string& hint);

  /// The same error by another name of the field.
  [[nodiscard]] InputError named(const std::string& field) const;

  /// The same error in entry `index` of arrays: "f = -1: ..." becomes "f[17] = -1: ...".
  [[nodiscard]] InputError in_entry(std::ptrdiff_t index) const;

  [[nodiscard]] const std::string& field() const noexcept { return field_; }

 private:
  struct Whole {
    std::string message;
  };
  InputError(std::string field, const Whole& whole);

  std::string field_;
};

/// The input is valid, but the friction is so small that the motion has more half-cycles than
/// allowed.
class TooManyHalfCycles : public std::runtime_error {
 public:
  /// The motion has at most `bound` half-cycles; `limit` are allowed.
  TooManyHalfCycles(double bound, double limit);

  /// It has at least that many.
  [[nodiscard]] static TooManyHalfCycles at_least(double least, double limit);

  /// There are more than `limit` half-cycles up to the end of a trajectory.
  [[nodiscard]] static TooManyHalfCycles in_trajectory(double limit);

  /// Under an excitation the motion has more than `limit` half-cycles up to `tau`.
  [[nodiscard]] static TooManyHalfCycles under_excitation(double limit, double tau);

  /// The same error in entry `index` of arrays: "entry 17: ...".
  [[nodiscard]] TooManyHalfCycles in_entry(std::ptrdiff_t index) const;

  /// Empty where only the limit is known to be exceeded.
  [[nodiscard]] std::optional<double> bound() const noexcept { return bound_; }

 private:
  explicit TooManyHalfCycles(const std::string& message);

  std::optional<double> bound_;
};

/// Throws InputError unless `value` is a finite number with low <= value <= high.
void require_within(std::string_view field, double value, double low, double high);

}  // namespace stillpoint
