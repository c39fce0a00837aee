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
  struct Prefix {
    double factor;
    std::string_view sign;
  };
  static constexpr std::array prefixes{Prefix{1e9, "G"}, Prefix{1e6, "M"},  Prefix{1e3, "k"},
                                       Prefix{1, ""},    Prefix{1e-3, "m"}, Prefix{1e-6, "u"},
                                       Prefix{1e-9, "n"}};
  // As it will be displayed: 0.99999999 mm is 1 mm, not 1000 um.
  const double magnitude = decimal(std::abs(value), digits);
  // For lengths neither kilometres nor micrometres, for times seconds down to a thousandth, as in
  // tables: those of one report compare at a glance.
  const bool length = unit == "m";
  const bool time = unit == "s";
  const auto* const fitting = std::ranges::find_if(prefixes, [&](const Prefix& now) {
    const bool least =
        (length && now.factor == 1e-3) || (time && now.factor == 1 && magnitude >= 1e-3);
    const bool unusual = (length || time) && now.factor > 1;
    return (magnitude >= now.factor || least) && !unusual;
  });
  const bool in_range = magnitude >= 1e-9 && magnitude < 1e12 && fitting != prefixes.end();
  const auto [factor, sign] = in_range ? *fitting : Prefix{1, ""};
  return fmt::format("{:.{}g} {}{}", value / factor, digits, sign, unit);
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

std::string interval_digits(double low, double high, int fewest) {
  constexpr double lost = 0.02;
  if (!(low < high)) {
    return fmt::format("{}", high);
  }
  const auto from = [low](int digits) {
    return digits < digits_of_double ? decimal(low, digits, Rounding::up) : low;
  };
  const auto to = [high](int digits) {
    return digits < digits_of_double ? decimal(high, digits, Rounding::down) : high;
  };
  const int shown = digits_until(fewest, [&](int digits) {
    return std::max(from(digits) - low, high - to(digits)) <= lost * (high - low);
  });
  return begins_at_nothing(low, high)
             ? fmt::format("up to {:.{}g}", to(shown), shown)
             : fmt::format("{0:.{2}g} to {1:.{2}g}", from(shown), to(shown), shown);
}

std::string plural(const std::optional<double>& count, std::string_view one) {
  constexpr double exact = 9007199254740992;  // 2^53
  const std::string number = !count            ? "none"
                             : *count <= exact ? fmt::format("{:.0f}", *count)
                                               : digits(*count);
  return fmt::format("{} {}{}", number, one, count == 1.0 ? "" : "s");
}

}  // namespace stillpoint::report
