// SPDX-License-Identifier: MIT
#pragma once

// The fields that the reports of a region and of a design share.

#include "choices.hpp"
#include "json/motion_fields.hpp"
#include "json/schema.hpp"
#include "sections.hpp"

#include <stillpoint/core/interval.hpp>
#include <stillpoint/design/hits.hpp>
#include <stillpoint/design/limit_kinds.hpp>
#include <stillpoint/design/region.hpp>
#include <stillpoint/design/works_for.hpp>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace stillpoint::report {

/// What was asked for.
// It is never made without a task. NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
struct ShownInput {
  ShownTask task;
  std::optional<double> v0;
  const std::optional<Catalogue>& catalogue;

  /// The factors of one side of a tolerance box; empty if the box has the usual shape.
  [[nodiscard]] std::optional<Interval> side(double design::BoxShape::*below,
                                             double design::BoxShape::*above) const;
  [[nodiscard]] double tolerance() const;
  [[nodiscard]] std::optional<double> k() const;
  [[nodiscard]] std::optional<double> lambda() const;
};
[[nodiscard]] std::optional<Interval> side_of(const design::BoxShape& shape, double tolerance,
                                              double below, double above);
[[nodiscard]] std::optional<Interval> range_of(const std::optional<double>& low,
                                               const std::optional<double>& high);
/// The constraints and limits that conflict, by name; empty where none do.
[[nodiscard]] std::optional<std::vector<std::string_view>> conflict_of(
    const design::Region& region);

struct ShownServed : design::WorksFor {
  bool of_pulse{false};

  [[nodiscard]] std::optional<design::ServedInterval> v0() const {
    return of_pulse ? std::nullopt : std::optional(hit);
  }
  [[nodiscard]] std::optional<design::ServedInterval> k() const {
    return of_pulse ? std::optional(hit) : std::nullopt;
  }
};
[[nodiscard]] std::optional<ShownServed> served(const std::optional<design::WorksFor>& works_for,
                                                const ShownTask& task);
/// By the k of a pulse if there is one; empty without a damper.
[[nodiscard]] std::optional<std::vector<design::Hits>> hits_of(const ShownTask& task,
                                                               const std::optional<double>& f,
                                                               const std::optional<double>& delta);
/// At the ends of the ranges; empty without any.
[[nodiscard]] std::optional<ShownPractice> practice_at_ends(
    const ShownTask& task, const std::optional<design::Practice>& own,
    const std::optional<double>& f, const std::optional<double>& delta);

struct ShownPart {
  const design::RatedPart& rated;
  ShownTask task;
};
[[nodiscard]] std::optional<std::vector<ShownPart>> parts_of(
    const std::optional<Catalogue>& catalogue, const ShownTask& task);
[[nodiscard]] std::optional<double> in_metres(const Physical& physical,
                                              const std::optional<double>& length);
[[nodiscard]] std::optional<std::string> file_of(const std::optional<Catalogue>& catalogue);
[[nodiscard]] std::optional<std::string> if_any(std::string text);

inline constexpr auto relations = std::to_array<std::string_view>({"<", "<=", ">=", ">"});
inline constexpr auto constrained =
    std::to_array<std::string_view>({"f", "delta", "v0", "peak", "acceleration"});
inline constexpr auto constraint_names =
    std::to_array<std::string_view>({"dead_zone", "start", "amplitude", "return", "residual",
                                     "stop", "f_max", "delta_max", "acceleration"});
inline constexpr auto conflict_names =
    std::to_array<std::string_view>({"amplitude", "return", "dead_zone", "f_max", "stop", "start",
                                     "delta_max", "acceleration", "arrivals", "rounding"});
inline constexpr auto region_origins =
    std::to_array<std::string_view>({"reduction", "forced_motion"});
inline constexpr auto pulse_names =
    std::to_array<std::string_view>({"half-sine", "full-sine", "rectangle"});

inline constexpr Measure at_least_one{Numbers::from_one};

/// Of the input, before the limits and behind them.
inline constexpr auto problem_fields = [] {
  using design::BoxShape;
  using Now = ShownInput;
  return std::tuple{
      Field{"v0", &Now::v0,
            "of the motion shown; with a pulse, the velocity of its reduction in a design, else "
            "null",
            any_number},
      Field{"v0_range",
            [](const Now& now) { return range_of(now.task.problem.v0_low, now.task.problem.v0); }},
      Field{"p", [](const Now& now) { return now.task.problem.p; }},
      Field{"p_range",
            [](const Now& now) { return range_of(now.task.problem.p, now.task.problem.p_high); }},
      Field{"beta", [](const Now& now) { return now.task.problem.beta; }},
      Field{"criterion", [](const Now& now) { return now.task.problem.criterion; }},
      Field{"arrivals", [](const Now& now) { return now.task.problem.arrivals; }, "", at_least_one},
      Field{"residual", [](const Now& now) { return now.task.problem.residual; }},
      Field{"tolerance", &Now::tolerance},
      Field{"tolerance_f",
            [](const Now& now) { return now.side(&BoxShape::f_low, &BoxShape::f_high); }},
      Field{"tolerance_delta",
            [](const Now& now) { return now.side(&BoxShape::delta_low, &BoxShape::delta_high); }}};
}();
inline constexpr auto pulse_fields = [] {
  using Now = ShownInput;
  return std::tuple{
      Field{"pulse",
            [](const Now& now) {
              return now.task.pulse ? std::optional(design::name(*now.task.pulse)) : std::nullopt;
            },
            "",
            {.texts = pulse_names}},
      Field{"k", &Now::k},
      Field{"k_range", [](const Now& now) { return range_of(now.task.ranges.k_low, now.k()); }},
      Field{"lambda", &Now::lambda},
      Field{"lambda_range",
            [](const Now& now) { return range_of(now.lambda(), now.task.ranges.lambda_high); }}};
}();

/// The whole input, with its own fields behind the others.
template <class Input, class Fields>
[[nodiscard]] nlohmann::ordered_json input_json(const Input& input, const Fields& own) {
  auto json = nlohmann::ordered_json::object();
  add_fields(json, problem_fields, input);
  for (const design::LimitKind& kind : design::limit_kinds()) {
    json[std::string(kind.field)] = input.task.limits.*kind.value;
  }
  add_fields(json, pulse_fields, input);
  add_fields(json, own, input);
  return json;
}
template <class Input, class Fields>
[[nodiscard]] nlohmann::ordered_json input_schema(const Fields& own) {
  auto properties = properties_of<Input>(problem_fields);
  for (const design::LimitKind& kind : design::limit_kinds()) {
    properties[std::string(kind.field)] = value_schema<std::optional<double>>();
  }
  properties.update(properties_of<Input>(pulse_fields));
  properties.update(properties_of<Input>(own));
  return object_schema(std::move(properties));
}

}  // namespace stillpoint::report

namespace stillpoint {

template <>
inline constexpr auto fields<design::Constraint> = [] {
  using Now = design::Constraint;
  return std::tuple{
      Field{"name", &Now::name, "", {.texts = report::constraint_names}},
      Field{"variable", &Now::variable, "what is bounded", {.texts = report::constrained}},
      Field{"relation", &Now::relation, "", {.texts = report::relations}},
      Field{"value", &Now::value, "", report::any_number},
      Field{"limit", &Now::limit, "", report::any_number},
      Field{"slack", &Now::slack, "", report::any_number},
      Field{"satisfied", &Now::satisfied}};
}();

template <>
inline constexpr auto fields<design::Mend> =
    std::tuple{Field{"input", &design::Mend::field},
               Field{"value", &design::Mend::value, "", report::any_number}};

template <>
inline constexpr auto fields<design::DesignPoint> =
    std::tuple{Field{"tolerance", &design::DesignPoint::tolerance},
               Field{"f", &design::DesignPoint::f}, Field{"delta", &design::DesignPoint::delta}};

template <>
inline constexpr auto fields<design::Strip> = [] {
  using Now = design::Strip;
  return std::tuple{
      Field{"arrival", &Now::arrival,
            "0 where any rest, or the first peak, is within the residual"},
      Field{"beta_min", &Now::beta_min},
      Field{"f_lower", &Now::f_lower, "with f_upper null if no damper has the tolerance asked for"},
      Field{"f_upper", &Now::f_upper},
      Field{"tolerance", &Now::tolerance, "the largest of any damper that stops at this arrival"}};
}();

template <>
inline constexpr auto fields<design::RegionVerdict> = [] {
  using design::Region;
  using Now = design::RegionVerdict;
  return std::tuple{
      Field{"feasible", in(&Now::region, &Region::feasible)},
      Field{"reason", &Now::reason, "why it is empty; else null"},
      Field{"conflict",
            [](const Now& now) { return report::conflict_of(now.region); },
            "the requirements that conflict; null if the region is not empty",
            {.numbers = Numbers::from_one, .texts = report::conflict_names}},
      Field{"f1", in(&Now::region, &Region::f1), "", report::any_number},
      Field{"f2", in(&Now::region, &Region::f2), "may be negative", report::any_number},
      Field{"f3", in(&Now::region, &Region::f3), "", report::any_number},
      Field{"f4", in(&Now::region, &Region::f4), "of acceleration_max; negative if no f meets it",
            report::any_number},
      Field{"f_lower", in(&Now::region, &Region::f_lower),
            "with f_upper: the f that every limit leaves", report::any_number},
      Field{"f_upper", in(&Now::region, &Region::f_upper), "", report::any_number},
      Field{"delta2", in(&Now::region, &Region::delta2),
            "null with a pulse: the mass starts from rest, and nothing bounds delta",
            report::any_number},
      Field{"beta_min", in(&Now::region, &Region::beta_min), "", report::any_number},
      Field{"by",
            [](const Now& now) {
              return now.intervals ? std::optional(report::region_origins.back()) : std::nullopt;
            },
            "how the region of a pulse was found; null without a pulse",
            {.texts = report::region_origins}},
      Field{"intervals", &Now::intervals,
            "with a pulse, the f that are admissible, regardless of the tolerance; else null"},
      Field{"most_tolerant", &Now::most_tolerant,
            "if only the requested tolerance makes the region empty: the damper with the largest "
            "tolerance, and that tolerance"},
      Field{"mends", &Now::mends,
            "an input and the nearest value that would make the region non-empty"},
      Field{"mends_cut_short", &Now::mends_cut_short,
            "with a pulse: the search for some mends was given up because it would have taken "
            "longer than a second"},
      Field{"largest_tolerance", &Now::largest_tolerance,
            "after a hit, if no single input makes it feasible: the largest tolerance of any "
            "damper, if that is less than asked for"},
      Field{"criterion_mend", &Now::criterion_mend,
            "exact if that criterion alone makes the region non-empty, or admits a part"}};
}();

template <>
inline constexpr auto fields<report::ShownServed> =
    std::tuple{Field{"v0", &report::ShownServed::v0}, Field{"k", &report::ShownServed::k},
               Field{"p", &report::ShownServed::p}};

template <>
inline constexpr auto fields<design::Hits> =
    std::tuple{Field{"from", &design::Hits::from}, Field{"to", &design::Hits::to},
               Field{"ends", &design::Hits::end},
               Field{"arrivals", &design::Hits::arrivals, "", {Numbers::counts}},
               Field{"rest", &design::Hits::rest, "off centre, the farthest", report::any_number}};

template <>
inline constexpr auto fields<report::ShownPart> = [] {
  using Now = report::ShownPart;
  return std::tuple{Field{"name", [](const Now& now) { return now.rated.part.name; }},
                    Field{"f", [](const Now& now) { return now.rated.part.f; }},
                    Field{"delta", [](const Now& now) { return now.rated.part.delta; }},
                    Field{"delta_m",
                          [](const Now& now) {
                            return report::in_metres(now.task.physical, now.rated.part.delta);
                          }},
                    Field{"admissible", [](const Now& now) { return now.rated.admissible; }},
                    Field{"tolerance", [](const Now& now) { return now.rated.tolerance; },
                          "the largest that the part allows; null if it is not admissible itself"},
                    Field{"why",
                          [](const Now& now) {
                            return now.rated.admissible
                                       ? std::nullopt
                                       : std::optional(report::judgement(now.rated, now.task));
                          },
                          "it is not admissible; null if it is",
                          {Numbers::all}},
                    Field{"violates", [](const Now& now) -> const auto& {return now.rated.violated;
}
}
}
;
}
();

}  // namespace stillpoint
