// SPDX-License-Identifier: MIT
#include <stillpoint/design/motion_findings.hpp>
#include "json/physical_fields.hpp"
#include "sections.hpp"

#include <algorithm>
#include <cmath>

namespace stillpoint::report {

std::optional<double> times(const std::optional<double>& value, const std::optional<double>& unit) {
  return value && unit && std::isfinite(*value * *unit) ? std::optional(*value * *unit)
                                                        : std::nullopt;
}

std::optional<double> Si::in_si(Dimension dimension, const std::optional<double>& value) const {
  return value ? times(scales().in_si(dimension, *value), 1) : value;
}

std::optional<double> mended(const Si& of, std::string_view field, bool by_stiffness) {
  const auto mend = std::ranges::find(of.mends, field, &design::Mend::field);
  if (mend == of.mends.end()) {
    return std::nullopt;
  }
  design::PhysicalInput given = of.input;
  given.by_frequency = false;
  given.by_stiffness = by_stiffness;
  return times(physical_mend(given, *mend)->value, 1);
}

std::vector<HitsSi> hits_si(const Si& of) {
  const design::Scales& scales = of.scales();
  std::vector<HitsSi> rows;
  rows.reserve(of.hits->size());
  for (const design::Hits& now : *of.hits) {
    rows.push_back({now.from * scales.velocity_m_per_s, now.to * scales.velocity_m_per_s,
                    now.rest ? std::optional(*now.rest * scales.length_m) : std::nullopt});
  }
  return rows;
}

namespace {

void add_wave(Si& si, const Excitation& excitation) {
  std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.lambda; }) {
          si.lambda = kind.lambda;
          si.duration = duration(excitation);
        }
      },
      excitation);
}

/// What a design and a point of a region have in common. A pulse is no hit.
void add_point(Si& si, const ShownTask& task, const std::optional<design::Practice>& practice) {
  const bool point = si.f && si.delta;
  si.of_pulse = task.pulse.has_value();
  si.practice = practice;
  const auto told = told_practice(task, practice, si.f.value_or(0), si.delta.value_or(0)).lines;
  si.notch_width_min = told ? told->notch_width_min : std::nullopt;
  if (point && !task.pulse) {
    si.hits = shown_hits(task.problem, *si.f, *si.delta);
  }
  if (task.pulse) {
    add_wave(si, design::excitation(*task.pulse));
  }
}

}  // namespace

std::optional<AnswerSi> physical_of(const DesignReport& report) {
  if (!report.physical) {
    return std::nullopt;
  }
  const design::DesignResult& result = report.result;
  AnswerSi si{{.input = *report.physical, .region = &result.region, .mends = result.mends}};
  const std::optional<double> v0 =
      result.request.pulse ? result.reduced_v0 : result.request.problem.v0;
  si.velocity_m_per_s = v0 ? std::optional(*v0 * si.scales().velocity_m_per_s) : v0;
  if (const auto& found = result.finding) {
    si.f = found->point.f;
    si.delta = found->point.delta;
    si.served = found->works_for;
    const auto [published, exact] = delta_needs(result);
    si.delta1_published = published;
    si.delta1_exact = exact;
    si.motion = &found->response;
    if (found->pulse) {
      si.motion = si.forced = &found->pulse->response;
    }
  }
  add_point(si, task_of(report), result.finding ? result.finding->practice : std::nullopt);
  return si;
}

std::optional<AnswerSi> physical_of(const RegionReport& report) {
  if (!report.physical) {
    return std::nullopt;
  }
  const design::RegionAnswer& answer = report.answer;
  AnswerSi si{{.input = *report.physical,
               .region = &answer.region,
               .mends = answer.mends,
               .f = report.request.f,
               .delta = report.request.delta,
               .served = answer.works_for,
               .delta1_published = answer.delta1_published,
               .delta1_exact = answer.delta1_exact,
               .motion = answer.response ? &*answer.response : nullptr,
               .forced = answer.forced ? &*answer.forced : nullptr}};
  if (!report.request.pulse) {
    si.velocity_m_per_s = report.physical->velocity_m_per_s;
  }
  add_point(si, task_of(report), answer.practice);
  return si;
}

std::optional<MotionSi> physical_of(const MotionReport& report) {
  if (!report.physical) {
    return std::nullopt;
  }
  MotionSi si{{.input = *report.physical,
               .velocity_m_per_s = report.physical->velocity_m_per_s,
               .f = report.request.oscillator.f,
               .delta = report.request.oscillator.delta,
               .practice = practice_of(report),
               .motion = &report.answer.response,
               .forced = report.answer.forced ? &*report.answer.forced : nullptr,
               .caught_impulse = design::caught_impulse(report.request, report.answer.response)}};
  add_wave(si, report.request.excitation);
  return si;
}

}  // namespace stillpoint::report
