// SPDX-License-Identifier: MIT
#include "mend_list.hpp"
#include "nearest_fit.hpp"
#include "region_edges.hpp"

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/region.hpp>

#include <algorithm>

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

bool strip_fits(const Case& now) {
  return stop_fits(now.problem, edges(now.problem, now.limits), now.limits);
}

bool feasible(const Case& now) {
  return amplitude_fits(now) && strip_fits(now);
}

// How far an input is changed: as long as it stays valid (problem.hpp), but for one decade.
constexpr double ratio = 1e99;

Input<Case> v0_of(const Problem& problem) {
  return {"v0", problem.v0, std::max(smallest_speed, problem.p * problem.beta / ratio),
          [](Case& now, double value) { now.problem.v0 = value; }};
}

Input<Case> beta_of(const Problem& problem) {
  return {"beta", problem.beta,
          std::min({largest_square, largest_speed / problem.p, problem.v0 / problem.p * ratio}),
          [](Case& now, double value) { now.problem.beta = value; }};
}

double least_p(const Problem& problem) {
  return std::max(
      {smallest_speed, smallest_speed / problem.beta, problem.v0 / problem.beta / ratio});
}

double most_p(const Problem& problem) {
  return std::min({largest_speed, largest_speed / problem.beta, problem.v0 / problem.beta * ratio});
}

/// More p helps the amplitude and can only harm the stop, so both are tested one after the other.
std::optional<double> mended_p(const Case& base, double least, double most) {
  const auto with = [&](double p) {
    Case changed = base;
    changed.problem.p = p;
    return changed;
  };
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
  if (const auto p = mended_p(base, least_p(problem), most_p(problem))) {
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
