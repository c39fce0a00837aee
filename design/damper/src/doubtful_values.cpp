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

double in_si(const records::Unit& unit) {
  return std::pow(10, unit.power_of_ten) * unit.times;
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
    const double then = std::abs(value) * in_si(unit);
    const double apart = std::abs(std::log(then * then / source.least / source.most));
    if (outside(source, then) == 0 && apart < nearest) {
      nearest = apart;
      found = Doubt::Meant{std::string(source.name), value, std::string(unit.name)};
    }
  }
  return found;
}

/// Asks one question after the other.
class Doubts {
 public:
  Doubts(const GivenValues& given, const std::optional<LoadReach>& load) : given_(given) {
    for (const Source& source : sources) {
      if (source.value != nullptr) {
        values_.*source.value = number(source.name);
      }
    }
    values_.gravity = number("gravity").value_or(values_.gravity);
    values_.load = load;
  }

  [[nodiscard]] std::vector<Doubt> all() && {
    if (!of_stroke()) {
      of_reach();
    }
    of_load();
    of_notch("delta-m");
    of_notch("delta-max-m");
    of_residual();
    of_width();
    of_pulse();
    of_peak();
    if (in_metres()) {
      std::ranges::for_each(sources, [this](const Source& source) { of_size(source); });
    }
    return std::move(doubts_);
  }

 private:
  [[nodiscard]] std::optional<double> number(std::string_view name) const {
    const auto found = given_.find(name);
    return found == given_.end() ? std::nullopt : std::optional(found->second.value);
  }

  [[nodiscard]] bool with_unit(std::string_view name) const {
    const auto found = given_.find(name);
    return found != given_.end() && found->second.with_unit;
  }

  void add(std::string_view name, std::string text, std::optional<Doubt::Meant> meant = {}) {
    doubts_.push_back({std::string(name), std::move(text), std::move(meant)});
  }

  /// The value given without a unit for which another unit makes `ratio` likely, in that unit; of
  /// several, the one furthest from the usual, then the one that brings the ratio closest to 1.
  template <class Ratio>
  [[nodiscard]] std::optional<Doubt::Meant> likely_unit(double factor, const Ratio& ratio) const {
    std::optional<Doubt::Meant> found;
    std::pair<double, double> best{-1, 0};
    if (const Source* const at_fault = strangest(values_);
        at_fault != nullptr && with_unit(at_fault->name)) {
      return found;
    }
    for (const Source& source : sources) {
      const auto value = source.value == nullptr ? std::nullopt : values_.*source.value;
      if (!value || *value == 0 || with_unit(source.name)) {
        continue;
      }
      for (const records::Unit& unit : records::units_of(source.dimension)) {
        Values now = values_;
        now.*source.value = *value * in_si(unit);
        const double then = std::abs(std::log(ratio(now)));
        const std::pair rank{outside(source, std::abs(*value)), -then};
        if (in_si(unit) != 1 && then < std::log(factor) && rank > best) {
          best = rank;
          found = Doubt::Meant{std::string(source.name), *value, std::string(unit.name)};
        }
      }
    }
    return found;
  }

  /// The number of a value without a unit, in a unit that makes it likely.
  [[nodiscard]] std::optional<Doubt::Meant> in_unit(std::string_view name, double value,
                                                    std::string_view unit, bool likely) const {
    return likely && !with_unit(name)
               ? std::optional(Doubt::Meant{std::string(name), value, std::string(unit)})
               : std::nullopt;
  }

  bool of_stroke() {
    const auto reach = values_.reach();
    if (!values_.stroke || !reach || *values_.stroke <= 0) {
      return false;
    }
    const auto ratio = [](const Values& now) { return *now.stroke / *now.reach(); };
    const double now = ratio(values_);
    const Source* const at_fault = strangest(values_);
    const bool said = is_far(values_, at_fault) && at_fault->value != &Values::stroke &&
                      with_unit(at_fault->name);
    if (said || (now <= far_from_one && now >= 1 / far_from_one)) {
      return false;
    }
    add("max-displacement",
        fmt::format("max-displacement = {} m is {:.3g} times {}{:.3g} m, the stroke without "
                    "friction",
                    *values_.stroke, now, values_.load ? "" : "V0/omega = ", *reach),
        likely_unit(near_one, ratio));
    return true;
  }

  void of_reach() {
    const auto ratio = [](const Values& now) {
      return now.stroke.value_or(now.reach().value_or(likely_m)) / likely_m;
    };
    const double length = ratio(values_) * likely_m;
    if (length > longest_m && (!values_.load || values_.stroke)) {
      add(values_.stroke ? "max-displacement" : "",
          values_.stroke ? fmt::format("max-displacement = {} m is longer than any stroke", length)
                         : fmt::format("the motion reaches {:.3g} m without friction", length),
          likely_unit(likely_factor, ratio));
    }
  }

  /// The load itself; in a design the stroke is compared with what it does.
  void of_load() {
    const auto k = number("k");
    if (k && values_.load && !values_.stroke && values_.load->reach_m > longest_under_load_m &&
        !is_far(values_, strangest(values_))) {
      add("k", fmt::format("k = {} g moves the mass {:.3g} m without friction; more than {} m is "
                           "doubtful",
                           *k, values_.load->reach_m, longest_under_load_m));
    }
  }

  /// The notch against the energy of the hit, g Delta against V0^2/2, or of any passage under the
  /// load.
  void of_notch(std::string_view name) {
    const auto notch = number(name);
    const double speed =
        std::abs(values_.velocity.value_or(0)) + (values_.load ? values_.load->speed_m_per_s : 0);
    const bool any_passage = values_.load && !values_.load->pulse;
    const double hit = speed * speed / (2 * values_.gravity);
    if (!notch || speed == 0 || values_.x0.value_or(0) != 0 ||
        *notch <= (any_passage ? 1 : far_beyond) * hit) {
      return;
    }
    const std::string energy =
        any_passage ? fmt::format("more than any passage under this load can have, {:.3g} m", hit)
                    : fmt::format("{:.3g} times the energy of the {} at each passage", *notch / hit,
                                  values_.load ? "pulse" : "hit");
    add(name, fmt::format("{} = {} m takes {}", name, *notch, energy),
        in_unit(name, *notch, "mm", *notch * 1e-3 <= near_one * hit));
  }

  /// With a rest allowed wherever the mass may go nothing has to return.
  void of_residual() {
    const auto residual = number("residual-m");
    const auto& stroke = values_.stroke;
    if (residual && stroke && *residual >= *stroke) {
      add("residual-m",
          fmt::format("residual-m = {} m allows a rest anywhere within max-displacement = {} m",
                      *residual, *stroke),
          in_unit("residual-m", *residual, "mm", *residual >= 1 && *residual * 1e-3 < *stroke));
    }
  }

  /// A notch that the mass never leaves is not one.
  void of_width() {
    const auto width = number("notch-width-m");
    const auto reach = values_.reach();
    if (width && reach && *width > 2 * *reach) {
      add("notch-width-m",
          fmt::format("notch-width-m = {} m is wider than the motion, which reaches {:.3g} m on "
                      "either side without friction",
                      *width, *reach),
          in_unit("notch-width-m", *width, "mm", *width * 1e-3 <= *reach));
    }
  }

  void of_pulse() {
    const auto pulse = number("pulse-duration");
    const double period = 2 * std::numbers::pi / values_.omega().value_or(0);
    if (pulse && *pulse > longest_pulse * period) {
      add("pulse-duration",
          fmt::format("pulse-duration = {} s is {:.3g} natural periods", *pulse, *pulse / period),
          in_unit("pulse-duration", *pulse, "ms", *pulse * 1e-3 <= period));
    }
  }

  /// g itself, within a percent, as a peak that should be in g.
  void of_peak() {
    const auto k = number("k");
    if (k && std::abs(*k / standard_gravity_m_per_s2 - 1) <= 0.01 && !with_unit("k")) {
      add("k",
          fmt::format("k = {} is in g, so the load is {:.3g} m/s2", *k,
                      *k * standard_gravity_m_per_s2),
          Doubt::Meant{"k", 1, ""});
    }
  }

  [[nodiscard]] bool in_metres() const {
    return std::ranges::any_of(sources, [this](const Source& source) {
      return source.dimension != Dimension::none && source.dimension != Dimension::gravities &&
             given_.contains(source.name);
    });
  }

  /// Of one that nothing else was said about.
  void of_size(const Source& source) {
    const auto value = number(source.name);
    const auto names_it = [&source](const Doubt& doubt) {
      return doubt.name == source.name || (doubt.meant && doubt.meant->name == source.name);
    };
    if (!value || *value == 0 || outside(source, std::abs(*value)) <= far_outside ||
        std::ranges::any_of(doubts_, names_it)) {
      return;
    }
    const auto units = records::units_of(source.dimension);
    const std::string unit = units.empty() ? "" : fmt::format(" {}", units.front().name);
    const std::string usual =
        source.least > 0
            ? fmt::format("far from the usual {:g} to {:g}{}", source.least, source.most, unit)
            : fmt::format("far above the usual values, which are at most {:g}{}", source.most,
                          unit);
    add(source.name, fmt::format("{} = {}{} is {}", source.name, *value, unit, usual),
        with_unit(source.name) ? std::nullopt : usual_unit(source, *value));
  }

  const GivenValues& given_;
  Values values_;
  std::vector<Doubt> doubts_;
};

}  // namespace

std::vector<Doubt> doubtful_values(const GivenValues& given, const std::optional<LoadReach>& load) {
  return Doubts(given, load).all();
}

}  // namespace stillpoint::design
