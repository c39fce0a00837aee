// SPDX-License-Identifier: MIT
#include "json/answer_fields.hpp"

#include <utility>

namespace stillpoint::report {

ShownAnswer shown(const RegionReport& report) {
  const design::RegionRequest& request = report.request;
  const design::RegionAnswer& answer = report.answer;
  const ShownTask task = task_of(report);
  ShownAnswer now = asked(task, answer, report.findings);
  now.verdict = verdict(report);
  now.constraints = shown_constraints(answer.constraints);
  now.admissible = answer.admissible;
  now.delta1_published = answer.delta1_published;
  now.delta1_exact = answer.delta1_exact;
  now.strips = answer.strips;
  if (!request.pulse) {
    now.input.v0 = request.problem.v0;
    now.velocity_m_per_s =
        report.physical ? std::optional(report.physical->velocity_m_per_s) : std::nullopt;
  }
  now.input.f = request.f;
  now.input.delta = request.delta;
  if (answer.response) {
    const auto& [pulse, p] =
        answer.shown ? std::pair(std::optional(answer.shown->first), answer.shown->second)
                     : std::pair(request.pulse, request.problem.p);
    now.cases.front().motions.push_back(
        loaded(task, request.problem.v0, pulse, p,
               answer.forced ? ShownResponse(*answer.forced) : ShownResponse(*answer.response)));
  }
  if (request.f && request.delta) {
    now.design = boxed_damper(task, *request.f, *request.delta);
    now.design->tolerance = answer.tolerance;
    now.design->arrival = answer.arrival;
    add_worst(now.cases.front(), task, *now.design, answer.worst);
  }
  add_point(now, task, request.f, request.delta, answer.practice,
            answer.response ? &*answer.response : nullptr, answer.works_for);
  add_catalogue(now, report.catalogue, task);
  return now;
}

}  // namespace stillpoint::report
