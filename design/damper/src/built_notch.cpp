// SPDX-License-Identifier: MIT
#include <stillpoint/design/built_notch.hpp>

#include <stillpoint/core/input_error.hpp>

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

/// Of a range, or of its one value.
std::vector<double> grid(double low, double high, int count) {
  std::vector<double> values;
  for (int i = 0; i < count && (i == 0 || low < high); ++i) {
    values.push_back(i == count - 1 ? high : low + (high - low) * i / (count - 1));
  }
  return values;
}

/// A hit of the range after which the mass turns just at the end of its dead zone, f/p^2, and rests
/// there, if there is one: (39), (42) of docs/theory.md, for a whole passage of the notch takes
/// Delta whatever its width is. One that the paper's notch catches leaves half of it first. Where
/// the dead zone ends within the notch, its own friction holds the mass up to the edge.
std::optional<double> hit_to_the_farthest_rest(const DesignPoint& damper, const NotchShape& shape,
                                               double p, const Interval& range) {
  const double phi = damper.f / p;
  const double d = 2 * damper.delta;
  const double edge = shape.width.value_or(0) / 2;
  const auto in_range = [&](double square) {
    const double v0 = std::sqrt(square);
    return range.low <= v0 && v0 <= range.high ? std::optional(v0) : std::nullopt;
  };
  if (phi / p <= edge && edge > 0) {
    const double friction = damper.f + damper.delta / *shape.width;
    const double x = std::min(edge, friction / p / p);
    return in_range(x * (p * p * x + 2 * friction));
  }
  constexpr int most = 1000;  // as arrivals
  double radius = 2 * phi;
  for (int n = 1; n <= most; ++n) {
    const double free = (radius - phi) * (radius + phi);
    const double caught = free + d / 2;
    const auto v0 = free > d                     ? in_range(free)
                    : shape.width && caught <= d ? in_range(caught)
                                                 : std::nullopt;
    if (v0) {
      return v0;
    }
    radius = 2 * phi + std::sqrt(radius * radius + d);
  }
  return std::nullopt;
}

/// The hits or pulses of the ranges, each with every spring, and the one shown.
std::vector<TriedMotion> of_ranges(const DesignRequest& request, const TriedMotion& shown,
                                   const DesignPoint& damper, const NotchShape& shape) {
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
    const Interval range{problem.v0_low.value_or(problem.v0), problem.v0};
    for (const double p : grid(problem.p, problem.stiffest_p(), springs)) {
      if (const auto v0 = hit_to_the_farthest_rest(damper, shape, p, range)) {
        all.push_back({*v0, {}, p});
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

/// The first of those with the largest value.
const TriedMotion& largest(const std::vector<TriedMotion>& tried,
                           double (*value)(const TriedMotion&)) {
  return *std::ranges::max_element(tried, {}, value);
}

}  // namespace

BuiltNotch built_notch(const DesignResult& design, const NotchShape& shape) {
  const DesignRequest& request = design.request;
  if (shape.width) {  // half of it ends a zone of friction
    require_within("notch-width", *shape.width,
                   2 * smallest_speed * std::max(1.0, 1 / request.problem.p), largest_speed);
  }
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
  BuiltNotch built{shape,
                   {},
                   shown.response,
                   motion_energies({shown.p, f, delta, shape.hold}, {0, shown.v0},
                                   shown.pulse ? excitation(*shown.pulse) : NoExcitation(), {},
                                   Surface{shape.width, {}})};
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
  if (!has_ranges(request.problem, request.pulse, request.pulse_ranges)) {
    return built;
  }
  std::vector<TriedMotion> tried = of_ranges(request, shown, design.finding->point, shape);
  for (TriedMotion& now : tried) {
    now.from_inside = shape.width && !now.pulse && now.v0 * now.v0 <= 2 * delta;
    now.response = now.from_inside ? strip(now) : motion(shape, now);
    built.holds_weakest = built.holds_weakest || (now.pulse && now.response.half_cycles == 0);
  }
  built.worst = {
      largest(tried, [](const TriedMotion& of) { return std::abs(of.rest()); }),
      largest(tried, [](const TriedMotion& of) { return of.response.peak_amplitude; }),
      largest(tried, [](const TriedMotion& of) { return figures_of(of.response).acceleration; }),
      largest(tried,
              [](const TriedMotion& of) { return of.p * of.response.peak_amplitude * of.p; })};
  return built;
}

}  // namespace stillpoint::design
