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

Pulse with(const Pulse& pulse, double k, double lambda) {
  return std::visit(
      [&](auto kind) {
        kind.k = k;
        kind.lambda = lambda;
        return Pulse(kind);
      },
      pulse);
}

/// Of a range, or of its one value.
std::vector<double> grid(double low, double high, int count) {
  std::vector<double> values;
  for (int i = 0; i < count && (i == 0 || low < high); ++i) {
    values.push_back(i == count - 1 ? high : low + (high - low) * i / (count - 1));
  }
  return values;
}

/// The hits or pulses of the ranges, each with every spring, and the one shown.
std::vector<TriedMotion> of_ranges(const DesignRequest& request, const TriedMotion& shown) {
  const auto& [problem, limits, search, pulse, ranges] = request;
  constexpr int springs = 5;
  std::vector<TriedMotion> all{shown};
  const auto add = [&, &of = problem](double v0, const std::optional<Pulse>& now) {
    for (const double p : grid(of.p, of.stiffest_p(), springs)) {
      all.push_back({v0, now, p});
    }
  };
  if (!pulse) {
    constexpr int hits = 65;
    for (const double v0 : grid(problem.v0_low.value_or(problem.v0), problem.v0, hits)) {
      if (v0 > 0) {
        add(v0, {});
      }
    }
    return all;
  }
  constexpr int strengths = 17;
  constexpr int lengths = 5;
  const double most = peak_load(*pulse);
  const double longest = angular_frequency(*pulse);
  for (const double k : grid(ranges.k_low.value_or(most), most, strengths)) {
    for (const double lambda : grid(longest, ranges.lambda_high.value_or(longest), lengths)) {
      add(0, with(*pulse, k, lambda));
    }
  }
  return all;
}

bool has_ranges(const DesignRequest& request) {
  const auto& [problem, limits, search, pulse, ranges] = request;
  return pulse ? pulse_problem(problem, *pulse, ranges).has_ranges()
               : problem.v0_low || problem.p_high;
}

/// The first of those with the largest value.
const TriedMotion& largest(const std::vector<TriedMotion>& tried,
                           double (*value)(const TriedMotion&)) {
  return *std::ranges::max_element(tried, {}, value);
}

}  // namespace

BuiltNotch built_notch(const DesignResult& design, const NotchShape& shape) {
  const DesignRequest& request = design.request;
  const auto& [f, delta, tolerance] = design.finding->point;
  const auto& check = design.finding->pulse;
  TriedMotion shown = check ? TriedMotion{0, check->pulse, check->p}
                            : TriedMotion{request.problem.v0, {}, request.problem.p};
  const auto motion = [&, f = f, delta = delta](const NotchShape& notch, const TriedMotion& now) {
    return forced_response({now.p, f, delta, notch.hold}, {0, now.v0},
                           now.pulse ? excitation(*now.pulse) : NoExcitation(), {},
                           Surface{notch.width, {}});
  };
  shown.response = motion(shape, shown);
  BuiltNotch built{shape, {}, shown.response};
  built.changes_nothing = same_motion(built.response, motion({}, shown));
  if (shape.width) {
    built.friction = f + delta / *shape.width;
  }
  const auto strip = [&, f = f](const TriedMotion& now) {
    return forced_response({now.p, f, 0, {}}, {0, now.v0}, NoExcitation(), {},
                           Surface{{}, {{*shape.width / 2, *built.friction}}});
  };
  if (shape.width && !shown.pulse) {
    built.from_start = strip(shown);
  }
  if (!has_ranges(request)) {
    return built;
  }
  std::vector<TriedMotion> tried = of_ranges(request, shown);
  for (TriedMotion& now : tried) {
    now.from_inside = shape.width && !now.pulse && now.v0 * now.v0 <= 2 * delta;
    now.response = now.from_inside ? strip(now) : motion(shape, now);
    built.holds_weakest = built.holds_weakest || (now.pulse && now.response.half_cycles == 0);
  }
  built.worst = {
      largest(tried, [](const TriedMotion& of) { return std::abs(of.rest()); }),
      largest(tried, [](const TriedMotion& of) { return of.response.peak_amplitude; }),
      largest(tried, [](const TriedMotion& of) { return of.response.peak_absolute_acceleration; }),
      largest(tried,
              [](const TriedMotion& of) { return of.p * of.response.peak_amplitude * of.p; })};
  return built;
}

}  // namespace stillpoint::design
