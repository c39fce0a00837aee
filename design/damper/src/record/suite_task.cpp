// SPDX-License-Identifier: MIT
#include "record/suite.hpp"

#include <stillpoint/design/suite_task.hpp>

#include <stillpoint/core/names.hpp>

#include <array>

namespace stillpoint::design {

std::span<const Named<SuiteObjective>> enumerators(SuiteObjective) noexcept {
  static constexpr auto rows =
      std::to_array<Named<SuiteObjective>>({{SuiteObjective::acceleration, "acceleration"},
                                            {SuiteObjective::amplitude, "amplitude"},
                                            {SuiteObjective::residual, "residual"}});
  return rows;
}

std::span<const Named<Combine>> enumerators(Combine) noexcept {
  static constexpr auto rows =
      std::to_array<Named<Combine>>({{Combine::max, "max"}, {Combine::mean, "mean"}});
  return rows;
}

Record scaled(const SuiteRecord& record) {
  Record load = record.record;
  for (double& value : load.values) {
    value *= record.scale;
  }
  return load;
}

double value_of(const SuiteFigures& figures, SuiteObjective which) {
  switch (which) {
    case SuiteObjective::amplitude:
      return figures.peak;
    case SuiteObjective::residual:
      return figures.residual;
    case SuiteObjective::acceleration:
      break;
  }
  return figures.acceleration;
}

bool admissible(const SuiteFigures& figures, const SuiteLimits& limits) {
  return rank(figures, SuiteObjective::acceleration, limits).off == 0;
}

}  // namespace stillpoint::design
