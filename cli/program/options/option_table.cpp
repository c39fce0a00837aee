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

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <list>

namespace stillpoint::cli {

namespace {

using enum Command;
using enum OptionKind;
using enum Role;
using enum Trait;

constexpr CommandSet every = design | region | simulate | sweep | accuracy;
/// One motion.
constexpr CommandSet motions = simulate | accuracy;
/// Commands that take metres and seconds.
constexpr CommandSet in_metres = every;
/// Commands that take a suite of records.
constexpr CommandSet of_suites = design | region | spectrum;
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

/// Their defaults.
std::string objectives_in_help() {
  std::vector<std::string_view> of_records = names<design::SuiteObjective>();
  std::erase(of_records, name(design::SuiteObjective::time));
  return fmt::format("{}; under records {}", with_default(names<design::Objective>()),
                     with_default(of_records));
}

std::string formats_in_help() {
  return listed(records::record_format_names());
}

/// In `help`, {} stands for the values.
template <class... Facts>
constexpr Option row(std::string_view name, OptionKind kind, std::string_view placeholder,
                     std::string_view help, CommandSet commands, Facts... facts) {
  return {name, kind, placeholder, help, commands, OptionTraits(facts...)};
}

constexpr Swept swept{sweep};
constexpr OrPerWeight or_force{Dimension::force};
constexpr OrPerWeight or_energy{Dimension::energy};
constexpr Needs of_a_reduction{sweep, "reduce", "a sweep without rows"};

// name, kind, placeholder, help, commands, facts
constexpr auto in_motion = std::to_array<Option>(
    {row("v0", number, "V", "initial velocity, just after the hit", every, swept,
         Units::dimensionless, Rivals::hit, RangeEnd::high),
     row("p", number, "P", "square root of the stiffness", every, swept, Units::dimensionless,
         Rivals::stiffness, RangeEnd::low),
     row("beta", number, "B", "largest admissible displacement", of_designs, swept,
         Units::dimensionless, Rivals::stroke, limits_case),
     row("pulse", text, "TYPE",
         "a pulse instead of a velocity: {}; needs --k, and --pulse-duration, "
         "--excitation-frequency or --lambda",
         of_designs, Rivals::hit, Values{[] { return design::excitation_names(true); }},
         Excludes{sweep, "residual residual-m", "in a sweep a design for a pulse stops at x = 0"},
         Instead{"a motion takes --excitation"}),
     row("x0", number, "X", "initial displacement (default 0)", motions | sweep, swept,
         Units::dimensionless, Rivals::start)});

constexpr auto in_physical = std::to_array<Option>(
    {row("velocity", number, "M/S", "initial velocity, just after the hit, in m/s", in_metres,
         swept, Rivals::hit, InSi{Dimension::velocity}, RangeEnd::high, Also{"pgv speed"}),
     row("max-displacement", number, "M", "largest admissible displacement in m", of_designs, swept,
         Rivals::stroke, InSi{Dimension::length}, Also{"stroke displacement"}, limits_case),
     row("period", number, "S", "natural period without friction in s", in_metres | spectrum,
         Swept{sweep | spectrum}, Rivals::stiffness, RangeEnd::high, InSi{Dimension::time}),
     row("natural-frequency", number, "HZ", "natural frequency in Hz, instead of the period",
         in_metres, swept, Rivals::stiffness, InSi{Dimension::frequency}, RangeEnd::low,
         Also{"frequency"}),
     row("stiffness", number, "N/M", "stiffness in N/m, instead of the period; needs --mass",
         in_metres, swept, Rivals::stiffness, InSi{Dimension::stiffness}, RangeEnd::low),
     row("mass", number, "KG", "mass in kg; adds forces and energies to the report",
         in_metres | spectrum, InSi{Dimension::mass}),
     row("gravity", number, "M/S2", "one g in m/s2, default 9.80665", in_metres | spectrum,
         Units::physical_without_records, Dimension::acceleration),
     row("x0-m", number, "M", "initial displacement in m", motions | sweep, swept, Rivals::start,
         InSi{Dimension::length})});

constexpr auto in_damper = std::to_array<Option>(
    {row("f", number, "F", "constant friction coefficient", region | motions | sweep | spectrum,
         swept, Rivals::friction, Also{"friction mu"}, Instead{"region judges a given damper"}),
     row("friction-force", number, "N", "the same as a force in N; needs --mass: f = N/(m g)",
         region | motions | sweep | spectrum, swept, Rivals::friction, InSi{Dimension::force},
         Also{"force"}, Instead{"region judges a given damper"}),
     row("delta", number, "D", "point friction", region | motions | sweep, swept,
         Rivals::point_friction, Also{"notch"}),
     row("delta-m", number, "M",
         "point friction in m, with physical input; with --mass it may be the energy of a passage, "
         "60kJ",
         region | motions | sweep | spectrum, swept, Rivals::point_friction,
         InSi{Dimension::length}, or_energy),
     row("damping", number, "Z",
         "viscous damping as a share of critical damping, 0.05 or 5%; default 0", every | spectrum,
         swept, Dimension::share, RangeEnd::low),
     row("breakaway", number, "R",
         "friction that holds a mass at rest, over the friction f of one that slides, 1 or more; "
         "default 1",
         every | spectrum, swept),
     row("hold", number, "H",
         "the notch holds a load up to f + H at x = 0, in g; default: any load",
         of_suites | of_excitations, swept, Rivals::notch, Dimension::gravities),
     row("notch-width", number, "W",
         "width of the notch: friction is f + delta/W for |x| < W/2; default: it acts only at x = "
         "0",
         design | region | of_excitations, swept, Units::dimensionless, Rivals::notch),
     row("notch-width-m", number, "M", "the same in m, with physical input",
         of_suites | of_excitations, swept, Rivals::notch, InSi{Dimension::length}),
     row("friction-zones", text, "X:F,...",
         "friction that steps with |x|: F up to X, f beyond the last X; with physical input X is "
         "in m or has a unit",
         of_excitations, InScene::zones),
     row("criterion", text, "NAME", "lower bound of delta: {}", of_designs, DesignFor::hit,
         Values{names<design::Criterion>, true}),
     row("arrivals", integer, "N", "stop at x = 0 by the N-th arrival, from 1 to 1000; default 1",
         of_designs, DesignFor::hit, swept, Bounds{1, design::most_arrivals}, limits_case),
     row("residual", number, "R", "also allow a rest with |x| up to R", of_designs, swept,
         Units::dimensionless, Rivals::residual, limits_case),
     row("residual-m", number, "M", "the same in m, with physical input", of_designs, swept,
         Rivals::residual, InSi{Dimension::length}, limits_case),
     row("tolerance", number, "R",
         "the design must stay admissible if its parts are off by up to R, or between the factors "
         "LOW:HIGH: f, delta, and under records the width of a notch; 0.1 is 10 %, 0.8:1.2 from "
         "0.8 to 1.2 times the design's; default 0, under records 0.1",
         of_designs, Dimension::share, RangeEnd::high),
     row("tolerance-f", number, "R", "the tolerance of f alone, R or LOW:HIGH", of_designs,
         Dimension::share, RangeEnd::high),
     row("tolerance-delta", number, "R", "the same for delta", of_designs, Dimension::share,
         RangeEnd::high),
     row("tolerance-width", number, "R", "the same for the width of the notch", design | region,
         DesignFor::cases, Dimension::share, RangeEnd::high),
     row("tolerance-period", number, "R", "the same for the period; default 0", design | region,
         DesignFor::cases, Dimension::share, RangeEnd::high),
     row("f-max", number, "F",
         "largest f that can be manufactured; with --mass it may be a force, 350kN", of_designs,
         or_force),
     row("delta-max", number, "D", "largest delta that can be manufactured", of_designs,
         Rivals::point_friction_limit),
     row("delta-max-m", number, "M",
         "the same in m, with physical input; with --mass it may be an energy, 80kJ", of_designs,
         InSi{Dimension::length}, or_energy, Rivals::point_friction_limit),
     row("acceleration-max", number, "A",
         "largest acceleration in g that the mass may feel outside the notch", of_designs,
         Dimension::gravities, limits_case),
     row("jump-max", number, "M/S",
         "largest jump of the velocity at a notch without a width, in m/s; with it "
         "such a notch is searched where an acceleration is asked for",
         design | region, DesignFor::cases, InSi{Dimension::velocity}, Rivals::jump_limit,
         limits_case),
     row("jump-max-v", number, "V", "the same, dimensionless", design | region, DesignFor::cases,
         Rivals::jump_limit, Units::dimensionless, limits_case)});

constexpr auto in_searching = std::to_array<Option>(
    {row("catalogue", text, "FILE",
         "choose among these parts: CSV with the columns name, f, and delta or delta_m; - for "
         "standard input",
         of_designs, FileUse::read,
         Excludes{design, "search-f search-delta-m search-period search-notch-width-m",
                  "the parts are what is searched"}),
     row("trade-off", integer, "N",
         "also list N dampers along the front of stroke, acceleration and tolerance, from 2 to "
         "1000; in a sweep, write a row for each instead of the design",
         design | sweep, Bounds{design::least_trade_offs, design::most_trade_offs},
         Excludes{sweep, "pulse", "in a sweep the front is for a hit given as a velocity"},
         Excludes{sweep, "catalogue objective", "in a sweep each row is a damper of the front"},
         not_explored),
     row("objective", text, "NAME", "what is best: {}", design | sweep, Values{all_objectives},
         objectives_in_help),
     row("combine", text, "NAME",
         "how to combine the figures of all records: {}; default: max for fewer than seven "
         "records",
         of_suites, DesignFor::records, Values{names<design::Combine>}, limits_case),
     row("cases", text, "JSON",
         "several load cases, in a scene a list of objects: each has a name, a load (a velocity, a "
         "pulse or records) and limits of its own; what stands outside is common to all",
         design | region, DesignFor::records, InScene::cases, not_explored),
     row("objective-case", text, "NAME",
         "the case whose figure is minimised; default: the largest of all", design,
         DesignFor::records, Needs{design, "cases", "several cases"}),
     row("search-f", number, "LOW:HIGH",
         "f, or the range LOW:HIGH to search; with --mass they may be forces, 200kN:500kN; "
         "default: from 0 to the largest load",
         design, DesignFor::cases, RangeEnd::high, or_force),
     row("search-delta-m", number, "LOW:HIGH",
         "delta in m, or the range LOW:HIGH to search; with --mass they may be energies, "
         "40kJ:90kJ; default: from 0 to what stops every return",
         design, DesignFor::cases, InSi{Dimension::length}, RangeEnd::high, or_energy),
     row("search-period", number, "LOW:HIGH", "search the period too, in this range LOW:HIGH in s",
         design, DesignFor::cases, InSi{Dimension::time}, RangeEnd::high),
     row("search-notch-width-m", number, "LOW:HIGH",
         "search the width of the notch too, in this range LOW:HIGH in m", design, DesignFor::cases,
         InSi{Dimension::length}, Rivals::notch, RangeEnd::high),
     row("scan-points", integer, "N",
         "under records: scan at most about this many dampers first, with three variables four "
         "times as many; default 10000",
         design, DesignFor::records, Bounds{1, most_scan_points}),
     row("algorithm", text, "NAME", "an NLopt algorithm (default LD_SLSQP)", design, DesignFor::hit,
         Values{design::algorithm_names})});

constexpr auto in_shaking = std::to_array<Option>(
    {row("excitation", text, "TYPE", "the load: {}", of_excitations,
         Values{[] { return design::excitation_names(); }}, InScene::group,
         Instead{"a design takes --pulse"}),
     row("k", number, "K", "peak of the excitation or pulse in g", of_waves, Load::wave, swept,
         Dimension::gravities, RangeEnd::high),
     row("excitation-frequency", number, "HZ",
         "with physical input: the frequency in Hz; for a pulse, that of its sine", of_waves,
         Load::wave, swept, Rivals::frequency, InSi{Dimension::frequency}, RangeEnd::low),
     row("pulse-duration", number, "S", "with physical input: how long the pulse lasts, in s",
         of_waves, Load::pulse, swept, Rivals::frequency, InSi{Dimension::time}, RangeEnd::high),
     row("lambda", number, "L",
         "dimensionless angular frequency, L/p times the natural one; a pulse lasts pi/L, a "
         "full-sine 2 pi/L",
         of_waves, Load::wave, swept, Rivals::frequency, RangeEnd::low),
     row("phase", number, "PHI", "of a harmonic, W = K sin(L tau + PHI); default 0", of_excitations,
         Load::harmonic, Instead{"only a harmonic has a phase"}),
     row("excitation-duration", number, "S",
         "with physical input: how long a harmonic lasts, in s, 0 or more; default: for ever",
         of_excitations, Load::harmonic, Rivals::duration,
         Instead{"a pulse takes --pulse-duration"}, InSi{Dimension::time}),
     row("duration", number, "TAU",
         "how long a harmonic lasts, in tau, 0 or more; default: for ever", of_excitations,
         Load::harmonic, Rivals::duration, Instead{"--lambda gives the length of a pulse"}),
     row("record", text, "FILE",
         "acceleration record: {}; times in s with physical input, else in tau; FILE#2 is channel "
         "2; design, region, spectrum and sweep take several, and folders",
         in_records, Load::record, FileUse::read, formats_in_help, repeats),
     row("records-list", text, "FILE",
         "CSV list of records with the header file,scale; or file,peak or file,spectrum, values "
         "in g to scale to",
         of_suites | sweep, DesignFor::records, FileUse::read),
     row("record-units", text, "UNITS", "units of the values: {}", in_records, Load::record,
         Values{names<records::RecordUnits>, true}),
     row("record-step", number, "DT",
         "time between two values, for a file without times; in s with physical input, else in "
         "tau",
         in_records, Load::record, Dimension::time),
     row("record-scale", number, "X", "factor on every value; default 1", in_records, Load::record,
         swept, Rivals::record_scale),
     row("record-peak", number, "A", "scale each record to this peak, in g", in_records,
         Load::record, Rivals::record_scale, Dimension::gravities),
     row("record-spectrum", number, "A",
         "scale each record so that its elastic spectrum, 5 % damping, has this value in g at the "
         "period",
         in_records, Load::record, Rivals::record_scale, Dimension::gravities),
     row("record-spectrum-period", number, "T",
         "the period of that value, in s with physical input, else in tau; default: that of the "
         "motion",
         in_records, Load::record, Dimension::time,
         Needs{in_records, "record-spectrum records-list", "a spectral value"}),
     row("end-time", number, "S",
         "with physical input: end of the run in s (default: end of the motion); required for a "
         "harmonic without a duration",
         of_excitations, InSi{Dimension::time}, Rivals::end),
     row("t-end", number, "TAU",
         "end of the run in tau (default: end of the motion); required for a harmonic without a "
         "duration",
         of_excitations, Rivals::end)});

constexpr auto in_sweeping = std::to_array<Option>(
    {row("list", text, "FILE", "one entry per row: CSV with a header; - for standard input", sweep,
         entries, FileUse::read),
     row("format", text, "NAME", "{}; default: npy if the output's name ends in .npy, else csv",
         sweep, content, Values{names<sweep::RowFormat>},
         Excludes{sweep, "reduce", "the report is JSON"}),
     row("columns", text, "NAMES", "the columns to write, e.g. f,delta,peak_amplitude", sweep,
         output, Excludes{sweep, "times", "name stop_time among the columns"}, InPython{sweep}),
     row("times", flag, "", "write stop_time as well", sweep, content),
     row("threads", integer, "N", "number of threads; default 0, all; results do not depend on it",
         of_suites | sweep, DesignFor::records, execution, Bounds{0, 1024}),
     row("reduce", flag, "",
         "report counts, extremes, histograms and the best rows instead of writing all rows", sweep,
         Excludes{sweep, "open html svg", "a map shows the rows"}),
     row("histogram", text, "BINS",
         "with --reduce: peak_amplitude:0:1:50 or :50:log, or edges, peak_amplitude:0,0.1,0.5",
         sweep, repeats, of_a_reduction),
     row("best", text, "ROWS",
         "with --reduce: the ten rows with the smallest value, peak_amplitude:10, or the largest, "
         "tolerance:10:largest",
         sweep, repeats, of_a_reduction),
     row("part", text, "I/N",
         "compute one of N parts, for sweep merge; {part} in the output's name becomes I-of-N",
         sweep, execution, Excludes{sweep, "open html svg", "a map shows a whole sweep"}),
     row("resume", flag, "", "continue an interrupted sweep; leave a complete part as it is", sweep,
         execution)});

constexpr auto in_writing = std::to_array<Option>(
    {row("max-half-cycles", integer, "N", "list at most this many half-cycles (default 1000)",
         simulate, content, Bounds{0, 100'000}),
     row("half-cycle-limit", number, "N",
         "refuse a motion that may take more half-cycles (default 1e8; no limit under an "
         "excitation)",
         simulate | sweep),
     row("trajectory", text, "FILE",
         "write the states to a CSV file, with physical input in SI units too, an event before and "
         "after; - prints them instead of the report",
         simulate, output, FileUse::written),
     row("samples", integer, "N",
         "number of evenly spaced instants in the trajectory, besides every event (default 1000)",
         simulate, output, Bounds{2, 1'000'000}, Needs{simulate, "trajectory", "a trajectory"},
         InPython{
             simulate,
             "also return the trajectory, at this many evenly spaced instants and at every event"}),
     row("table", text, "FILE",
         "write a row for each record and period to a file: NumPy's format if its name ends in "
         ".npy, else CSV; - prints CSV instead of the report",
         spectrum, output, FileUse::written),
     row("html", text, "FILE", "write a page with figures that needs no network", drawn, output,
         FileUse::written),
     row("sheet", text, "FILE",
         "write the specification of the damper for those who build it, a page that prints on two "
         "sheets of A4",
         design | region, output, FileUse::written),
     row("revision", text, "TEXT", "of the specification; else it has a blank to fill in",
         design | region, output, Needs{design | region, "sheet", "a specification"}),
     row("svg", text, "DIR", "write each figure to this directory", drawn, output,
         FileUse::directory),
     row("open", flag, "", "open the page of --html, or a temporary one, in a browser", drawn,
         output),
     row("title", text, "TEXT", "a heading for the report", reporting, content, InPython{}),
     row("json", flag, "", "print the JSON report, and nothing else", reporting, output),
     row("output", text, "FILE",
         "write the JSON report (for a sweep, the rows) to FILE, whole or not at all", reporting,
         output, FileUse::written,
         InPython{sweep, "a file for the rows, or for the report of a part without rows"}),
     row("quiet", flag, "", "print only errors on standard error", reporting, Rivals::verbosity,
         output),
     row("verbose", flag, "", "print the whole report", reporting, Rivals::verbosity, output)});

/// The headings of --help.
struct Group {
  std::string_view heading;
  std::span<const Option> rows;
};
constexpr auto groups = std::to_array<Group>(
    {{"Motion (dimensionless)", in_motion},
     {"Motion in SI units, or with units: 150mm, 2.8s, 1200t (instead of the dimensionless "
      "options)",
      in_physical},
     {"Damper", in_damper},
     {"Search", in_searching},
     {"Excitation (W in units of g)", in_shaking},
     {"Sweep", in_sweeping},
     {"Output", in_writing}});

/// With their groups, and the help in full.
std::vector<Option> all_options() {
  static std::list<std::string> texts;
  std::vector<Option> all;
  for (const auto& [heading, rows] : groups) {
    for (Option option : rows) {
      option.group = heading;
      if (const std::size_t place = option.help.find("{}"); place != std::string_view::npos) {
        const OptionTraits& traits = option.traits;
        option.help = texts.emplace_back(option.help)
                          .replace(place, 2,
                                   traits.in_help != nullptr        ? traits.in_help()
                                   : traits.values.first_is_default ? with_default(option.values())
                                                                    : listed(option.values()));
      }
      all.push_back(option);
    }
  }
  return all;
}

}  // namespace

std::span<const Option> options() {
  static const std::vector<Option> table = all_options();
  return table;
}

}  // namespace stillpoint::cli
