// SPDX-License-Identifier: MIT
#include "pulse_mends.hpp"

#include "nearest_fit.hpp"
#include "pulse_region.hpp"

#include <stillpoint/core/oscillator.hpp>

#include <algorithm>
#include <string_view>

namespace stillpoint::design {

namespace {

/// Six decades of any input are more than a design has to spare, and leave it valid.
constexpr double far = 1e6;

struct Case {
  PulseProblem problem;
  Limits limits;

  [[nodiscard]] bool fits() const { return feasible(problem, limits); }

  void set_k(double k) {
    std::visit([k](auto& kind) { kind.k = k; }, problem.pulse);
  }
  void set_lambda(double lambda) {
    std::visit([lambda](auto& kind) { kind.lambda = lambda; }, problem.pulse);
  }
};

template <class Change>
void add(std::vector<Mend>& list, const Case& base, std::string_view field, double from, double to,
         const Change& change) {
  const auto fits = [&](double value) {
    Case changed = base;
    change(changed, value);
    return changed.fits();
  };
  if (const auto value = nearest_fit(from, to, fits)) {
    list.push_back({field, *value, *value > from});
  }
}

/// More p helps the amplitude and can only harm the stop, so both are asked one after the other:
/// without a limit of Delta, then without one of the amplitude.
void add_p(std::vector<Mend>& list, const Case& base) {
  const auto with = [&](double p) {
    Case changed = base;
    changed.problem.p = p;
    return changed;
  };
  const double p = base.problem.p;
  const auto raised = nearest_fit(p, angular_frequency(base.problem.pulse), [&](double value) {
    Case wide = with(value);
    wide.limits.delta_max = std::nullopt;
    return wide.fits();
  });
  if (!raised) {
    return;
  }
  const double v0 = problem_at(base.problem, 0).v0;
  const auto value = nearest_fit(*raised, p / far, [&](double lower) {
    Case wide = with(lower);
    wide.problem.beta = 2 * v0 / lower;  // twice the peak without friction
    return wide.fits();
  });
  if (value && with(*value).fits()) {
    list.push_back({"p", *value, *value > p});
  }
}

}  // namespace

std::vector<Mend> mends(const PulseProblem& problem, const Limits& limits) {
  const Case base{problem, limits};
  std::vector<Mend> list;
  if (base.fits()) {
    return list;
  }
  const double k = peak_load(problem.pulse);
  const double lambda = angular_frequency(problem.pulse);
  const double most_lambda = std::min(lambda * far, problem.p * 1e12);
  add(list, base, "k", k, k / far, [](Case& now, double value) { now.set_k(value); });
  add(list, base, "lambda", lambda, most_lambda,
      [](Case& now, double value) { now.set_lambda(value); });
  add_p(list, base);
  add(list, base, "beta", problem.beta, problem.beta * far,
      [](Case& now, double value) { now.problem.beta = value; });
  if (limits.f_max) {
    add(list, base, "f_max", *limits.f_max, *limits.f_max * far,
        [](Case& now, double value) { now.limits.f_max = value; });
  }
  if (limits.delta_max) {
    add(list, base, "delta_max", *limits.delta_max, *limits.delta_max * far,
        [](Case& now, double value) { now.limits.delta_max = value; });
  }
  if (limits.tolerance > 0) {
    add(list, base, "tolerance", limits.tolerance, 0.0,
        [](Case& now, double value) { now.limits.tolerance = value; });
  }
  return list;
}

}  // namespace stillpoint::design
