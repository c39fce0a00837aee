// SPDX-License-Identifier: MIT
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

namespace stillpoint::records {

namespace {

bool is_sign(char c) {
  return c == '+' || c == '-';
}

/// Fortran's exponents in C's form; the text itself if there is nothing to change.
std::string with_c_exponent(std::string_view text) {
  std::string result(text);
  const std::size_t d = result.find_first_of("dD");
  if (d != std::string::npos) {
    result[d] = 'e';
    return result;
  }
  constexpr std::size_t exponent_length = 4;  // a sign and three digits
  if (text.size() > exponent_length) {
    const std::size_t sign = text.size() - exponent_length;
    const bool has_point = text.substr(0, sign).find('.') != std::string_view::npos;
    if (is_sign(text[sign]) && has_point) {
      result.insert(sign, 1, 'e');  // still not a number: no mantissa, or no digits around it
    }
  }
  return result;
}

}  // namespace

ScannedNumber scan_number(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
  }
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc::invalid_argument || stop != end) {
    return {0, NumberFault::no_number};
  }
  if (error == std::errc::result_out_of_range) {
    return {0, NumberFault::out_of_range};
  }
  return {value, std::isfinite(value) ? NumberFault::none : NumberFault::not_finite};
}

ScannedNumber scan_fortran_number(std::string_view text) {
  if (text.size() > 1 && is_sign(text[0]) && is_sign(text[1])) {
    return {0, NumberFault::no_number};
  }
  ScannedNumber scanned = scan_number(text);
  if (scanned.fault == NumberFault::no_number) {
    scanned = scan_number(with_c_exponent(text));
  }
  return std::fpclassify(scanned.value) == FP_SUBNORMAL
             ? ScannedNumber{0, NumberFault::out_of_range}
             : scanned;
}

std::string_view explanation(NumberFault fault) noexcept {
  switch (fault) {
    case NumberFault::none:
      break;
    case NumberFault::no_number:
      return "is not a number";
    case NumberFault::not_finite:
      return "is not a finite number";
    case NumberFault::out_of_range:
      return "is out of range, must be 0 or have a magnitude from 2.2e-308 to 1.8e308";
  }
  return "";
}

std::string_view comma_note(std::string_view text) noexcept {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto ends_word = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
  for (std::size_t at = 0; at + 1 < text.size(); ++at) {
    if (text[at] == ',' && is_digit(text[at + 1]) && !(at > 0 && ends_word(text[at - 1]))) {
      return "; write a decimal comma as a point, and thousands without a comma";
    }
  }
  return "";
}

namespace {

/// "; 10 % is 0.1" for "10%" or "10 %"; "" for any other text.
std::string without_percent(std::string_view text) {
  if (!text.ends_with('%')) {
    return "";
  }
  const std::string_view number = trimmed(text.substr(0, text.size() - 1));
  const ScannedNumber scanned = scan_number(number);
  return scanned.fault == NumberFault::none
             ? fmt::format("; {} % is {}", number, scanned.value / 100)
             : "";
}

}  // namespace

double parse_number(std::string_view field, std::string_view text) {
  const ScannedNumber scanned = scan_number(text);
  if (scanned.fault == NumberFault::out_of_range) {
    throw InputError(std::string(field), std::string(text),
                     "must have a magnitude that a double can hold, 2.2e-308 to 1.8e308");
  }
  if (scanned.fault != NumberFault::none) {
    throw InputError(std::string(field), quoted(text),
                     scanned.fault == NumberFault::not_finite
                         ? "must be a finite number"
                         : fmt::format("must be a number{}", without_percent(text)));
  }
  return scanned.value;
}

std::optional<std::int64_t> scan_integer(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size()) {
    return value;
  }
  constexpr double most = 1e18;  // below 2^63, or the cast is undefined
  const ScannedNumber scanned = scan_number(text);
  if (scanned.fault != NumberFault::none || scanned.value != std::floor(scanned.value) ||
      std::abs(scanned.value) > most) {
    return std::nullopt;
  }
  return static_cast<std::int64_t>(scanned.value);
}

std::int64_t parse_integer(std::string_view field, std::string_view text) {
  if (const auto value = scan_integer(text)) {
    return *value;
  }
  const ScannedNumber scanned = scan_number(text);
  if (scanned.fault != NumberFault::none) {
    throw InputError(std::string(field), quoted(text), "must be a whole number");
  }
  const bool whole = scanned.value == std::floor(scanned.value);
  throw InputError(
      std::string(field), std::string(text),
      whole ? "must be a whole number of at most 18 digits" : "must be a whole number");
}

}  // namespace stillpoint::records
