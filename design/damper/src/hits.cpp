// SPDX-License-Identifier: MIT
// In speeds: phi = f/p, d = 2 Delta, and the radius r_n of the n-th half-cycle. An edge is a radius
// r_n followed back to r_1 and V0 by (39).
#include "wide.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/names.hpp>
#include <stillpoint/design/hits.hpp>

#include <algorithm>

namespace stillpoint::design {

namespace {

struct Damper : WideNotch {
  Wide p;

  /// The V0 of a first radius.
  [[nodiscard]] Wide speed(Wide radius) const {
    return root(std::max(Wide(0), square_before(radius, 0)));
  }
  [[nodiscard]] Wide radius_of_half_cycle(int n, Wide v0) const {
    Wide radius = root(v0 * v0 + phi * phi);
    for (int i = 1; i < n; ++i) {
      const Wide t = radius - 2 * phi;
      radius = root(std::max(Wide(0), t * t - d));
    }
    return radius;
  }
};

/// The farthest rest of the n-th half-cycle for V0 from `from` to `to`; it is f/p^2 at `farthest`.
double rest(const Damper& damper, int n, Wide from, Wide to, Wide farthest) {
  Wide rest = damper.phi;
  if (farthest > to) {
    rest = damper.radius_of_half_cycle(n, to) - damper.phi;  // (5)
  } else if (farthest < from) {
    rest = 3 * damper.phi - damper.radius_of_half_cycle(n, from);  // (6)
  }
  const auto x = static_cast<double>(std::clamp(rest, Wide(0), damper.phi) / damper.p);
  return n % 2 == 1 ? x : -x;
}

/// The growing list, from the lowest V0 that starts a motion to the highest listed.
struct Listing {
  Wide lowest;
  Wide highest;
  std::vector<Hits> list;

  void add(Wide from, Wide to, HitEnd end, const std::optional<double>& arrivals = {}) {
    list.push_back({static_cast<double>(from), static_cast<double>(to), end, arrivals, {}});
  }
};

/// Up to a rest of `within` p from x = 0, at most phi, off centre is within the residual.
void add_motions(Listing& now, const Damper& damper, Wide within) {
  Wide stop = damper.phi;               // radius of the stop edge of the arrival before, (41)
  Wide near = damper.phi + within;      // of the first rest as far as the residual
  Wide far = 2 * damper.phi;            // of the farthest rest, (42)
  Wide back = 3 * damper.phi - within;  // of the last rest as far as the residual
  Wide reach = 3 * damper.phi;          // of the reach edge, (40)
  for (int n = 1; damper.speed(stop) < now.highest; ++n) {
    const Wide stop_here = damper.before(stop);
    const Wide low = std::max(now.lowest, damper.speed(stop));
    if (static_cast<int>(now.list.size()) >= most_hit_segments) {
      now.add(low, now.highest, HitEnd::alternating, n - 1);
      return;
    }
    Wide from = low;
    const auto up_to = [&](Wide radius, HitEnd end) {
      const Wide to = std::clamp(damper.speed(radius), from, std::max(from, now.highest));
      if (static_cast<double>(from) < static_cast<double>(to)) {
        const bool centred = end == HitEnd::centred;
        now.add(from, to, end, centred ? n : n - 1);
        if (!centred) {
          now.list.back().rest = rest(damper, n, from, to, damper.speed(far));
        }
      }
      from = to;
    };
    up_to(within < damper.phi ? near : reach, HitEnd::within_residual);
    up_to(back, HitEnd::off_centre);
    up_to(reach, HitEnd::within_residual);
    up_to(stop_here, HitEnd::centred);
    stop = stop_here;
    for (Wide* const edge : {&near, &far, &back, &reach}) {
      *edge = damper.before(*edge);
    }
  }
}

/// Every edge moves one way as p grows. So springs between two that end alike do too, and between
/// two stops at different arrivals some spring lets the mass rest in the dead zone.
Hits of_both(const Hits& softest, const Hits& stiffest) {
  Hits both = softest;
  both.rest = {};
  if (softest.end != stiffest.end) {
    const bool far = softest.end == HitEnd::too_far || stiffest.end == HitEnd::too_far;
    both.end = far ? HitEnd::too_far : HitEnd::off_centre;
    both.arrivals = {};
    both.every_spring = false;
  } else if (softest.arrivals != stiffest.arrivals) {
    both.arrivals = {};
    both.every_spring = softest.end == HitEnd::alternating;
    both.end = both.every_spring ? softest.end : HitEnd::off_centre;
  }
  return both;
}

}  // namespace

std::span<const Named<HitEnd>> enumerators(HitEnd) noexcept {
  static constexpr auto rows =
      std::to_array<Named<HitEnd>>({{HitEnd::held, "held"},
                                    {HitEnd::centred, "centred"},
                                    {HitEnd::within_residual, "within_residual"},
                                    {HitEnd::off_centre, "off_centre"},
                                    {HitEnd::alternating, "alternating"},
                                    {HitEnd::passes, "passes"},
                                    {HitEnd::too_far, "too_far"},
                                    {HitEnd::never_stops, "never_stops"}});
  return rows;
}

std::vector<Hits> hits(const Oscillator& oscillator, double beta, double v0_most, double residual) {
  require_valid(oscillator);
  require_within("beta", beta, smallest_limit, largest_square);
  require_within("v0", v0_most, smallest_speed, largest_speed);
  require_within("residual", residual, 0, largest_square);
  const auto& [p, f, delta, hold] = oscillator;
  const Damper damper{{f / Wide(p), 2 * Wide(delta)}, p};
  const Wide start = std::min(Wide(v0_most), root(damper.d));
  const Wide speed = Wide(beta) * p;
  const Wide peak_limit = root(speed) * root(speed + 2 * damper.phi);
  Listing now{start, std::clamp(peak_limit, start, Wide(v0_most)), {}};
  if (start > 0) {
    now.add(0, start, HitEnd::held);
  }
  if (now.lowest < now.highest) {
    if (f == 0 && delta == 0) {
      now.add(0, now.highest, HitEnd::never_stops);
    } else {
      add_motions(now, damper, std::min(Wide(residual) * p, damper.phi));
    }
  }
  if (now.highest < v0_most) {
    now.add(now.highest, v0_most, HitEnd::too_far);
  }
  return now.list;
}

std::vector<Hits> shown_hits(const Problem& problem, double f, double delta) {
  return hits({problem.p, f, delta}, problem.beta, std::min(2 * problem.v0, largest_speed),
              problem.residual.value_or(0));
}

std::vector<Hits> shown_hits_of_springs(const Problem& problem, double f, double delta) {
  if (!problem.p_high) {
    return shown_hits(problem, f, delta);
  }
  Problem one = problem;
  one.residual.reset();
  const auto softest = shown_hits(one, f, delta);
  one.p = *problem.p_high;
  const auto stiffest = shown_hits(one, f, delta);
  std::vector<Hits> list;
  double from = 0;
  auto soft = softest.begin();
  auto stiff = stiffest.begin();
  while (soft != softest.end() && stiff != stiffest.end()) {
    Hits now = of_both(*soft, *stiff);
    now.from = from;
    now.to = from = std::min(soft->to, stiff->to);
    soft += soft->to == from ? 1 : 0;
    stiff += stiff->to == from ? 1 : 0;
    Hits* const last = list.empty() ? nullptr : &list.back();
    if (last != nullptr && last->end == now.end && last->every_spring == now.every_spring &&
        last->arrivals == now.arrivals) {
      last->to = now.to;
    } else if (now.from < now.to) {
      list.push_back(now);
    }
  }
  return list;
}

}  // namespace stillpoint::design
