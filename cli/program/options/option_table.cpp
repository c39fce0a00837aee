// SPDX-License-Identifier: MIT
#include "options/options.hpp"

#include <stillpoint/core/names.hpp>
#include <stillpoint/design/excitation_kinds.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/record_design.hpp>
#include <stillpoint/design/search.hpp>
#include <stillpoint/design/trade_off.hpp>
#include <stillpoint/records/record_file.hpp>
#include <stillpoint/sweep/list.hpp>
#include <stillpoint/sweep/spec.hpp>

#include <algorithm>
#include <utility>

namespace stillpoint::cli {

namespace {

using enum Command;
using enum OptionKind;
using enum Role;

constexpr std::string_view motion = "Motion (dimensionless)";
constexpr std::string_view physical =
    "Motion in SI units, or with units: 150mm, 2.8s, 1200t (instead of the dimensionless options)";
constexpr std::string_view damper = "Damper";
constexpr std::string_view shaking = "Excitation (W in units of g)";
constexpr std::string_view searching = "Search";
constexpr std::string_view sweeping = "Sweep";
constexpr std::string_view writing = "Output";

constexpr CommandSet every = design | region | simulate | sweep | accuracy;
/// One motion.
constexpr CommandSet motions = simulate | accuracy;
/// Commands that take metres and seconds.
constexpr CommandSet in_metres = every;
/// Commands that take a suite of records and no other load.
constexpr CommandSet of_suites = design | spectrum;
/// Commands that make a report.
constexpr CommandSet reporting = every | spectrum;
constexpr CommandSet of_designs = design | region | sweep;
constexpr CommandSet of_excitations = motions | sweep;
/// Commands that take a load with a wave, or a pulse.
constexpr CommandSet of_waves = design | region | of_excitations;
/// Commands that take acceleration records.
constexpr CommandSet in_records = of_suites | of_excitations;
constexpr CommandSet drawn = design | region | simulate | spectrum | sweep;

/// A scan keeps about 100 bytes for each.
constexpr std::int64_t most_scan_points = 10'000'000;

/// Those of a design for a hit, then those that only a design under records has.
std::vector<std::string_view> all_objectives() {
  std::vector<std::string_view> both = names<design::Objective>();
  for (const std::string_view name : names<design::SuiteObjective>()) {
    if (std::ranges::find(both, name) == both.end()) {
      both.push_back(name);
    }
  }
  return both;
}

/// "robust (default), amplitude or time"
std::string with_default(std::span<const std::string_view> values) {
  std::string text = listed(values);
  return text.insert(values.front().size(), " (default)");
}

/// In `help`, {} stands for the values.
Option row(std::string_view name, OptionKind kind, std::string_view placeholder,
           std::string_view group, std::string help, CommandSet commands,
           OptionTraits traits = {}) {
  if (const std::size_t place = help.find("{}"); place != std::string::npos) {
    help.replace(place, 2,
                 traits.first_is_default ? with_default(traits.values) : listed(traits.values));
  }
  return {name, kind, placeholder, group, std::move(help), commands, std::move(traits)};
}

/// An input that a sweep varies, without a unit and with one, and a single number with a unit.
OptionTraits plain_axis(Rivals rivals, RangeEnd range = RangeEnd::none) {
  return {.axis = sweep, .rivals = rivals, .units = Units::dimensionless, .range = range};
}
OptionTraits in_si(Dimension dimension, Rivals rivals = Rivals::none,
                   RangeEnd range = RangeEnd::none) {
  return {.rivals = rivals, .units = Units::physical, .dimension = dimension, .range = range};
}
OptionTraits axis_in_si(Rivals rivals, Dimension dimension, RangeEnd range = RangeEnd::none) {
  OptionTraits traits = in_si(dimension, rivals, range);
  traits.axis = sweep;
  return traits;
}
/// For only one of the two kinds of design: for a hit, or under records.
OptionTraits for_hits(OptionTraits traits = {}) {
  traits.design = DesignFor::hit;
  return traits;
}
OptionTraits under_records(OptionTraits traits = {}) {
  traits.design = DesignFor::records;
  return traits;
}
/// Each case of a design may have its own.
OptionTraits limit(OptionTraits traits) {
  traits.limits_case = true;
  return traits;
}
OptionTraits of(Load load, OptionTraits traits = {}) {
  traits.load = load;
  return traits;
}
/// Where the numbers go.
OptionTraits goes(FileUse file = FileUse::none) {
  return {.role = output, .file = file};
}
OptionTraits also(std::vector<std::string_view> words, OptionTraits traits) {
  traits.also = std::move(words);
  return traits;
}

std::vector<Option> rows() {
  const std::vector<std::string_view> of_pages{"open", "html", "svg"};
  const Beside of_a_reduction{sweep, {"reduce"}, "a sweep without rows"};
  return {
      // name, kind, placeholder, group, help, commands, traits
      row("v0", number, "V", motion, "initial velocity, just after the hit", every,
          plain_axis(Rivals::hit, RangeEnd::high)),
      row("p", number, "P", motion, "square root of the stiffness", every,
          plain_axis(Rivals::stiffness, RangeEnd::low)),
      row("beta", number, "B", motion, "largest admissible displacement", of_designs,
          limit(plain_axis(Rivals::stroke))),
      row("pulse", text, "TYPE", motion,
          "a pulse instead of a velocity: {}; needs --k, and --pulse-duration, "
          "--excitation-frequency or --lambda",
          of_designs,
          {.rivals = Rivals::hit,
           .values = design::excitation_names(true),
           .excludes =
               {{of_designs, {"residual", "residual-m"}, "a design for a pulse stops at x = 0"}},
           .instead = "a motion takes --excitation",
           .explored = false}),
      row("x0", number, "X", motion, "initial displacement (default 0)", motions | sweep,
          plain_axis(Rivals::start)),

      row("velocity", number, "M/S", physical, "initial velocity, just after the hit, in m/s",
          in_metres,
          also({"pgv", "speed"}, axis_in_si(Rivals::hit, Dimension::velocity, RangeEnd::high))),
      row("max-displacement", number, "M", physical, "largest admissible displacement in m",
          of_designs,
          also({"stroke", "displacement"}, limit(axis_in_si(Rivals::stroke, Dimension::length)))),
      row("period", number, "S", physical, "natural period without friction in s",
          in_metres | spectrum,
          {.axis = sweep | spectrum,
           .rivals = Rivals::stiffness,
           .units = Units::physical,
           .dimension = Dimension::time,
           .range = RangeEnd::high}),
      row("natural-frequency", number, "HZ", physical,
          "natural frequency in Hz, instead of the period", in_metres,
          also({"frequency"}, axis_in_si(Rivals::stiffness, Dimension::frequency, RangeEnd::low))),
      row("stiffness", number, "N/M", physical,
          "stiffness in N/m, instead of the period; needs --mass", in_metres,
          axis_in_si(Rivals::stiffness, Dimension::stiffness, RangeEnd::low)),
      row("mass", number, "KG", physical, "mass in kg; adds forces and energies to the report",
          in_metres, in_si(Dimension::mass)),
      row("gravity", number, "M/S2", physical, "one g in m/s2, default 9.80665",
          in_metres | spectrum,
          {.units = Units::physical_without_records, .dimension = Dimension::acceleration}),
      row("x0-m", number, "M", physical, "initial displacement in m", motions | sweep,
          axis_in_si(Rivals::start, Dimension::length)),

      row("f", number, "F", damper, "constant friction coefficient",
          region | motions | sweep | spectrum,
          {.axis = sweep, .also = {"friction", "mu"}, .instead = "region judges a given damper"}),
      row("delta", number, "D", damper, "point friction", region | motions | sweep,
          {.axis = sweep, .rivals = Rivals::point_friction, .also = {"notch"}}),
      row("delta-m", number, "M", damper, "point friction in m, with physical input",
          region | motions | sweep | spectrum,
          axis_in_si(Rivals::point_friction, Dimension::length)),
      row("hold", number, "H", damper,
          "the notch holds a load up to f + H at x = 0, in g; default: any load",
          of_suites | of_excitations,
          {.axis = sweep, .rivals = Rivals::notch, .dimension = Dimension::gravities}),
      row("notch-width", number, "W", damper,
          "width of the notch: friction is f + delta/W for |x| < W/2; default: it acts only at x = "
          "0",
          design | of_excitations, plain_axis(Rivals::notch)),
      row("notch-width-m", number, "M", damper, "the same in m, with physical input",
          of_suites | of_excitations, axis_in_si(Rivals::notch, Dimension::length)),
      row("friction-zones", text, "X:F,...", damper,
          "friction that steps with |x|: F up to X, f beyond the last X; with physical input X is "
          "in m or has a unit",
          of_excitations, {.in_scene = InScene::zones}),
      row("criterion", text, "NAME", damper, "lower bound of delta: {}", of_designs,
          for_hits({.values = names<design::Criterion>(), .first_is_default = true})),
      row("arrivals", integer, "N", damper,
          "stop at x = 0 by the N-th arrival, from 1 to 1000; default 1", of_designs,
          limit(for_hits({.axis = sweep, .bounds = {1, design::most_arrivals}}))),
      row("residual", number, "R", damper, "also allow a rest with |x| up to R", of_designs,
          limit(plain_axis(Rivals::residual))),
      row("residual-m", number, "M", damper, "the same in m, with physical input", of_designs,
          limit(axis_in_si(Rivals::residual, Dimension::length))),
      row("tolerance", number, "R", damper,
          "the design must stay admissible if its parts are off by up to R, or between the factors "
          "LOW:HIGH: f, delta, and under records the width of a notch; 0.1 is 10 %, 0.8:1.2 from "
          "0.8 to 1.2 times the design's; default 0, under records 0.1",
          of_designs, {.range = RangeEnd::high}),
      row("tolerance-f", number, "R", damper, "the tolerance of f alone, R or LOW:HIGH", of_designs,
          {.range = RangeEnd::high}),
      row("tolerance-delta", number, "R", damper, "the same for delta", of_designs,
          {.range = RangeEnd::high}),
      row("tolerance-width", number, "R", damper,
          "under records: the same for the width of the notch", design,
          under_records({.range = RangeEnd::high})),
      row("tolerance-period", number, "R", damper,
          "under records: the same for the period; default 0", design,
          under_records({.range = RangeEnd::high})),
      row("f-max", number, "F", damper, "largest f that can be manufactured", of_designs),
      row("delta-max", number, "D", damper, "largest delta that can be manufactured", of_designs,
          {.rivals = Rivals::point_friction_limit}),
      row("delta-max-m", number, "M", damper, "the same in m, with physical input", of_designs,
          in_si(Dimension::length, Rivals::point_friction_limit)),
      row("acceleration-max", number, "A", damper,
          "largest acceleration in g that the mass may feel outside the notch", of_designs,
          limit({.dimension = Dimension::gravities})),

      row("jump-max", number, "M/S", damper,
          "under records: largest jump of the velocity at a notch without a width, in m/s; with it "
          "such a notch is searched where an acceleration is asked for",
          design, limit(under_records(in_si(Dimension::velocity, Rivals::jump_limit)))),
      row("jump-max-v", number, "V", damper, "the same, dimensionless", design,
          limit(under_records({.rivals = Rivals::jump_limit, .units = Units::dimensionless}))),

      row("catalogue", text, "FILE", searching,
          "choose among these parts: CSV with the columns name, f, and delta or delta_m; - for "
          "standard input",
          of_designs, for_hits({.file = FileUse::read})),
      row("trade-off", integer, "N", searching,
          "also list N dampers along the front of stroke, acceleration and tolerance, from 2 to "
          "1000; in a sweep, write a row for each instead of the design",
          design | sweep,
          for_hits({.bounds = {design::least_trade_offs, design::most_trade_offs},
                    .excludes =
                        {{design | sweep, {"pulse"}, "the front is for a hit given as a velocity"},
                         {sweep,
                          {"catalogue", "objective"},
                          "in a sweep each row is a damper of the front"}},
                    .explored = false})),
      row("objective", text, "NAME", searching,
          "what is best: " + with_default(names<design::Objective>()) + "; under records " +
              with_default(names<design::SuiteObjective>()),
          design | sweep, {.values = all_objectives(), .first_is_default = true}),
      row("combine", text, "NAME", searching,
          "how to combine the figures of all records: {}; default: max for fewer than seven "
          "records",
          of_suites, limit(under_records({.values = names<design::Combine>()}))),
      row("cases", text, "JSON", searching,
          "several load cases, in a scene a list of objects: each has a name, a load (a velocity, "
          "a "
          "pulse or records) and limits of its own; what stands outside is common to all",
          design, under_records({.in_scene = InScene::cases, .explored = false})),
      row("objective-case", text, "NAME", searching,
          "the case whose figure is minimised; default: the largest of all", design,
          under_records({.needs = {design, {"cases"}, "several cases"}})),
      row("search-f", number, "LOW:HIGH", searching,
          "under records: f, or the range LOW:HIGH to search; default: from 0 to the largest load",
          design, under_records({.range = RangeEnd::high})),
      row("search-delta-m", number, "LOW:HIGH", searching,
          "under records: delta in m, or the range LOW:HIGH to search; default: from 0 to what "
          "stops every return",
          design, under_records(in_si(Dimension::length, Rivals::none, RangeEnd::high))),
      row("search-period", number, "LOW:HIGH", searching,
          "under records: search the period too, in this range LOW:HIGH in s", design,
          under_records(in_si(Dimension::time, Rivals::none, RangeEnd::high))),
      row("search-notch-width-m", number, "LOW:HIGH", searching,
          "under records: search the width of the notch too, in this range LOW:HIGH in m", design,
          under_records(in_si(Dimension::length, Rivals::notch, RangeEnd::high))),
      row("scan-points", integer, "N", searching,
          "under records: scan at most about this many dampers first, with three variables four "
          "times as "
          "many; default 10000",
          design, under_records({.bounds = {1, most_scan_points}})),
      row("algorithm", text, "NAME", searching, "an NLopt algorithm (default LD_SLSQP)", design,
          for_hits({.values = design::algorithm_names()})),

      row("excitation", text, "TYPE", shaking, "the load: {}", of_excitations,
          {.values = design::excitation_names(),
           .in_scene = InScene::group,
           .instead = "a design takes --pulse"}),
      row("k", number, "K", shaking, "peak of the excitation or pulse in g", of_waves,
          of(Load::wave,
             {.axis = sweep, .dimension = Dimension::gravities, .range = RangeEnd::high})),
      row("excitation-frequency", number, "HZ", shaking,
          "with physical input: the frequency in Hz; for a pulse, that of its sine", of_waves,
          of(Load::wave, axis_in_si(Rivals::frequency, Dimension::frequency, RangeEnd::low))),
      row("pulse-duration", number, "S", shaking,
          "with physical input: how long the pulse lasts, in s", of_waves,
          of(Load::pulse, axis_in_si(Rivals::frequency, Dimension::time, RangeEnd::high))),
      row("lambda", number, "L", shaking,
          "dimensionless angular frequency, L/p times the natural one; half-sine and rectangle "
          "last pi/L, full-sine 2 pi/L",
          of_waves,
          of(Load::wave, {.axis = sweep, .rivals = Rivals::frequency, .range = RangeEnd::low})),
      row("phase", number, "PHI", shaking, "of a harmonic, W = K sin(L tau + PHI); default 0",
          of_excitations, of(Load::harmonic, {.instead = "only a harmonic has a phase"})),
      row("excitation-duration", number, "S", shaking,
          "with physical input: how long a harmonic lasts, in s, 0 or more; default: for ever",
          of_excitations,
          of(Load::harmonic, {.rivals = Rivals::duration,
                              .units = Units::physical,
                              .dimension = Dimension::time,
                              .instead = "a pulse takes --pulse-duration"})),
      row("duration", number, "TAU", shaking,
          "how long a harmonic lasts, in tau, 0 or more; default: for ever", of_excitations,
          of(Load::harmonic,
             {.rivals = Rivals::duration, .instead = "--lambda gives the length of a pulse"})),
      row("record", text, "FILE", shaking,
          "acceleration record: " + listed(records::record_format_names()) +
              "; times in s with physical input, else in tau; FILE#2 is channel 2; design and "
              "spectrum take several, and folders",
          in_records, of(Load::record, {.file = FileUse::read, .repeats = true})),
      row("records-list", text, "FILE", shaking,
          "CSV list of records with the header file,scale; or file,peak or file,spectrum, values "
          "in g to scale to",
          of_suites, under_records({.file = FileUse::read})),
      row("record-units", text, "UNITS", shaking, "units of the values: {}", in_records,
          of(Load::record, {.values = names<records::RecordUnits>(), .first_is_default = true})),
      row("record-step", number, "DT", shaking,
          "time between two values, for a file without times; in s with physical input, else in "
          "tau",
          in_records, of(Load::record, {.dimension = Dimension::time})),
      row("record-scale", number, "X", shaking, "factor on every value; default 1", in_records,
          of(Load::record, {.rivals = Rivals::record_scale})),
      row("record-peak", number, "A", shaking, "scale each record to this peak, in g", in_records,
          of(Load::record, {.rivals = Rivals::record_scale, .dimension = Dimension::gravities})),
      row("record-spectrum", number, "A", shaking,
          "scale each record so that its elastic spectrum, 5 % damping, has this value in g at the "
          "period",
          in_records,
          of(Load::record, {.rivals = Rivals::record_scale, .dimension = Dimension::gravities})),
      row("record-spectrum-period", number, "T", shaking,
          "the period of that value, in s with physical input, else in tau; default: that of the "
          "motion",
          in_records,
          of(Load::record,
             {.dimension = Dimension::time,
              .needs = {in_records, {"record-spectrum", "records-list"}, "a spectral value"}})),
      row("end-time", number, "S", shaking,
          "with physical input: end of the run in s (default: end of the motion); required for a "
          "harmonic without a duration",
          of_excitations, in_si(Dimension::time, Rivals::end)),
      row("t-end", number, "TAU", shaking,
          "end of the run in tau (default: end of the motion); required for a harmonic without a "
          "duration",
          of_excitations, {.rivals = Rivals::end}),

      row("list", text, "FILE", sweeping,
          "one entry per row: CSV with a header; - for standard input", sweep,
          {.role = entries, .file = FileUse::read}),
      row("format", text, "NAME", sweeping,
          "{}; default: npy if the output's name ends in .npy, else csv", sweep,
          {.role = content,
           .values = names<sweep::RowFormat>(),
           .excludes = {{sweep, {"reduce"}, "the report is JSON"}}}),
      row("columns", text, "NAMES", sweeping, "the columns to write, e.g. f,delta,peak_amplitude",
          sweep,
          {.role = output,
           .excludes = {{sweep, {"times"}, "name stop_time among the columns"}},
           .python = InPython{sweep}}),
      row("times", flag, "", sweeping, "write stop_time as well", sweep, {.role = content}),
      row("threads", integer, "N", sweeping,
          "number of threads; default 0, all; results do not depend on it", of_suites | sweep,
          under_records({.role = execution, .bounds = {0, 1024}})),
      row("reduce", flag, "", sweeping,
          "report counts, extremes, histograms and the best rows instead of writing all "
          "rows",
          sweep, {.excludes = {{sweep, of_pages, "a map shows the rows"}}}),
      row("histogram", text, "BINS", sweeping,
          "with --reduce: peak_amplitude:0:1:50 or :50:log, or edges, peak_amplitude:0,0.1,0.5",
          sweep, {.repeats = true, .needs = of_a_reduction}),
      row("best", text, "ROWS", sweeping,
          "with --reduce: the ten rows with the smallest value, peak_amplitude:10, or the largest, "
          "tolerance:10:largest",
          sweep, {.repeats = true, .needs = of_a_reduction}),
      row("part", text, "I/N", sweeping,
          "compute one of N parts, for sweep merge; {part} in the output's name becomes I-of-N",
          sweep, {.role = execution, .excludes = {{sweep, of_pages, "a map shows a whole sweep"}}}),
      row("resume", flag, "", sweeping,
          "continue an interrupted sweep; leave a complete part as it is", sweep,
          {.role = execution}),

      row("max-half-cycles", integer, "N", writing,
          "list at most this many half-cycles (default 1000)", simulate,
          {.role = content, .bounds = {0, 100'000}}),
      row("half-cycle-limit", number, "N", writing,
          "refuse a motion that may take more half-cycles (default 1e8; no limit under an "
          "excitation)",
          simulate | sweep),
      row("trajectory", text, "FILE", writing,
          "write tau,x,v to a CSV file; - prints them instead of the report", simulate,
          goes(FileUse::written)),
      row("samples", integer, "N", writing,
          "number of evenly spaced instants in the trajectory, besides every event (default 1000)",
          simulate,
          {.role = output,
           .bounds = {2, 1'000'000},
           .needs = {simulate, {"trajectory"}, "a trajectory"},
           .python =
               InPython{simulate,
                        "also return the trajectory, at this many evenly spaced instants and at "
                        "every event"}}),
      row("table", text, "FILE", writing,
          "write a row for each record and period to a file: NumPy's format if its name ends in "
          ".npy, else CSV; - prints CSV instead of the report",
          spectrum, goes(FileUse::written)),
      row("html", text, "FILE", writing, "write a page with figures that needs no network", drawn,
          goes(FileUse::written)),
      row("svg", text, "DIR", writing, "write each figure to this directory", drawn,
          goes(FileUse::directory)),
      row("open", flag, "", writing, "open the page of --html, or a temporary one, in a browser",
          drawn, goes()),
      row("title", text, "TEXT", writing, "a heading for the report", reporting,
          {.role = content, .python = InPython{}}),
      row("json", flag, "", writing, "print the JSON report, and nothing else", reporting, goes()),
      row("output", text, "FILE", writing,
          "write the JSON report (for a sweep, the rows) to FILE, whole or not at all", reporting,
          {.role = output,
           .file = FileUse::written,
           .python =
               InPython{sweep, "a file for the rows, or for the report of a part without rows"}}),
      row("quiet", flag, "", writing, "print only errors on standard error", reporting,
          {.rivals = Rivals::verbosity, .role = output}),
      row("verbose", flag, "", writing, "print the whole report", reporting,
          {.rivals = Rivals::verbosity, .role = output}),
  };
}

}  // namespace

std::span<const Option> options() {
  static const std::vector<Option> table = rows();
  return table;
}

}  // namespace stillpoint::cli
