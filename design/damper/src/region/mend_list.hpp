// SPDX-License-Identifier: MIT
#pragma once

// Mends of a case, a struct with `limits`. `fits(case)` says whether it has a design.

#include "nearest_fit.hpp"

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/region_result.hpp>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

namespace stillpoint::design {

/// An input that helps more the closer it is to `to`.
template <class Case>
struct Input {
  std::string_view field;
  double from{0};
  double to{0};
  void (*set)(Case&, double){nullptr};

  [[nodiscard]] Case in(Case changed, double value) const {
    set(changed, value);
    return changed;
  }
  [[nodiscard]] double moved(double factor) const {
    return to > from ? std::min(from * factor, to) : std::max(from / factor, to);
  }
  [[nodiscard]] Mend mend(double value) const { return {field, value, value > from}; }
};

/// The limits that are set.
template <class Case>
std::vector<Input<Case>> limit_inputs(const Limits& limits) {
  std::vector<Input<Case>> list;
  if (limits.f_max) {
    list.push_back({"f_max", *limits.f_max, largest_square,
                    [](Case& now, double value) { now.limits.f_max = value; }});
  }
  if (limits.delta_max) {
    list.push_back({"delta_max", *limits.delta_max, largest_square,
                    [](Case& now, double value) { now.limits.delta_max = value; }});
  }
  if (limits.acceleration_max) {
    list.push_back({"acceleration_max", *limits.acceleration_max, largest_square,
                    [](Case& now, double value) { now.limits.acceleration_max = value; }});
  }
  if (limits.tolerance > 0) {
    list.push_back({"tolerance", limits.tolerance, 0.0,
                    [](Case& now, double value) { now.limits.tolerance = value; }});
  }
  return list;
}

/// The mend of one input, if it suffices alone.
template <class Case, class Fits>
void add_mend(std::vector<Mend>& list, const Case& base, const Fits& fits,
              const Input<Case>& input) {
  if (const auto nearest = nearest_fit(input.from, input.to,
                                       [&](double value) { return fits(input.in(base, value)); })) {
    list.push_back(input.mend(*nearest));
  }
}

/// More arrivals are not suggested: searching for them would take seconds when there are none.
inline constexpr std::int64_t most_arrivals_offered = 100;

/// The least number of arrivals above that of the task that suffices alone. More arrivals never
/// hurt, so `fits`, a function of the number, holds from there on.
template <class Fits>
std::optional<Mend> arrivals_mend(const Problem& problem, const Fits& fits) {
  std::int64_t too_few = problem.arrivals;
  std::int64_t enough = most_arrivals_offered;
  if (too_few >= enough || !fits(enough)) {
    return std::nullopt;
  }
  while (enough - too_few > 1) {
    const std::int64_t middle = std::midpoint(too_few, enough);
    (fits(middle) ? enough : too_few) = middle;
  }
  return Mend{"arrivals", static_cast<double>(enough), true};
}

/// The JointMend of a case without a single one. `inputs` are those that bring the peak below beta,
/// the likeliest to be changed first; the tolerance is the last of the limits.
template <class Case, class Fits>
std::optional<JointMend> joint_mend_of(const Case& base, const Fits& fits,
                                       const std::vector<Input<Case>>& inputs) {
  constexpr double far = 1e99;     // to the end of every input
  constexpr double nearer = 1e-9;  // is the same
  const auto limits = limit_inputs<Case>(base.limits);
  if (!(base.limits.tolerance > 0)) {
    return std::nullopt;
  }
  const Input<Case>& tolerance = limits.back();
  Case wide = inputs.front().in(base, inputs.front().to);
  wide.limits = {};
  const auto largest = nearest_fit(tolerance.from, tolerance.to,
                                   [&](double value) { return fits(tolerance.in(wide, value)); });
  std::vector<Input<Case>> others = inputs;
  others.insert(others.end(), limits.begin(), limits.end() - 1);
  std::optional<double> least;
  JointMend joint{largest.value_or(0), {}};
  for (const Input<Case>& other : others) {
    const auto with = [&](double value, double its_tolerance) {
      return fits(tolerance.in(other.in(base, value), its_tolerance));
    };
    const auto factor = nearest_fit(
        1.0, far, [&](double by) { return with(other.moved(by), tolerance.moved(by)); });
    if (!factor || (least && *factor >= *least * (1 - nearer))) {
      continue;
    }
    least = factor;
    // One of them may have gone farther than necessary. At the largest possible tolerance rounding
    // decides, so the other is sought slightly inside it.
    const double most = tolerance.moved(*factor) * (1 - nearer);
    const double value =
        *nearest_fit(other.from, other.moved(*factor), [&](double now) { return with(now, most); });
    const double its_tolerance =
        *nearest_fit(tolerance.from, most, [&](double now) { return with(value, now); });
    joint.mends = {tolerance.mend(its_tolerance), other.mend(value)};
  }
  return least ? std::optional(joint) : std::nullopt;
}

}  // namespace stillpoint::design
