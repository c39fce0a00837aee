// SPDX-License-Identifier: MIT
#include "pulse_mends.hpp"

#include "mend_list.hpp"
#include "nearest_fit.hpp"
#include "pulse_region.hpp"

#include <stillpoint/core/oscillator.hpp>

#include <algorithm>
#include <string_view>

namespace stillpoint::design {

namespace {

/// Six decades of any input are more than a design has to spare, and leave it valid.
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
  const double k = peak_load(problem.pulse);
  const double lambda = angular_frequency(problem.pulse);
  const double most_lambda = std::min(lambda * far, problem.p * longest_ratio);
  add_mend(list, base, fits, "k", k, k / far, [](Case& now, double value) { now.set_k(value); });
  add_mend(list, base, fits, "lambda", lambda, most_lambda,
           [](Case& now, double value) { now.set_lambda(value); });
  add_p(list, base);
  add_mend(list, base, fits, "beta", problem.beta, problem.beta * far,
           [](Case& now, double value) { now.problem.beta = value; });
  add_limit_mends(list, base, fits);
  return list;
}

}  // namespace stillpoint::design
