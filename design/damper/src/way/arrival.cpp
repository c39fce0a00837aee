// SPDX-License-Identifier: MIT
#include "way/arrival.hpp"

#include "region/edges.hpp"
#include "way/way.hpp"
#include "way/wide_notch.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/strips.hpp>

namespace stillpoint::design {

Problem strongest_hit(Problem problem) {
  problem.v0_low = problem.p_high = problem.residual = std::nullopt;
  problem.criterion = Criterion::exact;
  return problem;
}

DecidingArrival deciding_arrival(const Problem& problem, double f, double delta) {
  const Edges edge = edges(problem, {});
  if (!(delta <= edge.delta_cap && f <= edge.f3)) {
    return {1, false};
  }
  if (delta > unchecked_delta1(problem, f)) {
    return {1, true};
  }
  const WideNotch notch{f / Wide(problem.p), 2 * Wide(delta)};
  Wide reach = 3 * notch.phi;
  Wide pass = notch.before(stop_radius(problem) * notch.phi);
  for (int n = 2; n <= problem.arrivals; ++n) {
    reach = notch.before(reach);
    pass = notch.before(pass);
    if (problem.v0 < notch.speed(reach)) {
      return {n, false};
    }
    if (problem.v0 < notch.speed(pass)) {
      return {n, true};
    }
  }
  return {static_cast<int>(problem.arrivals), false};
}

std::optional<std::int64_t> arrival_of(const Problem& problem, double f, double delta) {
  require_valid(problem);
  require_within("f", f, 0, largest_square);
  require_within("delta", delta, 0, largest_square);
  // For ranges, that of the motion shown; in an admissible way the model itself decides.
  const Problem shown = is_plain(problem, {}) ? problem : strongest_hit(problem);
  const auto [n, stops] = deciding_arrival(shown, f, delta);
  return stops ? std::optional<std::int64_t>(n) : std::nullopt;
}

}  // namespace stillpoint::design
