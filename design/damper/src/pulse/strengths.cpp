// SPDX-License-Identifier: MIT
// Every strength of a pulse for one damper, docs/theory.md (71): edges of f/k, the motions between
// two of which are alike.
#include "pulse/served.hpp"

#include "pulse/edge.hpp"
#include "pulse/intervals.hpp"

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/hits.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace stillpoint::design {

namespace {

HitEnd end_of(const DamperRooms& damper, const FirstReturn& motion, double k, double p) {
  return damper.peak(motion, k, p) < 0                      ? HitEnd::too_far
         : !motion.returns                                  ? HitEnd::off_centre
         : damper.stop(motion, k, p, Criterion::exact) >= 0 ? HitEnd::centred
                                                            : HitEnd::passes;
}

/// The k at which something changes, in order, from `least` to `strongest`.
std::vector<double> edges(const DamperRooms& damper, const WorstReturn& motions, double p,
                          double least, double strongest) {
  const auto at = [&](double unit_f) { return motions.found_at(unit_f); };
  std::vector<double> found{least, strongest};
  const auto add = [&](double k) {
    if (least < k && k < strongest) {
      found.push_back(k);
    }
  };
  if (damper.f == 0) {
    add(farthest_k(damper, at(0), p));
    add(stopped_k(damper, at(0), p, Criterion::exact));
  } else {
    std::vector<FirstReturn> points = motions.samples();
    insert(points, {at(damper.f / strongest), at(nearest_to_k)});
    const auto add_edges = [&](const auto& room) {
      for (const Island& now : where(points, at, room)) {
        add(damper.f / now.high);
        add(damper.f / now.low);
      }
    };
    add_edges([&](const FirstReturn& now) { return damper.peak(now, damper.f / now.f, p); });
    add_edges([&](const FirstReturn& now) { return now.returns ? 1.0 : -1.0; });
    add_edges([&](const FirstReturn& now) {
      return damper.stop(now, damper.f / now.f, p, Criterion::exact);
    });
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace

std::vector<Hits> shown_strengths(const PulseProblem& problem, double f, double delta,
                                  double k_most) {
  const DamperRooms damper(problem, {}, f, delta);
  const double p = problem.p;
  const double strongest = std::min(std::max(2 * peak_load(problem.pulse), k_most), largest_speed);
  const double least = std::min(f, strongest);
  std::vector<Hits> list;
  const auto add = [&list](double from, double to, HitEnd end) {
    if (!list.empty() && list.back().end == end) {
      list.back().to = to;
    } else if (from < to) {
      list.push_back(
          {from, to, end, end == HitEnd::centred ? std::optional(1.0) : std::nullopt, {}});
    }
  };
  add(0, least, HitEnd::held);
  if (least == strongest) {
    return list;
  }
  const WorstReturn motions = for_any_k(problem);
  const std::vector<double> ends = edges(damper, motions, p, least, strongest);
  double from = least;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    // The edges of two requirements, or of one seen from either side, may differ by rounding.
    constexpr double apart = 1e-9;
    if (ends[i] - from <= apart * ends[i] && i + 1 < ends.size()) {
      continue;
    }
    const double k = from + (ends[i] - from) / 2;
    add(from, ends[i], end_of(damper, motions.found_at(f / k), k, p));
    from = ends[i];
  }
  return list;
}

}  // namespace stillpoint::design
