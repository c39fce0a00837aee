// SPDX-License-Identifier: MIT
// The hits and the springs that a damper works for, docs/theory.md (35) to (38). In speeds:
// phi = f/p, d = 2 Delta.

#include <stillpoint/design/works_for.hpp>

#include "nearest_fit.hpp"
#include "region/edges.hpp"
#include "region/limit_table.hpp"
#include "way/way.hpp"
#include "wide.hpp"

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/strips.hpp>
#include <stillpoint/design/tolerance.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

namespace {

struct HitDamper {
  Wide f{0};
  Wide d{0};
  Wide beta{0};
  Criterion criterion{};
};

Wide lowest_v0(const HitDamper& damper, Wide p) {
  return std::max(root(damper.d), root(Wide(8)) * damper.f / p);
}

Wide highest_v0(const HitDamper& damper, Wide p) {
  const auto& [f, d, beta, criterion] = damper;
  const Wide phi = f / p;
  const Wide amplitude = root(p * beta) * root(p * beta + 2 * phi);
  const bool exact = criterion == Criterion::exact;
  const Wide notch = root(exact ? d + phi * phi : d);
  const Wide stop = root((exact ? 4 : 3) * phi * phi + 4 * phi * notch + d);
  return std::min(amplitude, stop);
}

Wide lowest_p(const HitDamper& damper, Wide v0) {
  const auto& [f, d, beta, criterion] = damper;
  const Wide square = (v0 / beta) * (v0 / beta) - 2 * f / beta;
  return std::max(root(std::max(Wide(0), square)), root(Wide(8)) * f / v0);
}

/// Infinite where nothing bounds it.
Wide highest_p(const HitDamper& damper, Wide v0) {
  const auto& [f, d, beta, criterion] = damper;
  const Wide lost = v0 * v0 - d;
  const Wide root_d = root(d);
  const Wide per_phi =
      criterion == Criterion::exact ? root(8 * (v0 * v0 + d)) : 2 * root_d + root(d + 3 * v0 * v0);
  return lost > 0 ? f * (per_phi / lost) : Wide(HUGE_VAL);
}

/// The edge as the last double that fits, seen from `nominal`, which does. The edge is accurate to
/// an ulp; what fits is decided by edges in f and Delta that are rounded inwards, a few
/// ulps of it.
template <class Fits>
double last_fit(double edge, double nominal, const Fits& fits) {
  constexpr double few_ulps = 4e-15;
  const bool upwards = edge > nominal;
  const double inner = edge * (upwards ? 1 - few_ulps : 1 + few_ulps);
  const double outer =
      std::clamp(edge * (upwards ? 1 + few_ulps : 1 - few_ulps), smallest_speed, largest_speed);
  const bool passed = upwards ? inner <= nominal : inner >= nominal;
  return *nearest_fit(fits(outer) ? edge : outer, passed || !fits(inner) ? nominal : inner, fits);
}

/// The intervals of the problem, extended as far as the damper works, one end after the other.
template <class WithV0, class WithP>
WorksFor extended(const Problem& problem, const WithV0& with_v0, const WithP& with_p) {
  const auto end = [](double from, double nominal, const auto& fits) {
    return *nearest_fit(from, nominal, fits);
  };
  const double weakest = problem.v0_low.value_or(problem.v0);
  const double stiffest = problem.stiffest_p();
  const Interval of_v0 = valid_v0(problem);
  const Interval of_p = valid_p(problem);
  WorksFor served;
  served.hit = {weakest == 0 ? 0 : end(std::min(weakest, of_v0.low), weakest, with_v0),
                end(std::max(problem.v0, of_v0.high), problem.v0, with_v0)};
  served.p.low = end(std::min(problem.p, of_p.low), problem.p, with_p);
  const double most = std::max(stiffest, of_p.high);
  if (const double high = end(most, stiffest, with_p); high < most) {
    served.p.high = high;
  }
  return served;
}

}  // namespace

std::optional<WorksFor> works_for(const Problem& problem, const Limits& limits, double f,
                                  double delta) {
  Limits of_the_point = limits;
  of_the_point.tolerance = 0;
  if (!admissible(problem, of_the_point, f, delta)) {
    return std::nullopt;
  }
  if (!is_plain(problem, limits)) {
    const auto holds = [&](const Problem& now) { return admissible(now, of_the_point, f, delta); };
    Problem wider = problem;
    return extended(
        problem,
        [&](double v0) {
          wider = problem;
          wider.v0_low = std::min(problem.v0_low.value_or(problem.v0), v0);
          wider.v0 = std::max(problem.v0, v0);
          return holds(wider);
        },
        [&](double p) {
          wider = problem;
          wider.p = std::min(problem.p, p);
          wider.p_high = std::max(problem.stiffest_p(), p);
          return holds(wider);
        });
  }
  const double v0 = problem.v0;
  const double p = problem.p;
  if (const auto arrival = arrival_of(problem, f, delta).value(); arrival > 1) {
    Problem one = problem;  // a range of one value is that value
    one.v0_low = one.p_high = {};
    // Only the intervals of its way: between the strips the mass rests off centre, so none
    // continues into another one. Without constant friction the strips touch, and way 0 covers all.
    const int way = f == 0 ? 0 : static_cast<int>(arrival);
    const auto holds = [&](double speed, double stiffness) {
      Problem now = one;
      now.v0 = speed;
      now.p = stiffness;
      return admissible(Way(now, of_the_point, way), f, delta);
    };
    return extended(
        one, [&](double speed) { return holds(speed, p); },
        [&](double stiffness) { return holds(v0, stiffness); });
  }
  const auto holds = [&](double speed, double stiffness) {
    return admissible({speed, stiffness, problem.beta, problem.criterion}, of_the_point, f, delta);
  };
  const auto with_v0 = [&](double value) { return holds(value, p); };
  const auto with_p = [&](double value) { return holds(v0, value); };
  const HitDamper damper{f, 2 * delta, problem.beta, problem.criterion};
  const Interval of_v0 = valid_v0(problem);
  const Interval of_p = valid_p(problem);
  // At the largest p rounding decides what nothing bounds.
  const bool limited = figures_edge(problem, limits) < HUGE_VAL;
  const auto ends = [limited](Wide low, Wide high, double nominal, const Interval& valid,
                              const auto& fits) {
    ServedInterval interval;
    interval.low =
        last_fit(std::max(static_cast<double>(low), std::min(nominal, valid.low)), nominal, fits);
    const double most = std::max(nominal, valid.high);
    if (high < HUGE_VAL || (limited && !fits(most))) {
      interval.high = last_fit(std::min(static_cast<double>(high), most), nominal, fits);
    }
    return interval;
  };
  return WorksFor{ends(lowest_v0(damper, p), highest_v0(damper, p), v0, of_v0, with_v0),
                  ends(lowest_p(damper, v0), highest_p(damper, v0), p, of_p, with_p)};
}

}  // namespace stillpoint::design
