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

}  // namespace

std::vector<SuiteDamper> neighbours_of_digits(const RecordDesignRequest& task,
                                              const SuiteDamper& damper, int digits) {
  const auto& [length, time] = task.printed.value();
  const double turn = 2 * std::numbers::pi * time.value_or(1);  // over p: the period
  Neighbours springs = neighbours(damper.p, 1, digits, task.p);
  if (time && task.p.low < task.p.high) {
    springs = neighbours(turn / damper.p, 1, digits, {turn / task.p.high, turn / task.p.low});
    springs = {turn / springs[0], turn / springs[1]};
  }
  std::vector<SuiteDamper> list;
  for (const double p : springs) {
    for (const double f : neighbours(damper.f, 1, digits, *task.f)) {
      for (const double delta : neighbours(damper.delta, length, digits, *task.delta)) {
        for (const double width :
             neighbours(damper.width, length, digits, task.width.value_or(Interval()))) {
          list.push_back({p, f, delta, width});
        }
      }
    }
  }
  return list;
}

}  // namespace stillpoint::design
