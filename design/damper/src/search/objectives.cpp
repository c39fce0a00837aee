// SPDX-License-Identifier: MIT
#include "search/objectives.hpp"

#include "unit_problem.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <numbers>

namespace stillpoint::design {

namespace {

/// In a = f / (V0 p).
struct ClosedForm {
  double (*value)(double a);
  double (*slope)(double a);
};

struct Row {
  Objective objective;
  std::string_view name;
  ClosedForm form;
};

/// f3 divided by p and V0 may be an ulp above a3.
double within(double given) {
  return std::min(given, unit::a3);
}

constexpr ClosedForm no_form{nullptr, nullptr};
constexpr ClosedForm peak_form{&unit::peak, &unit::peak_slope};
constexpr ClosedForm time_form{
    [](double a) { return unit::stop_phase(within(a)) / std::numbers::pi; },
    [](double a) { return unit::stop_phase_slope(within(a)) / std::numbers::pi; }};
constexpr ClosedForm acceleration_form{&unit::radius, [](double a) { return a / unit::radius(a); }};

constexpr std::array rows{
    Row{Objective::robust, "robust", no_form},
    Row{Objective::amplitude, "amplitude", peak_form},
    Row{Objective::time, "time", time_form},
    Row{Objective::acceleration, "acceleration", acceleration_form},
};

constexpr std::array names = [] {
  std::array<std::string_view, rows.size()> list;
  std::ranges::transform(rows, list.begin(), &Row::name);
  return list;
}();

const Row& row_of(Objective objective) {
  const auto* const row = std::ranges::find(rows, objective, &Row::objective);
  assert(row != rows.end() && "an Objective without a row");
  return *row;
}

}  // namespace

std::string_view name(Objective objective) noexcept {
  return row_of(objective).name;
}

std::optional<Objective> parse_objective(std::string_view name) noexcept {
  const auto* const row = std::ranges::find(rows, name, &Row::name);
  return row != rows.end() ? std::optional(row->objective) : std::nullopt;
}

std::span<const std::string_view> objective_names() {
  return names;
}

double objective_value(Objective objective, double given) {
  return row_of(objective).form.value(given);
}

double objective_slope(Objective objective, double given) {
  return row_of(objective).form.slope(given);
}

}  // namespace stillpoint::design
