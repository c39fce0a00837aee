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

/// What both answers tell of a damper, and of an f alone.
void add_judged(ShownAnswer& now, const ShownTask& task, const IfReal& f, const IfReal& delta,
                const design::Judged& judged) {
  now.constraints = judged.constraints;
  now.delta1_published = judged.delta1_published;
  now.delta1_exact = judged.delta1_exact;
  if (judged.works_for) {
    now.works_for = ShownServed{*judged.works_for, task.pulse.has_value()};
  }
  if (f && delta) {
    now.hits = task.pulse ? shown_strengths(pulse_problem(task.problem, *task.pulse, task.ranges),
                                            *f, *delta)
                          : shown_hits(task.problem, *f, *delta);
  }
  now.practice = judged.practice;
  now.practice_worst = judged.practice_worst;
  now.notch_width_min = judged.notch_width_min;
}

/// The motion of the damper, under a pulse if there is one.
void add_motion(ShownAnswer& now, const ShownTask& task, const Response& response,
                const design::PulseMotion* under) {
  now.cases.front().motions.push_back(
      under != nullptr
          ? loaded(task, 0, under->pulse, under->p, ShownResponse(under->response))
          : loaded(task, task.problem.v0, task.pulse, task.problem.p, ShownResponse(response)));
}

void add_found(ShownAnswer& now, const DesignReport& report, const design::Found& found) {
  const ShownTask task = task_of(report);
  const auto& [f, delta, tolerance] = found.point;
  const auto& [below_f, above_f, below_delta, above_delta] = task.limits.shape;
  BoxedDamper& damper = now.design.emplace(boxed_damper(task, f, delta));
  damper.name =
      report.catalogue ? std::optional(report.catalogue->parts.front().part.name) : std::nullopt;
  damper.tolerance = design::even_tolerance(report.result);
  damper.tolerance_f = side_of(task.limits.shape, tolerance, below_f, above_f);
  damper.tolerance_delta = side_of(task.limits.shape, tolerance, below_delta, above_delta);
  damper.arrival = found.arrival;
  now.pulse = found.pulse ? &*found.pulse : nullptr;
  add_motion(now, task, found.response, now.pulse);
  add_worst(now.cases.front(), task, damper, found.pulse ? found.pulse->worst : std::nullopt);
  now.search = found.search ? &*found.search : nullptr;
  now.cross_check = &found.cross_check;
  if (const auto& built = report.built_notch) {
    now.built_notch = shown_notch(task, found, *built);
    damper.width = built->shape.width.value_or(0);
    now.input.hold = built->shape.hold;
    now.input.notch_width = built->shape.width;
  }
  add_judged(now, task, f, delta, found);
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
  now.admissible = answer.admissible;
  now.strips = answer.strips;
  if (!request.pulse) {
    now.input.v0 = request.problem.v0;
    now.velocity_m_per_s =
        report.physical ? std::optional(report.physical->velocity_m_per_s) : std::nullopt;
  }
  now.input.f = request.f;
  now.input.delta = request.delta;
  const auto* const under = answer.under_pulse ? &*answer.under_pulse : nullptr;
  if (answer.response) {
    add_motion(now, task, *answer.response, under);
  }
  if (request.f && request.delta) {
    now.design = boxed_damper(task, *request.f, *request.delta);
    now.design->tolerance = answer.tolerance;
    now.design->arrival = answer.arrival;
    add_worst(now.cases.front(), task, *now.design, under != nullptr ? under->worst : std::nullopt);
  }
  add_judged(now, task, request.f, request.delta, answer);
  add_catalogue(now, report.catalogue, task);
  return now;
}

}  // namespace stillpoint::report
