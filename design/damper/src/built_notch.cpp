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
    values.push_back(low + (high - low) * i / (count - 1));
  }
  return values;
}

/// The hits or pulses of the ranges, each with every spring, and the one shown.
std::vector<RestAfter> of_ranges(const DesignRequest& request, const RestAfter& shown) {
  const auto& [problem, limits, search, pulse, ranges] = request;
  constexpr int springs = 5;
  std::vector<RestAfter> all{shown};
  const auto add = [&, &of = problem](double v0, const std::optional<Pulse>& now) {
    for (const double p : grid(of.p, of.stiffest_p(), springs)) {
      all.push_back({v0, now, p});
    }
  };
  if (!pulse) {
    constexpr int hits = 65;
    for (const double v0 : grid(problem.v0_low.value_or(problem.v0), problem.v0, hits)) {
      add(v0, {});
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

}  // namespace

BuiltNotch built_notch(const DesignResult& design, const NotchShape& shape) {
  const DesignRequest& request = design.request;
  const auto& [f, delta, tolerance] = design.finding->point;
  const auto& check = design.finding->pulse;
  const RestAfter shown = check ? RestAfter{0, check->pulse, check->p}
                                : RestAfter{request.problem.v0, {}, request.problem.p};
  const auto motion = [&, f = f, delta = delta](const NotchShape& notch, const RestAfter& now) {
    return forced_response({now.p, f, delta, notch.hold}, {0, now.v0},
                           now.pulse ? excitation(*now.pulse) : NoExcitation(), {},
                           Surface{notch.width, {}});
  };
  BuiltNotch built{shape, {}, motion(shape, shown)};
  built.changes_nothing = same_motion(built.response, motion({}, shown));
  if (shape.width) {
    built.friction = f + delta / *shape.width;
  }
  const auto strip = [&, f = f](const RestAfter& now) {
    return forced_response({now.p, f, 0, {}}, {0, now.v0}, NoExcitation(), {},
                           Surface{{}, {{*shape.width / 2, *built.friction}}});
  };
  if (shape.width && !shown.pulse) {
    built.from_start = strip(shown);
  }
  if (!has_ranges(request)) {
    return built;
  }
  built.farthest = shown;
  for (RestAfter& now : of_ranges(request, shown)) {
    if (now.v0 == 0 && !now.pulse) {
      continue;
    }
    const bool caught = !now.pulse && now.v0 * now.v0 <= 2 * delta;
    const ForcedResponse response = caught && shape.width ? strip(now) : motion(shape, now);
    now.rest = response.stop_position.value_or(0);
    if (std::abs(now.rest) > std::abs(built.farthest->rest)) {
      built.farthest = now;
    }
    built.holds_weakest = built.holds_weakest || (now.pulse && response.half_cycles == 0);
  }
  return built;
}

}  // namespace stillpoint::design
