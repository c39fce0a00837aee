// SPDX-License-Identifier: MIT
#include <stillpoint/design/motion_findings.hpp>
#include "json/physical_fields.hpp"
#include "sections.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace stillpoint::report {

std::optional<double> times(const std::optional<double>& value, const std::optional<double>& unit) {
  return value && unit && std::isfinite(*value * *unit) ? std::optional(*value * *unit)
                                                        : std::nullopt;
}

std::optional<double> Si::in_si(Dimension dimension, const std::optional<double>& value) const {
  return value ? times(scales().in_si(dimension, *value), 1) : value;
}

std::optional<double> mended(const Si& of, std::string_view field, bool by_stiffness) {
  const auto& mends = of.region->mends;
  const auto mend = std::ranges::find(mends, field, &design::Mend::field);
  if (mend == mends.end()) {
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

std::optional<DesignSi> physical_of(const DesignReport& report) {
  if (!report.physical) {
    return std::nullopt;
  }
  const design::DesignResult& result = report.result;
  DesignSi si{{.input = *report.physical, .region = &result}};
  const std::optional<double> v0 =
      result.request.pulse ? result.reduced_v0 : result.request.problem.v0;
  si.velocity_m_per_s = v0 ? std::optional(*v0 * si.scales().velocity_m_per_s) : v0;
  if (result.finding) {
    si.f = result.finding->point.f;
    si.delta = result.finding->point.delta;
    si.served = result.finding->works_for;
    si.motion = &result.finding->response;
  }
  add_point(si, task_of(report), result.finding ? result.finding->practice : std::nullopt);
  return si;
}

std::optional<RegionSi> physical_of(const RegionReport& report) {
  if (!report.physical) {
    return std::nullopt;
  }
  RegionSi si{{.input = *report.physical,
               .region = &report.answer,
               .f = report.request.f,
               .delta = report.request.delta,
               .served = report.answer.works_for,
               .delta1_published = report.answer.delta1_published,
               .delta1_exact = report.answer.delta1_exact}};
  if (!report.request.pulse) {
    si.velocity_m_per_s = report.physical->velocity_m_per_s;
  }
  add_point(si, task_of(report), report.answer.practice);
  return si;
}

std::optional<AnyMotionSi> physical_of(const MotionReport& report) {
  if (!report.physical) {
    return std::nullopt;
  }
  Si si{.input = *report.physical,
        .velocity_m_per_s = report.physical->velocity_m_per_s,
        .f = report.request.oscillator.f,
        .delta = report.request.oscillator.delta,
        .practice = practice_of(report),
        .motion = &report.answer.response,
        .caught_impulse = design::caught_impulse(report.request, report.answer.response)};
  add_wave(si, report.request.excitation);
  if (report.answer.forced) {
    si.forced = &*report.answer.forced;
    return ForcedMotionSi{si};
  }
  return MotionSi{si};
}

}  // namespace stillpoint::report
