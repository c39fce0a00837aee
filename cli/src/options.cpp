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

using enum OptionKind;

constexpr std::string_view motion = "Motion (dimensionless)";
constexpr std::string_view physical =
    "Motion in metres and seconds (in place of the dimensionless)";
constexpr std::string_view damper = "Damper";
constexpr std::string_view shaking = "Excitation (W in units of g, time in tau)";
constexpr std::string_view search = "Search";
constexpr std::string_view output = "Output";

constexpr std::array table{
    // name, kind, placeholder, group, help, design, region, simulate
    Option{"v0", number, "V", motion, "initial velocity", true, true, true},
    Option{"p", number, "P", motion, "square root of the stiffness", true, true, true},
    Option{"beta", number, "B", motion, "largest admissible displacement", true, true, false},
    Option{"pulse", text, "TYPE", motion,
           "half-sine or rectangle, with --k and --lambda: in place of the initial velocity", true,
           false, false},
    Option{"x0", number, "X", motion, "initial displacement (default 0)", false, false, true},

    Option{"velocity", number, "M/S", physical, "initial velocity in m/s", true, true, true},
    Option{"max-displacement", number, "M", physical, "largest admissible displacement in m", true,
           true, false},
    Option{"period", number, "S", physical, "natural period without friction in s", true, true,
           true},
    Option{"stiffness", number, "N/M", physical, "in place of the period, with --mass", true, true,
           true},
    Option{"mass", number, "KG", physical, "for forces and energies in the report", true, true,
           true},
    Option{"gravity", number, "M/S2", physical, "default 9.80665", true, true, true},
    Option{"x0-m", number, "M", physical, "initial displacement in m", false, false, true},

    Option{"f", number, "F", damper, "constant friction coefficient", false, true, true},
    Option{"delta", number, "D", damper, "point friction", false, true, true},
    Option{"delta-m", number, "M", damper, "point friction in m, with physical input", false, true,
           true},
    Option{"criterion", text, "NAME", damper, "lower bound of delta: published (default) or exact",
           true, true, false},
    Option{"tolerance", number, "R", damper,
           "the design must stay admissible within f(1 +- R), delta(1 +- R); default 0", true, true,
           false},
    Option{"f-max", number, "F", damper, "largest f that can be manufactured", true, true, false},
    Option{"delta-max", number, "D", damper, "largest delta that can be manufactured", true, true,
           false},
    Option{"delta-max-m", number, "M", damper, "the same in m, with physical input", true, true,
           false},

    Option{"objective", text, "NAME", search, "robust (default), amplitude, time or acceleration",
           true, false, false},
    Option{"algorithm", text, "NAME", search, "an NLopt algorithm (default LD_SLSQP)", true, false,
           false},

    Option{"excitation", text, "TYPE", shaking,
           "harmonic, half-sine, full-sine, rectangle or record", false, false, true},
    Option{"k", number, "K", shaking, "its peak in g, or that of the pulse", true, false, true},
    Option{"lambda", number, "L", shaking,
           "angular frequency; half-sine and rectangle last pi/L, full-sine 2 pi/L", true, false,
           true},
    Option{"phase", number, "PHI", shaking, "of harmonic, W = K sin(L tau + PHI); default 0", false,
           false, true},
    Option{"duration", number, "TAU", shaking, "of harmonic; default for ever", false, false, true},
    Option{"record", text, "FILE", shaking,
           "accelerations: PEER .AT2 or columns; in s with physical input, else in tau", false,
           false, true},
    Option{"record-units", text, "UNITS", shaking, "g (default), m/s2 or cm/s2", false, false,
           true},
    Option{"record-step", number, "DT", shaking, "between values that have no time column", false,
           false, true},
    Option{"record-scale", number, "X", shaking, "factor on every value", false, false, true},
    Option{"t-end", number, "TAU", shaking,
           "end of the run; default: the end of the motion, which a harmonic has not", false, false,
           true},

    Option{"max-half-cycles", integer, "N", output, "half-cycles listed (default 1000)", false,
           false, true},
    Option{"half-cycle-limit", number, "N", output,
           "refuse a motion that may take more steps (default 1e8)", false, false, true},
    Option{"trajectory", text, "FILE", output, "write tau,x,v to a CSV file", false, false, true},
    Option{"samples", integer, "N", output,
           "evenly spaced instants in it, besides every event (default 1000)", false, false, true},
    Option{"title", text, "TEXT", output, "a heading for the report", true, true, true},
    Option{"json", flag, "", output, "print the JSON report, and nothing else", true, true, true},
    Option{"output", text, "FILE", output, "write the JSON report to FILE, whole or not at all",
           true, true, true},
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
  }
  assert(false && "a Command outside its enumeration");
  return "";
}

bool Option::serves(Command command) const {
  switch (command) {
    case Command::design:
      return design;
    case Command::region:
      return region;
    case Command::simulate:
      return simulate;
  }
  assert(false && "a Command outside its enumeration");
  return false;
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
