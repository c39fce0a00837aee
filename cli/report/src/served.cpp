// SPDX-License-Identifier: MIT
// What a damper works for, and the figures used in practice.
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::report {

namespace {

/// Without an end that is the program's own limit, not the damper's; without a low one that is
/// next to nothing.
design::ServedInterval open(design::ServedInterval served, const Interval& valid) {
  constexpr double rounding = 1e-12;
  if (served.low <= valid.low * (1 + rounding)) {
    served.low = 0;
  }
  if (served.high && *served.high >= valid.high * (1 - rounding)) {
    served.high = std::nullopt;
  }
  return served;
}

}  // namespace

std::string interval_text(const design::ServedInterval& interval, const Interval& asked,
                          bool searched) {
  constexpr int shown = 3;
  const double low = end_or_asked(interval.low, asked.low);
  if (!interval.high) {
    return low == 0 ? "any size" : format("at least {}", limit_digits(low, true, shown));
  }
  const double high = end_or_asked(*interval.high, asked.high);
  constexpr double apart = 1e-6;
  return high - low <= apart * high ? format("exactly {}", decimal_within(low, high))
         : searched && low > 0 && begins_at_nothing(low, high)
             ? format("{} to {}", limit_digits(low, true, shown), limit_digits(high, false, shown))
             : interval_digits(low, high);
}

void add_works_for(Section& section, const std::optional<design::WorksFor>& served,
                   const ShownTask& task) {
  if (!served) {
    return;
  }
  const auto& [problem, limits, pulse, ranges, physical] = task;
  const auto in_units = [&given = physical](const design::WorksFor& now) {
    return given ? physical_works_for(given->scales, now)
                 : design::PhysicalWorksFor{now.hit, now.p};
  };
  // How far a pulse was searched says nothing of what is beyond.
  const auto works = in_units(pulse ? *served
                                    : design::WorksFor{open(served->hit, design::valid_v0(problem)),
                                                       open(served->p, design::valid_p(problem))});
  const double k = pulse ? design::peak_load(*pulse) : 0;
  const Interval hits = pulse ? Interval{ranges.k_low.value_or(k), k}
                              : Interval{problem.v0_low.value_or(problem.v0), problem.v0};
  const auto asked = in_units({{hits.low, hits.high}, {problem.p, problem.stiffest_p()}});
  const auto text =
      [&, searched = pulse.has_value()](design::ServedInterval design::PhysicalWorksFor::*of) {
        return interval_text(works.*of, {(asked.*of).low, *(asked.*of).high}, searched);
      };
  const std::string of_hits =
      pulse ? interval_text(served->hit, hits) : text(&design::PhysicalWorksFor::velocity_m_per_s);
  section.row("works for", pulse      ? format("k of {} g", of_hits)
                           : physical ? format("hits of {} m/s", of_hits)
                                      : "v0 of " + of_hits);
  section.row("", format("{} of {}{}, each with the other as given", physical ? "periods" : "p",
                         text(&design::PhysicalWorksFor::period_s), physical ? " s" : ""));
}

namespace {

/// 20 mm, or a fifth of the peak if that is less.
double example_width(const Physical& physical, double peak) {
  constexpr double usual_m = 0.02;
  return std::min(peak / 5, physical ? usual_m / physical->scales.length_m : peak);
}

}  // namespace

std::string inside_example(const Physical& physical, const Oscillator& damper, double peak) {
  const auto& [p, f, delta, hold] = damper;
  const double width = example_width(physical, peak);
  constexpr int shown = 3;
  return format("at most {} g inside one {} wide",
                limit_digits(design::notch_acceleration(f, delta, width, p), true, shown),
                length_shown(physical, width, shown));
}

std::string impulse_shown(const Physical& physical, double impulse) {
  const auto newton_seconds = physical ? physical->scales.impulse_n_s(impulse) : std::nullopt;
  return newton_seconds ? with_unit(*newton_seconds, "N s")
         : physical     ? format("{:.4g} N s per kg", impulse * physical->scales.velocity_m_per_s)
                        : format("{:.4g} times the mass", impulse);
}

}  // namespace stillpoint::report
