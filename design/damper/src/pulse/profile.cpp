// SPDX-License-Identifier: MIT
#include "pulse/profile.hpp"

#include "pulse/closed_return.hpp"
#include "pulse/edge.hpp"

#include <stillpoint/core/elementary.hpp>
#include <stillpoint/core/forced_motion.hpp>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace stillpoint::design {

namespace {

/// More than the energy of any arrival, so the notch holds it.
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

/// The first f to try. The spring of a mass that the pulse has given the speed I reaches
/// p I at most, so with a short pulse f is of that order. Fractions are those of the smaller of p I
/// and k; a pulse of one sign brings nothing back beyond half of it, (67), a full sine does up to
/// k.
std::vector<double> first_grid(const Pulse& pulse) {
  constexpr double least = 1e-9;
  constexpr int small = 4;
  constexpr int large = 10;
  const double scale = std::min(1.0, impulse(pulse));
  const bool both_ways = std::holds_alternative<FullSine>(pulse);
  const int even = both_ways ? 24 : 32;
  const int last = both_ways ? even : even / 2;
  std::vector<double> grid;
  grid.reserve(static_cast<std::size_t>(small + last + large));
  for (int i = 0; i < small; ++i) {
    grid.push_back(scale * least *
                   elementary::pow(1 / (even * least), static_cast<double>(i) / small));
  }
  for (int i = 1; i <= last; ++i) {
    grid.push_back(std::min(nearest_to_k, scale * i / even));
  }
  for (int i = 1; both_ways && scale < nearest_to_k && i <= large; ++i) {
    grid.push_back(scale * elementary::pow(nearest_to_k / scale, static_cast<double>(i) / large));
  }
  // Under a long pulse the last swings before the return follow each other there.
  constexpr double long_pulse = 1.0 / 4;
  for (int i = 5; angular_frequency(pulse) < long_pulse && i < 2 * small; ++i) {
    grid.push_back(scale * i / small / even);
  }
  std::ranges::sort(grid);
  return grid;
}

bool same_kind(const FirstReturn& a, const FirstReturn& b) {
  return a.returns == b.returns && (!a.returns || a.turns == b.turns);
}

/// No figure that a requirement bounds has a maximum between the middle two, so no box has its
/// largest value there.
bool no_top_between(const FirstReturn& a, const FirstReturn& b, const FirstReturn& c,
                    const FirstReturn& d) {
  const auto no_top = [&](double FirstReturn::*figure) {
    const double last = b.*figure;
    const double after = c.*figure;
    return (a.*figure >= last || last <= after) && (d.*figure >= after || after <= last);
  };
  return no_top(&FirstReturn::peak) && no_top(&FirstReturn::acceleration) &&
         no_top(&FirstReturn::exact_need) && no_top(&FirstReturn::published_need);
}

}  // namespace

FirstReturn first_return(const Pulse& pulse, double p, double f) {
  const Pulse unit = unit_pulse(pulse, p);
  if (const auto closed = closed_return(unit, f)) {
    return *closed;
  }
  const ForcedResponse motion = forced_response({1, f, unpassable}, {}, excitation(unit));
  const double speed = motion.arrival_speed.value_or(0);
  const double rest = std::abs(motion.stop_position.value_or(0));
  const double square = speed * speed;
  return {f,
          motion.stops_at_zero && motion.half_cycles == 1.0,
          motion.peak_amplitude,
          speed,
          motion.stop_time.value_or(0),
          motion.peak_absolute_acceleration,
          motion.turning_points.value_or(0),
          square / 2,
          (square + f * f) / 2,
          square > 0 ? square : rest * (rest - 2 * f)};
}

PulseProfile::PulseProfile(const Pulse& pulse, double p, Criterion criterion, bool k_varies)
    : pulse_(unit_pulse(pulse, p)) {
  for (const double f : first_grid(pulse_)) {
    const FirstReturn now = at(f);
    if (!samples_.empty()) {
      add_changes(now, k_varies);
    }
    samples_.push_back(now);
  }
  add_maxima(criterion, k_varies);
}

/// Both sides of each change of the kind between the last sample and the next one.
void PulseProfile::add_changes(const FirstReturn& to, bool k_varies) {
  // The kind may change more than once between two points.
  constexpr int most_changes = 8;
  for (int change = 0; change < most_changes && !same_kind(samples_.back(), to); ++change) {
    const FirstReturn before = samples_.back();
    FirstReturn last = before;
    FirstReturn after = to;
    const auto same_at = [&](double f) {
      const FirstReturn now = at(f);
      const bool same = same_kind(before, now);
      (same ? last : after) = now;
      return same;
    };
    if (before.returns != to.returns) {
      const double sign = before.returns ? 1 : -1;
      constexpr double none = std::numeric_limits<double>::min();
      const auto clearance = [&](double f) {
        if (f != before.f && f != to.f) {
          same_at(f);
        }
        return f == last.f ? std::max(sign * last.clearance, 0.0)
                           : std::min(sign * after.clearance, -none);
      };
      last_not_negative(before.f, to.f, clearance);
    } else {
      // Closer and closer, until nothing that matters happens between the two.
      for (const double near : {1.0 / 64, 1.0 / 4096, 0.0}) {
        last_that_holds(last.f, after.f, same_at, near * (to.f - before.f));
        const bool time_goes_on = (before.time <= last.time) == (after.time <= to.time);
        if (no_top_between(before, last, after, to) && (time_goes_on || !k_varies)) {
          break;
        }
      }
    }
    if (last.f > before.f) {
      samples_.push_back(last);
    }
    if (after.f < to.f) {
      samples_.push_back(after);
    }
  }
}

FirstReturn PulseProfile::at(double f) const {
  return first_return(pulse_, 1, f);
}

void PulseProfile::add_maxima(Criterion criterion, bool k_varies) {
  constexpr int bits = 24;  // the value at a maximum then has all its digits
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
  add([&](const FirstReturn& now) { return now.need(criterion); });
  if (k_varies) {
    add([&](const FirstReturn& now) { return now.need(criterion) / now.f / now.f; });
  }
}

}  // namespace stillpoint::design
