// SPDX-License-Identifier: MIT
#include "doubtful_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace stillpoint::cli {

namespace {

/// A stroke is compared with V0/omega, the stroke without friction. A damper exists for strokes
/// from 0.71 of it and is of no use above 1, so a factor of 20 either way is no design.
constexpr double far_from_one = 20;
/// What a likely unit must make of it.
constexpr double near_one = 3;
/// A motion of more than 30 m without friction is no isolator's; this is as likely as any.
constexpr double longest_m = 30;
constexpr double likely_m = 0.1;
constexpr double likely_factor = 30;
/// A notch that takes more than this many times the energy of the hit was given in another unit.
constexpr double far_beyond = 20;
/// A pulse longer than this many natural periods is no pulse.
constexpr double longest_pulse = 10;

/// What dimensionless ratios are made of, in SI units.
struct Values {
  std::optional<double> velocity, period, frequency, stiffness, mass, stroke, x0, gravity;

  [[nodiscard]] std::optional<double> omega() const {
    if (period) {
      return 2 * std::numbers::pi / *period;
    }
    if (frequency) {
      return 2 * std::numbers::pi * *frequency;
    }
    return stiffness && mass ? std::optional(std::sqrt(*stiffness / *mass)) : std::nullopt;
  }
  /// The largest displacement without friction.
  [[nodiscard]] std::optional<double> reach() const {
    const auto w = omega();
    const double by_velocity = w && velocity ? std::abs(*velocity) / *w : 0;
    const double most = std::max(by_velocity, std::abs(x0.value_or(0)));
    return w && most > 0 ? std::optional(most) : std::nullopt;
  }
};

/// An option, where its value stands, and the range that it mostly has.
struct Source {
  std::string_view option;
  std::optional<double> Values::*value;
  double least;
  double most;
};

constexpr std::array sources{
    Source{"max-displacement", &Values::stroke, 1e-3, 3},
    Source{"velocity", &Values::velocity, 1e-2, 10},
    Source{"period", &Values::period, 1e-2, 20},
    Source{"natural-frequency", &Values::frequency, 5e-2, 100},
    Source{"stiffness", &Values::stiffness, 1e3, 1e12},
    Source{"mass", &Values::mass, 1, 1e9},
    Source{"x0-m", &Values::x0, 1e-3, 3},
};

Values values_of(const Settings& settings) {
  Values values;
  for (const Source& source : sources) {
    values.*source.value = settings.number(source.option);
  }
  values.gravity = settings.number("gravity").value_or(9.80665);
  return values;
}

/// How many powers of ten a value is outside of its usual range.
double outside(const Source& source, double value) {
  return std::max({0.0, std::log10(source.least / value), std::log10(value / source.most)});
}

/// "; did you mean 150mm?" for the option that was given without a unit and of which another unit
/// makes `ratio` likely; of several the one that is furthest from what is usual, then the one that
/// makes the ratio nearest to 1. Else "".
template <class Ratio>
std::string likely_unit(const Settings& settings, const Values& values, double factor,
                        const Ratio& ratio) {
  std::string found;
  std::pair<double, double> best{-1, 0};
  for (const Source& source : sources) {
    const auto value = values.*source.value;
    if (!value || *value == 0 || settings.with_unit(source.option)) {
      continue;
    }
    for (const records::Unit& unit :
         records::units_of(find_option(source.option)->traits.dimension)) {
      Values now = values;
      now.*source.value = *value * std::pow(10, unit.power_of_ten);
      const double then = std::abs(std::log(ratio(now)));
      const std::pair rank{outside(source, std::abs(*value)), -then};
      if (unit.power_of_ten != 0 && then < std::log(factor) && rank > best) {
        best = rank;
        found = fmt::format("; did you mean --{} {}{}?", source.option, *value, unit.name);
      }
    }
  }
  return found;
}

std::optional<std::string> doubtful_stroke(const Settings& settings, const Values& values) {
  const auto reach = values.reach();
  if (!values.stroke || !reach || *values.stroke <= 0) {
    return std::nullopt;
  }
  const auto ratio = [](const Values& now) { return *now.stroke / *now.reach(); };
  const double now = ratio(values);
  if (now <= far_from_one && now >= 1 / far_from_one) {
    return std::nullopt;
  }
  return fmt::format(
      "max-displacement = {} m is {:.3g} times V0/omega = {:.3g} m, the stroke "
      "without friction{}",
      *values.stroke, now, *reach, likely_unit(settings, values, near_one, ratio));
}

std::optional<std::string> doubtful_reach(const Settings& settings, const Values& values) {
  const auto ratio = [](const Values& now) {
    return now.stroke.value_or(now.reach().value_or(likely_m)) / likely_m;
  };
  const double length = ratio(values) * likely_m;
  if (length <= longest_m) {
    return std::nullopt;
  }
  const std::string unit = likely_unit(settings, values, likely_factor, ratio);
  return values.stroke
             ? fmt::format("max-displacement = {} m is longer than any stroke{}", length, unit)
             : fmt::format("the motion reaches {:.3g} m without friction{}", length, unit);
}

/// The notch against the energy of the hit: g Delta against V0^2/2.
std::optional<std::string> doubtful_notch(const Settings& settings, const Values& values,
                                          std::string_view option) {
  const auto notch = settings.number(option);
  if (!notch || !values.velocity || *values.velocity == 0 || values.x0.value_or(0) != 0) {
    return std::nullopt;
  }
  const double hit = *values.velocity * *values.velocity / (2 * *values.gravity);
  if (*notch <= far_beyond * hit) {
    return std::nullopt;
  }
  const bool millimetres = !settings.with_unit(option) && *notch * 1e-3 <= near_one * hit;
  return fmt::format("{} = {} m takes {:.3g} times the energy of the hit at each passage{}", option,
                     *notch, *notch / hit,
                     millimetres ? fmt::format("; did you mean --{} {}mm?", option, *notch) : "");
}

std::optional<std::string> doubtful_pulse(const Settings& settings, const Values& values) {
  const auto pulse = settings.number("pulse-duration");
  const auto omega = values.omega();
  if (!pulse || !omega) {
    return std::nullopt;
  }
  const double period = 2 * std::numbers::pi / *omega;
  if (*pulse <= longest_pulse * period) {
    return std::nullopt;
  }
  const bool milliseconds = !settings.with_unit("pulse-duration") && *pulse * 1e-3 <= period;
  return fmt::format(
      "pulse-duration = {} s is {:.3g} natural periods{}", *pulse, *pulse / period,
      milliseconds ? fmt::format("; did you mean --pulse-duration {}ms?", *pulse) : "");
}

/// g itself, within a percent, as the peak of what is given in g.
std::optional<std::string> doubtful_peak(const Settings& settings) {
  const auto k = settings.number("k");
  const bool is_gravity = k && std::abs(*k / 9.80665 - 1) <= 0.01;
  if (!is_gravity || settings.with_unit("k")) {
    return std::nullopt;
  }
  return fmt::format("k = {} is in g, so the load is {:.3g} m/s2; did you mean --k 1?", *k,
                     *k * 9.80665);
}

}  // namespace

std::vector<std::string> doubtful_values(Command command, const Settings& all) {
  Settings settings;
  for (const auto& [name, value] : all.values()) {
    const Option& option = *find_option(name);
    if (option.serves(command) && std::holds_alternative<double>(value)) {
      settings.copy(option, all);
    }
  }
  const Values values = values_of(settings);
  std::vector<std::string> warnings;
  const auto add = [&warnings](const std::optional<std::string>& warning) {
    if (warning) {
      warnings.push_back(*warning);
    }
  };
  const auto stroke = doubtful_stroke(settings, values);
  add(stroke ? stroke : doubtful_reach(settings, values));
  add(doubtful_notch(settings, values, "delta-m"));
  add(doubtful_notch(settings, values, "delta-max-m"));
  add(doubtful_pulse(settings, values));
  add(doubtful_peak(settings));
  return warnings;
}

}  // namespace stillpoint::cli
