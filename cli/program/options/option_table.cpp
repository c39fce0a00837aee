// SPDX-License-Identifier: MIT
#include "options/options.hpp"

#include <stillpoint/design/excitation_kinds.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/record_design.hpp>
#include <stillpoint/design/search.hpp>
#include <stillpoint/design/trade_off.hpp>
#include <stillpoint/records/record_file.hpp>
#include <stillpoint/sweep/list.hpp>
#include <stillpoint/sweep/spec.hpp>
#include <stillpoint/texts/embedded.hpp>

#include <cassert>
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
/// Commands that take a wave in Hz or seconds.
constexpr CommandSet of_timed_waves = of_waves | spectrum;
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
  return fmt::format("{}; under records {}", with_default(all_objectives()),
                     with_default(of_records));
}

std::string formats_in_help() {
  return listed(records::record_format_names());
}

template <class... Facts>
constexpr Option row(std::string_view name, OptionKind kind, std::string_view placeholder,
                     CommandSet commands, Facts... facts) {
  return {name, kind, placeholder, commands, OptionTraits(facts...)};
}

constexpr Swept swept{sweep};
constexpr OrPerWeight or_force{Dimension::force};
constexpr OrPerWeight or_energy{Dimension::energy};
constexpr Needs of_a_reduction{sweep, "reduce", "a sweep without rows"};

// name, kind, placeholder, commands, facts; the help is a line of data/help/options.txt, under the
// heading of its group
constexpr auto rows = std::to_array<Option>(
    {row("v0", number, "V", every, swept, Units::dimensionless, Rivals::hit, RangeEnd::high),
     row("p", number, "P", every, swept, Units::dimensionless, Rivals::stiffness, RangeEnd::low),
     row("beta", number, "B", of_designs, swept, Units::dimensionless, Rivals::stroke, limits_case),
     row("pulse", text, "TYPE", of_designs | spectrum, Rivals::hit,
         Values{[] { return design::excitation_names(true); }},
         Excludes{sweep, "residual residual-m", "in a sweep a design for a pulse stops at x = 0"},
         Instead{"a motion takes --excitation"}),
     row("x0", number, "X", motions | sweep, swept, Units::dimensionless, Rivals::start),

     row("velocity", number, "M/S", in_metres | spectrum, swept, Rivals::hit,
         InSi{Dimension::velocity}, RangeEnd::high, Also{"pgv speed"}),
     row("max-displacement", number, "M", of_designs, swept, Rivals::stroke,
         InSi{Dimension::length}, Also{"stroke displacement"}, limits_case),
     row("period", number, "S", in_metres | spectrum, Swept{sweep | spectrum}, Rivals::stiffness,
         RangeEnd::high, InSi{Dimension::time}),
     row("natural-frequency", number, "HZ", in_metres, swept, Rivals::stiffness,
         InSi{Dimension::frequency}, RangeEnd::low, Also{"frequency"}),
     row("stiffness", number, "N/M", in_metres, swept, Rivals::stiffness,
         InSi{Dimension::stiffness}, RangeEnd::low),
     row("mass", number, "KG", in_metres | spectrum, InSi{Dimension::mass}),
     row("gravity", number, "M/S2", in_metres | spectrum, Units::physical_without_records,
         Dimension::acceleration),
     row("x0-m", number, "M", motions | sweep, swept, Rivals::start, InSi{Dimension::length}),

     row("f", number, "F", region | motions | sweep | spectrum, swept, Rivals::friction,
         Also{"friction mu"}, Instead{"region judges a given damper"}),
     row("friction-force", number, "N", region | motions | sweep | spectrum, swept,
         Rivals::friction, InSi{Dimension::force}, Also{"force"},
         Instead{"region judges a given damper"}),
     row("delta", number, "D", region | motions | sweep, swept, Rivals::point_friction,
         Also{"notch"}),
     row("delta-m", number, "M", region | motions | sweep | spectrum, swept, Rivals::point_friction,
         InSi{Dimension::length}, or_energy),
     row("damping", number, "Z", every | spectrum, swept, Dimension::share, RangeEnd::low),
     row("breakaway", number, "R", every | spectrum, swept),
     row("hold", number, "H", of_suites | of_excitations, swept, Rivals::notch,
         Dimension::gravities),
     row("notch-width", number, "W", design | region | of_excitations, swept, Units::dimensionless,
         Rivals::notch),
     row("notch-width-m", number, "M", of_suites | of_excitations, swept, Rivals::notch,
         InSi{Dimension::length}),
     row("friction-zones", text, "X:F,...", of_excitations, InScene::zones),
     row("criterion", text, "NAME", of_designs, DesignFor::hit,
         Values{names<design::Criterion>, true}),
     row("arrivals", integer, "N", of_designs, DesignFor::hit, swept,
         Bounds{1, design::most_arrivals}, limits_case),
     row("residual", number, "R", of_designs, swept, Units::dimensionless, Rivals::residual,
         limits_case),
     row("residual-m", number, "M", of_designs, swept, Rivals::residual, InSi{Dimension::length},
         limits_case),
     row("tolerance", number, "R", of_designs, Dimension::share, RangeEnd::high),
     row("tolerance-f", number, "R", of_designs, Dimension::share, RangeEnd::high),
     row("tolerance-delta", number, "R", of_designs, Dimension::share, RangeEnd::high),
     row("tolerance-width", number, "R", design | region, DesignFor::cases, Dimension::share,
         RangeEnd::high),
     row("tolerance-period", number, "R", design | region, DesignFor::cases, Dimension::share,
         RangeEnd::high),
     row("f-max", number, "F", of_designs, or_force),
     row("delta-max", number, "D", of_designs, Rivals::point_friction_limit),
     row("delta-max-m", number, "M", of_designs, InSi{Dimension::length}, or_energy,
         Rivals::point_friction_limit),
     row("acceleration-max", number, "A", of_designs, Dimension::gravities, limits_case),
     row("jump-max", number, "M/S", design | region, DesignFor::cases, InSi{Dimension::velocity},
         Rivals::jump_limit, limits_case),
     row("jump-max-v", number, "V", design | region, DesignFor::cases, Rivals::jump_limit,
         Units::dimensionless, limits_case),

     row("catalogue", text, "FILE", of_designs, FileUse::read,
         Excludes{design, "search-f search-delta-m search-period search-notch-width-m",
                  "the parts are what is searched"}),
     row("trade-off", integer, "N", design | sweep,
         Bounds{design::least_trade_offs, design::most_trade_offs},
         Excludes{sweep, "pulse", "in a sweep the front is for a hit given as a velocity"},
         Excludes{sweep, "catalogue objective", "in a sweep each row is a damper of the front"},
         not_explored),
     row("objective", text, "NAME", design | sweep, Values{all_objectives}, objectives_in_help),
     row("combine", text, "NAME", of_suites, DesignFor::records, Values{names<design::Combine>},
         limits_case),
     row("cases", text, "JSON", design | region, DesignFor::records, InScene::cases, not_explored),
     row("objective-case", text, "NAME", design, DesignFor::records,
         Needs{design, "cases", "several cases"}),
     row("search-f", number, "LOW:HIGH", design, DesignFor::cases, RangeEnd::high, or_force),
     row("search-delta-m", number, "LOW:HIGH", design, DesignFor::cases, InSi{Dimension::length},
         RangeEnd::high, or_energy),
     row("search-period", number, "LOW:HIGH", design, DesignFor::cases, InSi{Dimension::time},
         RangeEnd::high),
     row("search-notch-width-m", number, "LOW:HIGH", design, DesignFor::cases,
         InSi{Dimension::length}, Rivals::notch, RangeEnd::high),
     row("scan-points", integer, "N", design, DesignFor::records, Bounds{1, most_scan_points}),
     row("algorithm", text, "NAME", design, DesignFor::hit, Values{design::algorithm_names}),

     row("excitation", text, "TYPE", of_excitations,
         Values{[] { return design::excitation_names(); }}, InScene::group,
         Instead{
             "a design or a spectrum takes --pulse, which ends, so that the mass comes to rest"}),
     row("k", number, "K", of_timed_waves, Load::wave, swept, Dimension::gravities, RangeEnd::high),
     row("excitation-frequency", number, "HZ", of_timed_waves, Load::wave, swept, Rivals::frequency,
         InSi{Dimension::frequency}, RangeEnd::low),
     row("pulse-duration", number, "S", of_timed_waves, Load::pulse, swept, Rivals::frequency,
         InSi{Dimension::time}, RangeEnd::high),
     row("lambda", number, "L", of_waves, Load::wave, swept, Rivals::frequency, RangeEnd::low),
     row("phase", number, "PHI", of_excitations, Load::harmonic,
         Instead{"only a harmonic has a phase"}),
     row("excitation-duration", number, "S", of_excitations, Load::harmonic, Rivals::duration,
         Instead{"a pulse takes --pulse-duration"}, InSi{Dimension::time}),
     row("duration", number, "TAU", of_excitations, Load::harmonic, Rivals::duration,
         Instead{"--lambda gives the length of a pulse"}),
     row("record", text, "FILE", in_records, Load::record, FileUse::read, formats_in_help, repeats),
     row("records-list", text, "FILE", of_suites | sweep, DesignFor::records, FileUse::read),
     row("record-units", text, "UNITS", in_records, Load::record,
         Values{names<records::RecordUnits>, true}),
     row("record-step", number, "DT", in_records, Load::record, Dimension::time),
     row("record-scale", number, "X", in_records, Load::record, swept, Rivals::record_scale),
     row("record-peak", number, "A", in_records, Load::record, Rivals::record_scale,
         Dimension::gravities),
     row("record-spectrum", number, "A", in_records, Load::record, Rivals::record_scale,
         Dimension::gravities),
     row("record-spectrum-period", number, "T", in_records, Load::record, Dimension::time,
         Needs{in_records, "record-spectrum records-list", "a spectral value"}),
     row("end-time", number, "S", of_excitations, InSi{Dimension::time}, Rivals::end),
     row("t-end", number, "TAU", of_excitations, Rivals::end),

     row("list", text, "FILE", sweep, entries, FileUse::read),
     row("format", text, "NAME", sweep, content, Values{names<sweep::RowFormat>},
         Excludes{sweep, "reduce", "the report is JSON"}),
     row("columns", text, "NAMES", sweep, output,
         Excludes{sweep, "times", "name stop_time among the columns"}, InPython{sweep}),
     row("times", flag, "", sweep, content),
     row("threads", integer, "N", of_suites | sweep, DesignFor::records, execution,
         Bounds{0, 1024}),
     row("reduce", flag, "", sweep, Excludes{sweep, "open html svg", "a map shows the rows"}),
     row("histogram", text, "BINS", sweep, repeats, of_a_reduction),
     row("part", text, "I/N", sweep, execution,
         Excludes{sweep, "open html svg", "a map shows a whole sweep"}),
     row("resume", flag, "", sweep, execution),

     row("max-half-cycles", integer, "N", simulate, content, Bounds{0, 100'000}),
     row("half-cycle-limit", number, "N", simulate | sweep),
     row("trajectory", text, "FILE", simulate, output, FileUse::written),
     row("samples", integer, "N", simulate, output, Bounds{2, 1'000'000},
         Needs{simulate, "trajectory", "a trajectory"},
         InPython{
             simulate,
             "also return the trajectory, at this many evenly spaced instants and at every event"}),
     row("table", text, "FILE", spectrum, output, FileUse::written),
     row("html", text, "FILE", drawn, output, FileUse::written),
     row("sheet", text, "FILE", design | region, output, FileUse::written),
     row("revision", text, "TEXT", design | region, output,
         Needs{design | region, "sheet", "a specification"}),
     row("svg", text, "DIR", drawn, output, FileUse::directory),
     row("open", flag, "", drawn, output),
     row("title", text, "TEXT", reporting, content, InPython{}),
     row("json", flag, "", reporting, output),
     row("output", text, "FILE", reporting, output, FileUse::written,
         InPython{sweep, "a file for the rows, or without rows for the report"}),
     row("quiet", flag, "", reporting, Rivals::verbosity, output),
     row("verbose", flag, "", reporting, Rivals::verbosity, output)});

/// In the file {} stands for the values.
std::string help_of(const Option& option, std::string_view line) {
  std::string help(line);
  if (const std::size_t place = help.find("{}"); place != std::string::npos) {
    const OptionTraits& traits = option.traits;
    help.replace(place, 2,
                 traits.in_help != nullptr        ? traits.in_help()
                 : traits.values.first_is_default ? with_default(option.values())
                                                  : listed(option.values()));
  }
  return help;
}

/// With their groups and their help, in the order of the file.
std::vector<Option> all_options() {
  static std::list<std::string> helps;
  std::vector<Option> all;
  std::string_view heading;
  for (const std::string_view line : records::split(texts::embedded("help/options.txt"), '\n')) {
    const std::string_view name = line.substr(0, line.find(": "));
    if (line.starts_with("# ")) {
      heading = line.substr(2);
    } else if (const auto* const row = std::ranges::find(rows, name, &Option::name);
               row != rows.end()) {
      Option& option = all.emplace_back(*row);
      option.group = heading;
      option.help = helps.emplace_back(help_of(option, line.substr(name.size() + 2)));
    }
  }
  assert(all.size() == rows.size() && "an option without help");
  return all;
}

}  // namespace

std::span<const Option> options() {
  static const std::vector<Option> table = all_options();
  return table;
}

}  // namespace stillpoint::cli
