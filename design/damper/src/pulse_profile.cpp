// SPDX-License-Identifier: MIT
#include "pulse_profile.hpp"

#include <stillpoint/core/forced_motion.hpp>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

namespace stillpoint::design {

namespace {

/// More than any arrival has: the notch holds it.
constexpr double unpassable = 1e250;

Pulse unit_pulse(const Pulse& pulse, double p) {
  return std::visit(
      [p](const auto& kind) {
        return Pulse(std::decay_t<decltype(kind)>{1, kind.lambda / p});
      },
      pulse);
}

/// The integral of |W|.
double impulse(const Pulse& pulse) {
  const double lambda = angular_frequency(pulse);
  return std::holds_alternative<HalfSine>(pulse)    ? 2 / lambda
         : std::holds_alternative<Rectangle>(pulse) ? std::numbers::pi / lambda
                                                    : 4 / lambda;
}

/// The f at which to look first. The spring of a mass that the pulse has given the speed I reaches
/// p I at most, so with a short pulse f is of that order; beyond it, and up to k, only a full sine
/// brings the mass back. Fractions are those of the smaller of both.
std::vector<double> first_grid(const Pulse& pulse) {
  constexpr double least = 1e-9;
  constexpr int small = 16;
  constexpr int even = 40;
  constexpr int large = 20;
  constexpr double nearly = 1 - 1e-6;  // f = k moves nothing
  const double scale = std::min(1.0, impulse(pulse));
  std::vector<double> grid;
  grid.reserve(small + even + large);
  for (int i = 0; i < small; ++i) {
    grid.push_back(scale * least * std::pow(1 / (even * least), static_cast<double>(i) / small));
  }
  for (int i = 1; i <= even; ++i) {
    grid.push_back(std::min(nearly, scale * i / even));
  }
  for (int i = 1; scale < nearly && i <= large; ++i) {
    grid.push_back(scale * std::pow(nearly / scale, static_cast<double>(i) / large));
  }
  return grid;
}

bool same_kind(const FirstReturn& a, const FirstReturn& b) {
  return a.returns == b.returns && a.turns == b.turns;
}

}  // namespace

FirstReturn first_return(const Pulse& pulse, double p, double f) {
  const ForcedResponse motion =
      forced_response({1, f, unpassable}, {}, excitation(unit_pulse(pulse, p)));
  const double speed = motion.arrival_speed.value_or(0);
  return {f,
          motion.stops_at_zero && motion.half_cycles == 1.0,
          motion.peak_amplitude,
          speed,
          motion.stop_time.value_or(0),
          motion.peak_absolute_acceleration,
          motion.turning_points.value_or(0),
          speed * speed / 2,
          (speed * speed + f * f) / 2};
}

PulseProfile::PulseProfile(const Pulse& pulse, double p, bool k_varies)
    : pulse_(unit_pulse(pulse, p)) {
  std::vector<FirstReturn> coarse;
  for (const double f : first_grid(pulse_)) {
    coarse.push_back(at(f));
  }
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    samples_.push_back(coarse[i]);
    if (i + 1 == coarse.size()) {
      break;
    }
    // The kind may change more than once between two points.
    constexpr int most_changes = 8;
    for (int change = 0; change < most_changes && !same_kind(samples_.back(), coarse[i + 1]);
         ++change) {
      const FirstReturn before = samples_.back();
      FirstReturn after = coarse[i + 1];
      const double last = last_that_holds(before.f, after.f, [&](double f) {
        const FirstReturn now = at(f);
        const bool same = same_kind(before, now);
        if (!same) {
          after = now;
        }
        return same;
      });
      if (last > before.f) {
        samples_.push_back(at(last));
      }
      samples_.push_back(after);
    }
  }
  add_maxima(k_varies);
}

FirstReturn PulseProfile::at(double f) const {
  return first_return(pulse_, 1, f);
}

void PulseProfile::add_maxima(bool k_varies) {
  constexpr int bits = 24;  // the value at a maximum then has all digits
  const auto add = [&](const auto& value) {
    std::vector<FirstReturn> found;
    for (std::size_t i = 1; i + 1 < samples_.size(); ++i) {
      const FirstReturn& before = samples_[i - 1];
      const FirstReturn& after = samples_[i + 1];
      const FirstReturn& now = samples_[i];
      if (same_kind(before, now) && same_kind(now, after) && now.returns &&
          value(now) >= std::max(value(before), value(after))) {
        const auto less = [&](double f) { return -value(at(f)); };
        found.push_back(
            at(boost::math::tools::brent_find_minima(less, before.f, after.f, bits).first));
      }
    }
    samples_.insert(samples_.end(), found.begin(), found.end());
    std::ranges::sort(samples_, {}, &FirstReturn::f);
  };
  for (const Criterion criterion : {Criterion::exact, Criterion::published}) {
    add([&](const FirstReturn& now) { return now.need(criterion); });
    if (k_varies) {
      add([&](const FirstReturn& now) { return now.need(criterion) / now.f / now.f; });
    }
  }
}

}  // namespace stillpoint::design
