// SPDX-License-Identifier: MIT
#include "record/suite_digits.hpp"

#include <stillpoint/records/decimal.hpp>

#include <array>
#include <numbers>

namespace stillpoint::design {

namespace {

using Neighbours = std::array<double, 2>;

/// The decimals of so many digits below and above `value` in `unit`; itself if it was not searched.
Neighbours neighbours(double value, double unit, int digits, const Interval& range) {
  if (value == 0 || range.low == range.high) {
    return {value, value};
  }
  return {records::decimal(value * unit, digits, records::Rounding::down) / unit,
          records::decimal(value * unit, digits, records::Rounding::up) / unit};
}

bool includes(const Interval& range, double value) {
  return range.low <= value && value <= range.high;
}

}  // namespace

SuitePoint with_few_digits(const Suite& suite, const RecordDesignRequest& task,
                           const SuitePoint& found) {
  constexpr double costs_nothing = 1e-5;  // a tenth of what the docs promise of the search
  constexpr int fewest = 5;
  constexpr int most = 12;
  if (!task.printed) {
    return found;
  }
  const auto& [p, f, delta] = found.damper;
  const auto& [length, time] = *task.printed;
  const double turn = 2 * std::numbers::pi * time.value_or(1);  // over p: the period
  const auto rank_of = [&](const SuitePoint& point) {
    return rank(point.figures, task.objective, task.limits);
  };
  const auto is_as_good = [&, whole = rank_of(found)](const SuitePoint& point, double part) {
    const SuiteRank now = rank_of(point);
    return now.off <= whole.off * (1 + part) && now.value <= whole.value * (1 + part);
  };
  constexpr double next_to_nothing = 1e-3;  // a notch that gains less is not worth building
  if (delta > 0 && includes(*task.delta, 0)) {
    const SuitePoint bare{{p, f, 0}, suite.figures({p, f, 0})};
    if (is_as_good(bare, next_to_nothing)) {
      return with_few_digits(suite, task, bare);
    }
  }
  for (int digits = fewest; digits <= most; ++digits) {
    Neighbours springs = neighbours(p, 1, digits, task.p);
    if (time && task.p.low < task.p.high) {
      springs = neighbours(turn / p, 1, digits, {turn / task.p.high, turn / task.p.low});
      springs = {turn / springs[0], turn / springs[1]};
    }
    SuitePoint best;
    best.figures.settled = false;
    for (const double of_p : springs) {
      for (const double of_f : neighbours(f, 1, digits, *task.f)) {
        for (const double of_delta : neighbours(delta, length, digits, *task.delta)) {
          const SuiteDamper damper{of_p, of_f, of_delta};
          if (includes(task.p, of_p) && includes(*task.f, of_f) &&
              includes(*task.delta, of_delta)) {
            const SuitePoint point{damper, suite.figures(damper)};
            best = rank_of(point) < rank_of(best) ? point : best;
          }
        }
      }
    }
    if (is_as_good(best, costs_nothing)) {
      return best;
    }
  }
  return found;
}

}  // namespace stillpoint::design
