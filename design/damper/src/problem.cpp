// SPDX-License-Identifier: MIT
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/names.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/problem.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

namespace {

/// f2 is half of v0^2 / beta at most, and must stay a double.
constexpr double largest_f2 = 1e305;
/// p beta, a speed that is compared with v0 and may be slightly outside its range.
constexpr double smallest_edge = 1e-155;
constexpr double largest_edge = 1e155;
/// p beta / v0 decides everything; farther out f2 would overflow or beta would have no meaning.
constexpr double widest_ratio = 1e100;

}  // namespace

void require_valid(const Problem& problem) {
  require_within("v0", problem.v0, smallest_speed, largest_speed);
  require_within("p", problem.p, smallest_speed, largest_speed);
  require_within("beta", problem.beta, smallest_limit, largest_square);
  const double speed = problem.p * problem.beta;
  if (!(speed >= smallest_edge && speed <= largest_edge)) {
    throw InputError("beta", problem.beta,
                     fmt::format("p * beta must be from {} to {} (p = {})", smallest_edge,
                                 largest_edge, problem.p));
  }
  const double ratio = speed / problem.v0;
  if (!(ratio >= 1 / widest_ratio && ratio <= widest_ratio)) {
    throw InputError("beta", problem.beta,
                     fmt::format("p * beta / v0 must be from {} to {} (p = {}, v0 = {})",
                                 1 / widest_ratio, widest_ratio, problem.p, problem.v0));
  }
  if (!(problem.v0 * (problem.v0 / problem.beta) <= largest_f2)) {
    throw InputError(
        "beta", problem.beta,
        fmt::format("v0^2 / beta must be at most {} (v0 = {})", largest_f2, problem.v0));
  }
  if (problem.arrivals < 1 || problem.arrivals > most_arrivals) {
    throw InputError("arrivals", fmt::format("{}", problem.arrivals),
                     fmt::format("must be a whole number from 1 to {}", most_arrivals));
  }
  if (problem.v0_low && *problem.v0_low != 0) {
    require_within("v0_low", *problem.v0_low, smallest_speed, problem.v0);
  }
  if (problem.p_high) {
    require_within("p_high", *problem.p_high, problem.p, largest_speed);
  }
  if (problem.residual) {
    require_within("residual", *problem.residual, 0, largest_square);
  }
}

Interval valid_v0(const Problem& problem) {
  constexpr double sqrt_of_far_f2 = 1e152;  // f2 is v0^2 / beta at most, and below 1e305
  const double speed = problem.p * problem.beta;
  return {std::max(smallest_speed, speed / far_ratio),
          std::min({largest_speed, speed * far_ratio, std::sqrt(problem.beta) * sqrt_of_far_f2})};
}

Interval valid_p(const Problem& problem) {
  const double least = problem.v0 / problem.beta / far_ratio;
  const double most = problem.v0 / problem.beta * far_ratio;
  return {std::max({smallest_speed, smallest_speed / problem.beta, least}),
          std::min({largest_speed, largest_speed / problem.beta, most})};
}

std::vector<Problem> ends_of_ranges(const Problem& problem) {
  Problem one = problem;
  one.v0_low = one.p_high = {};
  std::vector<Problem> ends{one};
  if (problem.p_high) {
    ends.push_back(one);
    ends.back().p = *problem.p_high;
  }
  if (problem.v0_low.value_or(0) > 0) {
    for (std::size_t i = 0, strongest = ends.size(); i < strongest; ++i) {
      ends.push_back(ends[i]);
      ends.back().v0 = *problem.v0_low;
    }
  }
  return ends;
}

}  // namespace stillpoint::design
