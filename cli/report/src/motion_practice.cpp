// SPDX-License-Identifier: MIT
#include "sections.hpp"

#include <algorithm>

namespace stillpoint::report {

namespace {

/// A closed form has the impulses.
bool is_simple(const MotionReport& report) {
  return !report.answer.forced && report.request.surface.plain();
}

}  // namespace

std::vector<double> impulses_of(const MotionReport& report) {
  const auto& [request, answer, record, physical] = report;
  if (is_simple(report)) {
    return design::impulses(request.oscillator, answer.response);
  }
  std::vector<double> impulses;
  for (const HalfCycle& now : answer.half_cycles) {
    if (now.impulse) {
      impulses.push_back(*now.impulse);
    }
  }
  return impulses;
}

std::optional<design::Practice> practice_of(const MotionReport& report) {
  const auto& [request, answer, record, physical] = report;
  const auto& [width, zones] = request.surface;
  const Response& response = answer.response;
  if (!moves(response) || !zones.empty() || width.value_or(0) / 2 >= response.peak_amplitude) {
    return std::nullopt;
  }
  auto lines = design::practice(request.oscillator, response, std::nullopt);
  if (!lines || is_simple(report)) {
    return lines;
  }
  const std::vector<double> impulses = impulses_of(report);
  const bool all = static_cast<double>(answer.half_cycles.size()) == response.half_cycles;
  lines->impulse_largest =
      all && !impulses.empty() ? std::optional(std::ranges::max(impulses)) : std::nullopt;
  if (width) {  // it is felt as an acceleration
    lines->impulse_at_stop = lines->notch_used = {};
  }
  return lines;
}

}  // namespace stillpoint::report
