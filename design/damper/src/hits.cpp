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
    Wide radius = root(square(v0) + square(phi));
    for (int i = 1; i < n; ++i) {
      radius = root(std::max(Wide(0), square(radius - twice(phi)) - d));
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
  std::vector<int> places;  ///< of each in the order of all edges, see below

  void add(Wide from, Wide to, HitEnd end, int place = 0,
           const std::optional<double>& arrivals = {}) {
    list.push_back({static_cast<double>(from), static_cast<double>(to), end, arrivals, {}});
    places.push_back(place);
  }
};

/// Of the n-th half-cycle, in this order; where the dead zone is within the residual, only the last
/// two. 4 (n - 1) + that is the place of a segment.
enum HitPart { near_peak, too_far_off, near_centre, stopped };
constexpr int hit_parts = 4;

/// Up to a rest of `within` p from x = 0, at most phi, off centre is within the residual.
void add_motions(Listing& now, const Damper& damper, Wide within) {
  Wide stop = damper.phi;               // radius of the stop edge of the arrival before, (41)
  Wide near = damper.phi + within;      // of the first rest as far as the residual
  Wide far = twice(damper.phi);         // of the farthest rest, (42)
  Wide back = 3 * damper.phi - within;  // of the last rest as far as the residual
  Wide reach = 3 * damper.phi;          // of the reach edge, (40)
  for (int n = 1; damper.speed(stop) < now.highest; ++n) {
    const Wide stop_here = damper.before(stop);
    const Wide low = std::max(now.lowest, damper.speed(stop));
    if (static_cast<int>(now.list.size()) >= most_hit_segments) {
      now.add(low, now.highest, HitEnd::alternating, hit_parts * (n - 1) + too_far_off, n - 1);
      return;
    }
    Wide from = low;
    const auto up_to = [&](Wide radius, HitEnd end, HitPart part) {
      const Wide to = std::clamp(damper.speed(radius), from, std::max(from, now.highest));
      if (static_cast<double>(from) < static_cast<double>(to)) {
        const bool centred = end == HitEnd::centred;
        now.add(from, to, end, hit_parts * (n - 1) + part, centred ? n : n - 1);
        if (!centred) {
          now.list.back().rest = rest(damper, n, from, to, damper.speed(far));
        }
      }
      from = to;
    };
    if (within < damper.phi) {
      up_to(near, HitEnd::within_residual, near_peak);
      up_to(back, HitEnd::off_centre, too_far_off);
    }
    up_to(reach, HitEnd::within_residual, near_centre);
    up_to(stop_here, HitEnd::centred, stopped);
    stop = stop_here;
    for (Wide* const edge : {&near, &far, &back, &reach}) {
      *edge = damper.before(*edge);
    }
  }
}

Listing listed(const Oscillator& oscillator, double beta, double v0_most, double residual) {
  const double p = oscillator.p;
  const double f = oscillator.f;
  const double delta = oscillator.delta;
  const Damper damper{{Wide(f) / p, 2 * delta}, p};
  const Wide start = std::min(Wide(v0_most), root(damper.d));
  const Wide speed = Wide(beta) * p;
  const Wide peak_limit = root(speed) * root(speed + twice(damper.phi));
  Listing now{start, std::clamp(peak_limit, start, Wide(v0_most)), {}, {}};
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
  return now;
}

/// Whether a segment off centre is between two places or one of them.
bool passes_off(int one, int other) {
  const auto [first, last] = std::minmax(one, other);
  return first + (hit_parts + too_far_off - first % hit_parts) % hit_parts <= last;
}

/// The worst of softer springs, of a stiffer one and of those between; `off` if some of the latter
/// let the mass rest off centre.
Hits worse_of_springs(Hits softer, const Hits& stiffer, bool off) {
  const bool end_alike = softer.end == stiffer.end && !off;
  const bool alternating = softer.end == HitEnd::alternating;
  softer.rest = {};
  if (end_alike && softer.arrivals == stiffer.arrivals) {
    return softer;
  }
  softer.arrivals = {};
  if (end_alike && alternating) {
    return softer;
  }
  const auto is_either = [&](HitEnd end) { return softer.end == end || stiffer.end == end; };
  softer.every_spring = false;
  softer.end = is_either(HitEnd::too_far)                            ? HitEnd::too_far
               : off || alternating || is_either(HitEnd::off_centre) ? HitEnd::off_centre
                                                                     : HitEnd::within_residual;
  return softer;
}

/// Up to which reports show hits.
double shown_v0(const Problem& problem) {
  return std::min(2 * problem.v0, largest_speed);
}

/// A place in the list of a spring.
struct OfSpring {
  Listing listing;
  std::size_t at{0};

  [[nodiscard]] const Hits& hits() const { return listing.list[at]; }
  [[nodiscard]] int place() const { return listing.places[at]; }
  [[nodiscard]] bool ended() const { return at == listing.list.size(); }
};

/// The last spring whose dead zone is not within the residual, but for rounding.
double last_with_off_centre(const Problem& problem, double f) {
  constexpr double below = 1 - 1e-12;
  return problem.residual.value_or(0) > 0 ? below * std::sqrt(f / *problem.residual) : HUGE_VAL;
}

/// The softest spring, the stiffest, and that one if it is between them. Between two of these every
/// edge moves one way: docs/theory.md section 10.
std::vector<OfSpring> decisive_springs(const Problem& problem, double f, double delta) {
  const double residual = problem.residual.value_or(0);
  std::vector<OfSpring> springs;
  const auto add = [&](double p) {
    springs.push_back({listed({p, f, delta}, problem.beta, shown_v0(problem), residual)});
  };
  add(problem.p);
  const double last = last_with_off_centre(problem, f);
  if (problem.p < last && last < *problem.p_high) {
    add(last);
  }
  add(*problem.p_high);
  return springs;
}

}  // namespace

std::vector<Hits> hits(const Oscillator& oscillator, double beta, double v0_most, double residual) {
  require_valid(oscillator);
  require_within("beta", beta, smallest_limit, largest_square);
  require_within("v0", v0_most, smallest_speed, largest_speed);
  require_within("residual", residual, 0, largest_square);
  return listed(oscillator, beta, v0_most, residual).list;
}

std::vector<Hits> shown_hits(const Problem& problem, double f, double delta) {
  if (!problem.p_high) {
    return hits({problem.p, f, delta}, problem.beta, shown_v0(problem),
                problem.residual.value_or(0));
  }
  std::vector<OfSpring> springs = decisive_springs(problem, f, delta);
  std::vector<Hits> list;
  double from = 0;
  while (std::ranges::none_of(springs, &OfSpring::ended)) {
    const OfSpring& softest = springs[0];
    const OfSpring& next = springs[1];
    const bool off = problem.p < last_with_off_centre(problem, f) &&
                     softest.place() != next.place() && passes_off(softest.place(), next.place());
    Hits now = worse_of_springs(softest.hits(), next.hits(), off);
    if (springs.size() > 2) {
      now = worse_of_springs(now, springs[2].hits(), false);
    }
    now.from = from;
    now.to = HUGE_VAL;
    for (const OfSpring& each : springs) {
      now.to = std::min(now.to, each.hits().to);
    }
    from = now.to;
    for (OfSpring& each : springs) {
      each.at += each.hits().to == from ? 1U : 0U;
    }
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

std::optional<Interval> hits_above_limit(const Problem& problem, const Limits& limits, double f,
                                         const std::vector<Hits>& hits) {
  if (!limits.acceleration_max) {
    return std::nullopt;
  }
  const double limit = *limits.acceleration_max;
  const double from =
      limit > f ? std::sqrt((limit - f) * (limit + f)) / problem.p_high.value_or(problem.p) : 0;
  const auto far = std::ranges::find(hits, HitEnd::too_far, &Hits::end);
  const double to = far == hits.end() ? hits.back().to : far->from;
  return from < to ? std::optional(Interval{from, to}) : std::nullopt;
}

}  // namespace stillpoint::design
