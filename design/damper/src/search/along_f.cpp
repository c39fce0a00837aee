// SPDX-License-Identifier: MIT
#include "falling_root.hpp"
#include "search/best_point.hpp"
#include "search/objectives.hpp"
#include "unit_problem.hpp"
#include "way/highest.hpp"
#include "way/room.hpp"
#include "way/space.hpp"

#include <stillpoint/core/elementary.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stillpoint::design {

namespace {

struct Timed {
  double delta{0};
  double cost{HUGE_VAL};
};

/// The soonest stop with that f where rests off centre are allowed. From some Delta on the mass
/// stops an arrival earlier, and with more Delta later again: each such Delta is tried, and the
/// ends.
Timed soonest_at(const Way& way, double f) {
  const double low = best_delta(way, f, BestDelta::least);
  const double high = best_delta(way, f, BestDelta::largest);
  Timed least{low};
  const auto consider = [&](double delta) {
    const double its = way_cost(way, Objective::time, {f, delta, 0});
    least = its < least.cost ? Timed{delta, its} : least;
  };
  consider(low);
  consider(high);
  for (int n = 1; n <= way.passages() && n < least.cost; ++n) {
    const double jump = d_that_stops_at(n, way.scaled(f)) * way.square() * (1 + way_inset);
    if (jump <= low) {
      break;  // nor is that of a later arrival larger
    }
    if (jump < high) {
      consider(jump);
    }
  }
  return least;
}

/// The same over all f. It jumps where such a Delta becomes small enough to be allowed, which it
/// does as f grows; between two jumps the minimum is sought.
void consider_soonest(const Way& way, const Interval& f, BestPoint& best) {
  const auto consider = [&](double at) { best.consider(at, soonest_at(way, at).delta); };
  const auto between = [&](double low, double high) {
    const auto worth = [&](double at) { return -soonest_at(way, at).cost; };
    if (!(low <= high)) {
      return;
    }
    consider(low);
    if (best.cost() > first_half_turn(way.scaled(low), way.scaled(high)) + clearly_better) {
      consider(high);
      consider(highest(worth, {low, high}).at);
    }
  };
  double end = f.high;
  for (int n = 1; n <= way.passages() && n < best.cost(); ++n) {
    const auto lacking = [&](double at) {
      return d_that_stops_at(n, way.scaled(at)) * way.square() -
             best_delta(way, at, BestDelta::largest);
    };
    const double at_low = lacking(f.low);
    const double at_end = lacking(end);
    if (at_low > 0 && at_end < 0) {
      const double jump = falling_root(lacking, f.low, end, at_low, at_end);
      between(jump * (1 + way_inset), end);
      end = jump * (1 - way_inset);
    } else if (at_low <= 0) {
      break;
    }
  }
  between(f.low, end);
}

/// It grows with f at the first arrival, and at later ones first falls and then grows; with Delta
/// it grows.
void consider_time(const Way& way, const Interval& f, BestPoint& best) {
  best.consider(f.low);
  if (way.q > 0) {
    consider_soonest(way, f, best);
  } else if (!way.is_papers_task()) {
    best.consider(f.high);
    const auto worth = [&](double at) {
      return -way_cost(way, Objective::time, {at, best_delta(way, at, BestDelta::least), 0});
    };
    best.consider(highest(worth, f).at);
  }
}

}  // namespace

double first_half_turn(double low, double high) {
  const double swings_back_below = 1 / std::numbers::sqrt3;
  const double before = elementary::atan2(1.0, high);
  double phase = low < unit::a3 ? unit::stop_phase(low) : HUGE_VAL;
  if (high > unit::a3) {
    phase = std::min(phase, before + std::numbers::pi);
  }
  return (high < swings_back_below ? phase : before) / std::numbers::pi;
}

void consider_along_f(const Way& way, Objective objective, const DesignRange& range,
                      BestPoint& best) {
  if (objective == Objective::robust) {
    best.consider(most_tolerant(way));
  } else if (objective == Objective::time) {
    consider_time(way, range.f, best);
  } else {  // depends on f alone
    best.consider(falls_with_f(objective) ? range.f.high : range.f.low);
  }
}

}  // namespace stillpoint::design
