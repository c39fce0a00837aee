// SPDX-License-Identifier: MIT
#include "sections.hpp"

namespace stillpoint::report {

std::optional<design::Practice> practice_of(const MotionReport& report) {
  const SimulationRequest& request = report.request;
  const Simulation& answer = report.answer;
  const bool after_a_hit =
      !answer.forced && request.surface.plain() && request.start.x0 == 0 && moves(answer.response);
  return after_a_hit ? design::practice(request.oscillator, answer.response, std::nullopt)
                     : std::nullopt;
}

}  // namespace stillpoint::report
