// SPDX-License-Identifier: MIT
#include "format.hpp"
#include "sections.hpp"

#include <algorithm>

namespace stillpoint::report {

void add_check(Section& answer, const design::CrossCheck& check) {
  const double most =
      std::ranges::max(check.methods, {}, &design::CheckMethod::relative_error).relative_error;
  answer.row(
      "checks",
      format("{} independent method{} {} to within {:.1e}", check.methods.size(),
             check.methods.size() == 1 ? "" : "s", check.passed ? "agree" : "DISAGREE", most),
      check.passed ? Tone::good : Tone::bad);
}

void add_start(Section& answer, double least_width, const Response& response,
               const Physical& physical) {
  if (least_width < 2 * response.peak_amplitude) {
    answer.row("start", "needs a notch wider than " + length_limit(physical, least_width, true));
  }
}

std::string outcome_phrase(Outcome outcome) {
  return outcome == Outcome::stopped_at_zero        ? "stops at x = 0"
         : outcome == Outcome::stopped_in_dead_zone ? "stops off x = 0, in the dead zone"
         : outcome == Outcome::stopped_in_notch     ? "stops off x = 0, in the notch"
         : outcome == Outcome::never_stops ? "never stops: there is no friction where it moves"
         : outcome == Outcome::caught_at_start
             ? "never starts: the hit is too weak to leave the notch"
             : "is still moving at the end of the run";
}

std::string outcome_phrase(const ForcedResponse& response) {
  return response.outcome != Outcome::running || response.final_velocity != 0
             ? outcome_phrase(response.outcome)
             : "is at rest at the end of the run";
}

}  // namespace stillpoint::report
