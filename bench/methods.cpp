// SPDX-License-Identifier: MIT
#include "methods.hpp"

#include <stillpoint/peers/methods.hpp>

#include <cmath>
#include <cstddef>
#include <variant>

namespace stillpoint::bench {

namespace {

/// From `coarsest` down, each setting the previous one divided by `ratio`.
std::vector<double> ladder(double coarsest, double ratio, int rungs) {
  std::vector<double> settings;
  settings.reserve(static_cast<std::size_t>(rungs));
  for (int i = 0; i < rungs; ++i) {
    settings.push_back(coarsest / std::pow(ratio, i));
  }
  return settings;
}

/// Half decades from 1e-3 to 1e-13.
std::vector<double> tolerances() {
  return ladder(1e-3, std::sqrt(10.0), 21);
}

/// Fractions of the sample interval of a record, where every step has to end anyway; otherwise
/// fractions of tau = 1/4, four per factor of 2, down to 5e-4.
std::vector<double> steps(const Excitation& excitation) {
  const auto* record = std::get_if<Record>(&excitation);
  return record != nullptr ? ladder(record->step, 2, 5)
                           : ladder(0.25, std::sqrt(std::sqrt(2.0)), 37);
}

}  // namespace

std::vector<Method> methods(const peers::ReferenceScene& scene) {
  std::vector<Method> all;
  all.push_back({"stillpoint",
                 "this project's exact kernel, with times and decision margin; it has no setting",
                 "",
                 false,
                 {0},
                 [](const peers::Scene& s, double /*none*/) { return peers::kernel(s); }});
  all.push_back(
      {"dopri5",
       "Boost.Odeint's dopri5 with error control and events bracketed (TOMS 748) on its dense "
       "output; the absolute and relative tolerances are equal",
       "tolerance", true, tolerances(),
       [](const peers::Scene& s, double tolerance) { return peers::dopri5(s, tolerance); }});
  all.push_back(
      {"RK4",
       "the classical Runge-Kutta method with a fixed step, written out so that W is evaluated "
       "twice per step; the step brackets an event, and Newton's method finds it within the "
       "bracket on shorter steps",
       "step", true, steps(scene.scene.excitation),
       [](const peers::Scene& s, double step) { return peers::runge_kutta4(s, step); }});
  all.push_back(
      {"rk8pd",
       "GSL's rk8pd with gsl_odeiv2_evolve_apply; it has no dense output, so events are found "
       "as for RK4; the absolute and relative tolerances are equal",
       "tolerance", true, tolerances(), gsl_rk8pd});
#ifdef STILLPOINT_BENCH_CVODE
  all.push_back({"CVODE",
                 "SUNDIALS CVODE, Adams with fixed-point iteration, events by its own root finder",
                 "tolerance", false, tolerances(), cvode_adams});
#endif
  all.push_back({"regularised",
                 "tanh(v / width) instead of sgn, a bump of that width as the point friction, no "
                 "events; dopri5 with the tolerance width / 1000",
                 "width", false, ladder(1e-1, 10, 4),
                 [](const peers::Scene& s, double width) { return peers::regularised(s, width); }});
  return all;
}

}  // namespace stillpoint::bench
