// SPDX-License-Identifier: MIT
#include "kernel/zoned_friction.hpp"

#include <stillpoint/core/traced_state.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

namespace stillpoint {

namespace {

/// W at one tau after another.
class Loads {
 public:
  explicit Loads(const Excitation& excitation)
      : excitation_(excitation), lasts_(duration(excitation).value_or(HUGE_VAL)) {}

  [[nodiscard]] double at(double tau) {
    return tau < lasts_ ? std::visit([&](const auto& kind) { return of(kind, tau); }, excitation_)
                        : 0;
  }

 private:
  static double of(const NoExcitation& /*none*/, double /*tau*/) { return 0; }
  template <class Law>
  static double of(const Law& law, double tau) {
    return load_at(law, tau);
  }
  double of(const Record& record, double tau) {
    const auto time = [&](std::size_t i) {
      return record.times.empty() ? static_cast<double>(i) * record.step : record.times[i];
    };
    if (record.values.size() < 2 || tau < time(0)) {
      return 0;
    }
    while (next_ + 1 < record.values.size() && time(next_) <= tau) {
      ++next_;
    }
    const double from = time(next_ - 1);
    return std::lerp(record.values[next_ - 1], record.values[next_],
                     (tau - from) / (time(next_) - from));
  }

  const Excitation& excitation_;
  double lasts_;
  std::size_t next_{1};  ///< sample
};

/// Whether the mass stays where `at` says that it stands.
bool stays(const std::vector<State>& states, const State& at, bool held_at_last) {
  const auto later = std::ranges::upper_bound(states, at.tau, {}, &State::tau);
  return later == states.end() ? held_at_last : later->x == at.x && later->v == 0;
}

}  // namespace

std::vector<TracedState> traced(const Oscillator& oscillator, const Surface& surface,
                                const Excitation& excitation, const std::vector<State>& states) {
  const double p = oscillator.p;
  const State& start = states.front();
  ZonedFriction<double> law(oscillator, surface, {start.x, start.v});
  const bool notch = oscillator.delta > 0 && !surface.notch_width;
  Loads loads(excitation);
  std::vector<TracedState> all;
  all.reserve(states.size());
  for (const State& now : states) {
    const double u = p * now.x;
    const double w = loads.at(now.tau);
    const double pull = 0 - (w + p * u);
    const bool still = now.v == 0;
    if (still) {
      law.rest();
    }
    const double side = still ? pull : now.v;
    const double sliding = std::copysign(p * law.phi_ahead(std::copysign(u, u * side)), side);
    const bool holds =
        (notch && u == 0) || std::abs(pull) <= p * law.capacity(u, pull > 0 ? -1 : 1);
    const double friction = 0.0 + (still && stays(states, now, holds) ? pull : sliding);
    const double drag = 2 * oscillator.zeta * p * now.v;
    all.push_back({now.tau, now.x, now.v, w, 0 - (friction + drag + p * u), friction});
  }
  return all;
}

}  // namespace stillpoint
