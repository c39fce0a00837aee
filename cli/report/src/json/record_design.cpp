// SPDX-License-Identifier: MIT
#include "json/head_fields.hpp"
#include "json/schema.hpp"

#include "record_design_parts.hpp"

#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/schemas.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace stillpoint::report {

namespace {

constexpr auto record_design_name =
    std::to_array<std::string_view>({"stillpoint/record-design-report/1"});
constexpr auto boxes_status = std::to_array<std::string_view>({"SUCCESS", "INTERRUPTED"});

constexpr Measure in_metres_too{
    .dimension = Dimension::length, .physical = {}, .texts = {}, .si = InSi::beside};
constexpr Measure in_metres_alone{
    .dimension = Dimension::length, .physical = {}, .texts = {}, .si = InSi::alone};
constexpr Measure in_seconds_alone{
    .dimension = Dimension::time, .physical = {}, .texts = {}, .si = InSi::alone};

/// The period without friction, in tau.
double turn(double p) {
  return 2 * std::numbers::pi / p;
}

Interval factors(const design::Spread& spread) {
  return {1 - spread.below, 1 + spread.above};
}

/// Empty of what is exact.
std::optional<Interval> unless_exact(const Interval& side) {
  return side.low < side.high ? std::optional(side) : std::nullopt;
}

/// Empty where a motion never rests.
std::optional<design::SuiteFigures> settled(const design::SuiteFigures& figures) {
  return figures.settled ? std::optional(figures) : std::nullopt;
}

constexpr auto factors_of(design::Spread design::SuiteTolerance::*side) {
  return [side](const design::RecordDesignRequest& task) { return factors(task.tolerance.*side); };
}

/// A damper of the box, for each figure of its worst.
struct WorstDampers {
  const std::array<design::SuiteDamper, design::suite_figure_kinds.size()>& of;
};
struct ShownWorst : design::SuiteFigures {
  WorstDampers of;
};

struct ShownDamper : design::SuiteDamper {
  std::optional<double> tolerance;
  const design::SuiteBox& box;
};

struct ShownRecordMotion : design::SuiteFigures {
  const design::SuiteRecord& record;
  const ForcedResponse& response;
};

struct Scan {
  std::int64_t points;
  std::int64_t feasible;
};
struct SuiteMethod : design::SuiteCheck {};
struct Nearest {
  design::SuitePoint point;
};
struct ShownLimit : design::SuiteShortfall {
  std::string file;
  std::optional<double> found;
  bool is_length;
};

std::vector<ShownRecordMotion> suite_motions(const RecordDesignReport& report) {
  std::vector<ShownRecordMotion> shown;
  if (const auto& finding = report.result.finding) {
    for (std::size_t i = 0; i < finding->responses.size(); ++i) {
      const ForcedResponse& response = finding->responses[i];
      shown.push_back(
          {design::suite_figures(response), report.result.request.records[i], response});
    }
  }
  return shown;
}

std::vector<ShownLimit> limits_of(const RecordDesignReport& report) {
  const design::RecordDesign& result = report.result;
  std::vector<ShownLimit> shown;
  for (const design::SuiteShortfall& now : result.shortfalls) {
    shown.push_back(
        {now, result.request.records[now.record].name,
         result.nearest.figures.settled ? std::optional(now.nearest) : std::nullopt,
         now.kind->objective && now.kind->objective != design::SuiteObjective::acceleration});
  }
  return shown;
}

/// What `get` gives of a finding; empty without one.
template <class Get>
constexpr auto of_finding(Get get) {
  return [get](const RecordDesignReport& report) {
    const auto& finding = report.result.finding;
    using Value = std::remove_cvref_t<decltype(get(*finding, report.result))>;
    using Shown = std::conditional_t<is_optional<Value>, Value, std::optional<Value>>;
    return finding ? Shown(get(*finding, report.result)) : Shown();
  };
}

constexpr auto if_length(const auto& get) {
  return [get](const ShownLimit& now) {
    return now.is_length ? std::optional<double>(std::invoke(get, now)) : std::nullopt;
  };
}

}  // namespace

}  // namespace stillpoint::report

namespace stillpoint {

template <>
inline constexpr auto fields<design::RecordDesignRequest> = [] {
  using namespace report;
  using design::SuiteLimits;
  using design::SuiteTolerance;
  using Now = design::RecordDesignRequest;
  constexpr auto limits = &Now::limits;
  constexpr auto width = [](const Now& now) {
    return now.width && now.width->low == now.width->high ? std::optional(now.width->low)
                                                          : std::nullopt;
  };
  return std::tuple{
      Field{"records", [](const Now& now) { return now.records.size(); }, "", {Numbers::from_one}},
      Field{"p_range", &Now::p},
      Field{"f_range", [](const Now& now) { return now.f.value(); }},
      Field{"delta_range", [](const Now& now) { return now.delta.value(); }},
      Field{"objective", &Now::objective},
      Field{"combine", [](const Now& now) { return now.combine.value(); }},
      Field{"beta",
            in(limits, &SuiteLimits::peak),
            "",
            {.dimension = Dimension::length,
             .physical = "max_displacement_m",
             .texts = {},
             .si = InSi::beside}},
      Field{"residual", in(limits, &SuiteLimits::residual), "", in_metres_too},
      Field{"acceleration_max", in(limits, &SuiteLimits::acceleration)},
      Field{"jump_max",
            in(limits, &SuiteLimits::jump),
            "",
            {.dimension = Dimension::velocity, .physical = {}, .texts = {}, .si = InSi::beside}},
      Field{"hold", &Now::hold},
      Field{"notch_width", width, "", in_metres_too},
      Field{"notch_width_range", &Now::width},
      Field{"tolerance",
            [](const Now& now) {
              const auto& [f, delta, of_width, period] = now.tolerance;
              return std::max({f.below, f.above, delta.below, delta.above});
            }},
      Field{"tolerance_f", factors_of(&SuiteTolerance::f),
            "the factors between which it may be, like the next"},
      Field{"tolerance_delta", factors_of(&SuiteTolerance::delta)},
      Field{"tolerance_width", factors_of(&SuiteTolerance::width)},
      Field{"tolerance_period", factors_of(&SuiteTolerance::period)}};
}();

template <>
inline constexpr auto fields<design::SuiteDamper> = [] {
  using namespace report;
  using Now = design::SuiteDamper;
  return std::tuple{
      Field{"f", &Now::f},
      Field{"friction_force_n",
            &Now::f,
            "null without a mass, like energy_per_passage_j",
            {.dimension = Dimension::force, .physical = {}, .texts = {}, .si = InSi::alone}},
      Field{"delta", &Now::delta, "", in_metres_too},
      Field{"energy_per_passage_j",
            &Now::delta,
            "",
            {.dimension = Dimension::energy, .physical = {}, .texts = {}, .si = InSi::alone}},
      Field{"p", &Now::p},
      Field{"period_s", [](const Now& now) { return turn(now.p); }, "without friction",
            in_seconds_alone},
      Field{"notch_width",
            [](const Now& now) { return now.width > 0 ? std::optional(now.width) : std::nullopt; },
            "null without a width", in_metres_too}};
}();

template <>
inline constexpr auto fields<design::SuiteBox> = [] {
  using namespace report;
  using Now = design::SuiteBox;
  constexpr auto side = [](Interval Now::*of) {
    return [of](const Now& now) { return unless_exact(now.*of); };
  };
  return std::tuple{
      Field{"f", side(&Now::f), "null: exact"},
      Field{"delta", side(&Now::delta), "", in_metres_too},
      Field{"p", side(&Now::p)},
      Field{"period_s",
            [](const Now& now) {
              return unless_exact({turn(now.p.high), turn(now.p.low)});
            },
            "", in_seconds_alone},
      Field{"notch_width", side(&Now::width), "", in_metres_too},
      Field{"samples", &Now::samples, "the dampers of it that were tried"},
      Field{"exact", [](const Now&) { return false; }, "whether they prove it of all"}};
}();

template <>
inline constexpr auto fields<report::ShownDamper> = std::tuple_cat(
    fields<design::SuiteDamper>,
    std::tuple{
        Field{"tolerance", &report::ShownDamper::tolerance,
              "the largest within the limits, where that was searched"},
        Field{"box",
              [](const report::ShownDamper& now) -> const design::SuiteBox& { return now.box; },
              "the dampers that were tried"}});

template <>
inline constexpr auto fields<design::SuiteFigures> = [] {
  using Now = design::SuiteFigures;
  return std::tuple{
      Field{
          "peak_amplitude",
          &Now::peak,
          "",
          {.dimension = Dimension::length, .physical = "peak_m", .texts = {}, .si = InSi::beside}},
      Field{"peak_absolute_acceleration", &Now::acceleration},
      Field{"residual", &Now::residual, "", report::in_metres_too},
      Field{"jump",
            &Now::jump,
            "of the velocity at a notch without width",
            {.dimension = Dimension::velocity, .physical = {}, .texts = {}, .si = InSi::beside}}};
}();

template <>
inline constexpr auto fields<report::WorstDampers> = [] {
  using Now = report::WorstDampers;
  constexpr auto at = [](std::size_t kind) {
    return [kind](const Now& now) -> const design::SuiteDamper& { return now.of.at(kind); };
  };
  return std::tuple{Field{"peak_amplitude", at(0)}, Field{"peak_absolute_acceleration", at(1)},
                    Field{"residual", at(2)}, Field{"jump", at(3)}};
}();

template <>
inline constexpr auto fields<report::ShownWorst> =
    std::tuple_cat(fields<design::SuiteFigures>,
                   std::tuple{Field{"of", &report::ShownWorst::of,
                                    "of each figure the damper of the box that has it"}});

template <>
inline constexpr auto fields<report::ShownRecordMotion> = [] {
  using Now = report::ShownRecordMotion;
  return std::tuple_cat(
      std::tuple{Field{"file", [](const Now& now) { return now.record.name; }, "", {Numbers::all}},
                 Field{"scale", [](const Now& now) { return now.record.scale; },
                       "the factor on its values", report::any_number},
                 Field{"pga", [](const Now& now) { return design::peak_load(now.record); },
                       "the largest |W| in g, with that factor"}},
      fields<design::SuiteFigures>,
      std::tuple{
          Field{"outcome", [](const Now& now) { return now.response.outcome; }},
          Field{"locked_from",
                [](const Now& now) { return now.response.locked_from; },
                "null where the mass does not lock, like largest_load_while_locked",
                {.dimension = Dimension::time, .physical = {}, .texts = {}, .si = InSi::beside}},
          Field{"largest_load_while_locked",
                [](const Now& now) { return now.response.largest_load_while_locked; }},
          Field{"decision_margin", [](const Now& now) { return now.response.decision_margin; }}});
}();

template <>
inline constexpr auto fields<report::Scan> = std::tuple{
    Field{"points", &report::Scan::points, "boxes"}, Field{"feasible", &report::Scan::feasible}};

template <>
inline constexpr auto fields<design::SuiteSearchCost> = [] {
  using Now = design::SuiteSearchCost;
  return std::tuple{
      Field{"library",
            [](const Now&) { return report::program_names.front(); },
            "",
            {.texts = report::program_names}},
      Field{"algorithm", [](const Now&) { return std::string_view("boxes"); }},
      Field{"status",
            [](const Now& now) { return report::boxes_status.at(now.interrupted ? 1 : 0); },
            "",
            {.texts = report::boxes_status}},
      Field{"evaluations", &Now::evaluations, "dampers"},
      Field{"wall_time_s", &Now::wall_time_s},
      Field{"scan",
            [](const Now& now) {
              return report::Scan{now.scan_points, now.scan_feasible};
            }},
      Field{"interrupted", &Now::interrupted, "by the user: the design is the best so far"}};
}();

template <>
inline constexpr auto fields<design::SuiteOutlook> = [] {
  using Now = design::SuiteOutlook;
  return std::tuple{Field{"off", [](const Now&) { return Now::off; }},
                    Field{"period", [](const Now& now) { return report::settled(now.period); }},
                    Field{"scale", [](const Now& now) { return report::settled(now.scale); }}};
}();

template <>
inline constexpr auto fields<design::SuiteCheckRow> = [] {
  using Now = design::SuiteCheckRow;
  return std::tuple{
      Field{"peak_amplitude", &Now::peak}, Field{"peak_absolute_acceleration", &Now::acceleration},
      Field{"residual", &Now::residual}, Field{"relative_error", &Now::relative_error}};
}();

template <>
inline constexpr auto fields<report::SuiteMethod> = [] {
  using Now = report::SuiteMethod;
  return std::tuple{Field{"name", [](const Now&) { return std::string_view("runge_kutta"); }},
                    Field{"tolerance", &Now::tolerance},
                    Field{"relative_error", &Now::relative_error},
                    Field{"wall_time_s", &Now::wall_time_s}, Field{"records", &Now::records}};
}();

template <>
inline constexpr auto fields<design::SuiteCheck> =
    std::tuple{Field{"passed", &design::SuiteCheck::passed},
               Field{"methods", [](const design::SuiteCheck& check) {
                       return std::vector{report::SuiteMethod{check}};
                     }}};

template <>
inline constexpr auto fields<report::Nearest> = std::tuple{
    Field{"design", in(&report::Nearest::point, &design::SuitePoint::damper)},
    Field{"worst", [](const report::Nearest& now) { return report::settled(now.point.figures); },
          "null where a motion never rests"}};

template <>
inline constexpr auto fields<report::ShownLimit> = [] {
  using namespace report;
  using Now = ShownLimit;
  return std::tuple{
      Field{"limit", [](const Now& now) { return now.kind->limit_field; }},
      Field{"value", &Now::limit},
      Field{"value_m", if_length(&Now::limit), "of a length", in_metres_alone},
      Field{"nearest", &Now::found, "the largest in the box; null where a motion never rests"},
      Field{"nearest_m", if_length([](const Now& now) { return now.found; }), "", in_metres_alone},
      Field{"record", &Now::file, "under which that is largest", {Numbers::all}},
      Field{"relaxed", &Now::relaxed,
            "the value to which this limit alone must be relaxed; null where none was found"},
      Field{"relaxed_m", if_length(&Now::relaxed), "", in_metres_alone}};
}();

template <>
inline constexpr auto fields<report::RecordDesignReport> = [] {
  using namespace report;
  using design::RecordDesign;
  using design::RecordFinding;
  using Now = RecordDesignReport;
  return std::tuple_cat(
      head_fields<Now, record_design_name>,
      std::tuple{Field{"input", in(&Now::result, &RecordDesign::request)}}, told_fields<Now>,
      std::tuple{
          Field{"design", of_finding([](const RecordFinding& now, const RecordDesign& result) {
                  return ShownDamper{now.point.damper, result.largest_tolerance, now.box};
                }),
                "null where no damper was found, like the next two and cross_check"},
          Field{"worst", of_finding([](const RecordFinding& now, const auto&) {
                  return ShownWorst{now.box.worst, {now.box.of}};
                }),
                "the largest of the box, combined as asked"},
          Field{"records", &suite_motions, "under each the motion of the design itself"},
          Field{"search", in(&Now::result, &RecordDesign::search)},
          Field{"nominal", of_finding([](const RecordFinding& now, const auto&) {
                  return settled(now.point.figures);
                }),
                "of the design itself"},
          Field{"outlook",
                of_finding([](const RecordFinding& now, const auto&) { return now.outlook; }),
                "the worst where the period, or the scale of all records, is off as well"},
          Field{"largest_tolerance", in(&Now::result, &RecordDesign::largest_tolerance)},
          Field{"cross_check",
                of_finding([](const RecordFinding& now, const auto&) { return now.check; })},
          Field{"nearest",
                [](const Now& now) {
                  return now.result.finding ? std::nullopt
                                            : std::optional(Nearest{now.result.nearest});
                },
                "without a design: what violates the limits least"},
          Field{"limits", &limits_of, "without a design"}});
}();

}  // namespace stillpoint

namespace stillpoint::report {

nlohmann::ordered_json json(const RecordDesignReport& report) {
  return object_json(report, scales_of(report.physical));
}

nlohmann::ordered_json record_design_schema() {
  return document_schema(record_design_name.front(), "design --json", dimensionless_numbers,
                         schema_of<RecordDesignReport>());
}

}  // namespace stillpoint::report
