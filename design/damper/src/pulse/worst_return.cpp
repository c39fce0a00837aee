// SPDX-License-Identifier: MIT
#include "pulse/worst_return.hpp"

#include "pulse/edge.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stillpoint::design {

WorstReturn::WorstReturn(const PulseProblem& problem, bool k_varies, const Interval& window)
    : weakest_(problem.ranges.k_low.value_or(peak_load(problem.pulse)) / peak_load(problem.pulse)),
      legs_(std::make_shared<const Legs>(problem)),
      strongest_([legs = legs_](double f) { return legs->at(f).motion; }, legs_->ends(),
                 problem.criterion, k_varies || weakest_ < 1,
                 {window.low, std::min(1.0, window.high / weakest_)}) {
  add_samples(window);
}

FirstReturn WorstReturn::only_at(const PulseProblem& problem, double f) {
  return WorstReturn(problem, false, {f, f}).samples().front();
}

/// Where k has a range, the worst of it is largest, or jumps, at these f and where they are those
/// of the weakest pulse.
void WorstReturn::add_samples(const Interval& window) {
  samples_ = strongest_.samples();
  if (weakest_ == 1) {
    return;
  }
  std::vector<double> grid;
  for (const FirstReturn& now : samples_) {
    grid.push_back(now.f);
    grid.push_back(now.f * weakest_);
  }
  std::erase_if(grid, [&](double f) { return f < window.low || f > window.high; });
  std::ranges::sort(grid);
  grid.erase(std::unique(grid.begin(), grid.end()), grid.end());
  const auto returns = [&](double f) { return found_at(f).returns; };
  samples_.clear();
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

FirstReturn WorstReturn::at(double f) const {
  const auto sample = std::ranges::lower_bound(samples_, f, {}, &FirstReturn::f);
  return sample != samples_.end() && sample->f == f ? *sample : found_at(f);
}

/// At f/k for every k: as f/k grows from f/k_high to f/k_low.
FirstReturn WorstReturn::found_at(double f) const {
  if (is_single()) {
    return strongest_.at(f);
  }
  const auto& all = strongest_.samples();
  const auto known = [&](double at) {
    const auto sample = std::ranges::lower_bound(all, at, {}, &FirstReturn::f);
    return sample != all.end() && sample->f == at ? *sample : strongest_.at(at);
  };
  FirstReturn worst = known(f);
  if (weakest_ < 1) {
    const double most = f / weakest_;
    take_worse(worst, rescaled(known(most), weakest_, 1));
    for (auto now = std::ranges::upper_bound(all, f, {}, &FirstReturn::f);
         now != all.end() && now->f < most; ++now) {
      take_worse(worst, rescaled(*now, f / now->f, 1));
    }
    constexpr double rounding = 1e-14;
    worst.returns = worst.returns && most <= nearest_to_k * (1 + rounding);
  }
  return worst;
}

PulseProblem WorstReturn::largest_peak(PulseProblem problem, double f) const {
  if (!legs_->is_single()) {
    const Legs::Worst worst = legs_->at(f);
    problem.pulse =
        with(problem.pulse, peak_load(problem.pulse), angular_frequency(worst.pulse) * problem.p);
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

const FirstReturn& KnownMotions::at(double f) {
  const auto place = std::ranges::lower_bound(motions_, f, {}, &FirstReturn::f);
  return place != motions_.end() && place->f == f ? *place
                                                  : *motions_.insert(place, profile_.found_at(f));
}

double KnownMotions::need_between(double low, double high, Criterion criterion) {
  const double most =
      std::max(at(low).need(criterion), profile_.need_of_samples(low, high, criterion));
  return profile_.most_need(high, criterion) <= most ? most
                                                     : std::max(most, at(high).need(criterion));
}

double KnownMotions::need_slope(double f, Criterion criterion) {
  if (profile_.is_single()) {
    return at(f).slope(criterion);
  }
  constexpr double aside = 1e-7;
  const double need = at(f).need(criterion);
  return (need - at(f * (1 - aside)).need(criterion)) / (f * aside);
}

std::vector<FirstReturn> KnownMotions::between(double low, double high) {
  (void)at(low);
  (void)at(high);
  return {std::ranges::lower_bound(motions_, low, {}, &FirstReturn::f),
          std::ranges::upper_bound(motions_, high, {}, &FirstReturn::f)};
}

}  // namespace stillpoint::design
