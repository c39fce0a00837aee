// SPDX-License-Identifier: MIT
#include "pulse/profile.hpp"

#include "golden_sections.hpp"
#include "pulse/edge.hpp"
#include "pulse/first_return.hpp"
#include "pulse/neighbours.hpp"

#include <stillpoint/core/elementary.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace stillpoint::design {

namespace {

/// The integral of |W|; a polygon does not change its sign.
double impulse(const Pulse& pulse) {
  return std::visit(
      []<class Kind>(const Kind& kind) {
        if constexpr (IsPolygon<Kind>) {
          double twice = 0;  // of its mean
          for (const auto* to = Kind::corners.begin() + 1; to != Kind::corners.end(); ++to) {
            twice += (to->time - (to - 1)->time) * (to->load + (to - 1)->load);
          }
          return twice * Kind::turns * std::numbers::pi / kind.lambda;
        } else {
          return (IsSquare<Kind> ? std::numbers::pi : 4) * Kind::turns / kind.lambda;
        }
      },
      pulse);
}

/// The first f to try. The spring of a mass that the pulse has given the speed I reaches
/// p I at most, so with a short pulse f is of that order. Fractions are those of the smaller of p I
/// and k; a pulse of one sign brings nothing back beyond half of it, (67), a full sine does up to
/// k.
std::vector<double> first_grid(const Pulse& pulse) {
  constexpr double least = 1e-9;
  constexpr int small = 3;
  constexpr int large = 5;
  const double scale = std::min(1.0, impulse(pulse));
  const bool both_ways = std::holds_alternative<FullSine>(pulse);
  const int even = both_ways ? 12 : 16;
  const int last = both_ways ? even : even / 2;
  std::vector<double> grid;
  grid.reserve(static_cast<std::size_t>(small + last + large));
  for (int i = 0; i < small; ++i) {
    grid.push_back(scale * least *
                   elementary::pow(1 / (even * least), static_cast<double>(i) / small));
  }
  for (int i = 1; i <= last; ++i) {
    grid.push_back(std::min(nearest_to_k, scale * i / even));
  }
  for (int i = 1; both_ways && scale < nearest_to_k && i <= large; ++i) {
    grid.push_back(scale * elementary::pow(nearest_to_k / scale, static_cast<double>(i) / large));
  }
  // Under a rectangle the mass is held from its n-th turn on where f >= 1/(2 n + 1).
  constexpr double below = 1 - 1e-14;
  for (int n = 1; std::holds_alternative<Rectangle>(pulse) && n * angular_frequency(pulse) < 1;
       ++n) {
    grid.push_back(1.0 / (2 * n + 1));
    grid.push_back(grid.back() * below);
  }
  std::ranges::sort(grid);
  return grid;
}

}  // namespace

PulseProfile::PulseProfile(At at, const std::array<Pulse, 2>& between, Criterion criterion,
                           bool k_varies, const Interval& window)
    : at_(std::move(at)),
      criterion_(criterion),
      has_flat_(std::holds_alternative<Trapezoid>(between.front())) {
  std::vector<double> grid = first_grid(between.front());
  if (angular_frequency(between.front()) != angular_frequency(between.back())) {
    const std::vector<double> more = first_grid(between.back());
    grid.insert(grid.end(), more.begin(), more.end());
    std::ranges::sort(grid);
    grid.erase(std::unique(grid.begin(), grid.end()), grid.end());
  }
  if (window != Interval{0, 1}) {
    std::erase_if(grid, [&](double f) { return f <= window.low || f >= window.high; });
    grid.insert(grid.begin(), window.low);
    if (window.high > window.low && window.high < nearest_to_k) {
      grid.push_back(window.high);
    }
  }
  for (const double f : grid) {
    const FirstReturn now = this->at(f);
    if (!samples_.empty()) {
      const FirstReturn before = samples_.back();
      add_between(before, now, 0);
    }
    largest_ = std::max(largest_, now.exact_need);
    samples_.push_back(now);
  }
  add_misses(angular_frequency(between.front()) == angular_frequency(between.back()));
  if (k_varies) {
    add_maxima_over_square();
    add_slowest();
  }
}

void PulseProfile::add_between(const FirstReturn& a, const FirstReturn& b, int depth) {
  constexpr int deepest = 8;
  if (!(a.returns || b.returns) || depth > deepest || b.f - a.f <= 2 * edge_width(a.f, b.f)) {
    return;
  }
  const bool smooth = is_smooth(a, b, largest_);
  if (a.returns != b.returns || (!smooth && may_jump(a, b, depth))) {
    add_edge(a, b, depth);
    return;
  }
  const Rated from = need_of(a, criterion_);
  const Rated to = need_of(b, criterion_);
  const bool has_top = from.slope > 0 && to.slope < 0;
  if (has_top && has_flat_ && (smooth || depth == deepest)) {
    add_kink(a, b);
  } else if (has_top && smooth) {
    const FirstReturn top = maximum(
        a, b, [this](double f) { return at(f); },
        [this](const FirstReturn& now) { return need_of(now, criterion_); });
    if (a.f < top.f && top.f < b.f) {
      samples_.push_back(top);
    }
  } else if (!smooth || ((from.slope > 0 || to.slope < 0) && top_of_cubic(from, to, b.f - a.f))) {
    const FirstReturn middle = at(a.f + (b.f - a.f) / 2);
    add_between(a, middle, depth + 1);
    samples_.push_back(middle);
    add_between(middle, b, depth + 1);
  }
}

/// Both sides of the f where the mass stops to return, or where it first misses x = 0 and comes
/// back from another swing: there w^2 vanishes, and what it is short of on the other side.
void PulseProfile::add_edge(const FirstReturn& a, const FirstReturn& b, int depth) {
  const bool a_holds = b.returns ? a.returns && a.turns < b.turns : true;
  const double turns = a.returns && b.returns ? std::min(a.turns, b.turns) : HUGE_VAL;
  FirstReturn holds = a_holds ? a : b;
  FirstReturn fails = a_holds ? b : a;
  const auto clearance = [&](double f) {
    const FirstReturn now = f == holds.f ? holds : f == fails.f ? fails : at(f);
    const bool arrives = now.returns && now.turns <= turns;
    (arrives ? holds : fails) = now;
    return clearance_of(now, turns);
  };
  last_not_negative(holds.f, fails.f, clearance,
                    [&](double, double) { return is_smooth(holds, fails, largest_); });
  const FirstReturn& low = a_holds ? holds : fails;
  const FirstReturn& high = a_holds ? fails : holds;
  add_between(a, low, depth + 1);
  if (low.f > a.f) {
    samples_.push_back(low);
  }
  if (is_smooth(low, high, largest_)) {
    add_between(low, high, depth + 1);
  }
  if (high.f < b.f) {
    samples_.push_back(high);
  }
  add_between(high, b, depth + 1);
}

/// Where the need is largest, without slopes: near a kink they are differences across it.
void PulseProfile::add_kink(const FirstReturn& a, const FirstReturn& b) {
  constexpr double across = 4e-6;
  const auto need = [this](double f) { return at(f).need(criterion_); };
  const auto done = [](const Interval& span, double, double) {
    return span.high - span.low <= edge_width(span.low, span.high);
  };
  samples_.push_back(at(golden_sections({a.f * (1 - across), b.f}, need, done)));
}

/// Between three motions that arrive one may miss x = 0: where the clearance has a minimum below 0.
/// The need of one pulse is half of it; the largest need of several says nothing of the least.
void PulseProfile::add_misses(bool one_pulse) {
  constexpr int most_steps = 12;
  constexpr double apart = 1e-7;
  const std::vector<FirstReturn> known = samples_;
  for (std::size_t i = 1; i + 1 < known.size(); ++i) {
    FirstReturn a = known[i - 1];
    FirstReturn now = known[i];
    FirstReturn b = known[i + 1];
    if (one_pulse && !(a.need_slope < 0 && b.need_slope > 0)) {
      continue;
    }
    for (int step = 0; step < most_steps && a.returns && now.returns && b.returns; ++step) {
      const auto [least, most] = std::minmax({a.clearance, now.clearance, b.clearance});
      const auto bottom = top_of({a.f, -a.clearance}, {now.f, -now.clearance}, {b.f, -b.clearance});
      if (!bottom || bottom->value + unsure_top * (most - least) <= 0 ||
          std::min({now.f - a.f, b.f - now.f, std::abs(bottom->at - now.f)}) <= apart * now.f) {
        break;
      }
      const FirstReturn next = at(bottom->at);
      const bool above = next.f > now.f;
      if (!next.returns) {
        add_edge(above ? now : a, next, 0);
        samples_.push_back(next);
        add_edge(next, above ? b : now, 0);
        break;
      }
      if (next.clearance < now.clearance) {
        (above ? a : b) = now;
        now = next;
      } else {
        (above ? b : a) = next;
      }
    }
  }
  std::ranges::sort(samples_, {}, &FirstReturn::f);
  const auto same = [](const FirstReturn& x, const FirstReturn& y) { return x.f == y.f; };
  samples_.erase(std::unique(samples_.begin(), samples_.end(), same), samples_.end());
}

void PulseProfile::add_maxima_over_square() {
  add_maxima(
      samples_, at_, [this](const FirstReturn& now) { return need_over_square(now, criterion_); },
      [](const FirstReturn& a, const FirstReturn& b) {
        return a.returns && b.returns && b.f - a.f > 2 * edge_width(a.f, b.f);
      });
}

/// Between three samples of which the middle one returns last.
void PulseProfile::add_slowest() {
  const auto time = [this](double f) { return at(f).time; };
  constexpr double close = 1e-6;  // leaves the largest time wrong by the square of it
  const auto done = [](const Interval& span, double place, double) {
    return span.high - span.low <= close * place;
  };
  std::vector<FirstReturn> found;
  for (std::size_t i = 1; i + 1 < samples_.size(); ++i) {
    const FirstReturn& a = samples_[i - 1];
    const FirstReturn& now = samples_[i];
    const FirstReturn& b = samples_[i + 1];
    if (a.returns && now.returns && b.returns && a.turns == now.turns && now.turns == b.turns &&
        now.time >= a.time && now.time >= b.time) {
      found.push_back(at(golden_sections({a.f, b.f}, time, done)));
    }
  }
  insert(samples_, found);
}

}  // namespace stillpoint::design
