// SPDX-License-Identifier: MIT
#include "json/answer_fields.hpp"

namespace stillpoint::report {

namespace {

Interval factors(const design::Spread& spread) {
  return {1 - spread.below, 1 + spread.above};
}

IfRange unless_exact(const Interval& side) {
  return side.low < side.high ? std::optional(side) : std::nullopt;
}

AskedTask asked_task(const design::RecordDesignRequest& task) {
  // Without any that was asked for, that of the largest box of hits and pulses is only its shape.
  const bool of_shape = task.objective == design::SuiteObjective::robust &&
                        !task.requires_tolerance &&
                        std::ranges::none_of(task.cases, &design::LoadCase::of_records);
  const design::SuiteTolerance asked_for =
      of_shape ? design::SuiteTolerance{{}, {}, {}, {}} : task.tolerance;
  const auto& [f, delta, width, period] = asked_for;
  // Of several each has its own, which the constraints tell.
  const design::SuiteLimits limits =
      task.cases.size() == 1 ? task.cases.front().limits : design::SuiteLimits();
  AskedTask asked{.beta = limits.peak,
                  .residual = limits.residual,
                  .jump_max = limits.jump,
                  .hold = task.hold,
                  .p_range = Interval{task.p.low, task.p.high / (1 - task.spring.below)},
                  .tolerance_f = factors(f),
                  .tolerance_delta = factors(delta),
                  .tolerance_width = factors(width),
                  .tolerance_period = factors(period),
                  .notch_width_range = task.width,
                  .tolerance = std::max({f.below, f.above, delta.below, delta.above}),
                  .mass = oscillator_of(task, {}),
                  .damping_most = task.zeta.low < task.zeta.high ? task.zeta.high : 0};
  if (const design::LoadCase& only = task.cases.front();
      task.cases.size() == 1 && !only.of_records()) {
    const auto range_of = [&](double most) {
      return only.weakest < 1 ? std::optional(Interval{only.weakest * most, most}) : std::nullopt;
    };
    asked.v0 = only.v0;
    asked.v0_range = only.v0 ? range_of(*only.v0) : std::nullopt;
    asked.pulse = only.pulse;
    asked.k_range = only.pulse ? range_of(design::peak_load(*only.pulse)) : std::nullopt;
    asked.arrivals = static_cast<std::int64_t>(limits.passages.value_or(0)) + 1;
  }
  if (task.judges && task.parts.empty()) {
    asked.f = task.f->low;
    asked.delta = task.delta->low;
  }
  if (!task.judges) {
    asked.f_range = task.f;
    asked.delta_range = task.delta;
  }
  asked.limits.f_max = task.f_max;
  asked.limits.delta_max = task.delta_max;
  asked.limits.acceleration_max = limits.acceleration;
  if (task.width && task.width->low == task.width->high) {
    asked.notch_width = task.width->low;
  }
  return asked;
}

BoxedDamper boxed_damper(const design::RecordFinding& finding, const IfReal& tolerance) {
  const design::SuiteBox& box = finding.box;
  return {finding.point.damper,
          {unless_exact(box.f), unless_exact(box.delta), unless_exact(box.p),
           unless_exact({turn(box.p.high), turn(box.p.low)}), unless_exact(box.width),
           box.exact ? IfCount() : IfCount(box.samples), box.exact},
          tolerance,
          {},
          {},
          {},
          case_name(finding.part)};
}

/// In the order of design::suite_figure_kinds.
WorstInBox shown_worst(const design::RecordDesignRequest& task, const design::SuiteBox& box,
                       std::size_t in_case, const std::vector<design::CaseMotion>& motions) {
  const auto at = [&](std::size_t kind) {
    const design::SuiteDamper& damper = box.of[in_case].at(kind);
    return WorstAt{damper, motions[box.in[in_case].at(kind)].name,
                   design::load_part(task, in_case, damper),
                   task.zeta.low < task.zeta.high ? oscillator_of(task, damper).zeta : 0};
  };
  return {worst_of(box.worst[in_case]), {at(0), at(1), at(2), at(5), at(3)}};
}

std::string_view load_type(const design::LoadCase& load_case) {
  return load_case.v0 ? "hit" : load_case.pulse ? design::name(*load_case.pulse) : "records";
}

ShownCase shown_case(const design::RecordDesign& result, std::size_t index) {
  const design::LoadCase& load_case = result.request.cases[index];
  ShownCase shown{.name = case_name(load_case.name), .load = {load_type(load_case)}};
  if (load_case.of_records()) {
    shown.load.records = load_case.records.size();
    shown.combine = load_case.combine;
  } else {
    shown.load.weakest = load_case.weakest;
  }
  const auto& finding = result.finding;
  if (!finding) {
    return shown;
  }
  const std::vector<design::CaseMotion> motions = design::motions_of(load_case);
  shown.duty = duties_of(result)[index];
  shown.nominal = worst_of(finding->point.figures[index]);
  shown.worst = shown_worst(result.request, finding->box, index, motions);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const design::CaseMotion& motion = motions[i];
    shown.motions.push_back(
        {load_case.v0 ? std::optional(motion.start.v0) : std::nullopt, finding->point.damper.p,
         motion.pulse, ShownResponse(finding->responses[index][i], finding->energies[index][i]),
         load_case.of_records() ? &load_case.records[i] : nullptr});
  }
  return shown;
}

}  // namespace

ShownAnswer shown(const RecordDesignReport& report) {
  const design::RecordDesign& result = report.result;
  const design::RecordDesignRequest& request = result.request;
  ShownAnswer now{.units = report.physical,
                  .findings = findings(report),
                  .verdict = verdict(report),
                  .input = asked_task(request),
                  .constraints = result.constraints,
                  .mends = result.mends,
                  .search = &result.search};
  if (!report.of_region) {
    now.input.objective = name(request.objective);
  }
  if (request.trade_offs > 0) {
    now.input.trade_off = request.trade_offs;
    now.trade_off = front_of(result);
  }
  if (!request.parts.empty()) {
    now.input.catalogue = spelled_out(report.parts_file);
    now.catalogue = shown_parts(result.parts, report.physical);
  } else if (request.judges) {
    now.admissible = result.finding && result.finding->admissible;
  }
  if (result.region) {
    now.search = nullptr;
    now.feasible = &result.region->deltas;
  }
  if (const auto& finding = result.finding) {
    now.works_for = finding->works_for;
    now.design = boxed_damper(*finding, result.largest_tolerance);
    now.outlook = &finding->outlook;
    now.cross_check = &finding->cross_check;
  } else {
    now.largest_tolerance = result.largest_tolerance;
    now.nearest = result.nearest.figures.empty() ? nullptr : &result.nearest;
  }
  for (std::size_t i = 0; i < request.cases.size(); ++i) {
    now.cases.push_back(shown_case(result, i));
  }
  return now;
}

}  // namespace stillpoint::report
