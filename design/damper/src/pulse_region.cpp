// SPDX-License-Identifier: MIT
#include "pulse_region.hpp"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stillpoint::design {

namespace {

/// More than the rounding of a motion in other units, and less than anything that can be
/// built.
constexpr double edge_rounding = 1e-13;

double ratio_of_box(double tolerance) {
  return (1 + tolerance) / (1 - tolerance);
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
      asked_(limits.tolerance) {
  find_islands();
}

bool PulseRegion::holds(const FirstReturn& motion) const {
  return motion.returns && motion.f <= f_max_ && motion.peak <= beta_ &&
         motion.acceleration <= acceleration_max_;
}

void PulseRegion::find_islands() {
  std::vector<FirstReturn> points = profile_->samples();
  if (f_max_ <= points.back().f) {
    // Below every sample there is one more decade to look at.
    for (const double f : {f_max_ / 8, f_max_}) {
      points.push_back(at(f));
    }
    std::ranges::sort(points, {}, &FirstReturn::f);
  }
  if (std::isfinite(acceleration_max_)) {
    // It may be kept between two samples that do not keep it.
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
    return last_that_holds(inside, outside, [&](double f) { return holds(at(f)); });
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
             : profile_->need_between(low, high, criterion_) * ratio_of_box(tolerance) / delta_max_;
}

std::optional<double> PulseRegion::box_in(const Island& island, double tolerance) const {
  const double ratio = ratio_of_box(tolerance);
  const double last = island.high / ratio;
  if (island.low > last) {
    return std::nullopt;
  }
  const auto use = [&](double low) { return use_of_delta(low, low * ratio, tolerance); };
  if (use(last) <= 1) {
    return last;
  }
  // The need mostly falls with f. Where it does not, the box that needs least as far as the samples
  // know.
  const auto rough = [&](double low) {
    return profile_->rough_need_between(low, low * ratio, criterion_);
  };
  constexpr int steps = 100;
  double best = last;
  for (int i = 0; i < steps; ++i) {
    const double low = island.low * std::pow(last / island.low, static_cast<double>(i) / steps);
    if (rough(low) < rough(best)) {
      best = low;
    }
  }
  const double step = std::pow(last / island.low, 1.0 / steps);
  constexpr int bits = 30;
  const double refined =
      boost::math::tools::brent_find_minima(use, std::max(island.low, best / step),
                                            std::min(last, best * step), bits)
          .first;
  return use(refined) <= 1 ? std::optional(refined) : std::nullopt;
}

bool PulseRegion::feasible() const {
  return std::ranges::any_of(
      islands_, [&](const Island& island) { return box_in(island, asked_).has_value(); });
}

/// As far as f and delta_max, or the given Delta, allow.
double PulseRegion::widest(const Island& island, double f, double delta) const {
  const double most = std::max(widest_tolerance, asked_);
  const double of_f = std::min({most, (f - island.low) / f, (island.high - f) / f});
  const auto fits = [&](double tolerance) {
    const double low = std::max(island.low, f * (1 - tolerance));
    const double high = std::min(island.high, f * (1 + tolerance));
    if (std::isinf(delta)) {
      return use_of_delta(low, high, tolerance) <= 1;
    }
    return delta * (1 + tolerance) <= delta_max_ &&
           profile_->need_between(low, high, criterion_) <= delta * (1 - tolerance);
  };
  if (of_f < 0 || fits(of_f)) {
    return std::max(of_f, 0.0);
  }
  return fits(0) ? last_that_holds(0.0, of_f, fits) : 0;
}

DesignPoint PulseRegion::with_best_delta(const Island& island, double f) const {
  constexpr double reserve = 0.5;
  const double inside = std::clamp(f, island.low, island.high);
  const double tolerance = widest(island, inside, HUGE_VAL);
  const double need =
      profile_->need_between(std::max(island.low, inside * (1 - tolerance)),
                             std::min(island.high, inside * (1 + tolerance)), criterion_);
  // An arrival at rest needs a notch as well, of any size.
  const double least = std::max(need, std::numeric_limits<double>::epsilon() * at(inside).peak);
  const double delta = std::min(least / (1 - std::max(tolerance, reserve)) * (1 + edge_rounding),
                                delta_max_ / (1 + tolerance));
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
    const FirstReturn worst = profile_->between(f * (1 - tolerance), f * (1 + tolerance));
    return holds(worst) && f * (1 + tolerance) <= f_max_ && delta * (1 + tolerance) <= delta_max_ &&
           worst.need(criterion_) <= delta * (1 - tolerance);
  };
  if (!(f < profile_->samples().front().f && fits(0))) {
    return std::nullopt;
  }
  const double most = std::max(widest_tolerance, asked_);
  return fits(most) ? most : last_that_holds(0.0, most, fits);
}

}  // namespace stillpoint::design
