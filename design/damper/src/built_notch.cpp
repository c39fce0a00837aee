// SPDX-License-Identifier: MIT
#include <stillpoint/design/built_notch.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

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

/// Of the ranges, or of the one hit and the one spring.
std::vector<double> grid(double low, double high, int count) {
  std::vector<double> values;
  for (int i = 0; i < count && (i == 0 || low < high); ++i) {
    values.push_back(low + (high - low) * i / (count - 1));
  }
  return values;
}

template <class Motion>
RestAfter farthest_rest(const Problem& problem, const Motion& motion) {
  constexpr int hits = 65;
  constexpr int springs = 5;
  RestAfter farthest{problem.v0, problem.p, 0};
  for (const double v0 : grid(problem.v0_low.value_or(problem.v0), problem.v0, hits)) {
    for (const double p : grid(problem.p, problem.stiffest_p(), springs)) {
      const double rest = v0 > 0 ? motion(v0, p).stop_position.value_or(0) : 0;
      if (std::abs(rest) > std::abs(farthest.rest)) {
        farthest = {v0, p, rest};
      }
    }
  }
  return farthest;
}

}  // namespace

BuiltNotch built_notch(const DesignRequest& request, const DesignPoint& point,
                       const NotchShape& shape) {
  const Problem& problem = request.problem;
  const Excitation load = request.pulse ? excitation(*request.pulse) : NoExcitation();
  const auto motion = [&](const NotchShape& notch, double v0, double p) {
    return forced_response({p, point.f, point.delta, notch.hold}, {0, v0}, load, {},
                           Surface{notch.width, {}});
  };
  const double v0 = request.pulse ? 0 : problem.v0;
  BuiltNotch built{shape, {}, motion(shape, v0, problem.p)};
  built.changes_nothing = same_motion(built.response, motion({}, v0, problem.p));
  if (shape.width) {
    built.friction = point.f + point.delta / *shape.width;
  }
  if (request.pulse) {
    return built;
  }
  const auto strip = [&](double hit, double p) {
    return forced_response({p, point.f, 0, {}}, {0, hit}, load, {},
                           Surface{{}, {{*shape.width / 2, *built.friction}}});
  };
  if (shape.width) {
    built.from_start = strip(v0, problem.p);
  }
  if (problem.v0_low || problem.p_high) {
    built.farthest = farthest_rest(problem, [&](double hit, double p) {
      const bool caught = hit * hit <= 2 * point.delta;
      return caught && shape.width ? strip(hit, p) : motion(shape, hit, p);
    });
  }
  return built;
}

}  // namespace stillpoint::design
