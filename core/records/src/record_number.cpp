// SPDX-License-Identifier: MIT
#include "record_number.hpp"

#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

namespace stillpoint::cli {

namespace {

bool is_sign(char c) {
  return c == '+' || c == '-';
}

ScannedNumber scan_c_number(std::string_view text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc::invalid_argument || stop != end) {
    return {0, NumberFault::no_number};
  }
  if (error == std::errc::result_out_of_range) {
    return {0, NumberFault::out_of_range};
  }
  if (std::fpclassify(value) == FP_SUBNORMAL) {
    return {0, NumberFault::out_of_range};
  }
  return {value, std::isfinite(value) ? NumberFault::none : NumberFault::not_finite};
}

/// Fortran's exponents in C's form; the text itself where there is nothing to change.
std::string with_c_exponent(std::string_view text) {
  std::string result(text);
  const std::size_t d = result.find_first_of("dD");
  if (d != std::string::npos) {
    result[d] = 'e';
    return result;
  }
  constexpr std::size_t exponent_length = 4;
  if (text.size() > exponent_length) {
    const std::size_t sign = text.size() - exponent_length;
    const bool has_point = text.substr(0, sign).find('.') != std::string_view::npos;
    if (is_sign(text[sign]) && has_point) {
      result.insert(sign, 1, 'e');  // what is no mantissa or exponent about it is no number then
    }
  }
  return result;
}

}  // namespace

ScannedNumber scan_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && !is_sign(text[1])) {
    text.remove_prefix(1);
  }
  const ScannedNumber plain = scan_c_number(text);
  return plain.fault == NumberFault::no_number ? scan_c_number(with_c_exponent(text)) : plain;
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

}  // namespace stillpoint::cli
