// SPDX-License-Identifier: MIT
#include "ranking.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace stillpoint::design {

namespace {

/// The factor by which the worst constraint is missed, minus 1.
double miss_of(const std::vector<Constraint>& violated) {
  double worst = 0;
  for (const Constraint& now : violated) {
    worst =
        std::max(worst, std::abs(now.slack) / std::min(std::abs(now.value), std::abs(now.limit)));
  }
  return worst;
}

}  // namespace

void require_valid(const Part& part, double p) {
  require_within("f", part.f, 0, largest_part_value);
  require_within("delta", part.delta, 0, largest_part_value);
  require_valid(Oscillator{p, part.f, part.delta});
}

std::string none_admissible(std::size_t parts) {
  return parts == 1 ? "the only part of the catalogue is not admissible"
                    : fmt::format("none of the {} parts of the catalogue is admissible", parts);
}

std::vector<RatedPart> best_first(std::vector<RatedPart> all,
                                  const std::function<double(const RatedPart&)>& cost) {
  std::vector<std::tuple<int, double, double>> keys;
  keys.reserve(all.size());
  for (const RatedPart& now : all) {
    const double tolerance = now.tolerance.value_or(0);
    keys.push_back(now.admissible  ? std::tuple(0, cost(now), -tolerance)
                   : now.tolerance ? std::tuple(1, -tolerance, 0.0)
                                   : std::tuple(2, miss_of(now.violated), 0.0));
  }
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return keys[i]; });
  std::vector<RatedPart> sorted;
  sorted.reserve(all.size());
  for (const std::size_t i : order) {
    sorted.push_back(std::move(all[i]));
  }
  return sorted;
}

}  // namespace stillpoint::design
