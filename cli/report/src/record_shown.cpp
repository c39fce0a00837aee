// SPDX-License-Identifier: MIT
// The damper of a design under records as a reader can enter it again.
#include "format.hpp"
#include "record_design_parts.hpp"

#include <stillpoint/report/digits.hpp>

#include <numbers>

namespace stillpoint::report {

namespace {

/// A value that is printed in `unit`, with so many digits, rounded up or down.
double as_shown(double value, double unit, bool upwards, int digits) {
  return std::stod(limit_digits(value * unit, upwards, digits)) / unit;
}

bool includes(const Interval& searched, double value) {
  constexpr double rounding = 1e-12;
  return value >= searched.low * (1 - rounding) && value <= searched.high * (1 + rounding);
}

}  // namespace

ShownDamper shown_damper(const RecordDesignReport& report) {
  constexpr int fewest = 5;
  constexpr int every = 17;  // that a double has
  const Physical& physical = report.physical;
  const design::RecordDesignRequest& task = report.result.request;
  const auto& [damper, figures] = report.result.finding->point;
  const double metres = physical ? physical->scales.length_m : 1;
  const double period = 2 * std::numbers::pi * (physical ? physical->scales.time_s : 1);
  const bool free_period = task.p.low < task.p.high;
  const auto p_shown = [&](bool upwards, int digits) {
    return !free_period ? damper.p
           : physical   ? period / as_shown(period / damper.p, 1, upwards, digits)
                        : as_shown(damper.p, 1, upwards, digits);
  };
  const auto same = [&](const design::SuiteDamper& shown) {
    if (!includes(*task.f, shown.f) || !includes(*task.delta, shown.delta) ||
        !includes(task.p, shown.p)) {
      return false;
    }
    const design::SuiteFigures there = design::figures_of(task, shown);
    return admissible(there, task.limits) &&
           figures_words(there, physical) == figures_words(figures, physical);
  };
  for (int digits = fewest; digits < every; ++digits) {
    const auto period_digits = free_period ? std::optional(digits) : std::nullopt;
    for (const bool p_up : {false, true}) {
      for (const bool f_up : {false, true}) {
        for (const bool delta_up : {false, true}) {
          const design::SuiteDamper shown{p_shown(p_up, digits),
                                          as_shown(damper.f, 1, f_up, digits),
                                          as_shown(damper.delta, metres, delta_up, digits)};
          if (same(shown)) {
            return {shown, digits, period_digits};
          }
        }
      }
      if (!free_period) {
        break;
      }
    }
  }
  return {damper, every, free_period ? std::optional(every) : std::nullopt};
}

std::string damper_row(const ShownDamper& shown, const Physical& physical) {
  return format("f = {:.{}g}, delta = {}", shown.damper.f, shown.digits,
                length_shown(physical, shown.damper.delta, shown.digits));
}

}  // namespace stillpoint::report
