// SPDX-License-Identifier: MIT
#include "pulse/region.hpp"

#include "nearest_fit.hpp"
#include "region/mend_list.hpp"

#include <stillpoint/core/oscillator.hpp>

#include <algorithm>
#include <optional>

namespace stillpoint::design {

namespace {

/// Six decades of any input are more than any design needs, and keep it valid.
constexpr double far = 1e6;

struct PulseCase {
  PulseProblem problem;
  Limits limits;
  /// Only of lambda, p and the ranges, in units of k; empty where one of them has changed.
  std::shared_ptr<const WorstReturn> profile;
};

void set_k(PulseCase& now, double k) {
  std::visit([k](auto& kind) { kind.k = k; }, now.problem.pulse);
  if (now.problem.ranges.k_low) {
    now.profile.reset();
  }
}

void set_lambda(PulseCase& now, double lambda) {
  std::visit([lambda](auto& kind) { kind.lambda = lambda; }, now.problem.pulse);
  now.profile.reset();
}

void set_p(PulseCase& now, double p) {
  now.problem.p = p;
  now.profile.reset();
}

bool fits(const PulseCase& now) {
  const auto profile = now.profile ? now.profile : std::make_shared<const WorstReturn>(now.problem);
  return PulseRegion(profile, now.problem, now.limits).feasible();
}

/// By steps that grow: a region is expensive.
std::optional<double> nearest_either_way(const PulseCase& base, double from, double least,
                                         double most, void (*set)(PulseCase&, double)) {
  constexpr double growth = 1.12;
  return design::nearest_either_way(from, least, most, growth, [&](double value) {
    PulseCase changed = base;
    set(changed, value);
    return fits(changed);
  });
}

}  // namespace

std::optional<Criterion> criterion_mend(const PulseProblem& problem, const Limits& limits) {
  PulseCase exact{problem, limits, std::make_shared<WorstReturn>(problem)};
  if (problem.criterion == Criterion::exact || fits(exact)) {
    return std::nullopt;
  }
  exact.problem.criterion = Criterion::exact;  // on which the motions do not depend
  return fits(exact) ? std::optional(Criterion::exact) : std::nullopt;
}

std::vector<Mend> mends(const PulseProblem& problem, const Limits& limits) {
  const PulseCase base{problem, limits, std::make_shared<WorstReturn>(problem)};
  std::vector<Mend> list;
  if (fits(base)) {
    return list;
  }
  const auto add = [&](const Input<PulseCase>& input) { add_mend(list, base, fits, input); };
  const auto& [k_low, lambda_high] = problem.ranges;
  // In units of k a weaker pulse is a larger beta and larger limits: it can only help. So does a
  // range that is narrower.
  const double k = peak_load(problem.pulse);
  if (k_low) {
    add({"k_low", *k_low, k, [](PulseCase& now, double value) {
           now.problem.ranges.k_low = value;
           now.profile.reset();
         }});
    add({"k_high", k, *k_low, set_k});
  } else {
    add({"k", k, k / far, set_k});
  }
  const double p = problem.p;
  const double lambda = angular_frequency(problem.pulse);
  if (lambda_high) {
    add({"lambda_low", lambda, *lambda_high, set_lambda});
    add({"lambda_high", *lambda_high, lambda, [](PulseCase& now, double value) {
           now.problem.ranges.lambda_high = value;
           now.profile.reset();
         }});
  } else if (const auto value = nearest_either_way(
                 base, lambda,
                 std::min(lambda,
                          std::max(lambda / far, problem.p_high.value_or(p) / slowest_examined)),
                 std::min(lambda * far, p * fastest_pulse), set_lambda)) {
    list.push_back({"lambda", *value, *value > lambda});
  }
  if (problem.p_high) {
    add({"p_low", p, *problem.p_high, set_p});
    add({"p_high", *problem.p_high, p, [](PulseCase& now, double value) {
           now.problem.p_high = value;
           now.profile.reset();
         }});
  } else if (const auto value = nearest_either_way(
                 base, p, std::max(p / far, lambda_high.value_or(lambda) / fastest_pulse),
                 std::max(p, std::min(p * far, lambda * slowest_examined)), set_p)) {
    list.push_back({"p", *value, *value > p});
  }
  add({"beta", problem.beta, problem.beta * far,
       [](PulseCase& now, double value) { now.problem.beta = value; }});
  for (const Input<PulseCase>& limit : limit_inputs<PulseCase>(limits)) {
    add(limit);
  }
  return list;
}

}  // namespace stillpoint::design
