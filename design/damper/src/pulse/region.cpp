// SPDX-License-Identifier: MIT
#include "pulse/region.hpp"

#include "pulse/edge.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stillpoint::design {

PulseRegion::PulseRegion(std::shared_ptr<const WorstReturn> profile, const PulseProblem& problem,
                         const Limits& limits)
    : profile_(std::move(profile)),
      criterion_(problem.criterion),
      k_(peak_load(problem.pulse)),
      length_(k_ / problem.p / problem.p),
      beta_(problem.beta / length_ * (1 - edge_rounding)),
      f_max_(least_limit(Bounded::f, limits) / k_ * (1 - edge_rounding)),
      delta_max_(least_limit(Bounded::delta, limits) / length_ / k_ * (1 - edge_rounding)),
      asked_(limits.tolerance),
      shape_(limits.shape) {
  std::ranges::transform(limited_figures, figures_max_.begin(), [&](const LimitKind* kind) {
    return limit_or_infinity(*kind, limits) / k_ * (1 - edge_rounding);
  });
  find_islands();
}

/// By how much each is kept, as a part of it: >= 0 where it is.
PulseRegion::Rooms PulseRegion::rooms(const FirstReturn& motion) const {
  Rooms left{};
  if (!motion.returns) {
    left.fill(-1);
    return left;
  }
  const auto room = [](double value, double limit) {
    return std::isinf(limit) ? 1 : (limit - value) / limit;
  };
  left[0] = room(motion.f, f_max_);
  left[1] = room(motion.peak, beta_);
  for (std::size_t i = 0; i < figure_count; ++i) {
    left[2 + i] = room(motion.*limited_figures[i]->figure->under_pulse, figures_max_[i]);
  }
  return left;
}

void PulseRegion::find_islands() {
  const auto at_f = [&](double f) { return at(f); };
  std::vector<FirstReturn> points = profile_->samples();
  if (f_max_ <= points.back().f) {
    // Below every sample there is one more decade to examine.
    constexpr double lower = 1.0 / 8;
    if (f_max_ < points.front().f || f_max_ * lower > points.front().f) {
      insert(points, {at(f_max_ * lower)});
    }
    insert(points, {at(f_max_)});
  }
  for (std::size_t i = 0; i < figure_count; ++i) {
    if (std::isfinite(figures_max_[i])) {
      const auto figure = limited_figures[i]->figure->under_pulse;
      add_minima(
          points, at_f, [figure](const FirstReturn& now) { return now.*figure; }, figures_max_[i]);
    }
  }
  add_overlaps(points);
  islands_ = where(points, at_f, [&](const FirstReturn& now) { return room(now); });
}

/// Where one of two neighbours keeps what the other one does not, both may be kept between them:
/// the edge of the one requirement is where the other one is known.
void PulseRegion::add_overlaps(std::vector<FirstReturn>& points) const {
  std::vector<FirstReturn> found;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const FirstReturn& a = points[i - 1];
    const FirstReturn& b = points[i];
    const Rooms of_a = rooms(a);
    const Rooms of_b = rooms(b);
    const auto kept_by_one = [](double one, double other) { return std::max(one, other) >= 0; };
    if (holds(a) || holds(b) ||
        !std::equal(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), kept_by_one)) {
      continue;
    }
    for (std::size_t limit = 0; limit < of_a.size(); ++limit) {
      if (of_a[limit] < 0) {
        found.push_back(
            at(last_not_negative(b.f, a.f, [&](double f) { return rooms(at(f))[limit]; })));
      }
    }
  }
  insert(points, found);
}

}  // namespace stillpoint::design
