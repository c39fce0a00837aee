// SPDX-License-Identifier: MIT
// What a damper works for, and the figures used in practice, dimensionless.
#include "json/motion_fields.hpp"
#include "json/parts.hpp"

namespace stillpoint::report {

using nlohmann::ordered_json;

ordered_json served_json(const std::optional<design::WorksFor>& served, bool of_pulse) {
  return or_null(served, [&](const design::WorksFor& now) -> ordered_json {
    const ordered_json hit = interval_json(now.hit);
    return {{"v0", of_pulse ? nullptr : hit},
            {"k", of_pulse ? hit : nullptr},
            {"p", interval_json(now.p)}};
  });
}

ordered_json hits_json(const design::Problem& problem, const std::optional<design::Pulse>& pulse,
                       const design::PulseRanges& ranges, double f, double delta) {
  const auto hits = pulse ? shown_strengths(pulse_problem(problem, *pulse, ranges), f, delta)
                          : shown_hits(problem, f, delta);
  return list_json(hits, [](const design::Hits& now) -> ordered_json {
    return {{"from", now.from},
            {"to", now.to},
            {"ends", name(now.end)},
            {"arrivals", count(now.arrivals)},
            {"rest", now.rest}};
  });
}

ordered_json practice_json(const std::optional<design::Practice>& lines,
                           const std::optional<std::vector<double>>& impulses) {
  return lines ? object_json(ShownPractice{{*lines}, impulses}) : ordered_json();
}

}  // namespace stillpoint::report
