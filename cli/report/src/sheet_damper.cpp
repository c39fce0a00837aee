// SPDX-License-Identifier: MIT
// The damper on its specification sheet, in kN and kJ, with the digits that its tolerance deserves.
#include "specified.hpp"

#include <stillpoint/records/decimal.hpp>

#include <numbers>

namespace stillpoint::report {

namespace {

using records::decimal;
using records::Rounding;

/// A value and its range, in a unit, with the digits that its tolerance deserves.
struct Column {
  std::string head;
  double value;
  Interval range;

  [[nodiscard]] bool exact() const { return !(range.low < range.high); }
  [[nodiscard]] int shown() const {
    constexpr int usual = 4;
    return exact() ? usual + 2 : interval_places(range.low, range.high);
  }
};

/// "0.260", "1250": all digits that an end deserves, of which the last may be zeros.
std::string padded(double rounded, int digits) {
  int places = digits - 1;
  for (double left = rounded; left >= 10; left /= 10) {
    --places;
  }
  for (double left = rounded; left > 0 && left < 1 && places < digits_of_double; left *= 10) {
    ++places;
  }
  return places < digits_of_double ? format("{:.{}f}", rounded, std::max(places, 0))
                                   : format("{:.{}g}", rounded, digits);
}

Column column(std::string_view name, const Unit& unit, double value, const Interval& range) {
  return {in(name, unit), value * unit, {range.low * unit, range.high * unit}};
}

/// Friction over the weight has a force only with a mass; else it is one per mass.
Unit friction_unit(const Physical& physical) {
  if (!physical || has_mass(physical)) {
    return units_of(physical).force;
  }
  const Unit read = read_in(physical, "m/s²");
  return {physical->scales.gravity_m_per_s2 * read, read.name};
}

Table damper_table(const Specified& of) {
  const FigureUnits units = units_of(of.physical);
  std::vector<Column> all{column(has_mass(of.physical) ? "friction force"
                                 : of.physical         ? "friction per mass"
                                                       : "friction f",
                                 friction_unit(of.physical), of.damper.f, of.f),
                          column(of.physical ? "notch energy" : "notch energy Δ", units.energy,
                                 of.damper.delta, of.delta)};
  if (of.p.low < of.p.high) {
    constexpr double turn = 2 * std::numbers::pi;
    all.push_back(column(of.physical ? "period" : "period τ", units.time, turn / of.damper.p,
                         {turn / of.p.high, turn / of.p.low}));
  }
  if (of.damper.width > 0) {
    all.push_back(column("notch width", units.length, of.damper.width, of.width));
  }
  Table table{{""}, {{{"nominal"}}}};
  if (!std::ranges::all_of(all, &Column::exact)) {
    table.rows = {{{"least"}}, {{"nominal"}}, {{"most"}}};
  }
  for (const Column& now : all) {
    table.head.push_back(now.head);
    for (TableRow& row : table.rows) {
      const std::string& which = row.cells.front();
      constexpr double conversion = 1e-12;  // the rounding of 25 mm to dimensionless and back
      const auto& [low, high] = now.range;
      const int shown = now.shown();
      row.cells.push_back(
          now.exact()
              ? format("{:.{}g}", now.value, shown)
              : padded(which == "least"  ? decimal(low * (1 - conversion), shown, Rounding::up)
                       : which == "most" ? decimal(high * (1 + conversion), shown, Rounding::down)
                                         : decimal(now.value, shown),
                       shown));
    }
  }
  return table;
}

}  // namespace

void specify_damper(Document& sheet, const Specified& of) {
  Section& section = sheet.section("Damper", {damper_table(of)});
  const Oscillator& mass = of.cases.front().motion.oscillator;
  section.row("tolerance", of.tolerance);
  section.row("notch", of.damper.delta == 0 ? "none"
                       : of.damper.width > 0
                           ? "resists evenly within its width, by its energy over it"
                       : mass.hold ? format("at x = 0; lets go at {} above the friction",
                                            acceleration_shown(*mass.hold))
                                   : "at x = 0, where it holds the mass under any load");
  section.row("in the program", format("f = {:.6g}, delta = {}", of.damper.f,
                                       length_shown(of.physical, of.damper.delta)));
  section.row("spring", spring_words(of.physical, of.damper.p));
  if (const auto kg = of.physical ? of.physical->scales.mass_kg : std::nullopt) {
    constexpr double tonne = 1e3;
    section.row("mass", *kg < tonne ? format("{:.6g} kg", *kg) : format("{:.6g} t", *kg / tonne));
  }
  add_damping(section, mass);
}

}  // namespace stillpoint::report
