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

/// The margin of the requirements that do not concern Delta: the smallest, as a fraction of its
/// limit; they hold if this is >= 0.
double PulseRegion::room(const FirstReturn& motion) const {
  if (!motion.returns) {
    return -1;
  }
  const auto left = [](double value, double limit) {
    return std::isinf(limit) ? 1 : (limit - value) / limit;
  };
  return std::min({left(motion.f, f_max_), left(motion.peak, beta_),
                   left(motion.acceleration, acceleration_max_)});
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
    // It may be met between two samples that do not meet it.
    std::vector<FirstReturn> found;
    constexpr int bits = 24;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const double now = points[i].acceleration;
      if (now > acceleration_max_ && now <= points[i - 1].acceleration &&
          now <= points[i + 1].acceleration) {
        const auto acceleration = [&](double f) { return at(f).acceleration; };
        found.push_back(at(boost::math::tools::brent_find_minima(acceleration, points[i - 1].f,
                                                                 points[i + 1].f, bits)
                               .first));
      }
    }
    points.insert(points.end(), found.begin(), found.end());
    std::ranges::sort(points, {}, &FirstReturn::f);
  }
  const auto edge = [&](double inside, double outside) {
    return last_not_negative(inside, outside, [&](double f) { return room(at(f)); });
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!holds(points[i])) {
      continue;
    }
    const double low = i == 0 ? points[i].f : edge(points[i].f, points[i - 1].f);
    while (i + 1 < points.size() && holds(points[i + 1])) {
      ++i;
    }
    const double high = i + 1 == points.size() ? points[i].f : edge(points[i].f, points[i + 1].f);
    if (low * (1 + edge_rounding) <= high * (1 - edge_rounding)) {
      islands_.push_back({low * (1 + edge_rounding), high * (1 - edge_rounding)});
    }
  }
}

double PulseRegion::use_of_delta(double low, double high, double tolerance) const {
  return std::isinf(delta_max_)
             ? 0
             : profile_->need_between(low, high, criterion_) * (1 + shape_.delta_high * tolerance) /
                   (1 - shape_.delta_low * tolerance) / delta_max_;
}

double PulseRegion::most_tolerance() const {
  return std::max(widest_tolerance, asked_);
}

std::optional<FrictionBox> PulseRegion::cheapest_box(const Island& island, double tolerance) const {
  const double ratio = high_of(1, tolerance) / low_of(1, tolerance);
  const double last = island.high / ratio;
  if (island.low > last) {
    return std::nullopt;
  }
  const auto use = [&](double low) { return use_of_delta(low, low * ratio, tolerance); };
  const FrictionBox at_last{last, use(last)};
  if (at_last.use <= 1 || profile_->need_falls(island.low, island.high, criterion_)) {
    return at_last;
  }
  // The box that needs least, according to the samples.
  const auto rough = [&](double low) {
    return profile_->rough_need_between(low, low * ratio, criterion_);
  };
  constexpr int steps = 100;
  const double step = elementary::pow(last / island.low, 1.0 / steps);
  double best = last;
  double least = rough(last);
  double low = island.low;
  for (int i = 0; i < steps; ++i, low *= step) {
    const double now = rough(low);
    if (now < least) {
      best = low;
      least = now;
    }
  }
  constexpr double aside = 1e-4;
  if (best == last && use(last - (last - island.low) * aside) >= at_last.use) {
    return at_last;
  }
  constexpr int bits = 24;
  const auto [at, value] = boost::math::tools::brent_find_minima(
      use, std::max(island.low, best / step), std::min(last, best * step), bits);
  return value < at_last.use ? FrictionBox{at, value} : at_last;
}

std::optional<double> PulseRegion::box_in(const Island& island, double tolerance) const {
  const auto box = cheapest_box(island, tolerance);
  return box && box->use <= 1 ? std::optional(box->low) : std::nullopt;
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
