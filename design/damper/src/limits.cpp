// SPDX-License-Identifier: MIT
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/limit_kinds.hpp>
#include <stillpoint/design/problem.hpp>

#include <algorithm>

namespace stillpoint::design {

void require_valid(const Problem& problem, const Limits& limits) {
  require_valid(problem);
  const auto& [f_low, f_high, delta_low, delta_high] = limits.shape;
  for (const double side : {f_low, f_high, delta_low, delta_high}) {
    require_within("shape", side, 0, 1);
  }
  if (!(std::max({f_low, f_high, delta_low, delta_high}) > 0)) {
    throw InputError("tolerance", 0.0, "must be above 0 on at least one side of f or delta");
  }
  for (const LimitKind& kind : limit_kinds()) {
    if (const auto& limit = limits.*kind.value) {
      require_within(kind.field, *limit, kind.least(), largest_square);
    }
  }
  if (!(limits.tolerance >= 0 && limits.tolerance < 1)) {
    throw InputError("tolerance", limits.tolerance,
                     "must be at least 0 and less than 1 (0.1 is 10 %)");
  }
}

bool is_plain(const Problem& problem, const Limits& limits) {
  return problem.v0_low.value_or(problem.v0) == problem.v0 && problem.stiffest_p() == problem.p &&
         !problem.residual && limits.shape == BoxShape{};
}

}  // namespace stillpoint::design
