// SPDX-License-Identifier: MIT
#include "sections.hpp"

namespace stillpoint::report {

std::optional<double> felt_outside(double felt, double peak, double p, double f,
                                   const std::optional<double>& notch_width) {
  // It slides at the largest acceleration outside, f + p^2 |x|, where it is farthest.
  const double outside = f + p * p * peak;
  return notch_width.value_or(0) / 2 < peak && felt > for_rounding * outside
             ? std::optional(outside)
             : std::nullopt;
}

void add_start(Section& answer, double least_width, const Response& response,
               const Physical& physical) {
  if (least_width < 2 * response.peak_amplitude) {
    answer.row("start", "needs a notch wider than " + length_limit(physical, least_width, true));
  }
}

std::string outcome_phrase(Outcome outcome) {
  switch (outcome) {
    case Outcome::stopped_at_zero:
      return "stops at x = 0";
    case Outcome::stopped_in_dead_zone:
      return "stops off x = 0, in the dead zone";
    case Outcome::stopped_in_notch:
      return "stops off x = 0, in the notch";
    case Outcome::never_stops:
      return "never stops: there is no friction where it moves";
    case Outcome::caught_at_start:
      return "never starts: the hit is too weak to leave the notch";
    case Outcome::running:
      return "is still moving at the end of the run";
  }
  return {};
}

std::string outcome_phrase(const ForcedResponse& response) {
  return response.outcome != Outcome::running || response.final_velocity != 0
             ? outcome_phrase(response.outcome)
         : response.peak_amplitude == 0 ? "has not moved by the end of the run"
                                        : "is at rest at the end of the run";
}

}  // namespace stillpoint::report
