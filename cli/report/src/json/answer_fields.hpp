// SPDX-License-Identifier: MIT
#pragma once

// The report of a design or a region, the same of hits, pulses and records, with its tables of
// fields. What an answer does not have is empty.

#include "choices.hpp"
#include "json/asked_fields.hpp"
#include "json/head_fields.hpp"
#include "json/physical_fields.hpp"
#include "json/result_fields.hpp"

#include <stillpoint/report/record_design.hpp>

namespace stillpoint {

template <>
inline constexpr auto fields<report::Traded> = [] {
  using Now = report::Traded;
  return std::tuple_cat(
      fields<design::SuiteDamper>,
      std::tuple{Field{"tolerance", &Now::tolerance, "null where it is the one asked for"},
                 Field{"peak_amplitude", &Now::peak, "", with_si(Dimension::length, "peak_m")},
                 Field{transmitted_name, &Now::transmitted},
                 Field{"residual", &Now::residual, "null after a hit", in_metres},
                 Field{"stop_time", &Now::stop_time, "", with_si(Dimension::time)}});
}();

}  // namespace stillpoint

namespace stillpoint::report {

inline constexpr auto load_types = [] {
  constexpr const auto& pulses = kind_names<design::Pulse>;
  std::array<std::string_view, pulses.size() + 2> types{"hit"};
  std::ranges::copy(pulses, types.begin() + 1);
  types.back() = "records";
  return types;
}();

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
  IfReal part{};
  double zeta{0};

  static constexpr auto field_table = std::tuple_cat(
      std::tuple{Field{"motion", &WorstAt::motion, "of several the one with the most", any_number},
                 Field{"part", &WorstAt::part, "of a load that varies: of its largest v0 or k"},
                 Field{"damping", &WorstAt::zeta, "of a mass whose damping varies", unless(0)}},
      fields<design::SuiteDamper>);
};
struct WorstInBox : Worst {
  OfFigures<WorstAt> of{};

  static constexpr auto field_table = std::tuple_cat(
      fields<Worst>, std::tuple{Field{"of", &WorstInBox::of,
                                      "for each figure the damper of the box and the motion"}});
};

/// Any of it may be beyond a double.
struct ResponseSi : ShownResponse {
  static constexpr auto field_table = twins<fields<ShownResponse>>(
      [](auto get) { return in([](const ShownResponse& now) { return &now; }, get); });
};
/// A motion under a hit, a pulse or a record.
struct ShownLoaded {
  IfReal v0, p;
  std::optional<design::Pulse> pulse;
  ShownResponse response;
  const design::SuiteRecord* record{nullptr};
  std::optional<bool> from_inside{};

  /// The same load, but another response.
  [[nodiscard]] ShownLoaded with(const ForcedResponse& other,
                                 std::optional<MotionEnergies> of = {}) const {
    return {v0, p, pulse, ShownResponse(other, of), record, from_inside};
  }
  [[nodiscard]] std::string what() const {
    return record != nullptr ? record->name : std::string(pulse ? design::name(*pulse) : "hit");
  }
  using Now = ShownLoaded;
  using Record = design::SuiteRecord;
  static constexpr std::tuple field_table{
      Field{"what", &Now::what, "hit, the shape of the pulse, or the file of the record"},
      Field{"v0", [](const auto& now) { return now.pulse ? IfReal() : now.v0; }, "of a hit"},
      Field{"p", &Now::p},
      Field{"k", in(&Now::pulse, k_of), "of a pulse, like lambda"},
      Field{"lambda", in(&Now::pulse, lambda_of)},
      Field{"scale", in(&Now::record, &Record::scale), "the factor on the values of a record",
            any_number},
      Field{"pga", in(&Now::record, [](const Record& of) { return design::peak_load(of); }),
            "the largest |W| of a record in g, with that factor"},
      Field{"from_inside", &Now::from_inside,
            "of a notch as built: whether it acts from the start; else null"},
      Field{"response", &Now::response},
      Field{"physical", [](const auto& now) { return ResponseSi{now.response}; },
            "the response in SI units", si_alone(Dimension::none)}};
};

struct ShownLoad {
  std::string_view type;
  std::optional<std::size_t> records{};
  IfReal weakest{};

  static constexpr std::tuple field_table{Field{"type", &ShownLoad::type, "", one_of(load_types)},
                                          Field{"records", &ShownLoad::records, "how many"},
                                          Field{"weakest", &ShownLoad::weakest,
                                                "of a hit or pulse that varies, the least part of "
                                                "its v0 or k; null with a region of its own"}};
};
struct ShownCase {
  Name name{};
  ShownLoad load;
  std::optional<design::Combine> combine{};
  std::optional<Worst> nominal{};
  std::optional<WorstInBox> worst{};
  std::vector<ShownLoaded> motions{};
  std::optional<design::Duty> duty{};

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
      Field{"duty", &Now::duty, "what the damper itself has to stand; null without one"},
      Field{"motions", &Now::motions, "of the damper itself"}};
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
[[nodiscard]] inline std::vector<ShownPart> shown_parts(const std::vector<design::RatedPart>& parts,
                                                        const Physical& physical) {
  return mapped(parts, [&physical](const design::RatedPart& rated) {
    return ShownPart{rated, rated.admissible ? Name() : judgement(rated, physical)};
  });
}

/// A motion that was tried with a notch as built.
[[nodiscard]] inline ShownLoaded tried(const design::TriedMotion& of) {
  return {of.v0, of.p, of.pulse, ShownResponse(of.response), nullptr, of.from_inside};
}
struct ShownNotch {
  const design::BuiltNotch* built;
  ShownLoaded motion;

  using Now = ShownNotch;
  using Built = design::BuiltNotch;
  using Worst = design::WorstMotions;
  static constexpr auto worst = [](auto which) {
    return in(&Now::built, &Built::worst, which, &tried);
  };
  static constexpr std::tuple field_table{
      Field{"friction", in(&Now::built, &Built::friction),
            "inside, f + delta/width; null with a hold"},
      Field{"changes_nothing", [](const auto& now) { return now.built->changes_nothing; },
            "compared with the same motion with the paper's notch"},
      Field{"motion", &Now::motion},
      Field{"from_start",
            only_if([](const auto& now) { return now.built->from_start.has_value(); },
                    [](const auto& now) { return now.motion.with(*now.built->from_start); }),
            "if the notch acts on the way out too; null with a pulse or a hold"},
      Field{"farthest_rest", worst(&Worst::farthest),
            "of a grid of the ranges the motion that rests farthest from x = 0; null without "
            "any"},
      Field{"largest_peak", worst(&Worst::peak)},
      Field{"largest_acceleration", worst(&Worst::felt), "the notch included"}};
};

struct AnswerSi;

struct ShownAnswer {
  const Physical& units;
  std::span<const design::Finding> findings{};
  std::string verdict{};
  AskedTask input{};
  std::optional<BoxedDamper> design{};
  std::vector<ShownCase> cases{};
  std::span<const design::Constraint> constraints{};
  std::optional<bool> admissible{};
  const design::Judged* judged{nullptr};
  IfReal largest_tolerance{};
  const design::RegionVerdict* region{nullptr};
  const std::vector<design::Strip>* strips{nullptr};
  const std::vector<design::FeasibleDelta>* feasible{nullptr};
  std::span<const design::Mend> mends{};
  const design::SuitePoint* nearest{nullptr};
  std::optional<std::vector<design::Hits>> hits{};
  const design::PulseCheck* pulse{nullptr};
  std::optional<ShownNotch> built_notch{};
  std::optional<std::vector<ShownPart>> catalogue{};
  std::optional<std::vector<Traded>> trade_off{};
  std::optional<design::WorksFor> works_for{};
  const design::SuiteOutlook* outlook{nullptr};
  const design::SearchRecord* search{nullptr};
  const design::CrossCheck* cross_check{nullptr};
  IfReal velocity_m_per_s{};  ///< for `physical` alone

  [[nodiscard]] std::optional<AnswerSi> in_si() const;

  using Now = ShownAnswer;
  using Judged = design::Judged;
  static constexpr auto of_judged = [](auto get) { return in(&Now::judged, get); };
  static constexpr std::tuple field_table{
      Field{"verdict", &Now::verdict, "the answer, in a sentence or two"},
      Field{"findings",
            [](const auto& now) { return ShownFindings{findings_json(now.findings, now.units)}; }},
      Field{"input", &Now::input},
      Field{"design", &Now::design, "or the given damper; null without one"},
      Field{"cases", &Now::cases},
      Field{"constraints", &Now::constraints},
      Field{"admissible", &Now::admissible, "of a given damper; null without one"},
      Field{"delta1_published", of_judged(&Judged::delta1_published), "at the f of the damper"},
      Field{"delta1_exact", of_judged(&Judged::delta1_exact),
            "null if the motion does not return, for a hit with f > f3"},
      Field{"region", &Now::region, "null under records"},
      Field{"strips", &Now::strips,
            "of a region, one for each arrival up to input.arrivals at which some damper can "
            "stop; else null"},
      Field{"feasible", &Now::feasible,
            "of a region that has no closed form, for some f from end to end", unless(0)},
      Field{"largest_tolerance", &Now::largest_tolerance,
            "without a design: the largest tolerance of any damper, if that is less than asked "
            "for; after a hit only if no single input makes it feasible"},
      Field{"mends", &Now::mends,
            "an input and the nearest value that, alone, would leave an admissible damper"},
      Field{"nearest", &Now::nearest,
            "under records without a design: the damper that violates the limits least"},
      Field{"works_for", &Now::works_for,
            "around the given load and p, each with the other as given: where the point itself "
            "meets every requirement, both ends included; of load cases in steps of 1 %, loads "
            "from a tenth to ten times and p from half to twice"},
      Field{"hits", &Now::hits, "how the motion ends, for every v0 from 0 to twice the given one"},
      Field{"practice", of_judged(&Judged::practice)},
      Field{"practice_worst", of_judged(&Judged::practice_worst),
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
      Field{"physical", [](const auto& now) { return now.in_si(); },
            "in the units at the ends of the names; null with dimensionless input"}};
};

struct HitsSi : design::Hits {
  static constexpr auto field_table = twins<fields<design::Hits>>([](auto get) { return get; });
};
/// Of a damper and its task.
struct AnswerSi : Si {
  const ShownAnswer* answer{nullptr};

  /// What would mend an empty region; empty if that input alone cannot.
  [[nodiscard]] IfReal mended(std::string_view field, bool by_stiffness) const;
  [[nodiscard]] std::optional<design::PhysicalWorksFor> works_for() const {
    const auto& served = answer->works_for;
    return served ? std::optional(physical_works_for(scales(), *served)) : std::nullopt;
  }

  static constexpr auto mend = [](std::string_view field, bool by_stiffness = false) {
    return [=](const auto& now) { return now.mended(field, by_stiffness); };
  };
  static constexpr auto of_region = [](auto design::Region::*value) {
    return in(&AnswerSi::answer, &ShownAnswer::region, &design::RegionVerdict::region, value);
  };
  static constexpr auto of_judged = [](auto design::Judged::*value) {
    return in(&AnswerSi::answer, &ShownAnswer::judged, value);
  };
  static constexpr auto of_hit = [](const auto& now) { return !now.answer->input.pulse; };
  static constexpr auto serves_hits = [](const auto& now) {
    const auto& served = now.answer->works_for;
    return served && served->load == design::ServedLoad::v0;
  };
  static constexpr auto rows = [](const std::vector<design::Hits>& hits) {
    return mapped(hits, [](const design::Hits& row) { return HitsSi{row}; });
  };
  using Now = AnswerSi;
  using Served = design::PhysicalWorksFor;
  using Judged = design::Judged;
  static constexpr Measure length = si_always(Dimension::length);
  static constexpr auto field_table = std::tuple_cat(
      scale_fields,
      std::tuple{
          Field{"max_displacement_m", in(&Now::input, &design::PhysicalInput::max_displacement_m)},
          Field{"max_displacement_min_m", of_region(&design::Region::beta_min), "", length},
          Field{"delta2_m", of_region(&design::Region::delta2), "",
                si_always(Dimension::length, Numbers::all)},
          Field{"velocity_mend_m_per_s", mend("v0"), "with the next four: the mends of the region"},
          Field{"period_mend_s", mend("p")}, Field{"stiffness_mend_n_per_m", mend("p", true)},
          Field{"max_displacement_mend_m", mend("beta")},
          Field{"delta_max_mend_m", mend("delta_max")}},
      damper_fields,
      std::tuple{Field{"works_for_velocity_m_per_s",
                       only_if(serves_hits, in(&Now::works_for, &Served::velocity_m_per_s))},
                 Field{"works_for_period_s", in(&Now::works_for, &Served::period_s)},
                 Field{"hits", only_if(of_hit, in(&Now::answer, &ShownAnswer::hits, rows)),
                       "in the order of those of the report"}},
      practice_fields_si,
      std::tuple{Field{"delta1_published_m", of_judged(&Judged::delta1_published), "", length},
                 Field{"delta1_exact_m", of_judged(&Judged::delta1_exact), "", length}},
      motion_fields_si, wave_fields);
};

[[nodiscard]] ShownAnswer shown(const DesignReport& report);
[[nodiscard]] ShownAnswer shown(const RegionReport& report);
[[nodiscard]] ShownAnswer shown(const RecordDesignReport& report);

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
