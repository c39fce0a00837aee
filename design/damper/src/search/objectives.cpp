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
  ClosedForm form;
  double (*unit)(const Problem& problem);
  std::optional<double> (*of)(const Figures& motion);
  double FirstReturn::*under_pulse;
  double (*pulse_units)(double value, double k, double p);
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
    Row{Objective::robust, no_form, [](const Problem&) { return -1.0; },
        [](const Figures&) { return std::optional<double>(); }, nullptr,
        [](double value, double /*k*/, double /*p*/) { return -value; }},
    Row{Objective::amplitude, peak_form,
        [](const Problem& problem) { return problem.v0 / problem.p; },
        [](const Figures& motion) { return std::optional(motion.peak); }, &FirstReturn::peak,
        [](double value, double k, double p) { return value * (k / p / p); }},
    Row{Objective::time, time_form,
        [](const Problem& problem) { return std::numbers::pi / problem.p; },
        [](const Figures& motion) { return motion.stop_time; }, &FirstReturn::time,
        [](double value, double /*k*/, double p) { return value / p; }},
    Row{Objective::acceleration, acceleration_form,
        [](const Problem& problem) { return problem.v0 * problem.p; },
        [](const Figures& motion) { return std::optional(motion.acceleration); },
        &FirstReturn::acceleration, [](double value, double k, double /*p*/) { return value * k; }},
};

const Row& row_of(Objective objective) {
  const auto* const row = std::ranges::find(rows, objective, &Row::objective);
  assert(row != rows.end() && "an Objective without a row");
  return *row;
}

}  // namespace

double objective_value(Objective objective, double given) {
  return row_of(objective).form.value(given);
}

double objective_slope(Objective objective, double given) {
  return row_of(objective).form.slope(given);
}

bool falls_with_f(Objective objective) {
  return objective_slope(objective, unit::a3 / 2) < 0;
}

double objective_unit(Objective objective, const Problem& problem) {
  return row_of(objective).unit(problem);
}

double in_pulse_units(Objective objective, double value, double k, double p) {
  return row_of(objective).pulse_units(value, k, p);
}

double objective_of(Objective objective, const FirstReturn& motion) {
  assert(objective != Objective::robust && "no motion has a tolerance");
  return motion.*row_of(objective).under_pulse;
}

std::optional<double> objective_of(Objective objective, const Response& motion) {
  return row_of(objective).of(figures_of(motion));
}

}  // namespace stillpoint::design
