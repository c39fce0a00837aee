// SPDX-License-Identifier: MIT
#include "pulse/legs.hpp"

#include <stillpoint/core/elementary.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace stillpoint::design {

namespace {

double length(const Pulse& pulse) {
  return *duration(excitation(pulse));
}

/// In steps of lambda/p by a tenth, and of the pulse's length by a third of a radian of the spring.
Leg leg_of(const Pulse& pulse, double p, bool softens, double ratio, double zeta) {
  constexpr double part = 0.1;
  constexpr double turn = 0.3;
  const double turned = length(pulse) * p * (1 - 1 / ratio);
  const double steps =
      std::max({std::ceil(elementary::log(ratio) / part), std::ceil(turned / turn), 2.0});
  Leg leg{pulse, p, softens, {1}, zeta};
  for (double i = 1; i < steps; ++i) {
    leg.stops.push_back(elementary::pow(ratio, i / steps));
  }
  leg.stops.push_back(ratio);
  return leg;
}

}  // namespace

Legs::Legs(const PulseProblem& problem)
    : criterion_(problem.criterion),
      softest_(unit_pulse(problem.pulse, problem.p)),
      zeta_(problem.zeta) {
  const double stiffest = problem.p_high.value_or(problem.p) / problem.p;
  const double longest = angular_frequency(problem.pulse);
  const double shortest = problem.ranges.lambda_high.value_or(longest);
  if (stiffest > 1) {
    legs_.push_back(leg_of(softest_, stiffest, true, stiffest, zeta_));
  }
  if (shortest > longest) {
    legs_.push_back(leg_of(softest_, 1, false, shortest / longest, zeta_));
  }
}

std::array<Pulse, 2> Legs::ends() const {
  if (is_single()) {
    return {softest_, softest_};
  }
  const Leg& first = legs_.front();
  const Leg& last = legs_.back();
  return {unit_pulse(first.first, first.p),
          unit_pulse(last.pulse_at(last.stops.back()), last.p_at(last.stops.back()))};
}

Legs::Worst Legs::at(double f) const {
  if (is_single()) {
    return {first_return(softest_, 1, f, zeta_), softest_, 1};
  }
  std::vector<AlongLeg> along;
  along.reserve(legs_.size());
  Worst worst;
  double largest_need = -1;
  double largest_peak = -1;
  std::size_t leg_of_need = 0;
  std::size_t spot_of_need = 0;
  FirstReturn most;
  bool returns = true;
  double clearance = HUGE_VAL;
  for (const Leg& leg : legs_) {
    const AlongLeg& now = along.emplace_back(leg, f);
    returns = returns && now.returns();
    clearance = std::min(clearance, now.clearance());
    for (std::size_t i = 0; i < now.spots().size(); ++i) {
      const auto& [s, motion, jump] = now.spots()[i];
      for (const auto figure : bounded_figures) {
        most.*figure = std::max(most.*figure, motion.*figure);
      }
      if (motion.peak > largest_peak) {
        largest_peak = motion.peak;
        worst.pulse = leg.pulse_at(s);
        worst.p = leg.p_at(s);
      }
      if (motion.need(criterion_) > largest_need) {
        largest_need = motion.need(criterion_);
        leg_of_need = along.size() - 1;
        spot_of_need = i;
        worst.motion = motion;
      }
    }
  }
  worst.motion.returns = returns;
  worst.motion.clearance = clearance;
  for (const auto figure : bounded_figures) {
    worst.motion.*figure = most.*figure;
  }
  if (returns) {
    // FirstReturn::slope adds f for the published criterion, as with p = 1.
    worst.motion.need_slope = along[leg_of_need].need_slope(spot_of_need, criterion_) -
                              (criterion_ == Criterion::published ? f : 0);
  }
  return worst;
}

}  // namespace stillpoint::design
