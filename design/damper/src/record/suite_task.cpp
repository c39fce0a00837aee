// SPDX-License-Identifier: MIT
#include <stillpoint/design/suite_task.hpp>

#include <stillpoint/core/names.hpp>

#include <array>

namespace stillpoint::design {

namespace {

constexpr Names objectives(
    std::to_array<Named<SuiteObjective>>({{SuiteObjective::acceleration, "acceleration"},
                                          {SuiteObjective::amplitude, "amplitude"},
                                          {SuiteObjective::residual, "residual"}}));

constexpr Names combines(std::to_array<Named<Combine>>({{Combine::max, "max"},
                                                        {Combine::mean, "mean"}}));

}  // namespace

std::string_view name(SuiteObjective objective) noexcept {
  return objectives.name(objective);
}
std::optional<SuiteObjective> parse_suite_objective(std::string_view name) noexcept {
  return objectives.parse(name);
}
std::span<const std::string_view> suite_objective_names() {
  return objectives.all();
}

std::string_view name(Combine combine) noexcept {
  return combines.name(combine);
}
std::optional<Combine> parse_combine(std::string_view name) noexcept {
  return combines.parse(name);
}
std::span<const std::string_view> combine_names() {
  return combines.all();
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
