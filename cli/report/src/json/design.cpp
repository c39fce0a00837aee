// SPDX-License-Identifier: MIT
#include "json/head_fields.hpp"
#include "json/region_fields.hpp"
#include "json/schema.hpp"

#include <stillpoint/report/schemas.hpp>

namespace stillpoint::report {

namespace {

constexpr auto design_name = std::to_array<std::string_view>({"stillpoint/design-report/1"});
constexpr auto nlopt = std::to_array<std::string_view>({"NLopt"});
constexpr auto check_methods =
    std::to_array<std::string_view>({"half_cycle_map", "runge_kutta", "forced_pulse"});

struct DesignInput : ShownInput {
  const DesignReport& report;
};

constexpr auto design_input_fields = [] {
  using Now = DesignInput;
  return std::tuple{
      Field{"objective", [](const Now& now) { return now.report.result.request.search.objective; }},
      Field{"algorithm", [](const Now& now) { return now.report.result.request.search.algorithm; },
            "as given; null if the program chooses"},
      Field{"catalogue", [](const Now& now) { return file_of(now.catalogue); }, "the file"},
      Field{"trade_off", [](const Now& now) { return now.report.trade_offs; }, "how many"}};
}();

nlohmann::ordered_json own_json(const DesignInput& input) {
  return input_json(input, design_input_fields);
}
nlohmann::ordered_json own_schema(const DesignInput* /*input*/) {
  return input_schema<DesignInput>(design_input_fields);
}

DesignInput design_input(const DesignReport& report) {
  const design::DesignRequest& request = report.result.request;
  return {{task_of(report),
           request.pulse ? report.result.reduced_v0 : std::optional(request.problem.v0),
           report.catalogue},
          report};
}

/// A report with a design.
struct ShownDesign {
  const DesignReport& report;

  [[nodiscard]] const design::DesignResult& result() const { return report.result; }
  [[nodiscard]] const design::Found& found() const { return *report.result.finding; }
  [[nodiscard]] std::optional<Interval> side(double design::BoxShape::*below,
                                             double design::BoxShape::*above) const {
    const design::BoxShape& shape = result().request.limits.shape;
    return side_of(shape, found().point.tolerance, shape.*below, shape.*above);
  }
};

/// With the optimum beside what NLopt says.
struct ShownSearch : design::SearchRecord {
  Optimum optimum{};
};
struct ShownPulse : design::PulseCheck {
  Optimum optimum{};
};

/// A hit or a pulse of the ranges, and a motion with a notch as built.
struct ShownTried {
  const design::TriedMotion& tried;
  const Physical& physical;
};
struct ShownFromStart {
  const ForcedResponse& response;
  const Physical& physical;
};
struct ShownNotch {
  const design::BuiltNotch& built;
  const Physical& physical;
};
struct ShownTradeOff {
  const design::TradeOff& now;
  const Physical& physical;
};

/// Of ranges; empty without any.
constexpr auto tried(design::TriedMotion design::WorstMotions::*which) {
  return [which](const ShownNotch& now) {
    const auto& worst = now.built.worst;
    return worst ? std::optional(ShownTried{(*worst).*which, now.physical}) : std::nullopt;
  };
}

/// What `get` gives of a design; empty without one.
template <class Get>
constexpr auto of_design(Get get) {
  return [get](const DesignReport& report) {
    using Value = std::remove_cvref_t<std::invoke_result_t<Get, const ShownDesign&>>;
    using Shown = std::conditional_t<is_optional<Value>, Value, std::optional<Value>>;
    return report.result.finding ? Shown(get(ShownDesign{report})) : Shown();
  };
}

/// Where a motion with a notch rests, and what it takes; `response` is that of `Now`.
template <class Now, class Get>
constexpr auto rest_and_peak(Get response) {
  return std::tuple{
      Field{"stop_position", in(response, &Response::stop_position), "", any_number},
      Field{"stop_position_m",
            [response](const Now& now) {
              return in_metres(now.physical, response(now).stop_position);
            },
            "", any_number},
      Field{"peak_amplitude", in(response, &Response::peak_amplitude)},
      Field{"peak_absolute_acceleration", in(response, &Response::peak_absolute_acceleration),
            "in g, the notch included"}};
}

std::optional<std::vector<ShownTradeOff>> front_of(const DesignReport& report) {
  if (!report.trade_off) {
    return std::nullopt;
  }
  std::vector<ShownTradeOff> front;
  for (const design::TradeOff& now : *report.trade_off) {
    front.push_back({now, report.physical});
  }
  return front;
}

std::optional<double> in_seconds(const Physical& physical, const std::optional<double>& tau) {
  return physical && tau ? std::optional(*tau * physical->scales.time_s) : std::nullopt;
}

}  // namespace

}  // namespace stillpoint::report

namespace stillpoint {

template <>
inline constexpr auto fields<report::ShownDesign> = [] {
  using design::BoxShape;
  using Now = report::ShownDesign;
  return std::tuple{
      Field{"name",
            [](const Now& now) {
              const auto& catalogue = now.report.catalogue;
              return catalogue ? std::optional(catalogue->parts.front().part.name) : std::nullopt;
            },
            "of the part; null without a catalogue",
            {Numbers::all}},
      Field{"f", [](const Now& now) { return now.found().point.f; }},
      Field{"delta", [](const Now& now) { return now.found().point.delta; }},
      Field{"tolerance", [](const Now& now) { return design::even_tolerance(now.result()); },
            "the largest that the design allows, of f and delta at once"},
      Field{"tolerance_f",
            [](const Now& now) { return now.side(&BoxShape::f_low, &BoxShape::f_high); }},
      Field{"tolerance_delta",
            [](const Now& now) { return now.side(&BoxShape::delta_low, &BoxShape::delta_high); }},
      Field{"arrival", [](const Now& now) { return now.found().arrival; },
            "at which it stops the mass; null for a rest off centre, within the residual",
            report::at_least_one},
      Field{"delta1_published",
            [](const Now& now) { return report::delta_needs(now.result()).published; }},
      Field{"delta1_exact",
            [](const Now& now) { return report::delta_needs(now.result()).exact; }}};
}();

template <>
inline constexpr auto fields<report::ShownSearch> = [] {
  using report::Optimum;
  using Now = report::ShownSearch;
  return std::tuple{
      Field{"library",
            [](const Now&) { return report::nlopt.front(); },
            "",
            {.texts = report::nlopt}},
      Field{"library_version", [](const Now&) { return design::nlopt_version(); }},
      Field{"algorithm", &Now::algorithm},
      Field{"status", &Now::status, "NLopt's"},
      Field{"evaluations", &Now::evaluations},
      Field{"wall_time_s", &Now::wall_time_s},
      Field{"optimum", in(&Now::optimum, &Optimum::found),
            "the objective's value of the design; with a pulse, of NLopt's best point",
            report::any_number},
      Field{"optimum_along_f", in(&Now::optimum, &Optimum::along_f),
            "that of the best damper along f alone, found without NLopt", report::any_number}};
}();

template <>
inline constexpr auto fields<design::CheckMethod> = [] {
  using Now = design::CheckMethod;
  return std::tuple{Field{"name", &Now::name, "", {.texts = report::check_methods}},
                    Field{"tolerance", &Now::tolerance},
                    Field{"peak_amplitude", &Now::peak_amplitude},
                    Field{"peak_acceleration", &Now::peak_acceleration},
                    Field{"stop_time", &Now::stop_time},
                    Field{"arrival_speed", &Now::arrival_speed},
                    Field{"half_cycles", &Now::half_cycles, "", {Numbers::counts}},
                    Field{"stop_position", &Now::stop_position, "", report::any_number},
                    Field{"relative_error", &Now::relative_error},
                    Field{"wall_time_s", &Now::wall_time_s},
                    Field{"decided", &Now::decided},
                    Field{"passed", &Now::passed}};
}();

template <>
inline constexpr auto fields<design::CrossCheck> = std::tuple{
    Field{"passed", &design::CrossCheck::passed}, Field{"methods", &design::CrossCheck::methods}};

template <>
inline constexpr auto fields<design::PulseWorst> =
    std::tuple{Field{"peak_amplitude", &design::PulseWorst::peak},
               Field{"peak_absolute_acceleration", &design::PulseWorst::acceleration},
               Field{"stop_time", &design::PulseWorst::stop_time}};

template <>
inline constexpr auto fields<report::ShownPulse> = [] {
  using report::Optimum;
  using Now = report::ShownPulse;
  return std::tuple{
      Field{"lambda", [](const Now& now) { return design::angular_frequency(now.pulse); },
            "of the motion shown; with ranges, the one with the largest peak"},
      Field{"p", &Now::p},
      Field{"worst", &Now::worst, "the largest over the ranges; null without any"},
      Field{"shortness", &Now::shortness, "p/lambda"},
      Field{"friction_ratio", &Now::friction_ratio, "f/k"},
      Field{"equivalent_v0",
            [](const Now& now) {
              return now.start ? std::optional<double>(now.start->speed) : std::nullopt;
            },
            "", report::any_number},
      Field{"equivalent_start",
            [](const Now& now) {
              return now.start ? std::optional<double>(now.start->tau) : std::nullopt;
            },
            "", report::any_number},
      Field{"peak_error", &Now::peak_error, "", report::any_number},
      Field{"stop_time_error", &Now::stop_time_error, "", report::any_number},
      Field{"warnings", &Now::warnings},
      Field{"searched", in(&Now::optimum, &Optimum::found),
            "the objective of the best point that NLopt saw", report::any_number},
      Field{"bracketed", in(&Now::optimum, &Optimum::along_f),
            "the same of the best along f alone, found without NLopt", report::any_number},
      Field{"response", in(&design::PulseCheck::response)}};
}();

template <>
inline constexpr auto fields<report::ShownTried> = [] {
  using Now = report::ShownTried;
  return std::tuple{
      Field{"v0",
            [](const Now& now) {
              return now.tried.pulse ? std::nullopt : std::optional(now.tried.v0);
            },
            "null with a pulse"},
      Field{"k",
            [](const Now& now) {
              return now.tried.pulse ? std::optional(design::peak_load(*now.tried.pulse))
                                     : std::nullopt;
            },
            "null without a pulse"},
      Field{"lambda",
            [](const Now& now) {
              return now.tried.pulse ? std::optional(design::angular_frequency(*now.tried.pulse))
                                     : std::nullopt;
            },
            "null without a pulse"},
      Field{"p", [](const Now& now) { return now.tried.p; }},
      Field{"from_inside", [](const Now& now) { return now.tried.from_inside; },
            "the notch acts from the start"},
      Field{"stop_position", [](const Now& now) { return now.tried.rest(); }, "",
            report::any_number},
      Field{"stop_position_m",
            [](const Now& now) { return report::in_metres(now.physical, now.tried.rest()); }, "",
            report::any_number},
      Field{"peak_amplitude", [](const Now& now) { return now.tried.response.peak_amplitude; }},
      Field{"peak_m",
            [](const Now& now) {
              return report::in_metres(now.physical, now.tried.response.peak_amplitude);
            }},
      Field{"peak_absolute_acceleration",
            [](const Now& now) { return now.tried.response.peak_absolute_acceleration; }}};
}();

template <>
inline constexpr auto fields<report::ShownFromStart> =
    report::rest_and_peak<report::ShownFromStart>(
        [](const report::ShownFromStart& now) -> const ForcedResponse& { return now.response; });

template <>
inline constexpr auto fields<report::ShownNotch> = [] {
  using design::WorstMotions;
  using Now = report::ShownNotch;
  using report::tried;
  return std::tuple_cat(
      std::tuple{
          Field{"width", [](const Now& now) { return now.built.shape.width; }, "null with a hold"},
          Field{
              "width_m",
              [](const Now& now) { return report::in_metres(now.physical, now.built.shape.width); },
              "lengths in m are null with dimensionless input"},
          Field{"friction", [](const Now& now) { return now.built.friction; },
                "inside, f + delta/width; null with a hold"},
          Field{"hold", [](const Now& now) { return now.built.shape.hold; }, "null with a width"},
          Field{"changes_nothing", [](const Now& now) { return now.built.changes_nothing; },
                "compared with the same motion with the paper's notch"},
          Field{"outcome", [](const Now& now) { return now.built.response.outcome; }},
          Field{"zero_passages",
                [](const Now& now) { return now.built.response.zero_passages; },
                "",
                {Numbers::counts}},
          Field{"stop_time", [](const Now& now) { return now.built.response.stop_time; }}},
      report::rest_and_peak<Now>(
          [](const Now& now) -> const ForcedResponse& { return now.built.response; }),
      std::tuple{
          Field{"from_start",
                [](const Now& now) {
                  const auto& from = now.built.from_start;
                  return from ? std::optional(report::ShownFromStart{*from, now.physical})
                              : std::nullopt;
                },
                "if the notch acts on the way out too; null with a pulse or a hold"},
          Field{"farthest_rest", tried(&WorstMotions::farthest),
                "of a grid of the ranges the motion that rests farthest from x = 0; null without "
                "any"},
          Field{"largest_peak", tried(&WorstMotions::peak)},
          Field{"largest_acceleration", tried(&WorstMotions::felt), "the notch included"}});
}();

template <>
inline constexpr auto fields<report::ShownTradeOff> = [] {
  using Now = report::ShownTradeOff;
  return std::tuple{
      Field{"f", [](const Now& of) { return of.now.damper.f; }},
      Field{"delta", [](const Now& of) { return of.now.damper.delta; }},
      Field{"delta_m",
            [](const Now& of) { return report::in_metres(of.physical, of.now.damper.delta); }},
      Field{"tolerance", [](const Now& of) { return of.now.damper.tolerance; }},
      Field{"peak_amplitude", [](const Now& of) { return of.now.peak_amplitude; }},
      Field{"peak_m",
            [](const Now& of) { return report::in_metres(of.physical, of.now.peak_amplitude); }},
      Field{"peak_absolute_acceleration",
            [](const Now& of) { return of.now.peak_absolute_acceleration; }},
      Field{"stop_time", [](const Now& of) { return of.now.stop_time; }},
      Field{"stop_time_s",
            [](const Now& of) { return report::in_seconds(of.physical, of.now.stop_time); }}};
}();

template <>
inline constexpr auto fields<report::DesignReport> = [] {
  using namespace report;
  using Now = DesignReport;
  using Of = ShownDesign;
  return std::tuple_cat(
      head_fields<Now, design_name>, told_fields<Now>,
      std::tuple{
          Field{"input", &design_input},
          Field{"region",
                [](const Now& now) -> const design::RegionVerdict& { return now.result; }},
          Field{
              "design", of_design([](const Of& of) { return of; }),
              "null without an admissible design, like response, search and cross_check; search is "
              "null with a catalogue too"},
          Field{"constraints",
                [](const Now& now) {
                  const auto& found = now.result.finding;
                  return found ? found->constraints : std::vector<design::Constraint>();
                }},
          Field{"works_for", of_design([](const Of& of) {
                  return served(of.found().works_for, task_of(of.report));
                }),
                "around the given v0, or k of a pulse, and p, each with the other as given: where "
                "the "
                "point itself meets every requirement, both ends included"},
          Field{"hits", of_design([](const Of& of) {
                  return hits_of(task_of(of.report), of.found().point.f, of.found().point.delta);
                }),
                "how the motion ends, for every v0 from 0 to twice the given one"},
          Field{"practice", of_design([](const Of& of) {
                  const auto& [f, delta, tolerance] = of.found().point;
                  const auto& lines = of.found().practice;
                  return lines ? std::optional(ShownPractice{
                                     {*lines},
                                     design::impulses({of.result().request.problem.p, f, delta},
                                                      of.found().response)})
                               : std::nullopt;
                })},
          Field{"practice_worst", of_design([](const Of& of) {
                  return practice_at_ends(task_of(of.report), of.found().practice,
                                          of.found().point.f, of.found().point.delta);
                }),
                "each figure at the end of the ranges where it is worst; null without ranges and "
                "with "
                "a pulse"},
          Field{"response", of_design([](const Of& of) {
                  return of.found().pulse ? AnyResponse(of.found().pulse->response)
                                          : AnyResponse(of.found().response);
                }),
                "the second under a pulse"},
          Field{"search", of_design([](const Of& of) {
                  const auto& search = of.found().search;
                  return search ? std::optional(ShownSearch{*search, optimum_of(of.result())})
                                : std::nullopt;
                })},
          Field{"cross_check", of_design([](const Of& of) { return of.found().cross_check; })},
          Field{"pulse", of_design([](const Of& of) {
                  const auto& pulse = of.found().pulse;
                  return pulse ? std::optional(ShownPulse{*pulse, optimum_of(of.result())})
                               : std::nullopt;
                }),
                "null without a pulse"},
          Field{"built_notch",
                [](const Now& now) {
                  return now.built_notch ? std::optional(ShownNotch{*now.built_notch, now.physical})
                                         : std::nullopt;
                },
                "the motion of the design with the notch that will be built; null without "
                "--notch-width"},
          Field{"catalogue", [](const Now& now) { return parts_of(now.catalogue, task_of(now)); },
                "every part, best first; null without a catalogue"},
          Field{"trade_off", &front_of, "along the front; null if not asked for"},
          Field{"physical", [](const Now& now) { return physical_of(now); },
                "in the units at the ends of the names; null with dimensionless input"}});
}();

}  // namespace stillpoint

namespace stillpoint::report {

nlohmann::ordered_json json(const DesignReport& report) {
  return object_json(report);
}

nlohmann::ordered_json design_schema() {
  return document_schema(design_name.front(), "design --json", dimensionless_numbers,
                         schema_of<DesignReport>());
}

}  // namespace stillpoint::report
