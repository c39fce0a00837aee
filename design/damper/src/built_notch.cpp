// SPDX-License-Identifier: MIT
#include <stillpoint/design/built_notch.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace stillpoint::design {

namespace {

/// Two ways to compute one motion round differently.
bool same(double a, double b) {
  return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b));
}

bool same(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b ? same(*a, *b) : a == b;
}

bool same_motion(const Response& a, const Response& b) {
  return a.outcome == b.outcome && same(a.stop_time, b.stop_time) &&
         same(a.stop_position, b.stop_position) && same(a.peak_amplitude, b.peak_amplitude);
}

}  // namespace

BuiltNotch built_notch(const DesignRequest& request, const DesignPoint& point,
                       const NotchShape& shape) {
  const Problem& problem = request.problem;
  const Start start{0, request.pulse ? 0 : problem.v0};
  const Excitation load = request.pulse ? excitation(*request.pulse) : NoExcitation();
  const auto with = [&](const NotchShape& notch) {
    const Oscillator oscillator{problem.p, point.f, point.delta, notch.hold};
    return forced_response(oscillator, start, load, {}, Surface{notch.width, {}});
  };
  BuiltNotch built{shape, {}, with(shape)};
  if (shape.width) {
    built.friction = point.f + point.delta / *shape.width;
  }
  built.changes_nothing = same_motion(built.response, with({}));
  return built;
}

}  // namespace stillpoint::design
