// SPDX-License-Identifier: MIT
#include "json/answer_fields.hpp"
#include "json/physical_fields.hpp"
#include "sections.hpp"

#include <stillpoint/design/motion_findings.hpp>

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

std::optional<std::vector<HitsSi>> hits_si(const Si& of) {
  if (of.hits == nullptr) {
    return std::nullopt;
  }
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

}  // namespace

std::optional<AnswerSi> physical_of(const ShownAnswer& now) {
  if (!now.units) {
    return std::nullopt;
  }
  const AskedTask& input = now.input;
  AnswerSi si{{.input = *now.units,
               .velocity_m_per_s = now.velocity_m_per_s,
               .f = now.design ? std::optional(now.design->f) : input.f,
               .delta = now.design ? std::optional(now.design->delta) : input.delta,
               .delta1_published = now.delta1_published,
               .delta1_exact = now.delta1_exact,
               .practice = now.practice,
               .notch_width_min = now.notch_width_min,
               .lambda = input.lambda,
               .duration = now.duration,
               .region = now.region != nullptr ? &now.region->region : nullptr,
               .mends = now.mends,
               .served = now.works_for,
               .of_pulse = input.pulse.has_value(),
               .hits = now.hits && !input.pulse ? &*now.hits : nullptr}};
  if (now.region == nullptr) {  // under records, whose motions have their own
    si.input.max_displacement_m = si.in_si(Dimension::length, input.beta);
  } else if (const auto& motions = now.cases.front().motions; !motions.empty()) {
    si.motion = motions.front().response.response;
    si.forced = motions.front().response.forced;
  }
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
               .caught_impulse = design::caught_impulse(report.request, report.answer.response),
               .motion = &report.answer.response,
               .forced = report.answer.forced ? &*report.answer.forced : nullptr}};
  add_wave(si, report.request.excitation);
  return si;
}

}  // namespace stillpoint::report
