// SPDX-License-Identifier: MIT
// What a damper works for, in words.
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>

#include <cmath>

namespace stillpoint::report {

std::string interval_text(const design::ServedInterval& interval) {
  constexpr int shown = 3;
  constexpr double conversion = 1e-12;  // the rounding of 0.44 m/s to dimensionless and back
  constexpr double beyond_all = 1e30;   // an end that is the program's own limit, not the damper's
  constexpr double apart = 1e-6;
  const double low = interval.low < 1 / beyond_all ? 0 : interval.low * (1 - conversion);
  const double high = interval.high.value_or(HUGE_VAL) * (1 + conversion);
  return high < beyond_all ? high - low <= apart * high
                                 ? format("exactly {}", decimal_within(low, high))
                                 : interval_digits(low, high)
         : low == 0 ? "any size"
                           : format("at least {}", limit_digits(low, true, shown));
}

void add_works_for(Section& section, const std::optional<design::WorksFor>& served,
                   const ShownTask& task) {
  if (!served) {
    return;
  }
  const auto& physical = task.physical;
  const auto works = physical ? physical_works_for(physical->scales, *served)
                              : design::PhysicalWorksFor{served->hit, served->p};
  section.row("works for",
              task.pulse ? format("k of {} g", interval_text(served->hit))
                         : format("{} of {}{}", physical ? "hits" : "v0",
                                  interval_text(works.velocity_m_per_s), physical ? " m/s" : ""));
  section.row("", format("{} of {}{}, each with the other as given", physical ? "periods" : "p",
                         interval_text(works.period_s), physical ? " s" : ""));
}

std::string impulse_shown(const Physical& physical, double impulse) {
  const auto newton_seconds = physical ? physical->scales.impulse_n_s(impulse) : std::nullopt;
  return newton_seconds ? with_unit(*newton_seconds, "N s")
         : physical     ? format("{:.4g} N s per kg", impulse * physical->scales.velocity_m_per_s)
                        : format("{:.4g} times the mass", impulse);
}

}  // namespace stillpoint::report
