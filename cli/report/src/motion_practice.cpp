// SPDX-License-Identifier: MIT
#include "sections.hpp"

#include <algorithm>

namespace stillpoint::report {

std::optional<design::Practice> practice_of(const MotionReport& report) {
  const auto& [request, answer, record, physical] = report;
  const auto& [width, zones] = request.surface;
  const Response& response = answer.response;
  if (!moves(response) || !zones.empty() || width.value_or(0) / 2 >= response.peak_amplitude) {
    return std::nullopt;
  }
  auto lines = design::practice(request.oscillator, response, std::nullopt);
  if (!lines || !(answer.forced || width)) {
    return lines;
  }
  // Those of a free motion through x = 0 alone have a closed form.
  lines->impulses.clear();
  lines->impulse_largest = {};
  for (const HalfCycle& now : answer.half_cycles) {
    if (now.impulse) {
      lines->impulses.push_back(*now.impulse);
    }
  }
  const bool all = static_cast<double>(answer.half_cycles.size()) == response.half_cycles;
  if (all && !lines->impulses.empty()) {
    lines->impulse_largest = std::ranges::max(lines->impulses);
  }
  if (width) {  // it is felt as an acceleration
    lines->impulse_at_stop = lines->notch_used = {};
  }
  return lines;
}

}  // namespace stillpoint::report
