// SPDX-License-Identifier: MIT
// A design and a region as JSON.

#include "json/answer_fields.hpp"

namespace stillpoint::report {

std::optional<Worst> settled(const design::TaskFigures& figures) {
  return design::settled(figures) ? std::optional(worst_of(largest(figures))) : std::nullopt;
}

IfReal AnswerSi::mended(std::string_view field, bool by_stiffness) const {
  const auto found = std::ranges::find(answer->mends, field, &design::Mend::field);
  if (found == answer->mends.end() || (by_stiffness && !scales().mass_kg)) {
    return std::nullopt;
  }
  design::PhysicalInput given = input;
  given.by_frequency = false;
  given.by_stiffness = by_stiffness;
  return times(physical_mend(given, *found)->value, 1);
}

std::optional<AnswerSi> ShownAnswer::in_si() const {
  if (!units) {
    return std::nullopt;
  }
  AnswerSi si{{.input = *units,
               .velocity_m_per_s = velocity_m_per_s,
               .f = design ? std::optional(design->f) : input.f,
               .delta = design ? std::optional(design->delta) : input.delta,
               .practice = of_judged(&Judged::practice)(*this),
               .notch_width_min = of_judged(&Judged::notch_width_min)(*this),
               .lambda = in(&AskedTask::pulse, lambda_of)(input)},
              this};
  if (input.pulse) {
    si.duration = duration(design::excitation(*input.pulse));
  }
  if (region == nullptr) {  // under records, whose motions have their own
    si.input.max_displacement_m =
        input.beta ? units->scales.in_si(Dimension::length, *input.beta) : std::nullopt;
  } else if (const auto& motions = cases.front().motions; !motions.empty()) {
    si.motion = motions.front().response;
  }
  return si;
}

namespace {

using nlohmann::ordered_json;

constexpr auto design_names = std::to_array<std::string_view>({"stillpoint/design-report/2"});
constexpr auto region_names = std::to_array<std::string_view>({"stillpoint/region-report/2"});

/// The table of both is the same but for its head, so it is printed by the same code.
ordered_json answer_json(std::string_view schema, const ShownAnswer& answer) {
  ordered_json json{{"schema", schema}, {"program", object_json(Program())}};
  json.update(object_json(answer, scales_of(answer.units)));
  return json;
}

template <const auto& names>
ordered_json answer_schema(std::string_view command) {
  constexpr auto all = std::tuple_cat(head_fields<ShownAnswer, names>, fields<ShownAnswer>);
  return report_schema<ShownAnswer>(all, names.front(), command);
}

}  // namespace

ordered_json json(const DesignReport& report) {
  return answer_json(design_names.front(), shown(report));
}

ordered_json json(const RecordDesignReport& report) {
  return answer_json(report.of_region ? region_names.front() : design_names.front(), shown(report));
}

ordered_json json(const RegionReport& report) {
  return answer_json(region_names.front(), shown(report));
}

ordered_json design_schema() {
  return answer_schema<design_names>("design --json");
}

ordered_json region_schema() {
  return answer_schema<region_names>("region --json");
}

}  // namespace stillpoint::report
