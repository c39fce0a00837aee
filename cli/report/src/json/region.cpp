// SPDX-License-Identifier: MIT
#include "json/answer_fields.hpp"

#include <utility>

namespace stillpoint::report {

ShownAnswer shown(const RegionReport& report) {
  const design::RegionRequest& request = report.request;
  const design::RegionAnswer& answer = report.answer;
  const ShownTask task = task_of(report);
  ShownCase only{.load = load_of(task)};
  if (answer.response) {
    const auto& [pulse, p] =
        answer.shown ? std::pair(std::optional(answer.shown->first), answer.shown->second)
                     : std::pair(request.pulse, request.problem.p);
    only.motions.push_back(
        loaded(task, request.problem.v0, pulse, p,
               answer.forced ? ShownResponse(*answer.forced) : ShownResponse(*answer.response)));
  }
  ShownAnswer now{.units = report.physical,
                  .findings = report.findings,
                  .verdict = verdict(report),
                  .input = asked_task(task),
                  .constraints = shown_constraints(answer.constraints),
                  .admissible = answer.admissible,
                  .delta1_published = answer.delta1_published,
                  .delta1_exact = answer.delta1_exact,
                  .region = &answer,
                  .strips = answer.strips,
                  .largest_tolerance = answer.largest_tolerance,
                  .mends = shown_mends(answer.mends),
                  .physical = physical_of(report)};
  now.input.v0 = request.pulse ? std::nullopt : std::optional(request.problem.v0);
  now.input.f = request.f;
  now.input.delta = request.delta;
  if (request.f && request.delta) {
    now.design = boxed_damper(task, *request.f, *request.delta);
    now.design->tolerance = answer.tolerance;
    now.design->arrival = answer.arrival;
    add_worst(only, task, *now.design, answer.worst);
  }
  if (answer.works_for) {
    now.works_for = ShownServed{*answer.works_for, request.pulse.has_value()};
  }
  now.cases.push_back(std::move(only));
  add_point(now, task, request.f, request.delta, answer.practice,
            answer.response ? &*answer.response : nullptr);
  add_catalogue(now, report.catalogue, task);
  return now;
}

}  // namespace stillpoint::report
