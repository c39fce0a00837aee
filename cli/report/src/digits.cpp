// SPDX-License-Identifier: MIT
#include <stillpoint/report/digits.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stillpoint::report {

namespace {

/// As `shown` writes it, rounded up or down. The value is not negative.
template <class Shown>
std::string rounded(double value, bool upwards, const Shown& shown) {
  std::string text = shown(value);
  const auto misses = [&] { return upwards ? std::stod(text) < value : std::stod(text) > value; };
  // The nearest is at most half of its last digit away.
  for (double part = 0x1p-52; misses(); part *= 2) {
    text = shown(value * (upwards ? 1 + part : 1 - part));
  }
  return text;
}

}  // namespace

std::string digits(double value) {
  return fmt::format("{:.6g}", value);
}

std::string digits(const std::optional<double>& value) {
  return value ? digits(*value) : "none";
}

std::string few_digits(double value) {
  constexpr double million = 1e6;
  std::string text = fmt::format("{:.4g}", value);
  const double shown = std::stod(text);
  return std::abs(shown) >= 1 && std::abs(shown) < million ? fmt::format("{:.6g}", shown) : text;
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
  const double magnitude = std::stod(fmt::format("{:.{}g}", std::abs(value), digits));
  const bool in_range = magnitude >= 1e-9 && magnitude < 1e12;
  if (in_range) {
    for (const Prefix& prefix : prefixes) {
      // For lengths neither kilometres nor micrometres, so that those of one report compare at a
      // glance; for times no kiloseconds.
      const bool length = unit == "m";
      const bool least = length && prefix.factor == 1e-3;
      const bool unusual = (length || unit == "s") && prefix.factor > 1;
      if ((magnitude >= prefix.factor || least) && !unusual) {
        return fmt::format("{:.{}g} {}{}", value / prefix.factor, digits, prefix.sign, unit);
      }
    }
  }
  return fmt::format("{:.{}g} {}", value, digits, unit);
}

bool begins_at_nothing(double low, double high) {
  constexpr double nothing = 1e-6;
  return low <= nothing * high;
}

std::string limit_digits(double value, bool upwards, int shown) {
  return rounded(value, upwards,
                 [shown](double now) { return fmt::format("{:.{}g}", now, shown); });
}

double end_or_asked(double end, double asked) {
  const auto alike = [asked](double value) { return std::abs(value - asked) <= 1e-12 * asked; };
  const double decimal = std::stod(fmt::format("{:.9g}", asked));
  return !alike(end) ? end : alike(decimal) ? decimal : asked;
}

std::string digits_within(double low, double high) {
  constexpr int every = 17;  // that a double has
  int shown = 6;
  std::string text = limit_digits(high, false, shown);
  while (std::stod(text) < low && shown < every) {
    text = limit_digits(high, false, ++shown);
  }
  return text;
}

std::string range_digits(double low, double high) {
  constexpr int shown = 6;
  const std::string to = limit_digits(high, false, shown);
  if (begins_at_nothing(low, high)) {
    return "up to " + to;
  }
  if (!(low < high)) {
    return fmt::format("{}", high);
  }
  const std::string from = limit_digits(low, true, shown);
  return std::stod(from) < std::stod(to) ? fmt::format("{} to {}", from, to)
                                         : interval_digits(low, high);
}

std::string interval_digits(double low, double high) {
  constexpr int fewest = 3;
  constexpr int every = 17;  // that a double has
  constexpr double lost = 0.02;
  for (int shown = fewest; shown < every; ++shown) {
    const auto with_zeros = [shown](double now) { return fmt::format("{:#.{}g}", now, shown); };
    const std::string from = rounded(low, true, with_zeros);
    const std::string to = rounded(high, false, with_zeros);
    if (std::max(std::stod(from) - low, high - std::stod(to)) <= lost * (high - low)) {
      return begins_at_nothing(low, high) ? "up to " + to : fmt::format("{} to {}", from, to);
    }
  }
  return fmt::format("{} to {}", low, high);
}

std::string whole(const std::optional<double>& count) {
  constexpr double exact = 9007199254740992;  // 2^53
  if (!count) {
    return "none";
  }
  return *count <= exact ? fmt::format("{:.0f}", *count) : digits(*count);
}

std::string plural(const std::optional<double>& count, std::string_view one) {
  return fmt::format("{} {}{}", whole(count), one, count == 1.0 ? "" : "s");
}

}  // namespace stillpoint::report
