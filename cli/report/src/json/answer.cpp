// SPDX-License-Identifier: MIT
// The fields of a design and of a region.

#include "json/answer_fields.hpp"
#include "json/schema.hpp"

#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/schemas.hpp>

#include <array>
#include <functional>
#include <numbers>
#include <tuple>

namespace stillpoint::report {

double turn(double p) {
  return 2 * std::numbers::pi / p;
}

IfReal ShownConstraint::length(const IfReal& of) const {
  return variable == "delta" || variable == "peak" || variable == "residual" ? of : std::nullopt;
}

namespace {

constexpr auto design_names = std::to_array<std::string_view>({"stillpoint/design-report/2"});
constexpr auto region_names = std::to_array<std::string_view>({"stillpoint/region-report/2"});
constexpr auto objectives =
    std::to_array<std::string_view>({"robust", "amplitude", "time", "acceleration", "residual"});
constexpr auto pulse_names =
    std::to_array<std::string_view>({"half-sine", "full-sine", "rectangle"});
constexpr auto load_types =
    std::to_array<std::string_view>({"hit", "half-sine", "full-sine", "rectangle", "records"});
constexpr auto relations = std::to_array<std::string_view>({"<", "<=", ">=", ">"});
constexpr auto constrained = std::to_array<std::string_view>(
    {"f", "delta", "v0", "peak", "acceleration", "residual", "jump"});
constexpr auto constraint_names =
    std::to_array<std::string_view>({"dead_zone", "start", "amplitude", "return", "residual",
                                     "stop", "f_max", "delta_max", "acceleration", "jump"});
constexpr auto conflict_names =
    std::to_array<std::string_view>({"amplitude", "return", "dead_zone", "f_max", "stop", "start",
                                     "delta_max", "acceleration", "arrivals", "rounding"});
constexpr auto region_origins = std::to_array<std::string_view>({"reduction", "forced_motion"});
constexpr auto libraries = std::to_array<std::string_view>({"NLopt", "stillpoint"});
constexpr auto check_methods =
    std::to_array<std::string_view>({"half_cycle_map", "runge_kutta", "forced_pulse"});

constexpr Measure at_least_one{Numbers::from_one};
/// With the value in SI units beside it, or in its place.
constexpr Measure with_si(Dimension dimension, std::string_view name = {},
                          InSi place = InSi::beside, Numbers numbers = {}) {
  return {numbers, dimension, name, {}, place};
}
constexpr Measure metres = with_si(Dimension::length);
constexpr Measure metres_alone = with_si(Dimension::length, {}, InSi::alone, Numbers::all);
constexpr Measure seconds_alone = with_si(Dimension::time, {}, InSi::alone);

/// The constraints and limits that conflict, by name; empty where none do.
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

/// Empty where a motion never rests.
std::optional<Worst> settled(const design::SuiteFigures& figures) {
  return figures.settled
             ? std::optional(
                   Worst{figures.peak, figures.acceleration, figures.residual, {}, figures.jump})
             : std::nullopt;
}

/// The intervals of v0, or of the k of a pulse.
constexpr auto served_hits(bool of_pulse) {
  return [of_pulse](const ShownServed& now) {
    return now.of_pulse == of_pulse ? std::optional(now.hit) : std::nullopt;
  };
}

constexpr auto of_part(const auto& get) {
  return [get](const ShownPart& now) { return std::invoke(get, now.rated); };
}

/// A length of a constraint, in metres.
constexpr auto length_of(const auto& get) {
  return [get](const ShownConstraint& now) { return now.length(std::invoke(get, now)); };
}

}  // namespace

template <>
inline constexpr std::string_view shared_name<ShownLoaded> = "motion";
template <>
inline constexpr std::string_view shared_name<design::SuiteDamper> = "damper";
template <>
inline constexpr std::string_view shared_name<WorstAt> = "worst_damper";
template <>
inline constexpr std::string_view shared_name<Worst> = "figures";
template <>
inline constexpr std::string_view shared_name<ShownConstraint> = "constraint";
template <>
inline constexpr std::string_view shared_name<ShownPractice> = "practice";

}  // namespace stillpoint::report

namespace stillpoint {

template <>
inline constexpr auto fields<report::AskedTask> = [] {
  using Now = report::AskedTask;
  using design::Limits;
  return std::tuple{
      Field{"v0", &Now::v0,
            "of the motion shown; with a pulse, the velocity of its reduction in a design, else "
            "null",
            report::any_number},
      Field{"v0_range", &Now::v0_range},
      Field{"p", &Now::p, "null under records, like criterion and arrivals"},
      Field{"p_range", &Now::p_range},
      Field{"beta", &Now::beta},
      Field{"criterion", &Now::criterion},
      Field{"arrivals", &Now::arrivals, "", report::at_least_one},
      Field{"residual", &Now::residual, "", report::metres},
      Field{"tolerance", &Now::tolerance},
      Field{"tolerance_f", &Now::tolerance_f, "factors between which f may lie, like the next"},
      Field{"tolerance_delta", &Now::tolerance_delta},
      Field{"tolerance_width", &Now::tolerance_width},
      Field{"tolerance_period", &Now::tolerance_period},
      Field{"f_max", in(&Now::limits, &Limits::f_max)},
      Field{"delta_max", in(&Now::limits, &Limits::delta_max)},
      Field{"acceleration_max", in(&Now::limits, &Limits::acceleration_max)},
      Field{"jump_max", &Now::jump_max, "", report::with_si(Dimension::velocity)},
      Field{"pulse", &Now::pulse, "", {.texts = report::pulse_names}},
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
      Field{"notch_width", &Now::notch_width, "if it is given", report::metres},
      Field{"objective", &Now::objective, "null for a region", {.texts = report::objectives}},
      Field{"algorithm", &Now::algorithm, "as given; null if the program chooses"},
      Field{"catalogue", &Now::catalogue, "the file"},
      Field{"trade_off", &Now::trade_off, "how many"}};
}();

template <>
inline constexpr auto fields<design::SuiteDamper> = [] {
  using Now = design::SuiteDamper;
  return std::tuple{
      Field{"f", &Now::f}, Field{"delta", &Now::delta, "", report::metres},
      Field{"p", &Now::p, "of a range the softest spring"},
      Field{"period_s", [](const Now& now) { return report::turn(now.p); }, "without friction",
            report::seconds_alone},
      Field{"notch_width",
            [](const Now& now) { return now.width > 0 ? std::optional(now.width) : std::nullopt; },
            "null without a width", report::metres}};
}();

template <>
inline constexpr auto fields<report::ShownBox> = [] {
  using Now = report::ShownBox;
  return std::tuple{
      Field{"f", &Now::f, "null: exact, like the next"},
      Field{"delta", &Now::delta, "", report::metres},
      Field{"p", &Now::p},
      Field{"period_s", &Now::period, "", report::seconds_alone},
      Field{"notch_width", &Now::width, "", report::metres},
      Field{"samples", &Now::samples, "how many of its dampers were tried; null if proved"},
      Field{"exact", &Now::exact, "whether it is proved of all its dampers"}};
}();

template <>
inline constexpr auto fields<report::BoxedDamper> = [] {
  using Now = report::BoxedDamper;
  return std::tuple_cat(
      std::tuple{
          Field{"name", &Now::name, "of the part; null without a catalogue", {Numbers::all}}},
      fields<design::SuiteDamper>,
      std::tuple{
          Field{"tolerance", &Now::tolerance,
                "the largest of f and delta at once that was found to hold; null if not searched"},
          Field{"tolerance_f", &Now::tolerance_f,
                "the factors that it allows together, like the next; null if not asked for"},
          Field{"tolerance_delta", &Now::tolerance_delta},
          Field{"arrival", &Now::arrival,
                "at which it stops the mass; null for a rest off centre, with a given point under "
                "a pulse and under records",
                report::at_least_one},
          Field{"box", &Now::box, "the dampers that keep every requirement"}});
}();

template <>
inline constexpr auto fields<report::WorstAt> = std::tuple_cat(
    std::tuple{
        Field{"motion", &report::WorstAt::motion, "null of several records", {Numbers::all}}},
    fields<design::SuiteDamper>);

template <>
inline constexpr auto fields<report::WorstOf> = [] {
  using Now = report::WorstOf;
  return std::tuple{Field{"peak_amplitude", &Now::peak},
                    Field{"peak_absolute_acceleration", &Now::acceleration},
                    Field{"residual", &Now::residual}, Field{"stop_time", &Now::stop_time},
                    Field{"jump", &Now::jump}};
}();

template <>
inline constexpr auto fields<report::Worst> = [] {
  using Now = report::Worst;
  return std::tuple{
      Field{"peak_amplitude", &Now::peak, "", report::with_si(Dimension::length, "peak_m")},
      Field{"peak_absolute_acceleration", &Now::acceleration},
      Field{"residual", &Now::residual, "", report::metres},
      Field{"stop_time", &Now::stop_time, "", report::with_si(Dimension::time)},
      Field{"jump", &Now::jump, "of the velocity at a notch without a width",
            report::with_si(Dimension::velocity)}};
}();

template <>
inline constexpr auto fields<report::WorstInBox> =
    std::tuple_cat(fields<report::Worst>,
                   std::tuple{Field{"of", &report::WorstInBox::of,
                                    "for each figure the damper of the box and the motion"}});

template <>
inline constexpr auto fields<report::ShownLoaded> = [] {
  using Now = report::ShownLoaded;
  return std::tuple{
      Field{"what", &Now::what, "hit, the shape of the pulse, or the file of the record"},
      Field{"v0", &Now::v0, "of a hit"},
      Field{"p", &Now::p},
      Field{"k", &Now::k, "of a pulse, like lambda"},
      Field{"lambda", &Now::lambda},
      Field{"scale", &Now::scale, "the factor on the values of a record", report::any_number},
      Field{"pga", &Now::pga, "the largest |W| of a record in g, with that factor"},
      Field{"from_inside", &Now::from_inside,
            "of a notch as built: whether it acts from the start; else null"},
      Field{"response", &Now::response},
      Field{"physical", &Now::physical, "the response in SI units"}};
}();

template <>
inline constexpr auto fields<report::ShownLoad> =
    std::tuple{Field{"type", &report::ShownLoad::type, "", {.texts = report::load_types}},
               Field{"records", &report::ShownLoad::records, "how many"}};

template <>
inline constexpr auto fields<report::ShownCase> = [] {
  using Now = report::ShownCase;
  return std::tuple{
      Field{"name", &Now::name},
      Field{"load", &Now::load},
      Field{"combine", &Now::combine, "of several records"},
      Field{"nominal", &Now::nominal,
            "the largest for the damper itself, combined as asked; null but of records and of the "
            "ranges of a pulse"},
      Field{"worst", &Now::worst,
            "the same over the box that was required; null without a damper and of a figure that "
            "is not known"},
      Field{"motions", &Now::motions, "of the damper itself"}};
}();

template <>
inline constexpr auto fields<report::ShownConstraint> = [] {
  using Now = report::ShownConstraint;
  return std::tuple{
      Field{"case", &Now::of_case},
      Field{"name", &Now::name, "", {.texts = report::constraint_names}},
      Field{"variable", &Now::variable, "what is bounded", {.texts = report::constrained}},
      Field{"relation", &Now::relation, "", {.texts = report::relations}},
      Field{"value", &Now::value, "null where a motion never rests, like slack",
            report::any_number},
      Field{"value_m", report::length_of(&Now::value), "of a length", report::metres_alone},
      Field{"limit", &Now::limit, "", report::any_number},
      Field{"limit_m", report::length_of(&Now::limit), "", report::metres_alone},
      Field{"slack", &Now::slack, "", report::any_number},
      Field{"satisfied", &Now::satisfied},
      Field{"motion",
            &Now::motion,
            "without a design, the record under which the value is largest",
            {Numbers::all}}};
}();

template <>
inline constexpr auto fields<report::ShownMend> = std::tuple{
    Field{"case", &report::ShownMend::of_case}, Field{"input", &report::ShownMend::input},
    Field{"value", &report::ShownMend::value, "", report::any_number}};

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
            {.texts = report::region_origins}},
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
inline constexpr auto fields<report::Nearest> =
    std::tuple{Field{"design", &report::Nearest::damper},
               Field{"worst", &report::Nearest::worst, "null where a motion never rests"}};

template <>
inline constexpr auto fields<report::ShownServed> =
    std::tuple{Field{"v0", report::served_hits(false)}, Field{"k", report::served_hits(true)},
               Field{"p", &report::ShownServed::p}};

template <>
inline constexpr auto fields<design::Hits> =
    std::tuple{Field{"from", &design::Hits::from}, Field{"to", &design::Hits::to},
               Field{"ends", &design::Hits::end},
               Field{"arrivals", &design::Hits::arrivals, "", {Numbers::counts}},
               Field{"rest", &design::Hits::rest, "off centre, the farthest", report::any_number}};

template <>
inline constexpr auto fields<design::PulseCheck> = [] {
  using Now = design::PulseCheck;
  return std::tuple{Field{"shortness", &Now::shortness, "p/lambda"},
                    Field{"friction_ratio", &Now::friction_ratio, "f/k"},
                    Field{"equivalent_v0", report::IfAny{&Now::start, &EquivalentStart::speed}, "",
                          report::any_number},
                    Field{"equivalent_start", report::IfAny{&Now::start, &EquivalentStart::tau}, "",
                          report::any_number},
                    Field{"peak_error", &Now::peak_error, "", report::any_number},
                    Field{"stop_time_error", &Now::stop_time_error, "", report::any_number},
                    Field{"warnings", &Now::warnings}};
}();

template <>
inline constexpr auto fields<report::ShownNotch> = [] {
  using Now = report::ShownNotch;
  return std::tuple{
      Field{"friction", &Now::friction, "inside, f + delta/width; null with a hold"},
      Field{"changes_nothing", &Now::changes_nothing,
            "compared with the same motion with the paper's notch"},
      Field{"motion", &Now::motion},
      Field{"from_start", &Now::from_start,
            "if the notch acts on the way out too; null with a pulse or a hold"},
      Field{"farthest_rest", &Now::farthest,
            "of a grid of the ranges the motion that rests farthest from x = 0; null without any"},
      Field{"largest_peak", &Now::peak},
      Field{"largest_acceleration", &Now::felt, "the notch included"}};
}();

template <>
inline constexpr auto fields<report::ShownPart> = [] {
  using design::Part;
  using design::RatedPart;
  using Now = report::ShownPart;
  using report::of_part;
  return std::tuple{Field{"name", of_part(in(&RatedPart::part, &Part::name))},
                    Field{"f", of_part(in(&RatedPart::part, &Part::f))},
                    Field{"delta", of_part(in(&RatedPart::part, &Part::delta)), "", report::metres},
                    Field{"admissible", of_part(&RatedPart::admissible)},
                    Field{"tolerance", of_part(&RatedPart::tolerance),
                          "the largest that the part allows; null if it is not admissible itself"},
                    Field{"why",
                          [](const Now& now) {
                            return now.rated.admissible
                                       ? std::nullopt
                                       : std::optional(report::judgement(now.rated, now.task));
                          },
                          "it is not admissible; null if it is",
                          {Numbers::all}},
                    Field{"violates", [](const Now& now) {
                            return report::shown_constraints(now.rated.violated);
                          }}};
}();

template <>
inline constexpr auto fields<design::TradeOff> = [] {
  using design::DesignPoint;
  using Now = design::TradeOff;
  return std::tuple{Field{"f", in(&Now::damper, &DesignPoint::f)},
                    Field{"delta", in(&Now::damper, &DesignPoint::delta), "", report::metres},
                    Field{"tolerance", in(&Now::damper, &DesignPoint::tolerance)},
                    Field{"peak_amplitude", &Now::peak_amplitude, "",
                          report::with_si(Dimension::length, "peak_m")},
                    Field{"peak_absolute_acceleration", &Now::peak_absolute_acceleration},
                    Field{"stop_time", &Now::stop_time, "", report::with_si(Dimension::time)}};
}();

template <>
inline constexpr auto fields<design::SuiteOutlook> = [] {
  using Now = design::SuiteOutlook;
  return std::tuple{Field{"off", [](const Now&) { return Now::off; }},
                    Field{"period", [](const Now& now) { return report::settled(now.period); }},
                    Field{"scale", [](const Now& now) { return report::settled(now.scale); }}};
}();

template <>
inline constexpr auto fields<report::Scan> = std::tuple{
    Field{"points", &report::Scan::points, "boxes"}, Field{"feasible", &report::Scan::feasible}};

template <>
inline constexpr auto fields<report::ShownSearch> = [] {
  using report::Optimum;
  using Now = report::ShownSearch;
  return std::tuple{
      Field{"library", &Now::library, "", {.texts = report::libraries}},
      Field{"library_version", &Now::version},
      Field{"algorithm", &Now::algorithm},
      Field{"status", &Now::status, "NLopt's; under records SUCCESS or INTERRUPTED"},
      Field{"evaluations", &Now::evaluations},
      Field{"wall_time_s", &Now::wall_time_s},
      Field{"optimum", in(&Now::optimum, &Optimum::found),
            "the objective's value of the design; with a pulse, of NLopt's best point",
            report::any_number},
      Field{"optimum_along_f", in(&Now::optimum, &Optimum::along_f),
            "that of the best damper along f alone, found without NLopt", report::any_number},
      Field{"scan", &Now::scan, "null without records"},
      Field{"interrupted", &Now::interrupted, "by the user: the design is the best so far"}};
}();

template <>
inline constexpr auto fields<design::SuiteCheckRow> = [] {
  using Now = design::SuiteCheckRow;
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
                    Field{"half_cycles", &Now::half_cycles, "", {Numbers::counts}},
                    Field{"stop_position", &Now::stop_position, "", report::any_number}};
}();

template <>
inline constexpr auto fields<report::ShownCheckMethod> = [] {
  using Now = report::ShownCheckMethod;
  return std::tuple_cat(std::tuple{Field{"name", &Now::name, "", {.texts = report::check_methods}},
                                   Field{"tolerance", &Now::tolerance}},
                        report::fields_if_any(&Now::figures, fields<design::MotionFigures>),
                        std::tuple{Field{"relative_error", &Now::relative_error},
                                   Field{"wall_time_s", &Now::wall_time_s},
                                   Field{"decided", &Now::decided}, Field{"passed", &Now::passed},
                                   Field{"motions", &Now::motions,
                                         "under each record, in place of the figures; else null"}});
}();

template <>
inline constexpr auto fields<report::ShownCheck> = std::tuple{
    Field{"passed", &report::ShownCheck::passed}, Field{"methods", &report::ShownCheck::methods}};

template <>
inline constexpr auto fields<report::ShownAnswer> = [] {
  using Now = report::ShownAnswer;
  return std::tuple{
      Field{"verdict", &Now::verdict, "the answer, in a sentence or two"},
      Field{"findings",
            [](const Now& now) {
              return report::ShownFindings{now.findings, now.units};
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
            "of a region, one for each arrival up to input.arrivals at which some damper can stop; "
            "else null"},
      Field{"largest_tolerance", &Now::largest_tolerance,
            "without a design: the largest tolerance of any damper, if that is less than asked "
            "for; after a hit only if no single input makes it feasible"},
      Field{"mends", &Now::mends,
            "an input and the nearest value that, alone, would leave an admissible damper"},
      Field{"nearest", &Now::nearest,
            "under records without a design: the damper that violates the limits least"},
      Field{"works_for", &Now::works_for,
            "around the given v0, or k of a pulse, and p, each with the other as given: where the "
            "point itself meets every requirement, both ends included"},
      Field{"hits", &Now::hits, "how the motion ends, for every v0 from 0 to twice the given one"},
      Field{"practice", &Now::practice},
      Field{"practice_worst", &Now::practice_worst,
            "each figure at the end of the ranges where it is worst; null without ranges and with "
            "a pulse"},
      Field{"pulse", &Now::pulse, "null without a pulse"},
      Field{"built_notch", &Now::built_notch,
            "the motion of the design with the notch that will be built; null without "
            "--notch-width"},
      Field{"catalogue", &Now::catalogue, "every part, best first; null without a catalogue"},
      Field{"trade_off", &Now::trade_off, "along the front; null if not asked for"},
      Field{"outlook", &Now::outlook,
            "what is not required of records: the worst where the period, or the scale of all, is "
            "off as well"},
      Field{"search", &Now::search, "null with a catalogue and for a region"},
      Field{"cross_check", &Now::cross_check},
      Field{"physical", &Now::physical,
            "in the units at the ends of the names; null with dimensionless input"}};
}();

template <>
inline constexpr auto fields<report::DesignAnswer> = std::tuple_cat(
    report::head_fields<report::DesignAnswer, report::design_names>, fields<report::ShownAnswer>);
template <>
inline constexpr auto fields<report::RegionAnswer> = std::tuple_cat(
    report::head_fields<report::RegionAnswer, report::region_names>, fields<report::ShownAnswer>);

}  // namespace stillpoint

namespace stillpoint::report {

namespace {

/// The table of both is the same but for its head, so it is printed by the same code.
nlohmann::ordered_json answer_json(std::string_view schema, const ShownAnswer& answer) {
  nlohmann::ordered_json json{{"schema", schema}, {"program", object_json(Program())}};
  json.update(object_json(answer, scales_of(answer.units)));
  return json;
}

}  // namespace

nlohmann::ordered_json json(const DesignReport& report) {
  return answer_json(design_names.front(), shown(report));
}

nlohmann::ordered_json json(const RecordDesignReport& report) {
  return answer_json(design_names.front(), shown(report));
}

nlohmann::ordered_json json(const RegionReport& report) {
  return answer_json(region_names.front(), shown(report));
}

nlohmann::ordered_json design_schema() {
  return document_schema(design_names.front(), "design --json", dimensionless_numbers,
                         schema_of<DesignAnswer>());
}

nlohmann::ordered_json region_schema() {
  return document_schema(region_names.front(), "region --json", dimensionless_numbers,
                         schema_of<RegionAnswer>());
}

}  // namespace stillpoint::report
