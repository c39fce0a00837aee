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

/// More p helps the amplitude and can only harm the stop, so both are asked one after the other.
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
  // As far as the changed input stays valid (problem.hpp), but for one decade.
  constexpr double ratio = 1e99;
  const double speed = problem.p * problem.beta;
  const double least_v0 = std::max(smallest_speed, speed / ratio);
  add_mend(list, base, feasible, "v0", problem.v0, least_v0,
           [](Case& now, double value) { now.problem.v0 = value; });
  const double p_unit = problem.v0 / problem.beta;
  const double least_p = std::max({smallest_speed, smallest_speed / problem.beta, p_unit / ratio});
  const double most_p = std::min({largest_speed, largest_speed / problem.beta, p_unit * ratio});
  if (const auto p = mended_p(base, least_p, most_p)) {
    list.push_back({"p", *p, *p > problem.p});
  }
  const double most_beta =
      std::min({largest_square, largest_speed / problem.p, problem.v0 / problem.p * ratio});
  add_mend(list, base, feasible, "beta", problem.beta, most_beta,
           [](Case& now, double value) { now.problem.beta = value; });
  add_limit_mends(list, base, feasible);
  return list;
}

}  // namespace stillpoint::design
