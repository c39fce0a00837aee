// SPDX-License-Identifier: MIT
#include "pulse/region.hpp"

#include <stillpoint/core/elementary.hpp>
#include "pulse/edge.hpp"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stillpoint::design {

namespace {

/// More than the rounding of a motion in other units, and less than any manufacturing accuracy.
constexpr double edge_rounding = 1e-13;

void insert(std::vector<FirstReturn>& points, const std::vector<FirstReturn>& more) {
  points.insert(points.end(), more.begin(), more.end());
  std::ranges::sort(points, {}, &FirstReturn::f);
}

}  // namespace

PulseRegion::PulseRegion(std::shared_ptr<const WorstReturn> profile, const PulseProblem& problem,
                         const Limits& limits)
    : profile_(std::move(profile)),
      criterion_(problem.criterion),
      k_(peak_load(problem.pulse)),
      length_(k_ / problem.p / problem.p),
      beta_(problem.beta / length_ * (1 - edge_rounding)),
      f_max_(limits.f_max.value_or(HUGE_VAL) / k_ * (1 - edge_rounding)),
      delta_max_(limits.delta_max.value_or(HUGE_VAL) / length_ / k_ * (1 - edge_rounding)),
      acceleration_max_(limits.acceleration_max.value_or(HUGE_VAL) / k_ * (1 - edge_rounding)),
      asked_(limits.tolerance),
      shape_(limits.shape) {
  find_islands();
}

/// By how much f_max, beta and the limit of acceleration are kept, as parts of them: >= 0 where
/// they are.
PulseRegion::Rooms PulseRegion::rooms(const FirstReturn& motion) const {
  if (!motion.returns) {
    return {-1, -1, -1};
  }
  const auto left = [](double value, double limit) {
    return std::isinf(limit) ? 1 : (limit - value) / limit;
  };
  return {left(motion.f, f_max_), left(motion.peak, beta_),
          left(motion.acceleration, acceleration_max_)};
}

double PulseRegion::room(const FirstReturn& motion) const {
  return std::ranges::min(rooms(motion));
}

void PulseRegion::find_islands() {
  std::vector<FirstReturn> points = profile_->samples();
  if (f_max_ <= points.back().f) {
    // Below every sample there is one more decade to examine.
    for (const double f : {f_max_ / 8, f_max_}) {
      points.push_back(at(f));
    }
    std::ranges::sort(points, {}, &FirstReturn::f);
  }
  if (std::isfinite(acceleration_max_)) {
    add_minima(
        points, [&](const FirstReturn& now) { return now.acceleration; }, acceleration_max_);
  }
  add_overlaps(points);
  islands_ = where(points, [&](const FirstReturn& now) { return room(now); });
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

/// A figure may be within its limit between two points where it is not.
template <class Figure>
void PulseRegion::add_minima(std::vector<FirstReturn>& points, const Figure& figure,
                             double limit) const {
  constexpr int bits = 24;
  std::vector<FirstReturn> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const FirstReturn& before = points[i == 0 ? 0 : i - 1];
    const FirstReturn& after = points[std::min(i + 1, points.size() - 1)];
    const double now = figure(points[i]);
    if (now > limit && now <= figure(before) && now <= figure(after) && before.f < after.f) {
      const auto value = [&](double f) { return figure(at(f)); };
      found.push_back(
          at(boost::math::tools::brent_find_minima(value, before.f, after.f, bits).first));
    }
  }
  insert(points, found);
}

/// The intervals in which `room` is >= 0, a little inside of their edges.
template <class Room>
std::vector<Island> PulseRegion::where(const std::vector<FirstReturn>& points,
                                       const Room& room) const {
  const auto edge = [&](double inside, double outside) {
    return last_not_negative(inside, outside, [&](double f) { return room(at(f)); });
  };
  std::vector<Island> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (room(points[i]) < 0) {
      continue;
    }
    const double low = i == 0 ? points[i].f : edge(points[i].f, points[i - 1].f);
    while (i + 1 < points.size() && room(points[i + 1]) >= 0) {
      ++i;
    }
    const double high = i + 1 == points.size() ? points[i].f : edge(points[i].f, points[i + 1].f);
    if (low * (1 + edge_rounding) <= high * (1 - edge_rounding)) {
      found.push_back({low * (1 + edge_rounding), high * (1 - edge_rounding)});
    }
  }
  return found;
}

std::vector<Island> PulseRegion::left_by_delta(const Island& island, double tolerance,
                                               double use) const {
  if (std::isinf(delta_max_)) {
    return {island};
  }
  const double most = use * delta_max_ * (1 - shape_.delta_low * tolerance) /
                      (1 + shape_.delta_high * tolerance) * (1 - edge_rounding);
  const auto need = [&](const FirstReturn& now) { return now.need(criterion_); };
  std::vector<FirstReturn> points{at(island.low)};
  for (const FirstReturn& now : profile_->samples()) {
    if (island.low < now.f && now.f < island.high) {
      points.push_back(now);
    }
  }
  points.push_back(at(island.high));
  add_minima(points, need, most);
  return where(points, [&](const FirstReturn& now) { return most - need(now); });
}

double PulseRegion::use_of_delta(double low, double high, double tolerance,
                                 RecentMotions* recent) const {
  return std::isinf(delta_max_) ? 0
                                : profile_->need_between(low, high, criterion_, recent) *
                                      (1 + shape_.delta_high * tolerance) /
                                      (1 - shape_.delta_low * tolerance) / delta_max_;
}

double PulseRegion::most_tolerance() const {
  return std::max(widest_tolerance, asked_);
}

double PulseRegion::room_for(const Island& island, double tolerance, double use) const {
  double widest = 0;
  for (const Island& part : left_by_delta(island, tolerance, use)) {
    widest = std::max(widest, part.high / part.low);
  }
  return widest * low_of(1, tolerance) / high_of(1, tolerance) - 1;
}

std::optional<double> PulseRegion::box_in(const Island& island, double tolerance,
                                          double use) const {
  const double ratio = high_of(1, tolerance) / low_of(1, tolerance);
  const double last = island.high / ratio;
  if (last < island.low) {
    return std::nullopt;
  }
  if (use_of_delta(last, island.high, tolerance) <= use * (1 - edge_rounding)) {
    return last;
  }
  const std::vector<Island> parts = left_by_delta(island, tolerance, use);
  const auto part = std::find_if(parts.rbegin(), parts.rend(), [ratio](const Island& now) {
    return now.low * ratio <= now.high;
  });
  return part == parts.rend() ? std::nullopt : std::optional(part->high / ratio);
}

bool PulseRegion::feasible() const {
  return std::ranges::any_of(
      islands_, [&](const Island& island) { return box_in(island, asked_).has_value(); });
}

/// As far as f and delta_max, or the given Delta, allow.
double PulseRegion::widest(const Island& island, double f, double delta) const {
  // A side of the box that does not move allows any tolerance.
  const auto along = [](double room, double side) { return side > 0 ? room / side : HUGE_VAL; };
  const double of_f = f < island.low || f > island.high
                          ? 0
                          : std::min({most_tolerance(), along((f - island.low) / f, shape_.f_low),
                                      along((island.high - f) / f, shape_.f_high)});
  const auto room = [&](double tolerance) {
    const double low = std::max(island.low, low_of(f, tolerance));
    const double high = std::min(island.high, high_of(f, tolerance));
    if (std::isinf(delta)) {
      return 1 - use_of_delta(low, high, tolerance);
    }
    return std::min(
        delta_max_ - delta * (1 + shape_.delta_high * tolerance),
        delta * (1 - shape_.delta_low * tolerance) - profile_->need_between(low, high, criterion_));
  };
  if (room(of_f) >= 0) {
    return of_f;
  }
  return room(0) >= 0 ? last_not_negative(0.0, of_f, room) : 0;
}

DesignPoint PulseRegion::with_best_delta(const Island& island, double f) const {
  constexpr double reserve = 0.5;
  const double inside = std::clamp(f, island.low, island.high);
  const double tolerance = widest(island, inside, HUGE_VAL);
  const double need =
      profile_->need_between(std::max(island.low, low_of(inside, tolerance)),
                             std::min(island.high, high_of(inside, tolerance)), criterion_);
  // An arrival at rest needs a notch as well, of any size.
  const double least = std::max(need, std::numeric_limits<double>::epsilon() * at(inside).peak);
  const double delta =
      std::min(least / (1 - std::max(shape_.delta_low * tolerance, reserve)) * (1 + edge_rounding),
               delta_max_ / (1 + shape_.delta_high * tolerance));
  return {inside, delta, tolerance};
}

std::optional<double> PulseRegion::tolerance_of(double f, double delta) const {
  for (const Island& island : islands_) {
    if (island.low <= f && f <= island.high && delta <= delta_max_ &&
        at(f).need(criterion_) <= delta) {
      return widest(island, f, delta);
    }
  }
  // Below every sample nothing but the need changes.
  const auto fits = [&](double tolerance) {
    const double high = high_of(f, tolerance);
    const FirstReturn worst = profile_->between(low_of(f, tolerance), high);
    return holds(worst) && high <= f_max_ &&
           delta * (1 + shape_.delta_high * tolerance) <= delta_max_ &&
           worst.need(criterion_) <= delta * (1 - shape_.delta_low * tolerance);
  };
  if (!(f < profile_->samples().front().f && fits(0))) {
    return std::nullopt;
  }
  const double most = most_tolerance();
  return fits(most) ? most : last_that_holds(0.0, most, fits);
}

}  // namespace stillpoint::design
