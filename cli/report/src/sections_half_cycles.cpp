// SPDX-License-Identifier: MIT
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::report {

void add_half_cycles(Section& section, std::span<const HalfCycle> half_cycles,
                     const std::optional<double>& count, std::string_view where_more,
                     const Physical& physical) {
  const FigureUnits units(physical);
  Table table{{"", in("starts", units.time_unit), in("leaves with", units.velocity_unit),
               in("peak at", units.time_unit), in("peak", units.length_unit),
               in("ends", units.time_unit), in("arrives with", units.velocity_unit)},
              {}};
  const bool impulses = std::ranges::any_of(
      half_cycles, [](const HalfCycle& now) { return now.impulse.value_or(0) > 0; });
  if (impulses) {
    table.head.push_back(in("impulse/mass", units.velocity_unit));
  }
  const std::size_t listed = std::min(most_half_cycles, half_cycles.size());
  for (const HalfCycle& now : half_cycles.first(listed)) {
    table.rows.push_back(
        {{format("{}", now.index), digits(now.start_time * units.time),
          digits(now.departure_speed * units.velocity), digits(now.peak_time * units.time),
          digits(now.side * now.peak * units.length), digits(now.end_time * units.time),
          now.arrival_speed ? digits(*now.arrival_speed * units.velocity) : "none"}});
    if (impulses) {
      table.rows.back().cells.push_back(now.impulse ? digits(*now.impulse * units.velocity) : "");
    }
  }
  section.parts.emplace_back(std::move(table));
  if (count.value_or(HUGE_VAL) > static_cast<double>(listed)) {
    section.line(format("The first {}{}; --json {}.", listed,
                        count ? " of " + plural(count, "half-cycle") : "", where_more),
                 Tone::faint);
  }
}

}  // namespace stillpoint::report
