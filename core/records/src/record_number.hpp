// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace stillpoint::cli {

enum class NumberFault { none, no_number, not_finite, out_of_range };

struct ScannedNumber {
  double value{0};
  NumberFault fault{NumberFault::none};
};

/// A number as C, Fortran and spreadsheets write it: -.123E-03, +5., 1.2D-3, 7d2. The whole of
/// `text` must be the number.
///
/// Fortran leaves the E out where the exponent takes three digits: 0.1234567-100. That is read
/// where it can be nothing else: a decimal point, then a sign and exactly three digits at the end.
/// Any other sign inside a number (0.12-0.34, 12-100) makes it no number.
[[nodiscard]] ScannedNumber scan_number(std::string_view text);

/// What is wrong, to stand behind the text: "is not a number". For `none`, "".
[[nodiscard]] std::string_view explanation(NumberFault fault) noexcept;

}  // namespace stillpoint::cli
