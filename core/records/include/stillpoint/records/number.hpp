// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace stillpoint::records {

enum class NumberFault { none, no_number, not_finite, out_of_range };

struct ScannedNumber {
  double value{0};
  NumberFault fault{NumberFault::none};
};

/// A number in decimal or exponent form, as C writes it, with or without a sign. The whole of
/// `text` must be the number.
[[nodiscard]] ScannedNumber scan_number(std::string_view text);

/// The same, or as Fortran and spreadsheets write it: -.123E-03, +5., 1.2D-3, 7d2. A subnormal
/// number is out of range.
///
/// Fortran leaves out the E of an exponent with three digits: 0.1234567-100. That is read if it can
/// mean nothing else: a decimal point, then a sign and exactly three digits at the end. Text with
/// any other sign inside (0.12-0.34, 12-100) is not a number.
[[nodiscard]] ScannedNumber scan_fortran_number(std::string_view text);

/// What is wrong, to follow the text in a message: "is not a number". For `none`, "".
[[nodiscard]] std::string_view explanation(NumberFault fault) noexcept;

/// What to say as well if a comma in `text` may belong to a number, as in 0,01 and 4,000, and does
/// not follow a word, as in NPTS,4000. Else "".
[[nodiscard]] std::string_view comma_note(std::string_view text) noexcept;

/// A whole number up to 1e18, "1000" or "1e3"; empty for any other text.
[[nodiscard]] std::optional<std::int64_t> scan_integer(std::string_view text);

/// The number that the value of a field stands for. Throws InputError, which names the field.
[[nodiscard]] double parse_number(std::string_view field, std::string_view text);
[[nodiscard]] std::int64_t parse_integer(std::string_view field, std::string_view text);

}  // namespace stillpoint::records
