// SPDX-License-Identifier: MIT
#include <stillpoint/core/elementary.hpp>
#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>

#include <cmath>
#include <numbers>

namespace stillpoint {

namespace {

/// A half-sine in units of k / lambda and k / lambda^2, t = lambda tau: the motion under only load
/// and friction, from where the load exceeds friction, sin t = ratio.
struct Push {
  double ratio{0};
  double begin{elementary::asin(ratio)};
  double cosine{std::sqrt((1 - ratio) * (1 + ratio))};

  [[nodiscard]] double speed(double t) const {
    return cosine - elementary::sin_cos(t).cosine - ratio * (t - begin);
  }
  [[nodiscard]] double distance(double t) const {
    const double since = t - begin;
    return cosine * since - elementary::sin_cos(t).sine + ratio - ratio * since * since / 2;
  }

  /// The end of the pulse, or the turn where friction stops the mass before it.
  [[nodiscard]] double end() const {
    double low = std::numbers::pi - begin;  // where the load falls below friction
    double high = std::numbers::pi;
    if (speed(high) >= 0) {
      return high;
    }
    for (double middle = low; low < high; (speed(middle) > 0 ? low : high) = middle) {
      middle = low + (high - low) / 2;
      if (middle == low || middle == high) {
        break;
      }
    }
    return high;
  }
};

/// (F22) and (F23) in the units of Push: the pulse, or the turn, at `end`, with `speed` there and
/// `distance` so far.
std::optional<EquivalentStart> carried_back(double ratio, double end, double speed,
                                            double distance) {
  const double square = speed * speed + 2 * ratio * distance;
  if (!(square > 0)) {
    return std::nullopt;
  }
  const double start_speed = std::sqrt(square);
  return EquivalentStart{start_speed, end - 2 * distance / (start_speed + speed)};
}

/// `carried` gives the start in the units of Push, for a ratio below 1.
template <class Pulse, class Carried>
std::optional<EquivalentStart> start_of(const Pulse& pulse, double f, const Carried& carried) {
  require_valid(Excitation(pulse));
  require_within("f", f, 0, largest_square);
  const double k = std::abs(pulse.k);
  const std::optional<EquivalentStart> start = k > f ? carried(f / k) : std::nullopt;
  return start ? std::optional(
                     EquivalentStart{k / pulse.lambda * start->speed, start->tau / pulse.lambda})
               : std::nullopt;
}

}  // namespace

std::optional<EquivalentStart> equivalent_start(const HalfSine& pulse, double f) {
  return start_of(pulse, f, [](double ratio) {
    const Push push{ratio};
    const double end = push.end();
    return carried_back(ratio, end, push.speed(end), push.distance(end));
  });
}

std::optional<EquivalentStart> equivalent_start(const Rectangle& pulse, double f) {
  return start_of(pulse, f, [](double ratio) {
    constexpr double end = std::numbers::pi;
    const double speed = (1 - ratio) * end;
    return carried_back(ratio, end, speed, speed * end / 2);
  });
}

}  // namespace stillpoint
