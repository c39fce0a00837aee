// SPDX-License-Identifier: MIT
#pragma once

// Numbers as people read them.

#include <optional>
#include <string>
#include <string_view>

namespace stillpoint::report {

/// Six significant digits: "0.259325", "1.2e-09".
[[nodiscard]] std::string digits(double value);
/// Four, without an exponent below a million: "0.2593", "19240".
[[nodiscard]] std::string few_digits(double value);
/// Five digits, the unit and the prefix that fits: "12.1 mm", "3.46 kN"; lengths in m or mm.
[[nodiscard]] std::string with_unit(double value, std::string_view unit, int digits = 5);
/// low <= 1e-6 high: of two sizes, where the lower end is less than anyone can build or measure.
[[nodiscard]] bool begins_at_nothing(double low, double high);
/// The digits of a limit that an input copied from a report must meet.
inline constexpr int every_digit = 10;
/// That many digits, rounded up or down so that an input set to them meets the limit.
[[nodiscard]] std::string limit_digits(double value, bool upwards, int shown = every_digit);
/// As many digits as hold both ends of an interval, rounded inwards, to 2 % of its width, at least
/// the fewest.
[[nodiscard]] int interval_places(double low, double high, int fewest = 3);
/// "0.341 to 0.429": rounded inwards to that many; "up to 0.429" if it begins at nothing.
[[nodiscard]] std::string interval_digits(double low, double high, int fewest = 3);
inline constexpr int digits_of_double = 17;
/// The least number of digits, from `fewest` on, that is enough; else all that a double has.
template <class Enough>
[[nodiscard]] int digits_until(int fewest, const Enough& enough) {
  while (fewest < digits_of_double && !enough(fewest)) {
    ++fewest;
  }
  return fewest;
}
/// A number of the range that six digits write, or as many as it takes.
[[nodiscard]] double decimal_within(double low, double high);
/// "1 turning point", "2 turning points", with every digit up to 2^53, six of larger counts; or
/// "none".
[[nodiscard]] std::string plural(const std::optional<double>& count, std::string_view one);

}  // namespace stillpoint::report
