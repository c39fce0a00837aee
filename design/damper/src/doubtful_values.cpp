// SPDX-License-Identifier: MIT
#include <stillpoint/design/doubtful_values.hpp>
#include <stillpoint/records/units.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

namespace stillpoint::design {

namespace {

using records::Dimension;
using records::standard_gravity_m_per_s2;

/// A stroke is compared with V0/omega, the stroke without friction. A damper exists for strokes
/// from 0.71 of it and is useless above 1, so a factor of 20 either way is not a sensible task.
constexpr double far_from_one = 20;
/// What a likely unit must bring it to.
constexpr double near_one = 3;
/// A motion of more than 30 m without friction is not that of an isolator; this is a plausible one.
constexpr double longest_m = 30;
constexpr double likely_m = 0.1;
constexpr double likely_factor = 30;
/// A load that moves the mass so far without friction is not one that it is isolated from.
constexpr double longest_under_load_m = 5;
/// A notch that takes more than this many times the energy of the hit was given in another unit.
constexpr double far_beyond = 20;
/// A pulse longer than this many natural periods is not a pulse.
constexpr double longest_pulse = 10;

/// The quantities that make dimensionless ratios, in SI units.
struct Values {
  std::optional<double> velocity, period, frequency, stiffness, mass, stroke, x0;
  double gravity{standard_gravity_m_per_s2};
  std::optional<LoadReach> load;

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
    const double most = std::max({by_velocity, std::abs(x0.value_or(0)), load ? load->reach_m : 0});
    return w && most > 0 ? std::optional(most) : std::nullopt;
  }
};

/// A value, what it measures, its usual range, and where it is kept if it is part of a ratio. The
/// ranges span what isolators are built for, from an instrument to a tall building, and dampers:
/// wide, for a warning that is often wrong is not read.
struct Source {
  std::string_view name;
  Dimension dimension;
  double least;
  double most;
  std::optional<double> Values::*value{nullptr};
};

constexpr std::array sources{
    Source{"max-displacement", Dimension::length, 1e-3, 3, &Values::stroke},
    Source{"velocity", Dimension::velocity, 1e-2, 10, &Values::velocity},
    Source{"period", Dimension::time, 0.05, 5, &Values::period},
    Source{"natural-frequency", Dimension::frequency, 0.2, 20, &Values::frequency},
    Source{"stiffness", Dimension::stiffness, 10, 1e12, &Values::stiffness},
    Source{"mass", Dimension::mass, 1, 1e9, &Values::mass},
    Source{"x0-m", Dimension::length, 1e-3, 3, &Values::x0},
    Source{"delta-m", Dimension::length, 1e-6, 0.3},
    Source{"delta-max-m", Dimension::length, 1e-6, 0.3},
    Source{"residual-m", Dimension::length, 1e-6, 1},
    Source{"notch-width-m", Dimension::length, 1e-5, 1},
    Source{"hold", Dimension::gravities, 0, 2},
    Source{"f", Dimension::none, 0, 0.2},
    Source{"f-max", Dimension::none, 0, 0.2},
};
/// A value this many powers of ten outside its usual range was probably given in another unit.
constexpr double far_outside = 1;

std::optional<double> number(const GivenValues& given, std::string_view name) {
  const auto found = given.find(name);
  return found == given.end() ? std::nullopt : std::optional(found->second.value);
}

bool with_unit(const GivenValues& given, std::string_view name) {
  const auto found = given.find(name);
  return found != given.end() && found->second.with_unit;
}

Values values_of(const GivenValues& given) {
  Values values;
  for (const Source& source : sources) {
    if (source.value != nullptr) {
      values.*source.value = number(given, source.name);
    }
  }
  values.gravity = number(given, "gravity").value_or(values.gravity);
  return values;
}

/// How many powers of ten a value is outside its usual range.
double outside(const Source& source, double value) {
  return std::max({0.0, std::log10(source.least / value), std::log10(value / source.most)});
}

/// The value of a ratio that is furthest outside its usual range; null if none is.
const Source* strangest(const Values& values) {
  const Source* found = nullptr;
  double most = 0;
  for (const Source& source : sources) {
    const auto value = source.value == nullptr ? std::nullopt : values.*source.value;
    if (value && *value != 0 && outside(source, std::abs(*value)) > most) {
      most = outside(source, std::abs(*value));
      found = &source;
    }
  }
  return found;
}

/// Whether that is far outside, which is a doubt of its own.
bool is_far(const Values& values, const Source* source) {
  return source != nullptr && outside(*source, std::abs(*(values.*source->value))) > far_outside;
}

/// The value given without a unit for which another unit makes `ratio` likely, in that unit; of
/// several, the one furthest from the usual, then the one that brings the ratio closest to 1.
template <class Ratio>
std::optional<Doubt::Meant> likely_unit(const GivenValues& given, const Values& values,
                                        double factor, const Ratio& ratio) {
  std::optional<Doubt::Meant> found;
  std::pair<double, double> best{-1, 0};
  if (const Source* const at_fault = strangest(values);
      at_fault != nullptr && with_unit(given, at_fault->name)) {
    return found;
  }
  for (const Source& source : sources) {
    const auto value = source.value == nullptr ? std::nullopt : values.*source.value;
    if (!value || *value == 0 || with_unit(given, source.name)) {
      continue;
    }
    for (const records::Unit& unit : records::units_of(source.dimension)) {
      Values now = values;
      now.*source.value = *value * std::pow(10, unit.power_of_ten);
      const double then = std::abs(std::log(ratio(now)));
      const std::pair rank{outside(source, std::abs(*value)), -then};
      if (unit.power_of_ten != 0 && then < std::log(factor) && rank > best) {
        best = rank;
        found = Doubt::Meant{std::string(source.name), *value, std::string(unit.name)};
      }
    }
  }
  return found;
}

/// The number of a value without a unit, in a unit that makes it likely.
std::optional<Doubt::Meant> in_unit(const GivenValues& given, std::string_view name, double value,
                                    std::string_view unit, bool likely) {
  return likely && !with_unit(given, name)
             ? std::optional(Doubt::Meant{std::string(name), value, std::string(unit)})
             : std::nullopt;
}

std::optional<Doubt> doubtful_stroke(const GivenValues& given, const Values& values) {
  const auto reach = values.reach();
  if (!values.stroke || !reach || *values.stroke <= 0) {
    return std::nullopt;
  }
  const auto ratio = [](const Values& now) { return *now.stroke / *now.reach(); };
  const double now = ratio(values);
  const Source* const at_fault = strangest(values);
  const bool said = is_far(values, at_fault) && at_fault->value != &Values::stroke &&
                    with_unit(given, at_fault->name);
  if (said || (now <= far_from_one && now >= 1 / far_from_one)) {
    return std::nullopt;
  }
  return Doubt{"max-displacement",
               fmt::format("max-displacement = {} m is {:.3g} times {}{:.3g} m, the stroke "
                           "without friction",
                           *values.stroke, now, values.load ? "" : "V0/omega = ", *reach),
               likely_unit(given, values, near_one, ratio)};
}

std::optional<Doubt> doubtful_reach(const GivenValues& given, const Values& values) {
  const auto ratio = [](const Values& now) {
    return now.stroke.value_or(now.reach().value_or(likely_m)) / likely_m;
  };
  const double length = ratio(values) * likely_m;
  if (length <= longest_m || (values.load && !values.stroke)) {
    return std::nullopt;
  }
  return Doubt{values.stroke ? "max-displacement" : "",
               values.stroke
                   ? fmt::format("max-displacement = {} m is longer than any stroke", length)
                   : fmt::format("the motion reaches {:.3g} m without friction", length),
               likely_unit(given, values, likely_factor, ratio)};
}

/// The load itself; in a design the stroke is compared with what it does.
std::optional<Doubt> doubtful_load(const GivenValues& given, const Values& values) {
  const auto k = number(given, "k");
  if (!k || !values.load || values.stroke || values.load->reach_m <= longest_under_load_m ||
      is_far(values, strangest(values))) {
    return std::nullopt;
  }
  return Doubt{"k", fmt::format("k = {} g moves the mass {:.3g} m without friction; more than {} m "
                                "is doubtful",
                                *k, values.load->reach_m, longest_under_load_m)};
}

/// The notch against the energy of the hit, g Delta against V0^2/2, or of any passage under the
/// load.
std::optional<Doubt> doubtful_notch(const GivenValues& given, const Values& values,
                                    std::string_view name) {
  const auto notch = number(given, name);
  const double speed =
      std::abs(values.velocity.value_or(0)) + (values.load ? values.load->speed_m_per_s : 0);
  if (!notch || speed == 0 || values.x0.value_or(0) != 0) {
    return std::nullopt;
  }
  const bool any_passage = values.load && !values.load->pulse;
  const double hit = speed * speed / (2 * values.gravity);
  if (*notch <= (any_passage ? 1 : far_beyond) * hit) {
    return std::nullopt;
  }
  const std::string energy =
      any_passage ? fmt::format("more than any passage under this load can have, {:.3g} m", hit)
                  : fmt::format("{:.3g} times the energy of the {} at each passage", *notch / hit,
                                values.load ? "pulse" : "hit");
  return Doubt{std::string(name), fmt::format("{} = {} m takes {}", name, *notch, energy),
               in_unit(given, name, *notch, "mm", *notch * 1e-3 <= near_one * hit)};
}

/// With a rest allowed wherever the mass may go nothing has to return.
std::optional<Doubt> doubtful_residual(const GivenValues& given, const Values& values) {
  constexpr std::string_view name = "residual-m";
  const auto residual = number(given, name);
  if (!residual || !values.stroke || *residual < *values.stroke) {
    return std::nullopt;
  }
  return Doubt{
      std::string(name),
      fmt::format("residual-m = {} m allows a rest anywhere within max-displacement = {} m",
                  *residual, *values.stroke),
      in_unit(given, name, *residual, "mm", *residual >= 1 && *residual * 1e-3 < *values.stroke)};
}

/// A notch that the mass never leaves is not one.
std::optional<Doubt> doubtful_width(const GivenValues& given, const Values& values) {
  constexpr std::string_view name = "notch-width-m";
  const auto width = number(given, name);
  const auto reach = values.reach();
  if (!width || !reach || *width <= 2 * *reach) {
    return std::nullopt;
  }
  return Doubt{std::string(name),
               fmt::format("{} = {} m is wider than the motion, which reaches {:.3g} m on either "
                           "side without friction",
                           name, *width, *reach),
               in_unit(given, name, *width, "mm", *width * 1e-3 <= *reach)};
}

std::optional<Doubt> doubtful_pulse(const GivenValues& given, const Values& values) {
  constexpr std::string_view name = "pulse-duration";
  const auto pulse = number(given, name);
  const auto omega = values.omega();
  if (!pulse || !omega) {
    return std::nullopt;
  }
  const double period = 2 * std::numbers::pi / *omega;
  if (*pulse <= longest_pulse * period) {
    return std::nullopt;
  }
  return Doubt{std::string(name),
               fmt::format("{} = {} s is {:.3g} natural periods", name, *pulse, *pulse / period),
               in_unit(given, name, *pulse, "ms", *pulse * 1e-3 <= period)};
}

/// g itself, within a percent, as a peak that should be in g.
std::optional<Doubt> doubtful_peak(const GivenValues& given) {
  const auto k = number(given, "k");
  if (!k || std::abs(*k / standard_gravity_m_per_s2 - 1) > 0.01 || with_unit(given, "k")) {
    return std::nullopt;
  }
  return Doubt{
      "k",
      fmt::format("k = {} is in g, so the load is {:.3g} m/s2", *k, *k * standard_gravity_m_per_s2),
      Doubt::Meant{"k", 1, ""}};
}

/// The unit that brings a value closest to the middle of its usual range; of a plain number, per
/// cent.
std::optional<Doubt::Meant> usual_unit(const Source& source, double value) {
  if (source.dimension == Dimension::none) {
    const double part = value / 100;
    return outside(source, part) < far_outside
               ? std::optional(Doubt::Meant{std::string(source.name), part, ""})
               : std::nullopt;
  }
  std::optional<Doubt::Meant> found;
  double nearest = HUGE_VAL;
  for (const records::Unit& unit : records::units_of(source.dimension)) {
    const double then = std::abs(value) * std::pow(10, unit.power_of_ten);
    const double apart = std::abs(std::log(then * then / source.least / source.most));
    if (outside(source, then) == 0 && apart < nearest) {
      nearest = apart;
      found = Doubt::Meant{std::string(source.name), value, std::string(unit.name)};
    }
  }
  return found;
}

std::optional<Doubt> doubtful_size(const GivenValues& given, const Source& source) {
  const auto value = number(given, source.name);
  if (!value || *value == 0 || outside(source, std::abs(*value)) <= far_outside) {
    return std::nullopt;
  }
  const auto units = records::units_of(source.dimension);
  const std::string unit = units.empty() ? "" : fmt::format(" {}", units.front().name);
  const std::string usual =
      source.least > 0
          ? fmt::format("far from the usual {:g} to {:g}{}", source.least, source.most, unit)
          : fmt::format("far above the usual values, which are at most {:g}{}", source.most, unit);
  return Doubt{std::string(source.name),
               fmt::format("{} = {}{} is {}", source.name, *value, unit, usual),
               with_unit(given, source.name) ? std::nullopt : usual_unit(source, *value)};
}

bool names(const Doubt& doubt, std::string_view name) {
  return doubt.name == name || (doubt.meant && doubt.meant->name == name);
}

bool in_metres(const GivenValues& given) {
  return std::ranges::any_of(sources, [&](const Source& source) {
    return source.dimension != Dimension::none && source.dimension != Dimension::gravities &&
           given.contains(source.name);
  });
}

}  // namespace

std::vector<Doubt> doubtful_values(const GivenValues& given, const std::optional<LoadReach>& load) {
  Values values = values_of(given);
  values.load = load;
  const auto stroke = doubtful_stroke(given, values);
  std::vector<Doubt> doubts;
  for (const std::optional<Doubt>& doubt :
       {stroke ? stroke : doubtful_reach(given, values), doubtful_load(given, values),
        doubtful_notch(given, values, "delta-m"), doubtful_notch(given, values, "delta-max-m"),
        doubtful_residual(given, values), doubtful_width(given, values),
        doubtful_pulse(given, values), doubtful_peak(given)}) {
    if (doubt) {
      doubts.push_back(*doubt);
    }
  }
  for (const Source& source : sources) {
    const auto doubt = in_metres(given) ? doubtful_size(given, source) : std::nullopt;
    if (doubt && std::ranges::none_of(
                     doubts, [&](const Doubt& known) { return names(known, source.name); })) {
      doubts.push_back(*doubt);
    }
  }
  return doubts;
}

}  // namespace stillpoint::design
