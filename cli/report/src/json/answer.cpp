// SPDX-License-Identifier: MIT
// A design and a region as JSON.

#include "json/answer_fields.hpp"

#include <stillpoint/report/schemas.hpp>

namespace stillpoint::report {

std::optional<std::vector<std::string_view>> conflict_of(const design::Region& region) {
  using Names = std::vector<std::string_view>;
  switch (region.conflict) {
    case design::Conflict::none:
      break;
    case design::Conflict::amplitude_against_return:
      return Names{"amplitude", "return"};
    case design::Conflict::amplitude_against_dead_zone:
      return Names{"amplitude", "dead_zone"};
    case design::Conflict::amplitude_against_limit:
      return Names{"amplitude", region.limit->constraint};
    case design::Conflict::limit_alone:
      return Names{region.limit->constraint};
    case design::Conflict::stop_against_start:
      return Names{"stop", "start"};
    case design::Conflict::stop_against_limit:
      return Names{"stop", region.limit->constraint};
    case design::Conflict::no_arrival:
      return Names{"stop", "arrivals"};
    case design::Conflict::narrower_than_rounding:
      return Names{"rounding"};
  }
  return std::nullopt;
}

Worst worst_of(const design::SuiteFigures& figures) {
  return {figures.peak, figures.acceleration, figures.residual, {}, figures.jump};
}

std::optional<Worst> settled(const design::SuiteFigures& figures) {
  return figures.settled ? std::optional(worst_of(figures)) : std::nullopt;
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
  return answer_json(design_names.front(), shown(report));
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
