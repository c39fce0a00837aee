// SPDX-License-Identifier: MIT
#include <stillpoint/core/elementary.hpp>
#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/interval.hpp>
#include <stillpoint/core/oscillator.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <variant>

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
  [[nodiscard]] double falls() const { return std::numbers::pi - begin; }
};

/// The integral of a load from 0, in units of k and lambda, and the integral of that.
struct LoadIntegrals {
  double once;
  double twice;
};

LoadIntegrals integrals(const Haversine& /*shape*/, double t) {
  const auto [sine, cosine] = elementary::sin_cos(t);
  return {(t - sine * cosine) / 2, (t - sine) * (t + sine) / 4};
}
template <IsPolygon Polygon>
LoadIntegrals integrals(const Polygon& /*shape*/, double t) {
  LoadIntegrals sum{0, 0};
  for (std::size_t i = 1; i < Polygon::corners.size(); ++i) {
    const auto& [from, load] = Polygon::corners.at(i - 1);
    const auto& [to, next] = Polygon::corners.at(i);
    const double h = std::clamp(t / std::numbers::pi - from, 0.0, to - from) * std::numbers::pi;
    const double rate = (next - load) / ((to - from) * std::numbers::pi);
    sum.twice += h * (sum.once + h * (load / 2 + h * rate / 6));
    sum.once += h * (load + h * rate / 2);
  }
  return sum;
}

/// The first and the last t at which the load is `ratio`, or has jumped across it.
Interval exceeds(const Haversine& /*shape*/, double ratio) {
  const double begin = elementary::asin(std::sqrt(ratio));
  return {begin, std::numbers::pi - begin};
}
template <IsPolygon Polygon>
Interval exceeds(const Polygon& /*shape*/, double ratio) {
  const auto& corners = Polygon::corners;
  const double rise = corners[1].time * ratio;
  const double fall = corners.back().load < ratio ? 1 - rise : 1;
  return {rise * std::numbers::pi, fall * std::numbers::pi};
}

/// The same for a shape that rises from 0 and may fall as it rises.
template <class Shape>
struct ShapedPush {
  double ratio{0};
  Interval above{exceeds(Shape(), ratio)};
  LoadIntegrals start{integrals(Shape(), above.low)};

  [[nodiscard]] double speed(double t) const {
    return integrals(Shape(), t).once - start.once - ratio * (t - above.low);
  }
  [[nodiscard]] double distance(double t) const {
    const double since = t - above.low;
    return integrals(Shape(), t).twice - start.twice - since * (start.once + ratio * since / 2);
  }
  [[nodiscard]] double falls() const { return above.high; }
};

/// The end of the pulse, or the turn where friction stops the mass before it.
template <class AnyPush>
double end_of(const AnyPush& push) {
  double low = push.falls();
  double high = std::numbers::pi;
  if (push.speed(high) >= 0) {
    return high;
  }
  for (double middle = low; low < high; (push.speed(middle) > 0 ? low : high) = middle) {
    middle = low + (high - low) / 2;
    if (middle == low || middle == high) {
      break;
    }
  }
  return high;
}

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

template <class AnyPush>
std::optional<EquivalentStart> carried_back(const AnyPush& push) {
  const double end = end_of(push);
  return carried_back(push.ratio, end, push.speed(end), push.distance(end));
}

// Of each kind of pulse in the units of Push, for a ratio below 1.

std::optional<EquivalentStart> start_of(const HalfSine& /*pulse*/, double ratio) {
  return carried_back(Push{ratio});
}
std::optional<EquivalentStart> start_of(const Rectangle& /*pulse*/, double ratio) {
  constexpr double end = std::numbers::pi;
  const double speed = (1 - ratio) * end;
  return carried_back(ratio, end, speed, speed * end / 2);
}
template <class Shape>
requires requires(const Shape& shape) {
  exceeds(shape, 0.0);
}
std::optional<EquivalentStart> start_of(const Shape& /*pulse*/, double ratio) {
  return carried_back(ShapedPush<Shape>{ratio});
}

}  // namespace

std::optional<EquivalentStart> equivalent_start(const Excitation& pulse, double f) {
  require_valid(pulse);
  require_within("f", f, 0, largest_square);
  const auto of_kind = [f](const auto& kind) -> std::optional<EquivalentStart> {
    if constexpr (requires { start_of(kind, f); }) {
      const double k = std::abs(kind.k);
      const std::optional<EquivalentStart> start = k > f ? start_of(kind, f / k) : std::nullopt;
      if (start) {
        return EquivalentStart{k / kind.lambda * start->speed, start->tau / kind.lambda};
      }
    }
    return std::nullopt;
  };
  return std::visit(of_kind, pulse);
}

}  // namespace stillpoint
