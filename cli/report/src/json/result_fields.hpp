// SPDX-License-Identifier: MIT
#pragma once

// The tables of fields of what a design or a region finds.

#include "json/motion_fields.hpp"

#include <stillpoint/design/duty.hpp>
#include <stillpoint/design/hits.hpp>
#include <stillpoint/design/record_design_result.hpp>
#include <stillpoint/report/page_frame.hpp>

namespace stillpoint::report {

inline constexpr auto relations = std::to_array<std::string_view>({"<", "<=", ">=", ">"});
inline constexpr auto constrained = std::to_array<std::string_view>(
    {"f", "delta", "v0", "peak", "acceleration", "residual", "jump", "passages"});
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

/// Null of the only case.
[[nodiscard]] inline Name case_name(const std::string& load_case) {
  return load_case.empty() ? Name() : Name(load_case);
}

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
      Field{transmitted_name, &OfFigures::acceleration},
      Field{"residual", &OfFigures::residual, "", in_si<Value>(Dimension::length)},
      Field{"stop_time", &OfFigures::stop_time, "", in_si<Value>(Dimension::time)},
      Field{"jump", &OfFigures::jump, numbers ? "of the velocity at a notch without a width" : "",
            in_si<Value>(Dimension::velocity)}};
};
using Worst = OfFigures<double>;
/// Of a motion or of a suite.
[[nodiscard]] Worst worst_of(const auto& of) {
  Worst worst{of.peak, of.acceleration, of.residual, {}, of.jump};
  if constexpr (requires { of.stop_time; }) {
    worst.stop_time = of.stop_time;
  }
  return worst;
}
/// Empty where a motion never rests.
[[nodiscard]] std::optional<Worst> settled(const design::TaskFigures& figures);

}  // namespace stillpoint::report

namespace stillpoint {

template <>
inline constexpr auto fields<design::SuiteDamper> = std::tuple{
    Field{"f", &design::SuiteDamper::f}, Field{"delta", &design::SuiteDamper::delta, "", in_metres},
    Field{"p", &design::SuiteDamper::p, "of a range the softest spring"},
    Field{"period_s", [](const design::SuiteDamper& now) { return turn(now.p); },
          "without friction", si_alone(Dimension::time)},
    Field{"notch_width", &design::SuiteDamper::notch_width, "null without a width", in_metres}};

template <>
inline constexpr auto fields<design::Duty> = [] {
  using Now = design::Duty;
  using Cycle = design::FullCycle;
  const auto most = [](auto part) { return in(&Now::most, part); };
  const auto cycle = [](auto part) { return in(&Now::cycle, part); };
  constexpr Measure in_joules = with_si(Dimension::energy);
  return std::tuple{
      Field{"motion", &Now::motion, "of several, the one that moves the mass farthest", any_number},
      Field{"stroke", &Now::stroke, "of several records combined as asked", in_metres},
      Field{"stroke_worst", &Now::stroke_worst,
            "of the dampers within the tolerance that was asked for or, without one, within the "
            "largest; null if there is none",
            in_metres},
      Field{"peak_velocity", &Now::peak_velocity, "of any motion, like the next four",
            with_si(Dimension::velocity)},
      Field{"slip_path", most(&Energies::slip_path), "", in_metres},
      Field{"friction_energy", most(&Energies::friction), "", in_joules},
      Field{"notch_energy", most(&Energies::notch), "", in_joules},
      Field{"damping_energy", most(&Energies::damping), "", in_joules},
      Field{"secant_stiffness", cycle(&Cycle::secant_stiffness),
            "at the stroke (theory.md section 11); null, like the next two, if nothing moves"},
      Field{"equivalent_damping", cycle(&Cycle::equivalent_damping),
            "of a full cycle between plus and minus the stroke; null above 1"},
      Field{"cycle_energy", cycle(&Cycle::energy), "what that cycle takes", in_joules}};
}();

template <>
inline constexpr auto fields<design::DesignPoint> =
    std::tuple{Field{"tolerance", &design::DesignPoint::tolerance},
               Field{"f", &design::DesignPoint::f}, Field{"delta", &design::DesignPoint::delta}};

template <>
inline constexpr auto fields<design::Strip> =
    std::tuple{Field{"arrival", &design::Strip::arrival,
                     "0 where any rest, or the first peak, is within the residual"},
               Field{"beta_min", &design::Strip::beta_min},
               Field{"f_lower", &design::Strip::f_lower,
                     "with f_upper null if no damper has the tolerance asked for"},
               Field{"f_upper", &design::Strip::f_upper},
               Field{"tolerance", &design::Strip::tolerance,
                     "the largest of any damper that stops at this arrival"}};

template <>
inline constexpr auto fields<design::WorksFor> = [] {
  using Now = design::WorksFor;
  using Load = design::ServedLoad;
  constexpr auto of_load = [](Load which) {
    return only_if([which](const auto& now) { return now.load == which; }, &Now::hit);
  };
  return std::tuple{
      Field{"v0", of_load(Load::v0)}, Field{"k", of_load(Load::k), "of a pulse"},
      Field{"scale", of_load(Load::scale), "of records, and of all loads of several cases"},
      Field{"p", &Now::p}};
}();

template <>
inline constexpr auto fields<design::FeasibleDelta> =
    std::tuple{Field{"f", &design::FeasibleDelta::f},
               Field{"delta", &design::FeasibleDelta::delta, "", in_metres}};

template <>
inline constexpr auto fields<design::RegionVerdict> = [] {
  using design::Region;
  using Now = design::RegionVerdict;
  return std::tuple{
      Field{"feasible", in(&Now::region, &Region::feasible)},
      Field{"reason", &Now::reason, "why it is empty; else null"},
      Field{"conflict",
            in(&Now::region, &design::conflicting),
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
            only_if(&Now::intervals, [](const Now&) { return report::region_origins.back(); }),
            "how the region of a pulse was found; null without a pulse",
            one_of(report::region_origins)},
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
inline constexpr auto fields<design::Hits> = std::tuple{
    Field{"from", &design::Hits::from, "", si_apart(Dimension::velocity, "from_m_per_s")},
    Field{"to", &design::Hits::to, "", si_apart(Dimension::velocity, "to_m_per_s")},
    Field{"ends", &design::Hits::end}, Field{"arrivals", &design::Hits::arrivals, "", counted},
    Field{"rest", &design::Hits::rest, "off centre, the farthest",
          si_apart(Dimension::length, "rest_m", Numbers::all)}};

template <>
inline constexpr auto fields<design::PulseCheck> = [] {
  using Now = design::PulseCheck;
  return std::tuple{
      Field{"shortness", &Now::shortness, "p/lambda"},
      Field{"friction_ratio", &Now::friction_ratio, "f/k"},
      Field{"equivalent_v0", in(&Now::start, &EquivalentStart::speed), "", any_number},
      Field{"equivalent_start", in(&Now::start, &EquivalentStart::tau), "", any_number},
      Field{"peak_error", &Now::peak_error, "", any_number},
      Field{"stop_time_error", &Now::stop_time_error, "", any_number},
      Field{"warnings", &Now::warnings}};
}();

template <>
inline constexpr auto fields<design::SuitePoint> = std::tuple{
    Field{"design", &design::SuitePoint::damper},
    Field{"worst", [](const design::SuitePoint& now) { return report::settled(now.figures); },
          "of all cases; null where a motion never rests"}};

template <>
inline constexpr auto fields<design::SuiteOutlook> = std::tuple{
    Field{"off", [](const design::SuiteOutlook&) { return design::SuiteOutlook::off; }},
    Field{"period", [](const design::SuiteOutlook& now) { return report::settled(now.period); }},
    Field{"scale", [](const design::SuiteOutlook& now) { return report::settled(now.scale); }}};

template <>
inline constexpr auto fields<design::CheckedMotion> =
    std::tuple{Field{"peak_amplitude", &design::CheckedMotion::peak},
               Field{transmitted_name, &design::CheckedMotion::acceleration},
               Field{"residual", &design::CheckedMotion::residual},
               Field{"relative_error", &design::CheckedMotion::relative_error}};

template <>
inline constexpr auto fields<design::MotionFigures> =
    std::tuple{Field{"peak_amplitude", &design::MotionFigures::peak_amplitude},
               Field{"peak_acceleration", &design::MotionFigures::peak_acceleration},
               Field{"stop_time", &design::MotionFigures::stop_time},
               Field{"arrival_speed", &design::MotionFigures::arrival_speed},
               Field{"half_cycles", &design::MotionFigures::half_cycles, "", counted},
               Field{"stop_position", &design::MotionFigures::stop_position, "", any_number}};

template <>
inline constexpr auto fields<design::Constraint> = [] {
  using Now = design::Constraint;
  constexpr Measure metres_alone = si_alone(Dimension::length, Numbers::all);
  constexpr auto is_length = [](const Now& now) { return now.dimension() == Dimension::length; };
  return std::tuple{
      Field{"case", [](const Now& now) { return report::case_name(now.in_case); }},
      Field{"name", &Now::name, "", one_of(report::constraint_names)},
      Field{"variable", &Now::variable, "what is bounded", one_of(report::constrained)},
      Field{"relation", &Now::relation, "", one_of(report::relations)},
      Field{"value", only_if(&Now::known, &Now::value),
            "null where a motion never rests, like slack", any_number},
      Field{"value_m", only_if(&Now::known, only_if(is_length, &Now::value)), "of a length",
            metres_alone},
      Field{"limit", &Now::limit, "", any_number},
      Field{"limit_m", only_if(is_length, &Now::limit), "", metres_alone},
      Field{"slack", only_if(&Now::known, &Now::slack), "", any_number},
      Field{"satisfied", &Now::satisfied},
      Field{"motion", in(&Now::motion, &Now::Motion::file),
            "without a design, the record under which the value is largest", any_number}};
}();

template <>
inline constexpr auto fields<design::Mend> = std::tuple{
    Field{"case", [](const design::Mend& now) { return report::case_name(now.in_case); }},
    Field{"input", &design::Mend::field}, Field{"value", &design::Mend::value, "", any_number}};

template <>
inline constexpr auto fields<design::SearchRecord::Scan> =
    std::tuple{Field{"points", &design::SearchRecord::Scan::points, "boxes"},
               Field{"feasible", &design::SearchRecord::Scan::feasible}};

template <>
inline constexpr auto fields<design::SearchRecord> = [] {
  using Now = design::SearchRecord;
  return std::tuple{
      Field{"library", [](const Now& now) { return report::libraries.at(now.scan ? 1 : 0); }, "",
            one_of(report::libraries)},
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
  constexpr auto has_motions = [](const Now& now) { return !now.motions.empty(); };
  constexpr auto figures = [](const Now& now) {
    return now.motions.empty() ? static_cast<const design::MotionFigures*>(&now) : nullptr;
  };
  return std::tuple_cat(std::tuple{Field{"name", &Now::name, "", one_of(report::check_methods)},
                                   Field{"tolerance", &Now::tolerance}},
                        fields_in(figures, fields<design::MotionFigures>),
                        std::tuple{Field{"relative_error", &Now::relative_error},
                                   Field{"wall_time_s", &Now::wall_time_s},
                                   Field{"decided", &Now::decided}, Field{"passed", &Now::passed},
                                   Field{"motions", only_if(has_motions, &Now::motions),
                                         "under each record, in place of the figures; else null"}});
}();

template <>
inline constexpr auto fields<design::CrossCheck> = std::tuple{
    Field{"passed", &design::CrossCheck::passed}, Field{"methods", &design::CrossCheck::methods}};

}  // namespace stillpoint
