// SPDX-License-Identifier: MIT
#include "pulse/along_leg.hpp"

#include "pulse/edge.hpp"
#include "pulse/neighbours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

namespace stillpoint::design {

namespace {

/// Of s. Closer together, the sides of a jump are one place.
constexpr double one_place = 1e-13;

/// The need is no other on the other side of a change of turns.
bool continues(const FirstReturn& a, const FirstReturn& b) {
  constexpr double unseen = 1e-3;
  return a.returns && b.returns &&
         std::abs(a.exact_need - b.exact_need) <= unseen * std::max(a.exact_need, b.exact_need);
}

}  // namespace

AlongLeg::AlongLeg(const Leg& leg, double f) : leg_(leg), f_(f), clearance_(HUGE_VAL) {
  spots_.reserve(leg.stops.size());
  for (const double s : leg.stops) {
    spots_.push_back(spot(s));
    if (const FirstReturn& now = spots_.back().motion; now.returns) {
      clearance_ = std::min(clearance_, now.clearance);
    } else {
      found_miss(now);
    }
  }
  split_kinds();
  seek_misses();
  for (const auto figure : bounded_figures) {
    double most = 0;
    for (const Spot& now : spots_) {
      most = std::max(most, now.motion.*figure);
    }
    constexpr double rounding = 1e-13;
    raise([figure](const FirstReturn& now) { return now.*figure; },
          [&](const FirstReturn* now) {
            most = now == nullptr ? most : std::max(most, now->*figure);
            return most * (1 + rounding);
          });
  }
}

void AlongLeg::found_miss(const FirstReturn& motion) {
  returns_ = false;
  clearance_ = std::min(clearance_, motion.clearance);
}

void AlongLeg::split_kinds() {
  for (std::size_t i = 0; returns_ && i + 1 < spots_.size();) {
    if (!split(i)) {
      ++i;
    }
  }
  // A maximum between two jumps needs three motions to be seen.
  for (std::size_t i = 0; returns_ && i + 1 < spots_.size(); ++i) {
    const bool first = i == 0 || spots_[i - 1].before_jump;
    const bool last = i + 2 == spots_.size() || spots_[i + 1].before_jump;
    const double step = spots_[i + 1].s - spots_[i].s;
    constexpr double visible = 1e-4;
    if (first && last && !spots_[i].before_jump && step > visible * spots_[i].s) {
      insert(i + 1, spot(spots_[i].s + step / 2));
    }
  }
}

/// Looks for a jump between two neighbours. Whether it is known better than before.
bool AlongLeg::split(std::size_t first) {
  const Spot a = spots_[first];
  const Spot b = spots_[first + 1];
  if (a.motion.turns == b.motion.turns || a.before_jump || b.s - a.s <= one_place * b.s) {
    return false;
  }
  const bool a_holds = a.motion.turns < b.motion.turns;
  Spot holds = a_holds ? a : b;
  Spot fails = a_holds ? b : a;
  const double turns = holds.motion.turns;
  const auto clearance = [&](double s) {
    const Spot now = s == holds.s ? holds : s == fails.s ? fails : spot(s);
    const bool arrives = now.motion.returns && now.motion.turns <= turns;
    (arrives ? holds : fails) = now;
    return clearance_of(now.motion, turns);
  };
  last_not_negative(holds.s, fails.s, clearance, [&](double, double) {
    return !fails.motion.returns || continues(holds.motion, fails.motion) ||
           std::abs(fails.s - holds.s) <= one_place * fails.s;
  });
  if (!fails.motion.returns) {
    found_miss(fails.motion);
    return false;
  }
  Spot& low = a_holds ? holds : fails;
  const Spot& high = a_holds ? fails : holds;
  low.before_jump = !continues(low.motion, high.motion);
  const auto size = spots_.size();
  const auto place = [&](std::size_t i) { return spots_.begin() + static_cast<std::ptrdiff_t>(i); };
  if (high.s < b.s) {
    spots_.insert(place(first + 1), high);
  }
  if (low.s > a.s) {
    spots_.insert(place(first + 1), low);
  } else {
    spots_[first] = low;
  }
  return spots_.size() > size;
}

void AlongLeg::insert(std::size_t place, const Spot& now) {
  if (!now.motion.returns) {
    return found_miss(now.motion);
  }
  spots_.insert(spots_.begin() + static_cast<std::ptrdiff_t>(place), now);
  for (std::size_t i = place - 1, end = place + 1; returns_ && i < end;) {
    if (split(i)) {
      end += 1;
    } else {
      ++i;
    }
  }
}

/// Between three motions that return one may not: where the clearance has a minimum below 0.
void AlongLeg::seek_misses() {
  raise([](const FirstReturn& now) { return -now.clearance; },
        [](const FirstReturn*) { return 0.0; });
  for (std::size_t i = 1; returns_ && i + 1 < spots_.size(); ++i) {
    const Spot& before = spots_[i - 1];
    const Spot& now = spots_[i];
    const Spot& after = spots_[i + 1];
    if (!before.before_jump && !now.before_jump) {
      const auto bottom =
          top_of({before.s, -before.motion.clearance}, {now.s, -now.motion.clearance},
                 {after.s, -after.motion.clearance});
      clearance_ = std::min(clearance_, bottom ? -bottom->value : now.motion.clearance);
    }
  }
}

/// Adds the motion at each maximum of the figure that may be above `threshold`, which is told of
/// the motions that are found. The top of a parabola may be wrong by a part of what the figure
/// changes by in its three motions.
template <class Figure, class Threshold>
void AlongLeg::raise(const Figure& figure, const Threshold& threshold) {
  constexpr int most_steps = 12;
  constexpr double apart = 1e-7;  // leaves a value wrong by its square
  for (std::size_t i = 1; returns_ && i + 1 < spots_.size();) {
    const double next = spots_[i + 1].s;
    for (int step = 0; step < most_steps && returns_; ++step) {
      const Spot& before = spots_[i - 1];
      const Spot& now = spots_[i];
      const Spot& after = spots_[i + 1];
      if (before.before_jump || now.before_jump ||
          std::min(now.s - before.s, after.s - now.s) <= apart * now.s) {
        break;
      }
      const std::array<double, 3> values{figure(before.motion), figure(now.motion),
                                         figure(after.motion)};
      const auto top = top_of({before.s, values[0]}, {now.s, values[1]}, {after.s, values[2]});
      const auto [least, most] = std::ranges::minmax(values);
      if (!top || !(top->value + unsure_top * (most - least) > threshold(nullptr)) ||
          std::abs(top->at - now.s) <= apart * now.s || top->at == before.s || top->at == after.s) {
        break;
      }
      const Spot found = spot(top->at);
      const bool after_now = found.s > now.s;
      const double turns = now.motion.turns;
      (void)threshold(&found.motion);
      const bool better = figure(found.motion) > values[1];
      insert(after_now ? i + 1 : i, found);
      if (found.motion.turns != turns) {
        break;
      }
      i += (after_now && better) || (!after_now && !better) ? 1 : 0;
    }
    while (spots_[i].s < next) {
      ++i;
    }
  }
}

double AlongLeg::need_slope(std::size_t place, Criterion criterion) const {
  const Spot& now = spots_[place];
  const double p = leg_.p_at(now.s);
  const double by_f = now.motion.need_slope + (criterion == Criterion::published ? f_ / p / p : 0);
  const bool above = place > 0 && spots_[place - 1].before_jump;
  if (!above && !now.before_jump) {
    return by_f;
  }
  // The jump is where the clearance of the other side vanishes.
  const Spot& other = spots_[above ? place - 1 : place + 1];
  constexpr double part = 1e-6;
  const double aside = (above ? part : -part) * now.s;
  const double by_s =
      (spot(now.s + aside).motion.need(criterion) - now.motion.need(criterion)) / aside;
  const double clearance_by_s =
      (other.motion.clearance - spot(other.s - aside).motion.clearance) / aside;
  const double jump_by_f = -2 * other.motion.need_slope / clearance_by_s;
  return by_f + (std::isfinite(jump_by_f) ? by_s * jump_by_f : 0);
}

}  // namespace stillpoint::design
