// SPDX-License-Identifier: MIT
// The answers of a design and a region after a hit or under a pulse.

#include "json/answer_fields.hpp"

#include <utility>

namespace stillpoint::report {

namespace {

ShownNotch shown_notch(const ShownTask& task, const design::Found& found,
                       const design::BuiltNotch& built) {
  const auto& pulse = found.pulse ? std::optional(found.pulse->pulse) : std::nullopt;
  const double p = found.pulse ? found.pulse->p : task.problem.p;
  const auto motion = [&](const ForcedResponse& response) {
    return loaded(task, task.problem.v0, pulse, p, ShownResponse(response));
  };
  const auto tried = [&](const design::TriedMotion& now) {
    ShownLoaded shown = loaded(task, now.v0, now.pulse, now.p, ShownResponse(now.response));
    shown.from_inside = now.from_inside;
    return shown;
  };
  ShownNotch shown{built.friction, built.changes_nothing, motion(built.response)};
  if (built.from_start) {
    shown.from_start = motion(*built.from_start);
  }
  if (const auto& worst = built.worst) {
    shown.farthest = tried(worst->farthest);
    shown.peak = tried(worst->peak);
    shown.felt = tried(worst->felt);
  }
  return shown;
}

/// The rest of a point's answer.
template <class Answer>
void add_point(ShownAnswer& now, const ShownTask& task, const IfReal& f, const IfReal& delta,
               const Answer& answer, const Response* response) {
  if (answer.works_for) {
    now.works_for = ShownServed{*answer.works_for, task.pulse.has_value()};
  }
  if (f && delta) {
    now.hits = task.pulse ? shown_strengths(pulse_problem(task.problem, *task.pulse, task.ranges),
                                            *f, *delta)
                          : shown_hits(task.problem, *f, *delta);
  }
  if (answer.practice) {
    now.practice = ShownPractice{{*answer.practice},
                                 design::impulses({task.problem.p, *f, *delta}, *response)};
  }
  if (answer.practice_worst) {
    now.practice_worst = ShownPractice{{*answer.practice_worst}, {}};
  }
  now.notch_width_min = answer.notch_width_min;
}

void add_found(ShownAnswer& now, const DesignReport& report, const design::Found& found) {
  const ShownTask task = task_of(report);
  ShownCase& only = now.cases.front();
  const auto& [f, delta, tolerance] = found.point;
  const auto& [below_f, above_f, below_delta, above_delta] = task.limits.shape;
  BoxedDamper& damper = now.design.emplace(boxed_damper(task, f, delta));
  damper.name =
      report.catalogue ? std::optional(report.catalogue->parts.front().part.name) : std::nullopt;
  damper.tolerance = design::even_tolerance(report.result);
  damper.tolerance_f = side_of(task.limits.shape, tolerance, below_f, above_f);
  damper.tolerance_delta = side_of(task.limits.shape, tolerance, below_delta, above_delta);
  damper.arrival = found.arrival;
  if (found.pulse) {
    only.motions.push_back(
        loaded(task, 0, found.pulse->pulse, found.pulse->p, ShownResponse(found.pulse->response)));
    now.pulse = &*found.pulse;
  } else {
    only.motions.push_back(
        loaded(task, task.problem.v0, {}, task.problem.p, ShownResponse(found.response)));
  }
  add_worst(only, task, damper, found.pulse ? found.pulse->worst : std::nullopt);
  now.delta1_published = found.delta1_published;
  now.delta1_exact = found.delta1_exact;
  now.constraints = found.constraints;
  if (found.search) {
    now.search = &*found.search;
  }
  now.cross_check = &found.cross_check;
  if (const auto& built = report.built_notch) {
    now.built_notch = shown_notch(task, found, *built);
    damper.width = built->shape.width.value_or(0);
    now.input.hold = built->shape.hold;
    now.input.notch_width = built->shape.width;
  }
  add_point(now, task, f, delta, found, &found.response);
}

}  // namespace

ShownAnswer shown(const DesignReport& report) {
  const design::DesignResult& result = report.result;
  const design::DesignRequest& request = result.request;
  const ShownTask task = task_of(report);
  ShownAnswer now = asked(task, result, report.findings);
  now.verdict = verdict(report);
  now.trade_off = report.trade_off;
  now.input.v0 = request.pulse ? result.reduced_v0 : std::optional(request.problem.v0);
  if (now.input.v0 && report.physical) {
    now.velocity_m_per_s = *now.input.v0 * report.physical->scales.velocity_m_per_s;
  }
  now.input.objective = name(request.search.objective);
  now.input.algorithm = request.search.algorithm;
  now.input.trade_off = report.trade_offs;
  add_catalogue(now, report.catalogue, task);
  if (result.finding) {
    add_found(now, report, *result.finding);
  }
  return now;
}

ShownAnswer shown(const RegionReport& report) {
  const design::RegionRequest& request = report.request;
  const design::RegionAnswer& answer = report.answer;
  const ShownTask task = task_of(report);
  ShownAnswer now = asked(task, answer, report.findings);
  now.verdict = verdict(report);
  now.constraints = answer.constraints;
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
  add_point(now, task, request.f, request.delta, answer,
            answer.response ? &*answer.response : nullptr);
  add_catalogue(now, report.catalogue, task);
  return now;
}

}  // namespace stillpoint::report
