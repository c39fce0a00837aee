// SPDX-License-Identifier: MIT
#pragma once

// The report of a design or a region, the same of hits, pulses and records, with its tables of
// fields. What an answer does not have is empty.

#include "choices.hpp"
#include "json/head_fields.hpp"
#include "json/schema.hpp"
#include "sections.hpp"

#include <stillpoint/core/interval.hpp>
#include <stillpoint/design/hits.hpp>
#include <stillpoint/design/record_design_result.hpp>
#include <stillpoint/design/region.hpp>
#include <stillpoint/design/works_for.hpp>
#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/report.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace stillpoint::report {

using IfReal = std::optional<double>;
using IfCount = std::optional<std::int64_t>;
using IfRange = std::optional<Interval>;
using Name = std::optional<std::string>;

inline constexpr auto objectives =
    std::to_array<std::string_view>({"robust", "amplitude", "time", "acceleration", "residual"});
inline constexpr auto pulse_names =
    std::to_array<std::string_view>({"half-sine", "full-sine", "rectangle"});
inline constexpr auto load_types =
    std::to_array<std::string_view>({"hit", "half-sine", "full-sine", "rectangle", "records"});
inline constexpr auto relations = std::to_array<std::string_view>({"<", "<=", ">=", ">"});
inline constexpr auto constrained = std::to_array<std::string_view>(
    {"f", "delta", "v0", "peak", "acceleration", "residual", "jump"});
inline constexpr auto constraint_names =
    std::to_array<std::string_view>({"dead_zone", "start", "amplitude", "return", "residual",
                                     "stop", "f_max", "delta_max", "acceleration", "jump"});
inline constexpr auto conflict_names =
    std::to_array<std::string_view>({"amplitude", "return", "dead_zone", "f_max", "stop", "start",
                                     "delta_max", "acceleration", "arrivals", "rounding"});
inline constexpr auto region_origins =
    std::to_array<std::string_view>({"reduction", "forced_motion"});
inline constexpr auto libraries = std::to_array<std::string_view>({"NLopt", "stillpoint"});
inline constexpr auto check_methods =
    std::to_array<std::string_view>({"half_cycle_map", "runge_kutta", "forced_pulse"});

/// The constraints and limits that conflict, by name; empty where none do.
[[nodiscard]] std::optional<std::vector<std::string_view>> conflict_of(
    const design::Region& region);

/// Of numbers; what else there is of a figure has no unit.
template <class Value>
constexpr Measure in_si(Dimension dimension, std::string_view name = {}) {
  return std::is_same_v<Value, double> ? with_si(dimension, name) : Measure();
}
/// A value of each figure that may be limited: of several motions, or of several dampers.
template <class Value>
struct OfFigures {
  std::optional<Value> peak{}, acceleration{}, residual{}, stop_time{}, jump{};

  static constexpr bool numbers = std::is_same_v<Value, double>;
  static constexpr std::tuple field_table{
      Field{"peak_amplitude", &OfFigures::peak, "", in_si<Value>(Dimension::length, "peak_m")},
      Field{"peak_absolute_acceleration", &OfFigures::acceleration},
      Field{"residual", &OfFigures::residual, "", in_si<Value>(Dimension::length)},
      Field{"stop_time", &OfFigures::stop_time, "", in_si<Value>(Dimension::time)},
      Field{"jump", &OfFigures::jump, numbers ? "of the velocity at a notch without a width" : "",
            in_si<Value>(Dimension::velocity)}};
};
using Worst = OfFigures<double>;
[[nodiscard]] Worst worst_of(const design::SuiteFigures& figures);
/// Empty where a motion never rests.
[[nodiscard]] std::optional<Worst> settled(const design::SuiteFigures& figures);

}  // namespace stillpoint::report

namespace stillpoint {

template <>
inline constexpr auto fields<design::SuiteDamper> = [] {
  using Now = design::SuiteDamper;
  return std::tuple{
      Field{"f", &Now::f}, Field{"delta", &Now::delta, "", report::in_metres},
      Field{"p", &Now::p, "of a range the softest spring"},
      Field{"period_s", [](const Now& now) { return report::turn(now.p); }, "without friction",
            report::si_alone(Dimension::time)},
      Field{"notch_width",
            [](const Now& now) { return now.width > 0 ? std::optional(now.width) : std::nullopt; },
            "null without a width", report::in_metres}};
}();

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
  using report::any_number;
  using Now = design::RegionVerdict;
  return std::tuple{
      Field{"feasible", in(&Now::region, &Region::feasible)},
      Field{"reason", &Now::reason, "why it is empty; else null"},
      Field{"conflict",
            [](const Now& now) { return report::conflict_of(now.region); },
            "the requirements that conflict; null if the region is not empty",
            {.numbers = Numbers::from_one, .texts = report::conflict_names}},
      Field{"f1", in(&Now::region, &Region::f1), "", any_number},
      Field{"f2", in(&Now::region, &Region::f2), "may be negative", any_number},
      Field{"f3", in(&Now::region, &Region::f3), "", any_number},
      Field{"f4", in(&Now::region, &Region::f4), "of acceleration_max; negative if no f meets it",
            any_number},
      Field{"f_lower", in(&Now::region, &Region::f_lower),
            "with f_upper: the f that every limit leaves", any_number},
      Field{"f_upper", in(&Now::region, &Region::f_upper), "", any_number},
      Field{"delta2", in(&Now::region, &Region::delta2),
            "null with a pulse: the mass starts from rest, and nothing bounds delta", any_number},
      Field{"beta_min", in(&Now::region, &Region::beta_min), "", any_number},
      Field{"by",
            [](const Now& now) {
              return now.intervals ? std::optional(report::region_origins.back()) : std::nullopt;
            },
            "how the region of a pulse was found; null without a pulse",
            report::one_of(report::region_origins)},
      Field{"intervals", &Now::intervals,
            "with a pulse, the f that are admissible, regardless of the tolerance; else null"},
      Field{"most_tolerant", &Now::most_tolerant,
            "if only the requested tolerance makes the region empty: the damper with the largest "
            "tolerance, and that tolerance"},
      Field{"mends_cut_short", &Now::mends_cut_short,
            "with a pulse: the search for some mends was given up because it would have taken "
            "longer than a second"},
      Field{"criterion_mend", &Now::criterion_mend,
            "exact if that criterion alone makes the region non-empty, or admits a part"}};
}();

template <>
inline constexpr auto fields<design::Hits> =
    std::tuple{Field{"from", &design::Hits::from}, Field{"to", &design::Hits::to},
               Field{"ends", &design::Hits::end},
               Field{"arrivals", &design::Hits::arrivals, "", report::counted},
               Field{"rest", &design::Hits::rest, "off centre, the farthest", report::any_number}};

template <>
inline constexpr auto fields<design::PulseCheck> = [] {
  using Now = design::PulseCheck;
  using report::any_number;
  using report::IfAny;
  return std::tuple{
      Field{"shortness", &Now::shortness, "p/lambda"},
      Field{"friction_ratio", &Now::friction_ratio, "f/k"},
      Field{"equivalent_v0", IfAny{&Now::start, &EquivalentStart::speed}, "", any_number},
      Field{"equivalent_start", IfAny{&Now::start, &EquivalentStart::tau}, "", any_number},
      Field{"peak_error", &Now::peak_error, "", any_number},
      Field{"stop_time_error", &Now::stop_time_error, "", any_number},
      Field{"warnings", &Now::warnings}};
}();

template <>
inline constexpr auto fields<design::TradeOff> = [] {
  using design::DesignPoint;
  using report::with_si;
  using Now = design::TradeOff;
  return std::tuple{
      Field{"f", in(&Now::damper, &DesignPoint::f)},
      Field{"delta", in(&Now::damper, &DesignPoint::delta), "", report::in_metres},
      Field{"tolerance", in(&Now::damper, &DesignPoint::tolerance)},
      Field{"peak_amplitude", &Now::peak_amplitude, "", with_si(Dimension::length, "peak_m")},
      Field{"peak_absolute_acceleration", &Now::transmitted},
      Field{"stop_time", &Now::stop_time, "", with_si(Dimension::time)}};
}();

template <>
inline constexpr auto fields<design::SuitePoint> = [] {
  using Now = design::SuitePoint;
  return std::tuple{Field{"design", &Now::damper},
                    Field{"worst", [](const Now& now) { return report::settled(now.figures); },
                          "null where a motion never rests"}};
}();

template <>
inline constexpr auto fields<design::SuiteOutlook> = [] {
  using Now = design::SuiteOutlook;
  return std::tuple{Field{"off", [](const Now&) { return Now::off; }},
                    Field{"period", [](const Now& now) { return report::settled(now.period); }},
                    Field{"scale", [](const Now& now) { return report::settled(now.scale); }}};
}();

template <>
inline constexpr auto fields<design::CheckedMotion> = [] {
  using Now = design::CheckedMotion;
  return std::tuple{
      Field{"peak_amplitude", &Now::peak}, Field{"peak_absolute_acceleration", &Now::acceleration},
      Field{"residual", &Now::residual}, Field{"relative_error", &Now::relative_error}};
}();

template <>
inline constexpr auto fields<design::MotionFigures> = [] {
  using Now = design::MotionFigures;
  return std::tuple{Field{"peak_amplitude", &Now::peak_amplitude},
                    Field{"peak_acceleration", &Now::peak_acceleration},
                    Field{"stop_time", &Now::stop_time},
                    Field{"arrival_speed", &Now::arrival_speed},
                    Field{"half_cycles", &Now::half_cycles, "", report::counted},
                    Field{"stop_position", &Now::stop_position, "", report::any_number}};
}();

template <>
inline constexpr auto fields<design::Constraint> = [] {
  using report::any_number;
  using Now = design::Constraint;
  constexpr Measure metres_alone = report::si_alone(Dimension::length, Numbers::all);
  const auto if_known = [](double Now::*of) {
    return [of](const Now& now) { return now.known ? std::optional(now.*of) : std::nullopt; };
  };
  return std::tuple{
      Field{"case", [](const Now&) { return report::Name(); }},
      Field{"name", &Now::name, "", report::one_of(report::constraint_names)},
      Field{"variable", &Now::variable, "what is bounded", report::one_of(report::constrained)},
      Field{"relation", &Now::relation, "", report::one_of(report::relations)},
      Field{"value", if_known(&Now::value), "null where a motion never rests, like slack",
            any_number},
      Field{"value_m",
            [](const Now& now) {
              return now.dimension() == Dimension::length && now.known ? std::optional(now.value)
                                                                       : std::nullopt;
            },
            "of a length", metres_alone},
      Field{"limit", &Now::limit, "", any_number},
      Field{"limit_m",
            [](const Now& now) {
              return now.dimension() == Dimension::length ? std::optional(now.limit) : std::nullopt;
            },
            "", metres_alone},
      Field{"slack", if_known(&Now::slack), "", any_number},
      Field{"satisfied", &Now::satisfied},
      Field{"motion", report::IfAny{&Now::motion, &Now::Motion::file},
            "without a design, the record under which the value is largest", any_number}};
}();

template <>
inline constexpr auto fields<design::Mend> =
    std::tuple{Field{"case", [](const design::Mend&) { return report::Name(); }},
               Field{"input", &design::Mend::field},
               Field{"value", &design::Mend::value, "", report::any_number}};

template <>
inline constexpr auto fields<design::SearchRecord::Scan> =
    std::tuple{Field{"points", &design::SearchRecord::Scan::points, "boxes"},
               Field{"feasible", &design::SearchRecord::Scan::feasible}};

template <>
inline constexpr auto fields<design::SearchRecord> = [] {
  using report::any_number;
  using Now = design::SearchRecord;
  return std::tuple{
      Field{"library", [](const Now& now) { return report::libraries.at(now.scan ? 1 : 0); }, "",
            report::one_of(report::libraries)},
      Field{"library_version",
            [](const Now& now) {
              return now.scan ? report::program_version() : design::nlopt_version();
            }},
      Field{"algorithm", &Now::algorithm},
      Field{"status", &Now::status, "NLopt's; under records SUCCESS or INTERRUPTED"},
      Field{"evaluations", &Now::evaluations},
      Field{"wall_time_s", &Now::wall_time_s},
      Field{"optimum", &Now::by_nlopt,
            "the objective's value of the design; with a pulse, of NLopt's best point", any_number},
      Field{"optimum_along_f", &Now::along_f,
            "that of the best damper along f alone, found without NLopt", any_number},
      Field{"scan", &Now::scan, "null without records"},
      Field{"interrupted", &Now::interrupted, "by the user: the design is the best so far"}};
}();

template <>
inline constexpr auto fields<design::CheckMethod> = [] {
  using Now = design::CheckMethod;
  const auto figures = [](const Now& now) {
    return now.motions.empty() ? static_cast<const design::MotionFigures*>(&now) : nullptr;
  };
  return std::tuple_cat(
      std::tuple{Field{"name", &Now::name, "", report::one_of(report::check_methods)},
                 Field{"tolerance", &Now::tolerance}},
      report::fields_if_any(figures, fields<design::MotionFigures>),
      std::tuple{Field{"relative_error", &Now::relative_error},
                 Field{"wall_time_s", &Now::wall_time_s}, Field{"decided", &Now::decided},
                 Field{"passed", &Now::passed},
                 Field{"motions",
                       [](const Now& now) {
                         return now.motions.empty() ? std::nullopt : std::optional(now.motions);
                       },
                       "under each record, in place of the figures; else null"}});
}();

template <>
inline constexpr auto fields<design::CrossCheck> = std::tuple{
    Field{"passed", &design::CrossCheck::passed}, Field{"methods", &design::CrossCheck::methods}};

}  // namespace stillpoint

namespace stillpoint::report {

/// What was asked for.
struct AskedTask {
  IfReal v0{}, p{}, beta{}, residual{}, jump_max{}, k{}, lambda{}, f{}, delta{}, hold{},
      notch_width{};
  IfRange v0_range{}, p_range{}, tolerance_f{}, tolerance_delta{}, tolerance_width{},
      tolerance_period{}, k_range{}, lambda_range{}, f_range{}, delta_range{}, notch_width_range{};
  IfCount arrivals{}, trade_off{};
  std::optional<design::Criterion> criterion{};
  double tolerance{0};
  design::Limits limits{};
  std::optional<std::string_view> pulse{}, objective{};
  Name algorithm{}, catalogue{};

  using Now = AskedTask;
  using Limits = design::Limits;
  static constexpr std::tuple field_table{
      Field{"v0", &Now::v0,
            "of the motion shown; with a pulse, the velocity of its reduction in a design, else "
            "null",
            any_number},
      Field{"v0_range", &Now::v0_range},
      Field{"p", &Now::p, "null under records, like criterion and arrivals"},
      Field{"p_range", &Now::p_range},
      Field{"beta", &Now::beta},
      Field{"criterion", &Now::criterion},
      Field{"arrivals", &Now::arrivals, "", at_least_one},
      Field{"residual", &Now::residual, "", in_metres},
      Field{"tolerance", &Now::tolerance},
      Field{"tolerance_f", &Now::tolerance_f, "factors between which f may lie, like the next"},
      Field{"tolerance_delta", &Now::tolerance_delta},
      Field{"tolerance_width", &Now::tolerance_width},
      Field{"tolerance_period", &Now::tolerance_period},
      Field{"f_max", in(&Now::limits, &Limits::f_max)},
      Field{"delta_max", in(&Now::limits, &Limits::delta_max)},
      Field{"acceleration_max", in(&Now::limits, &Limits::acceleration_max)},
      Field{"jump_max", &Now::jump_max, "", with_si(Dimension::velocity)},
      Field{"pulse", &Now::pulse, "", one_of(pulse_names)},
      Field{"k", &Now::k},
      Field{"k_range", &Now::k_range},
      Field{"lambda", &Now::lambda},
      Field{"lambda_range", &Now::lambda_range},
      Field{"f_range", &Now::f_range, "searched under records, like the next two"},
      Field{"delta_range", &Now::delta_range},
      Field{"notch_width_range", &Now::notch_width_range},
      Field{"f", &Now::f, "of a given damper, like delta"},
      Field{"delta", &Now::delta},
      Field{"hold", &Now::hold, "null: any load"},
      Field{"notch_width", &Now::notch_width, "if it is given", in_metres},
      Field{"objective", &Now::objective, "null for a region", one_of(objectives)},
      Field{"algorithm", &Now::algorithm, "as given; null if the program chooses"},
      Field{"catalogue", &Now::catalogue, "the file"},
      Field{"trade_off", &Now::trade_off, "how many"}};
};

/// The dampers that the answer is about: the sides of a box that are not exact.
struct ShownBox {
  IfRange f{}, delta{}, p{}, period{}, width{};  ///< the period in tau
  IfCount samples{};
  bool exact{true};

  using Now = ShownBox;
  static constexpr std::tuple field_table{
      Field{"f", &Now::f, "null: exact, like the next"},
      Field{"delta", &Now::delta, "", in_metres},
      Field{"p", &Now::p},
      Field{"period_s", &Now::period, "", si_alone(Dimension::time)},
      Field{"notch_width", &Now::width, "", in_metres},
      Field{"samples", &Now::samples, "how many of its dampers were tried; null if proved"},
      Field{"exact", &Now::exact, "whether it is proved of all its dampers"}};
};

struct BoxedDamper : design::SuiteDamper {
  ShownBox box{};
  IfReal tolerance{};
  IfRange tolerance_f{}, tolerance_delta{};
  IfCount arrival{};
  Name name{};

  using Now = BoxedDamper;
  static constexpr auto field_table = std::tuple_cat(
      std::tuple{Field{"name", &Now::name, "of the part; null without a catalogue", any_number}},
      fields<design::SuiteDamper>,
      std::tuple{Field{"tolerance", &Now::tolerance,
                       "the largest of f and delta at once that was found to hold; null if not "
                       "searched"},
                 Field{"tolerance_f", &Now::tolerance_f,
                       "the factors that it allows together, like the next; null if not asked for"},
                 Field{"tolerance_delta", &Now::tolerance_delta},
                 Field{"arrival", &Now::arrival,
                       "at which it stops the mass; null for a rest off centre, with a given point "
                       "under a pulse and under records",
                       at_least_one},
                 Field{"box", &Now::box, "the dampers that keep every requirement"}});
};

/// The damper of a box, and the motion, that have the worst of a figure.
struct WorstAt : design::SuiteDamper {
  Name motion{};

  static constexpr auto field_table = std::tuple_cat(
      std::tuple{Field{"motion", &WorstAt::motion, "null of several records", any_number}},
      fields<design::SuiteDamper>);
};
struct WorstInBox : Worst {
  OfFigures<WorstAt> of{};

  static constexpr auto field_table = std::tuple_cat(
      fields<Worst>, std::tuple{Field{"of", &WorstInBox::of,
                                      "for each figure the damper of the box and the motion"}});
};

/// A motion under a load.
struct ShownLoaded {
  std::string what;
  IfReal v0{}, p{}, k{}, lambda{}, scale{}, pga{};
  std::optional<bool> from_inside{};
  ShownResponse response;
  std::optional<TwinsSi> physical{};

  using Now = ShownLoaded;
  static constexpr std::tuple field_table{
      Field{"what", &Now::what, "hit, the shape of the pulse, or the file of the record"},
      Field{"v0", &Now::v0, "of a hit"},
      Field{"p", &Now::p},
      Field{"k", &Now::k, "of a pulse, like lambda"},
      Field{"lambda", &Now::lambda},
      Field{"scale", &Now::scale, "the factor on the values of a record", any_number},
      Field{"pga", &Now::pga, "the largest |W| of a record in g, with that factor"},
      Field{"from_inside", &Now::from_inside,
            "of a notch as built: whether it acts from the start; else null"},
      Field{"response", &Now::response},
      Field{"physical", &Now::physical, "the response in SI units"}};
};

struct ShownLoad {
  std::string_view type;
  std::optional<std::size_t> records{};

  static constexpr std::tuple field_table{Field{"type", &ShownLoad::type, "", one_of(load_types)},
                                          Field{"records", &ShownLoad::records, "how many"}};
};
struct ShownCase {
  Name name{};
  ShownLoad load;
  std::optional<design::Combine> combine{};
  std::optional<Worst> nominal{};
  std::optional<WorstInBox> worst{};
  std::vector<ShownLoaded> motions{};

  using Now = ShownCase;
  static constexpr std::tuple field_table{
      Field{"name", &Now::name},
      Field{"load", &Now::load},
      Field{"combine", &Now::combine, "of several records"},
      Field{"nominal", &Now::nominal,
            "the largest for the damper itself, combined as asked; null but of records and of "
            "the ranges of a pulse"},
      Field{"worst", &Now::worst,
            "the same over the box that was required; null without a damper and of a figure that "
            "is not known"},
      Field{"motions", &Now::motions, "of the damper itself"}};
};

/// The intervals of v0, or of the k of a pulse.
constexpr auto served_hits(bool of_pulse) {
  return [of_pulse](const auto& now) {
    return now.of_pulse == of_pulse ? std::optional(now.hit) : std::nullopt;
  };
}
struct ShownServed : design::WorksFor {
  bool of_pulse{false};

  static constexpr std::tuple field_table{
      Field{"v0", served_hits(false)}, Field{"k", served_hits(true)}, Field{"p", &ShownServed::p}};
};

struct ShownPart : design::RatedPart {
  Name why{};

  using Part = design::Part;
  using Now = ShownPart;
  static constexpr std::tuple field_table{
      Field{"name", in(&Now::part, &Part::name)},
      Field{"f", in(&Now::part, &Part::f)},
      Field{"delta", in(&Now::part, &Part::delta), "", in_metres},
      Field{"admissible", &Now::admissible},
      Field{"tolerance", &Now::tolerance,
            "the largest that the part allows; null if it is not admissible itself"},
      Field{"why", &Now::why, "it is not admissible; null if it is", any_number},
      Field{"violates", [](const auto& now) { return now.violated; }}};
};

struct ShownNotch {
  IfReal friction{};
  bool changes_nothing{false};
  ShownLoaded motion;
  std::optional<ShownLoaded> from_start{}, farthest{}, peak{}, felt{};

  using Now = ShownNotch;
  static constexpr std::tuple field_table{
      Field{"friction", &Now::friction, "inside, f + delta/width; null with a hold"},
      Field{"changes_nothing", &Now::changes_nothing,
            "compared with the same motion with the paper's notch"},
      Field{"motion", &Now::motion},
      Field{"from_start", &Now::from_start,
            "if the notch acts on the way out too; null with a pulse or a hold"},
      Field{"farthest_rest", &Now::farthest,
            "of a grid of the ranges the motion that rests farthest from x = 0; null without "
            "any"},
      Field{"largest_peak", &Now::peak},
      Field{"largest_acceleration", &Now::felt, "the notch included"}};
};

struct ShownAnswer;
[[nodiscard]] std::optional<AnswerSi> physical_of(const ShownAnswer& now);

struct ShownAnswer {
  const Physical& units;
  std::span<const design::Finding> findings{};
  std::string verdict{};
  AskedTask input{};
  std::optional<BoxedDamper> design{};
  std::vector<ShownCase> cases{};
  std::vector<design::Constraint> constraints{};
  std::optional<bool> admissible{};
  IfReal delta1_published{}, delta1_exact{}, largest_tolerance{};
  const design::RegionVerdict* region{nullptr};
  std::optional<std::vector<design::Strip>> strips{};
  std::vector<design::Mend> mends{};
  const design::SuitePoint* nearest{nullptr};
  std::optional<ShownServed> works_for{};
  std::optional<std::vector<design::Hits>> hits{};
  std::optional<design::Practice> practice{}, practice_worst{};
  const design::PulseCheck* pulse{nullptr};
  std::optional<ShownNotch> built_notch{};
  std::optional<std::vector<ShownPart>> catalogue{};
  std::optional<std::vector<design::TradeOff>> trade_off{};
  std::optional<design::SuiteOutlook> outlook{};
  const design::SearchRecord* search{nullptr};
  const design::CrossCheck* cross_check{nullptr};
  /// For `physical` alone: the duration of a pulse, and the width of the worst of ranges.
  IfReal velocity_m_per_s{}, duration{}, notch_width_min{};

  using Now = ShownAnswer;
  static constexpr std::tuple field_table{
      Field{"verdict", &Now::verdict, "the answer, in a sentence or two"},
      Field{"findings",
            [](const auto& now) {
              return ShownFindings{now.findings, now.units};
            }},
      Field{"input", &Now::input},
      Field{"design", &Now::design, "or the given damper; null without one"},
      Field{"cases", &Now::cases},
      Field{"constraints", &Now::constraints},
      Field{"admissible", &Now::admissible, "of a given damper; null without one"},
      Field{"delta1_published", &Now::delta1_published, "at the f of the damper"},
      Field{"delta1_exact", &Now::delta1_exact,
            "null if the motion does not return, for a hit with f > f3"},
      Field{"region", &Now::region, "null under records"},
      Field{"strips", &Now::strips,
            "of a region, one for each arrival up to input.arrivals at which some damper can "
            "stop; else null"},
      Field{"largest_tolerance", &Now::largest_tolerance,
            "without a design: the largest tolerance of any damper, if that is less than asked "
            "for; after a hit only if no single input makes it feasible"},
      Field{"mends", &Now::mends,
            "an input and the nearest value that, alone, would leave an admissible damper"},
      Field{"nearest", &Now::nearest,
            "under records without a design: the damper that violates the limits least"},
      Field{"works_for", &Now::works_for,
            "around the given v0, or k of a pulse, and p, each with the other as given: where "
            "the point itself meets every requirement, both ends included"},
      Field{"hits", &Now::hits, "how the motion ends, for every v0 from 0 to twice the given one"},
      Field{"practice", &Now::practice},
      Field{"practice_worst", &Now::practice_worst,
            "each figure at the end of the ranges where it is worst; null without ranges and "
            "with a pulse"},
      Field{"pulse", &Now::pulse, "null without a pulse"},
      Field{"built_notch", &Now::built_notch,
            "the motion of the design with the notch that will be built; null without "
            "--notch-width"},
      Field{"catalogue", &Now::catalogue, "every part, best first; null without a catalogue"},
      Field{"trade_off", &Now::trade_off, "along the front; null if not asked for"},
      Field{"outlook", &Now::outlook,
            "what is not required of records: the worst where the period, or the scale of all, "
            "is off as well"},
      Field{"search", &Now::search, "null with a catalogue and for a region"},
      Field{"cross_check", &Now::cross_check},
      Field{"physical", [](const auto& now) { return physical_of(now); },
            "in the units at the ends of the names; null with dimensionless input"}};
};

/// Of a hit or a pulse; without its answer.
[[nodiscard]] ShownAnswer asked(const ShownTask& task, const design::RegionVerdict& region,
                                std::span<const design::Finding> findings);
/// In which the damper keeps every requirement, as its corners prove, or a scan of a pulse's
/// ranges.
[[nodiscard]] BoxedDamper boxed_damper(const ShownTask& task, double f, double delta);
[[nodiscard]] std::optional<TwinsSi> twins_of(const Physical& physical,
                                              const ShownResponse& response);
/// What the hit or pulse of a motion is.
[[nodiscard]] ShownLoaded loaded(const ShownTask& task, double v0,
                                 const std::optional<design::Pulse>& pulse, double p,
                                 const ShownResponse& response);
/// Over the box that was asked for, as far as it is known from the motion of the damper itself, or
/// from the `worst` of ranges.
void add_worst(ShownCase& now, const ShownTask& task, const BoxedDamper& damper,
               const std::optional<design::PulseWorst>& worst);
void add_catalogue(ShownAnswer& answer, const std::optional<Catalogue>& catalogue,
                   const ShownTask& task);

[[nodiscard]] ShownAnswer shown(const DesignReport& report);
[[nodiscard]] ShownAnswer shown(const RegionReport& report);
[[nodiscard]] ShownAnswer shown(const RecordDesignReport& report);

/// The factors of one side of a tolerance box; empty if the box has the usual shape.
[[nodiscard]] IfRange side_of(const design::BoxShape& shape, double tolerance, double below,
                              double above);

template <>
inline constexpr std::string_view shared_name<ShownLoaded> = "motion";
template <>
inline constexpr std::string_view shared_name<design::SuiteDamper> = "damper";
template <>
inline constexpr std::string_view shared_name<WorstAt> = "worst_damper";
template <>
inline constexpr std::string_view shared_name<Worst> = "figures";
template <>
inline constexpr std::string_view shared_name<design::Constraint> = "constraint";
template <>
inline constexpr std::string_view shared_name<design::Practice> = "practice";

}  // namespace stillpoint::report
