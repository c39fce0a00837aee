// SPDX-License-Identifier: MIT
#include "pulse_region.hpp"

#include "mend_list.hpp"
#include "nearest_fit.hpp"

#include <stillpoint/core/oscillator.hpp>

#include <algorithm>

namespace stillpoint::design {

namespace {

/// Six decades of any input are more than any design can use, and keep it valid.
constexpr double far = 1e6;
/// Of lambda to p, as require_valid has it.
constexpr double longest_ratio = 1e12;

struct Case {
  PulseProblem problem;
  Limits limits;

  void set_k(double k) {
    std::visit([k](auto& kind) { kind.k = k; }, problem.pulse);
  }
  void set_lambda(double lambda) {
    std::visit([lambda](auto& kind) { kind.lambda = lambda; }, problem.pulse);
  }
};

bool fits(const Case& now) {
  return feasible(PulseTask(now.problem, now.limits));
}

Input<Case> k_of(const PulseProblem& problem) {
  const double k = peak_load(problem.pulse);
  return {"k", k, k / far, [](Case& now, double value) { now.set_k(value); }};
}

Input<Case> lambda_of(const PulseProblem& problem) {
  const double lambda = angular_frequency(problem.pulse);
  return {"lambda", lambda, std::min(lambda * far, problem.p * longest_ratio),
          [](Case& now, double value) { now.set_lambda(value); }};
}

Input<Case> beta_of(const PulseProblem& problem) {
  return {"beta", problem.beta, problem.beta * far,
          [](Case& now, double value) { now.problem.beta = value; }};
}

/// More p helps the amplitude and can only harm the stop, so both are tested one after the other:
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
    return fits(wide);
  });
  if (!raised) {
    return;
  }
  const double v0 = problem_at(base.problem, 0).v0;
  // A forced run reaches no further.
  const double least = std::max(p / far, angular_frequency(base.problem.pulse) / longest_ratio);
  const auto value = nearest_fit(*raised, least, [&](double lower) {
    Case wide = with(lower);
    wide.problem.beta = 2 * v0 / lower;  // twice the peak without friction
    return fits(wide);
  });
  if (value && fits(with(*value))) {
    list.push_back({"p", *value, *value > p});
  }
}

}  // namespace

std::vector<Mend> mends(const PulseProblem& problem, const Limits& limits) {
  const Case base{problem, limits};
  std::vector<Mend> list;
  if (fits(base)) {
    return list;
  }
  add_mend(list, base, fits, k_of(problem));
  add_mend(list, base, fits, lambda_of(problem));
  add_p(list, base);
  add_mend(list, base, fits, beta_of(problem));
  for (const Input<Case>& limit : limit_inputs<Case>(limits)) {
    add_mend(list, base, fits, limit);
  }
  return list;
}

std::optional<JointMend> joint_mend(const PulseProblem& problem, const Limits& limits) {
  const Case base{problem, limits};
  if (fits(base) || !mends(problem, limits).empty()) {
    return std::nullopt;
  }
  return joint_mend_of(base, fits, {beta_of(problem), k_of(problem), lambda_of(problem)});
}

}  // namespace stillpoint::design
