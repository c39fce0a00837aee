// SPDX-License-Identifier: MIT
#pragma once

// Mends of a case, a struct with `limits`. `fits(case)` says whether it has a design.

#include "nearest_fit.hpp"

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/limit_kinds.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/region_result.hpp>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

namespace stillpoint::design {

struct HitCase {
  Problem problem;
  Limits limits;
};

/// For an input that does not always help or always harm: the nearest value on either side that
/// fits, as far as `least` and `most`. An interval narrower than a step may be missed; the steps
/// grow by the factor `growth` each.
template <class Fits>
std::optional<double> nearest_either_way(double from, double least, double most, double growth,
                                         const Fits& fits, double close = 0) {
  double step = 1.02;
  double inner = 1;  // factors up to this are tried
  const auto nearest = [&](double inside, double to) {
    return inside != to && fits(to) ? nearest_fit(inside, to, fits, close) : std::nullopt;
  };
  while (from * inner < most || from / inner > least) {
    const double outer = inner * step;
    const auto up = nearest(std::min(from * inner, most), std::min(from * outer, most));
    const auto down = nearest(std::max(from / inner, least), std::max(from / outer, least));
    if (up || down) {
      return up && (!down || *up / from <= from / *down) ? up : down;
    }
    step = 1 + (step - 1) * growth;
    inner = outer;
  }
  return std::nullopt;
}

/// An input that helps more the closer it is to `to`; one with `least` may help either way, up to
/// `to` and down to `least`, by steps that grow.
template <class Case>
struct Input {
  std::string_view field;
  double from{0};
  double to{0};
  std::function<void(Case&, double)> set{};
  std::optional<double> least{};
  double growth{1};

  [[nodiscard]] Case in(Case changed, double value) const {
    set(changed, value);
    return changed;
  }
  [[nodiscard]] Mend mend(double value) const { return {field, value, value > from}; }
  /// If it suffices alone.
  template <class Fits>
  [[nodiscard]] std::optional<Mend> mend(const Case& base, const Fits& fits,
                                         double close = 0) const {
    const auto tried = [&](double value) { return fits(in(base, value)); };
    const auto value = least ? nearest_either_way(from, *least, to, growth, tried, close)
                             : nearest_fit(from, to, tried, close);
    return value ? std::optional(mend(*value)) : std::nullopt;
  }
};

/// Sets a member of the problem.
template <class Member>
auto in_problem(Member member) {
  return [member](auto& now, double value) { now.problem.*member = value; };
}

/// The limits that are set.
template <class Case>
std::vector<Input<Case>> limit_inputs(const Limits& limits) {
  std::vector<Input<Case>> list;
  for (const LimitKind& kind : limit_kinds()) {
    if (const auto& limit = limits.*kind.value) {
      list.push_back({kind.field, *limit, largest_square,
                      [&kind](Case& now, double value) { now.limits.*kind.value = value; }});
    }
  }
  if (limits.tolerance > 0) {
    list.push_back({"tolerance", limits.tolerance, 0.0,
                    [](Case& now, double value) { now.limits.tolerance = value; }});
  }
  return list;
}

/// The exact criterion, if it suffices alone.
template <class Case, class Fits>
std::optional<Criterion> exact_if_it_fits(Case now, const Fits& fits) {
  if (now.problem.criterion == Criterion::exact) {
    return std::nullopt;
  }
  now.problem.criterion = Criterion::exact;
  return fits(now) ? std::optional(Criterion::exact) : std::nullopt;
}

/// More arrivals are not suggested: searching for them would take seconds when there are none.
inline constexpr std::int64_t most_arrivals_offered = 100;

/// The least number of arrivals above that of the task that suffices alone. More arrivals never
/// hurt, so `fits`, a function of the number, holds from there on.
template <class Fits>
std::optional<Mend> arrivals_mend(const Problem& problem, const Fits& fits) {
  std::int64_t too_few = problem.arrivals;
  std::int64_t enough = problem.zeta.high > 0 ? most_damped_arrivals : most_arrivals_offered;
  if (too_few >= enough || !fits(enough)) {
    return std::nullopt;
  }
  while (enough - too_few > 1) {
    const std::int64_t middle = std::midpoint(too_few, enough);
    (fits(middle) ? enough : too_few) = middle;
  }
  return Mend{"arrivals", static_cast<double>(enough), true};
}

}  // namespace stillpoint::design
