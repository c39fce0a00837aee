// SPDX-License-Identifier: MIT
#include "pulse/worst_return.hpp"

#include "pulse/edge.hpp"

#include <stillpoint/core/elementary.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace stillpoint::design {

namespace {

/// The quantities that grow with k and fall with p, and others bounded from above.
constexpr std::array bounded_figures{&FirstReturn::peak,       &FirstReturn::speed,
                                     &FirstReturn::time,       &FirstReturn::acceleration,
                                     &FirstReturn::exact_need, &FirstReturn::published_need};

void take_worse(FirstReturn& worst, const FirstReturn& other) {
  worst.returns = worst.returns && other.returns;
  for (const auto figure : bounded_figures) {
    worst.*figure = std::max(worst.*figure, other.*figure);
  }
}

/// A motion of the unit pulse on the unit spring as that of the load k on the spring p, both over
/// the units: (60) of docs/theory.md.
FirstReturn rescaled(FirstReturn motion, double k, double p) {
  if (k == 1 && p == 1) {
    return motion;
  }
  const double length = k / p / p;
  motion.f *= k;
  motion.peak *= length;
  motion.speed *= length * p;
  motion.time /= p;
  motion.acceleration *= k;
  motion.exact_need *= length * k;
  motion.published_need *= length * k;
  return motion;
}

Pulse with_wave(Pulse pulse, double k, double lambda) {
  std::visit(
      [&](auto& kind) {
        kind.k = k;
        kind.lambda = lambda;
      },
      pulse);
  return pulse;
}

/// A value and its position.
struct Placed {
  double at;
  double value;
};

/// The top of the parabola through three values, if it is between them; else the largest.
double top_of(const Placed& before, const Placed& now, const Placed& after) {
  const double largest = std::max({before.value, now.value, after.value});
  const double left = now.at - before.at;
  const double right = after.at - now.at;
  const double down_left = (now.value - before.value) / left;
  const double down_right = (now.value - after.value) / right;
  const double curvature = (down_left + down_right) / (left + right);
  const double slope = (down_left * right - down_right * left) / (left + right);
  if (!(curvature > 0) || slope < -2 * curvature * left || slope > 2 * curvature * right) {
    return largest;
  }
  return std::max(largest, now.value + slope * slope / (4 * curvature));
}

}  // namespace

WorstReturn::WorstReturn(const PulseProblem& problem, bool k_varies)
    : WorstReturn(problem, k_varies, {0, 1}) {
  add_samples();
}

WorstReturn::WorstReturn(const PulseProblem& problem, bool k_varies, const Interval& window)
    : criterion_(problem.criterion),
      weakest_(problem.ranges.k_low.value_or(peak_load(problem.pulse)) / peak_load(problem.pulse)),
      k_varies_(k_varies || weakest_ < 1) {
  add_cases(problem, window);
}

FirstReturn WorstReturn::only_at(const PulseProblem& problem, double f) {
  const double k = peak_load(problem.pulse);
  const Interval window{f, f / (problem.ranges.k_low.value_or(k) / k)};
  return WorstReturn(problem, false, window).found_at(f);
}

/// The two legs of (61).
void WorstReturn::add_cases(const PulseProblem& problem, const Interval& window) {
  const double lambda = angular_frequency(problem.pulse) / problem.p;
  const double shortest =
      problem.ranges.lambda_high.value_or(angular_frequency(problem.pulse)) / problem.p;
  const double stiffest = problem.p_high.value_or(problem.p) / problem.p;
  const Pulse unit = with_wave(problem.pulse, 1, lambda);
  add_leg(window, unit, lambda, stiffest, lambda, 1);
  corner_ = cases_.size();
  add_leg(window, unit, lambda, 1, shortest, 1);
  cases_.push_back(
      {shortest, 1, PulseProfile(with_wave(unit, 1, shortest), 1, criterion_, k_varies_, window)});
}

/// Without its end. The ratio lambda/p grows along it.
void WorstReturn::add_leg(const Interval& window, const Pulse& unit, double lambda, double p,
                          double to_lambda, double to_p) {
  const double ratio = (to_lambda / lambda) * (p / to_p);
  if (!(ratio > 1)) {
    return;
  }
  // In steps of lambda/p by a tenth, and of the pulse's length by a third of a radian of the
  // spring.
  constexpr double part = 0.1;
  constexpr double turn = 0.3;
  constexpr double most = 64;
  const double turned = *duration(excitation(with_wave(unit, 1, lambda))) * p -
                        *duration(excitation(with_wave(unit, 1, to_lambda))) * to_p;
  const double steps =
      std::clamp(std::ceil(std::max(elementary::log(ratio) / part, turned / turn)), 2.0, most);
  const auto count = static_cast<std::size_t>(steps);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / steps;
    const double now = lambda * elementary::pow(to_lambda / lambda, share);
    const double spring = p * elementary::pow(to_p / p, share);
    cases_.push_back(
        {now, spring,
         PulseProfile(with_wave(unit, 1, now), spring, criterion_, k_varies_, window)});
  }
}

void WorstReturn::add_samples() {
  if (is_single()) {
    samples_ = cases_.front().profile.samples();
    return;
  }
  std::vector<double> grid;
  for (const Case& one : cases_) {
    for (const FirstReturn& now : one.profile.samples()) {
      grid.push_back(now.f);
      grid.push_back(now.f * weakest_);
    }
  }
  std::ranges::sort(grid);
  grid.erase(std::unique(grid.begin(), grid.end()), grid.end());
  const auto returns = [&](double f) { return found_at(f).returns; };
  samples_.reserve(2 * grid.size());
  for (const double f : grid) {
    FirstReturn now = found_at(f);
    if (!samples_.empty() && samples_.back().returns != now.returns) {
      // Rounding may have moved the edge of the return away from both samples. Both sides of it are
      // samples, so that nobody looks for it again: rounding decides about the last f below a full
      // sine's k, and another search might end elsewhere.
      const double before = samples_.back().f;
      const Bracket edge = narrowed({now.returns ? f : before, now.returns ? before : f}, returns);
      for (const double side :
           {std::min(edge.holds, edge.fails), std::max(edge.holds, edge.fails)}) {
        if (side != before && side != f) {
          samples_.push_back(found_at(side));
        }
      }
    }
    samples_.push_back(now);
  }
}

/// At f/k for every k: as f/k grows from f/k_high to f/k_low.
FirstReturn WorstReturn::worst_of(const Case& one, double f) const {
  FirstReturn worst = rescaled(one.profile.at(f), 1, one.p);
  if (weakest_ < 1) {
    const double most = f / weakest_;
    take_worse(worst, rescaled(one.profile.at(most), weakest_, one.p));
    const auto& all = one.profile.samples();
    for (auto now = std::ranges::upper_bound(all, f, {}, &FirstReturn::f);
         now != all.end() && now->f < most; ++now) {
      take_worse(worst, rescaled(*now, f / now->f, one.p));
    }
    constexpr double rounding = 1e-14;
    worst.returns = worst.returns && most <= nearest_to_k * (1 + rounding);
  }
  return worst;
}

FirstReturn WorstReturn::at(double f) const {
  const auto sample = std::ranges::lower_bound(samples_, f, {}, &FirstReturn::f);
  return sample != samples_.end() && sample->f == f ? *sample : found_at(f);
}

FirstReturn WorstReturn::found_at(double f) const {
  FirstReturn worst = worst_of(cases_.front(), f);
  if (cases_.size() == 1) {
    return worst;
  }
  std::vector<FirstReturn> each{worst};
  each.reserve(cases_.size());
  for (std::size_t i = 1; i < cases_.size(); ++i) {
    each.push_back(worst_of(cases_[i], f));
    take_worse(worst, each.back());
  }
  // Between the cases it may be larger. The excess of the parabola over its three values is counted
  // twice.
  const auto placed = [&](std::size_t i, const auto figure) {
    return Placed{elementary::log(cases_[i].lambda / cases_[i].p), each[i].*figure};
  };
  for (std::size_t i = 1; worst.returns && i + 1 < each.size(); ++i) {
    if (i == corner_) {
      continue;
    }
    for (const auto figure : bounded_figures) {
      const Placed before = placed(i - 1, figure);
      const Placed now = placed(i, figure);
      const Placed after = placed(i + 1, figure);
      const double largest = std::max({before.value, now.value, after.value});
      worst.*figure = std::max(worst.*figure, 2 * top_of(before, now, after) - largest);
    }
  }
  return worst;
}

PulseProblem WorstReturn::largest_peak(PulseProblem problem, double f) const {
  const auto peak = [&](const Case& one) { return one.profile.at(f).peak / one.p / one.p; };
  const Case& worst =
      cases_.size() == 1 ? cases_.front() : *std::ranges::max_element(cases_, {}, peak);
  if (cases_.size() > 1) {
    problem.pulse = with_wave(problem.pulse, peak_load(problem.pulse), worst.lambda * problem.p);
    problem.p *= worst.p;
  }
  problem.ranges = {};
  problem.p_high = std::nullopt;
  return problem;
}

FirstReturn WorstReturn::between(double low, double high) const {
  FirstReturn worst = at(low);
  take_worse(worst, at(high));
  for (auto now = std::ranges::lower_bound(samples_, low, {}, &FirstReturn::f);
       now != samples_.end() && now->f <= high; ++now) {
    take_worse(worst, *now);
  }
  return worst;
}

double WorstReturn::most_need(double f, Criterion criterion) const {
  const auto after = std::ranges::lower_bound(samples_, f, {}, &FirstReturn::f);
  return is_single() && after != samples_.begin() && after != samples_.end()
             ? std::max((after - 1)->need(criterion), after->need(criterion))
             : HUGE_VAL;
}

double WorstReturn::need_of_samples(double low, double high, Criterion criterion) const {
  double most = 0;
  for (auto now = std::ranges::lower_bound(samples_, low, {}, &FirstReturn::f);
       now != samples_.end() && now->f <= high; ++now) {
    most = std::max(most, now->need(criterion));
  }
  return most;
}

}  // namespace stillpoint::design
