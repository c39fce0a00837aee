// SPDX-License-Identifier: MIT
#include <stillpoint/records/decimal.hpp>
#include <stillpoint/report/digits.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stillpoint::report {

using records::decimal;
using records::Rounding;

std::string digits(double value) {
  return fmt::format("{:.6g}", value);
}

std::string few_digits(double value) {
  constexpr double million = 1e6;
  const double shown = decimal(value, 4);
  return std::abs(shown) >= 1 && std::abs(shown) < million ? fmt::format("{:.6g}", shown)
                                                           : fmt::format("{:.4g}", shown);
}

std::string with_unit(double value, std::string_view unit, int digits) {
  constexpr std::array factors{1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9};
  constexpr std::string_view signs = "num kMG";
  constexpr int milli = 2;
  constexpr int one = 3;
  // As it will be displayed: 0.99999999 mm is 1 mm, not 1000 um.
  const double magnitude = decimal(std::abs(value), digits);
  // For lengths neither kilometres nor micrometres, for times seconds down to a thousandth, as in
  // tables: those of one report compare at a glance.
  const int least = unit == "m" ? milli : unit == "s" && magnitude >= 1e-3 ? one : 0;
  const int most = unit == "m" || unit == "s" ? one : one + one;
  const auto fitting =
      static_cast<int>(std::ranges::upper_bound(factors, magnitude) - factors.begin()) - 1;
  const int at = fitting < 0 || magnitude >= 1e12 ? one : std::clamp(fitting, least, most);
  return fmt::format("{:.{}g} {}{}", value / factors.at(static_cast<std::size_t>(at)), digits,
                     at == one ? "" : signs.substr(static_cast<std::size_t>(at), 1), unit);
}

bool begins_at_nothing(double low, double high) {
  constexpr double nothing = 1e-6;
  return low <= nothing * high;
}

std::string limit_digits(double value, bool upwards, int shown) {
  return fmt::format("{:.{}g}", decimal(value, shown, upwards ? Rounding::up : Rounding::down),
                     shown);
}

double decimal_within(double low, double high) {
  const auto rounded = [high](int digits) { return decimal(high, digits, Rounding::down); };
  return rounded(digits_until(6, [&](int digits) { return rounded(digits) >= low; }));
}

int interval_places(double low, double high, int fewest) {
  constexpr double lost = 0.02;
  return digits_until(fewest, [&](int digits) {
    return std::max(decimal(low, digits, Rounding::up) - low,
                    high - decimal(high, digits, Rounding::down)) <= lost * (high - low);
  });
}

std::string interval_digits(double low, double high, int fewest) {
  if (!(low < high)) {
    return fmt::format("{}", high);
  }
  const int shown = interval_places(low, high, fewest);
  const std::string to = limit_digits(high, false, shown);
  return begins_at_nothing(low, high) ? "up to " + to
                                      : fmt::format("{} to {}", limit_digits(low, true, shown), to);
}

std::string plural(const std::optional<double>& count, std::string_view one) {
  constexpr double exact = 9007199254740992;  // 2^53
  const std::string number = !count            ? "none"
                             : *count <= exact ? fmt::format("{:.0f}", *count)
                                               : digits(*count);
  return fmt::format("{} {}{}", number, one, count == 1.0 ? "" : "s");
}

}  // namespace stillpoint::report
