// SPDX-License-Identifier: MIT
// The answers of a design and a region after a hit or under a pulse.

#include "json/answer_fields.hpp"

namespace stillpoint::report {

namespace {

IfRange range_of(const IfReal& low, const IfReal& high) {
  return low && high ? std::optional(Interval{*low, *high}) : std::nullopt;
}

bool has_ranges(const ShownTask& task) {
  return has_ranges(task.problem, task.pulse, task.ranges);
}

/// The factors of f and delta in a tolerance box; empty if it has the usual shape.
std::pair<IfRange, IfRange> sides_of(const design::BoxShape& shape, double tolerance) {
  const auto& [f_low, f_high, delta_low, delta_high] = shape;
  if (shape == design::BoxShape()) {
    return {};
  }
  return {Interval{1 - tolerance * f_low, 1 + tolerance * f_high},
          Interval{1 - tolerance * delta_low, 1 + tolerance * delta_high}};
}

AskedTask asked_task(const ShownTask& task) {
  const auto& [problem, limits, pulse, ranges, physical] = task;
  const auto& [f_low, f_high, delta_low, delta_high] = limits.shape;
  AskedTask asked{.p = problem.p,
                  .beta = problem.beta,
                  .residual = problem.residual,
                  .v0_range = range_of(problem.v0_low, problem.v0),
                  .p_range = range_of(problem.p, problem.p_high),
                  .arrivals = problem.arrivals,
                  .criterion = problem.criterion,
                  .tolerance = limits.tolerance * std::min({f_low, f_high, delta_low, delta_high}),
                  .limits = limits,
                  .pulse = pulse};
  std::tie(asked.tolerance_f, asked.tolerance_delta) = sides_of(limits.shape, limits.tolerance);
  if (pulse) {
    asked.k_range = range_of(ranges.k_low, k_of(*pulse));
    asked.lambda_range = range_of(lambda_of(*pulse), ranges.lambda_high);
  }
  return asked;
}

/// What both answers tell, of a damper if there is one, and of an f alone.
template <class Report>
ShownAnswer answer_of(const Report& report, const ShownTask& task,
                      const design::RegionVerdict& region, const design::Judged* judged) {
  ShownAnswer now{.units = task.physical,
                  .findings = report.findings,
                  .verdict = verdict(report),
                  .input = asked_task(task),
                  .judged = judged,
                  .largest_tolerance = region.largest_tolerance,
                  .region = &region,
                  .mends = region.mends};
  if (judged != nullptr) {
    now.constraints = judged->constraints;
    now.works_for = judged->works_for;
  }
  now.cases.push_back({.load = {task.pulse ? design::name(*task.pulse) : "hit"}});
  if (const auto& catalogue = report.catalogue) {
    now.input.catalogue = spelled_out(catalogue->file);
    now.catalogue = shown_parts(catalogue->parts, task.physical);
  }
  return now;
}

/// In which it keeps every requirement, as its corners prove, or a scan of a pulse's ranges.
BoxedDamper boxed_damper(const ShownTask& task, double f, double delta) {
  const auto& [f_low, f_high, delta_low, delta_high] = task.limits.shape;
  const design::DamperBox box =
      design::box_about({f, delta, task.limits.tolerance}, task.limits.shape);
  const auto side = [&](const Interval& range, double off) {
    return task.limits.tolerance * off > 0 ? std::optional(range) : std::nullopt;
  };
  return {{task.problem.p, f, delta},
          {.f = side(box.f, std::max(f_low, f_high)),
           .delta = side(box.delta, std::max(delta_low, delta_high)),
           .exact = !(task.pulse && has_ranges(task))}};
}

/// Over the box that was asked for, as far as it is known from the motion of the damper itself, or
/// from the `worst` of ranges.
void add_worst(ShownCase& now, const ShownTask& task, const BoxedDamper& damper,
               const std::optional<design::PulseWorst>& worst) {
  const bool exactly = !damper.box.f && !damper.box.delta;
  if (worst) {
    now.nominal = Worst{worst->peak, worst->acceleration, {}, worst->stop_time, {}};
    if (exactly) {
      now.worst = {*now.nominal, {}};
    }
  } else if (exactly && !now.motions.empty()) {
    const ShownLoaded& motion = now.motions.front();
    const auto here = [at = WorstAt{damper, motion.what()}](const IfReal& figure) {
      return figure ? std::optional(at) : std::nullopt;
    };
    Worst of = worst_of(design::figures_of(*motion.response.response));
    if (has_ranges(task)) {  // the motion shown is only the one with the largest peak
      of = {.peak = of.peak};
    }
    now.worst = {of,
                 {here(of.peak), here(of.acceleration), here(of.residual), here(of.stop_time),
                  here(of.jump)}};
  }
}

/// The motion of the damper, under a pulse if there is one, and the damper with its box.
void add_damper(ShownAnswer& now, const ShownTask& task, const IfReal& f, const IfReal& delta,
                const std::optional<design::ShownDamper>& shown) {
  ShownCase& only = now.cases.front();
  const design::PulseMotion* const under = shown ? shown->under_pulse : nullptr;
  if (under != nullptr) {
    only.motions.push_back(
        {{}, under->p, under->pulse, ShownResponse(under->response, shown->energies)});
  } else if (shown) {
    only.motions.push_back({task.problem.v0, task.problem.p, task.pulse,
                            ShownResponse(shown->response, shown->energies)});
  }
  if (shown) {
    only.duty = duty_of(*shown);
  }
  if (f && delta) {
    now.design = boxed_damper(task, *f, *delta);
    add_worst(only, task, *now.design, under != nullptr ? under->worst : std::nullopt);
    now.hits = task.pulse ? shown_strengths(pulse_problem(task.problem, *task.pulse, task.ranges),
                                            *f, *delta)
                          : shown_hits(task.problem, *f, *delta);
  }
}

void add_found(ShownAnswer& now, const DesignReport& report, const design::Found& found) {
  const ShownTask task = task_of(report);
  const auto& [f, delta, tolerance] = found.point;
  now.pulse = found.pulse ? &*found.pulse : nullptr;
  add_damper(now, task, f, delta, shown_damper(report.result, {}));
  BoxedDamper& damper = *now.design;
  damper.name =
      report.catalogue ? std::optional(report.catalogue->parts.front().part.name) : std::nullopt;
  damper.tolerance = design::even_tolerance(report.result);
  std::tie(damper.tolerance_f, damper.tolerance_delta) = sides_of(task.limits.shape, tolerance);
  damper.arrival = found.arrival;
  now.search = found.search ? &*found.search : nullptr;
  now.cross_check = &found.cross_check;
  if (const auto& built = report.built_notch) {
    now.built_notch = {&*built,
                       now.cases.front().motions.front().with(built->response, built->energies)};
    now.cases.front().duty = duty_of(shown_damper(report.result, built));
    damper.width = built->shape.width.value_or(0);
    now.input.hold = built->shape.hold;
    now.input.notch_width = built->shape.width;
  }
}

}  // namespace

ShownAnswer shown(const DesignReport& report) {
  const design::DesignResult& result = report.result;
  const design::DesignRequest& request = result.request;
  ShownAnswer now =
      answer_of(report, task_of(report), result, result.finding ? &*result.finding : nullptr);
  if (report.trade_off) {
    now.trade_off = front_of(report);
  }
  now.input.v0 = request.pulse ? result.reduced_v0 : std::optional(request.problem.v0);
  if (now.input.v0 && report.physical) {
    now.velocity_m_per_s = *now.input.v0 * report.physical->scales.velocity_m_per_s;
  }
  now.input.objective = name(request.search.objective);
  now.input.algorithm = request.search.algorithm;
  now.input.trade_off = report.trade_offs;
  if (result.finding) {
    add_found(now, report, *result.finding);
  }
  return now;
}

ShownAnswer shown(const RegionReport& report) {
  const design::RegionRequest& request = report.request;
  const design::RegionAnswer& answer = report.answer;
  const ShownTask task = task_of(report);
  ShownAnswer now = answer_of(report, task, answer, &answer);
  now.admissible = answer.admissible;
  now.strips = &answer.strips;
  if (!request.pulse) {
    now.input.v0 = request.problem.v0;
    now.velocity_m_per_s =
        report.physical ? std::optional(report.physical->velocity_m_per_s) : std::nullopt;
  }
  now.input.f = request.f;
  now.input.delta = request.delta;
  add_damper(now, task, request.f, request.delta,
             answer.response ? std::optional(shown_damper(request, answer)) : std::nullopt);
  if (now.design) {
    now.design->tolerance = answer.tolerance;
    now.design->arrival = answer.arrival;
  }
  return now;
}

}  // namespace stillpoint::report
