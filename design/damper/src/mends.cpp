// SPDX-License-Identifier: MIT
#include "mend_list.hpp"
#include "nearest_fit.hpp"
#include "region_edges.hpp"

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/region.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

namespace {

struct Case {
  Problem problem;
  Limits limits;
};

bool amplitude_fits(const Case& now) {
  const Edges edge = edges(now.problem, now.limits);
  return amplitude_fits_return(edge, now.limits) && amplitude_fits_f_max(edge, now.limits);
}

bool acceleration_fits(const Case& now) {
  return amplitude_fits_acceleration(edges(now.problem, now.limits), now.limits);
}

bool strip_fits(const Case& now) {
  const Edges edge = edges(now.problem, now.limits);
  return edge.f4 >= 0 && stop_fits(now.problem, edge, now.limits);
}

bool feasible(const Case& now) {
  return amplitude_fits(now) && acceleration_fits(now) && strip_fits(now);
}

Input<Case> v0_of(const Problem& problem) {
  return {"v0", problem.v0, valid_v0(problem).least,
          [](Case& now, double value) { now.problem.v0 = value; }};
}

Input<Case> beta_of(const Problem& problem) {
  return {"beta", problem.beta,
          std::min({largest_square, largest_speed / problem.p, problem.v0 / problem.p * far_ratio}),
          [](Case& now, double value) { now.problem.beta = value; }};
}

/// The p at which a box has the most room between f2 and f4, the root of (34).
double roomiest_p(const Case& now) {
  const auto& [v0, p, beta, criterion] = now.problem;
  const double wider = (1 + now.limits.tolerance) / (1 - now.limits.tolerance);
  const double f4 = v0 / beta / wider * v0;
  const double most = now.limits.acceleration_max.value();
  return f4 < most ? std::sqrt((most - f4) / v0) * std::sqrt((most + f4) / v0) : 0;
}

/// More p helps the amplitude and can only harm the stop, so both are tested one after the other.
/// With a limit of the acceleration the p that fit are one interval; if it is not empty, the p with
/// the most room is in it, as far as the other conditions let it.
std::optional<double> mended_p(const Case& base, double least, double most) {
  const auto with = [&](double p) {
    Case changed = base;
    changed.problem.p = p;
    return changed;
  };
  if (base.limits.acceleration_max) {
    const auto low = nearest_fit(least, most, [&](double p) { return amplitude_fits(with(p)); });
    const auto high = nearest_fit(most, least, [&](double p) { return strip_fits(with(p)); });
    if (!low || !high || *low > *high) {
      return std::nullopt;
    }
    return nearest_fit(base.problem.p, std::clamp(roomiest_p(base), *low, *high),
                       [&](double p) { return feasible(with(p)); });
  }
  const auto raised =
      nearest_fit(base.problem.p, most, [&](double p) { return amplitude_fits(with(p)); });
  if (!raised) {
    return std::nullopt;
  }
  const auto value = nearest_fit(*raised, least, [&](double p) { return strip_fits(with(p)); });
  return value && feasible(with(*value)) ? value : std::nullopt;
}

}  // namespace

std::vector<Mend> mends(const Problem& problem, const Limits& limits) {
  require_valid(problem, limits);
  const Case base{problem, limits};
  std::vector<Mend> list;
  if (feasible(base)) {
    return list;
  }
  add_mend(list, base, feasible, v0_of(problem));
  const auto [least_p, most_p] = valid_p(problem);
  if (const auto p = mended_p(base, least_p, most_p)) {
    list.push_back({"p", *p, *p > problem.p});
  }
  add_mend(list, base, feasible, beta_of(problem));
  for (const Input<Case>& limit : limit_inputs<Case>(limits)) {
    add_mend(list, base, feasible, limit);
  }
  return list;
}

std::optional<JointMend> joint_mend(const Problem& problem, const Limits& limits) {
  const Case base{problem, limits};
  if (feasible(base) || !mends(problem, limits).empty()) {
    return std::nullopt;
  }
  // More p does no better than more beta: p beta / v0 is the same, and f_max comes nearer.
  return joint_mend_of(base, feasible, {beta_of(problem), v0_of(problem)});
}

}  // namespace stillpoint::design
