// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>
#include <vector>

namespace stillpoint::cli {

namespace {

using enum Command;
using enum OptionKind;

constexpr std::string_view motion = "Motion (dimensionless)";
constexpr std::string_view physical =
    "Motion in metres and seconds (in place of the dimensionless)";
constexpr std::string_view damper = "Damper";
constexpr std::string_view shaking = "Excitation (W in units of g, time in tau)";
constexpr std::string_view searching = "Search";
constexpr std::string_view sweeping = "Sweep";
constexpr std::string_view output = "Output";

constexpr CommandSet every = design | region | simulate | sweep | accuracy;
/// One motion.
constexpr CommandSet motions = simulate | accuracy;
/// For a number that sweep takes an axis of.
constexpr bool swept = true;

constexpr std::array table{
    // name, kind, placeholder, group, help, commands, swept
    Option{"v0", number, "V", motion, "initial velocity", every, swept},
    Option{"p", number, "P", motion, "square root of the stiffness", every, swept},
    Option{"beta", number, "B", motion, "largest admissible displacement", design | region | sweep,
           swept},
    Option{"pulse", text, "TYPE", motion,
           "half-sine or rectangle, with --k and --lambda: in place of the initial velocity",
           design},
    Option{"x0", number, "X", motion, "initial displacement (default 0)", motions | sweep, swept},

    Option{"velocity", number, "M/S", physical, "initial velocity in m/s",
           design | region | motions},
    Option{"max-displacement", number, "M", physical, "largest admissible displacement in m",
           design | region},
    Option{"period", number, "S", physical, "natural period without friction in s",
           design | region | motions},
    Option{"stiffness", number, "N/M", physical, "in place of the period, with --mass",
           design | region | motions},
    Option{"mass", number, "KG", physical, "for forces and energies in the report",
           design | region | motions},
    Option{"gravity", number, "M/S2", physical, "default 9.80665", design | region | motions},
    Option{"x0-m", number, "M", physical, "initial displacement in m", motions},

    Option{"f", number, "F", damper, "constant friction coefficient", region | motions | sweep,
           swept},
    Option{"delta", number, "D", damper, "point friction", region | motions | sweep, swept},
    Option{"delta-m", number, "M", damper, "point friction in m, with physical input",
           region | motions},
    Option{"criterion", text, "NAME", damper, "lower bound of delta: published (default) or exact",
           design | region | sweep},
    Option{"tolerance", number, "R", damper,
           "the design must stay admissible within f(1 +- R), delta(1 +- R); default 0",
           design | region | sweep},
    Option{"f-max", number, "F", damper, "largest f that can be manufactured",
           design | region | sweep},
    Option{"delta-max", number, "D", damper, "largest delta that can be manufactured",
           design | region | sweep},
    Option{"delta-max-m", number, "M", damper, "the same in m, with physical input",
           design | region},

    Option{"objective", text, "NAME", searching,
           "robust (default), amplitude, time or acceleration", design | sweep},
    Option{"algorithm", text, "NAME", searching, "an NLopt algorithm (default LD_SLSQP)", design},

    Option{"excitation", text, "TYPE", shaking,
           "harmonic, half-sine, full-sine, rectangle or record", motions | sweep},
    Option{"k", number, "K", shaking, "its peak in g, or that of the pulse",
           design | motions | sweep},
    Option{"lambda", number, "L", shaking,
           "angular frequency, dimensionless with physical input too: L/p times the natural one; "
           "half-sine and rectangle last pi/L, full-sine 2 pi/L",
           design | motions | sweep},
    Option{"phase", number, "PHI", shaking, "of harmonic, W = K sin(L tau + PHI); default 0",
           motions | sweep},
    Option{"duration", number, "TAU", shaking, "of harmonic; default for ever", motions | sweep},
    Option{"record", text, "FILE", shaking,
           "accelerations: PEER .AT2 or columns; in s with physical input, else in tau",
           motions | sweep},
    Option{"record-units", text, "UNITS", shaking, "g (default), m/s2 or cm/s2", motions | sweep},
    Option{"record-step", number, "DT", shaking, "between values that have no time column",
           motions | sweep},
    Option{"record-scale", number, "X", shaking, "factor on every value", motions | sweep},
    Option{"t-end", number, "TAU", shaking,
           "end of the run; default: the end of the motion, which a harmonic has not",
           motions | sweep},

    Option{"list", text, "FILE", sweeping,
           "entries by rows: CSV with a header, or JSON lines; - for standard input", sweep},
    Option{"list-format", text, "NAME", sweeping,
           "csv or jsonl; default: jsonl where the list begins with {", sweep},
    Option{"format", text, "NAME", sweeping,
           "csv or npy; default: by the end of the output's name, else csv", sweep},
    Option{"columns", text, "NAMES", sweeping, "what to write, e.g. f,delta,peak_amplitude", sweep},
    Option{"times", flag, "", sweeping, "write stop_time as well", sweep},
    Option{"threads", integer, "N", sweeping, "default: all. No result depends on it", sweep},
    Option{"resume", flag, "", sweeping, "go on with what an interrupted sweep left", sweep},

    Option{"max-half-cycles", integer, "N", output, "half-cycles listed (default 1000)", simulate},
    Option{"half-cycle-limit", number, "N", output,
           "do not compute a motion that may take more half-cycles (default 1e8; under an "
           "excitation none)",
           simulate | sweep},
    Option{"trajectory", text, "FILE", output, "write tau,x,v to a CSV file", simulate},
    Option{"samples", integer, "N", output,
           "evenly spaced instants in it, besides every event (default 1000)", simulate},
    Option{"html", text, "FILE", output, "write a page with figures, readable offline",
           design | region | simulate | sweep},
    Option{"svg", text, "DIR", output, "write each figure to this directory",
           design | region | simulate | sweep},
    Option{"title", text, "TEXT", output, "a heading for the report", every},
    Option{"json", flag, "", output, "print the JSON report, and nothing else", every},
    Option{"output", text, "FILE", output,
           "write the JSON report (of sweep: the rows) to FILE, whole or not at all", every},
};

/// Levenshtein's distance.
std::size_t slips(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string_view name(Command command) noexcept {
  switch (command) {
    case Command::design:
      return "design";
    case Command::region:
      return "region";
    case Command::simulate:
      return "simulate";
    case Command::sweep:
      return "sweep";
    case Command::accuracy:
      return "accuracy";
  }
  assert(false && "a Command outside its enumeration");
  return "";
}

std::span<const Option> options() {
  return table;
}

const Option* find_option(std::string_view name) {
  const auto* const found = std::ranges::find(table, name, &Option::name);
  return found == table.end() ? nullptr : &*found;
}

std::string suggestion(std::string_view wrong) {
  const auto* const nearest = std::ranges::min_element(
      table, {}, [&](const Option& option) { return slips(wrong, option.name); });
  const std::size_t distance = slips(wrong, nearest->name);
  return distance <= 2 && distance < wrong.size() ? fmt::format("; did you mean {}?", nearest->name)
                                                  : "";
}

}  // namespace stillpoint::cli
