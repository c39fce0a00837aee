// SPDX-License-Identifier: MIT
#include "nearest_fit.hpp"
#include "pulse/region.hpp"
#include "region/mend_list.hpp"

#include <stillpoint/core/cancellation.hpp>
#include <stillpoint/core/oscillator.hpp>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace stillpoint::design {

namespace {

/// Six decades of any input are more than any design needs, and keep it valid.
constexpr double far_factor = 1e6;

/// A region is expensive: a change is the least to this part of it.
constexpr double close = 1e-10;

struct PulseCase {
  PulseProblem problem;
  Limits limits;
  /// Only of lambda, p and the ranges, in units of k; empty where one of them has changed.
  std::shared_ptr<const WorstReturn> profile;
};

/// What the motions depend on.
template <class Set>
auto of_motions(const Set& set) {
  return [set](PulseCase& now, double value) {
    set(now, value);
    now.profile.reset();
  };
}

void set_k(PulseCase& now, double k) {
  now.problem.pulse = with(now.problem.pulse, k, angular_frequency(now.problem.pulse));
}

void set_lambda(PulseCase& now, double lambda) {
  now.problem.pulse = with(now.problem.pulse, peak_load(now.problem.pulse), lambda);
}

/// What a motion costs, in those of a short pulse: measured are 0.15 us and as much for each radian
/// of the spring in 1/lambda, and 40 us without a closed form.
double cost_of(const PulseProblem& problem) {
  constexpr double without_form = 250;
  const double lambda = angular_frequency(problem.pulse);
  const double p = problem.p_high.value_or(problem.p);
  const bool closed =
      problem.zeta == 0 && closed_return(unit_pulse(problem.pulse, problem.p), 0.5).has_value();
  return closed ? 1 + p / lambda : without_form;
}

/// Counts what the changes cost. It does not look at a clock, so that every machine finds the same.
class Budget {
 public:
  void costs(double each) { each_ = each; }

  /// What `search` finds before it has spent a fair share of the rest.
  template <class Search>
  std::optional<Mend> within(const Search& search, std::size_t searches_left) {
    const double least = left_ - left_ / static_cast<double>(searches_left);
    bool spent = false;
    const Cancellable limited([&] {
      left_ -= each_;
      spent = left_ < least;
      return !spent;
    });
    try {
      return search();
    } catch (const Cancelled&) {
      if (!spent) {
        throw;
      }
      was_spent_ = true;
      return std::nullopt;
    }
  }
  [[nodiscard]] bool was_spent() const { return was_spent_; }

 private:
  static constexpr double all = 5e6;  // more than half a second
  double left_{all};
  double each_{1};
  bool was_spent_{false};
};

/// The same with one pulse and one spring.
PulseCase alone(PulseCase now, double k, double lambda, double p) {
  now.problem.pulse = with(now.problem.pulse, k, lambda);
  now.problem.p = p;
  now.problem.p_high = {};
  now.problem.ranges = {};
  return now;
}

/// Around the f that suit the single pulses and springs at the ends of the ranges: any that suits
/// all of them is one of these.
std::optional<Interval> window_of(const PulseCase& now) {
  const PulseProblem& problem = now.problem;
  const double k = peak_load(problem.pulse);
  const double lambda = angular_frequency(problem.pulse);
  const double shortest = problem.ranges.lambda_high.value_or(lambda);
  std::vector<std::pair<double, double>> ends{{lambda, problem.p_high.value_or(problem.p)}};
  for (const auto& end : {std::pair(lambda, problem.p), std::pair(shortest, problem.p)}) {
    if (end != ends.back()) {
      ends.push_back(end);
    }
  }
  Interval window{0, HUGE_VAL};
  for (const auto& [length, spring] : ends) {
    const PulseCase strongest = alone(now, k, length, spring);
    const auto profile = std::make_shared<const WorstReturn>(strongest.problem);
    for (const double load : {k, problem.ranges.k_low.value_or(k)}) {
      const PulseCase one = alone(now, load, length, spring);
      const auto suits = PulseRegion(profile, one.problem, one.limits).around_boxes();
      if (!suits) {
        return std::nullopt;
      }
      window = {std::max(window.low, suits->low * load / k),
                std::min(window.high, suits->high * load / k)};
    }
  }
  return window.low <= window.high ? std::optional(Interval{window.low, std::min(1.0, window.high)})
                                   : std::nullopt;
}

bool fits(const PulseCase& now) {
  if (now.profile) {
    return PulseRegion(now.profile, now.problem, now.limits).feasible();
  }
  if (!now.problem.has_ranges()) {
    return PulseRegion(now.problem, now.limits).feasible();
  }
  const auto window = window_of(now);
  return window && PulseRegion(std::make_shared<const WorstReturn>(now.problem, false, *window),
                               now.problem, now.limits)
                       .feasible();
}

/// In units of k a weaker pulse is a larger beta and larger limits: it can only help. So does a
/// range that is narrower.
std::vector<Input<PulseCase>> inputs_of(const PulseProblem& problem) {
  constexpr double growth = 1.12;
  constexpr double above_rounding = 1 + 1e-12;
  const auto& [k_low, lambda_high] = problem.ranges;
  const double k = peak_load(problem.pulse);
  const double lambda = angular_frequency(problem.pulse);
  const double p = problem.p;
  const double stiffest = problem.p_high.value_or(p);
  const double shortest = lambda_high.value_or(lambda);
  std::vector<Input<PulseCase>> list;
  if (k_low) {
    const auto set_low = [](PulseCase& now, double value) { now.problem.ranges.k_low = value; };
    list = {{"k_low", *k_low, k, of_motions(set_low)}, {"k_high", k, *k_low, of_motions(set_k)}};
  } else {
    list = {{"k", k, k / far_factor, set_k}};
  }
  if (lambda_high) {
    const auto set_high = [](PulseCase& now, double value) {
      now.problem.ranges.lambda_high = value;
    };
    list.push_back({"lambda_low", lambda, shortest, of_motions(set_lambda)});
    list.push_back({"lambda_high", shortest, lambda, of_motions(set_high)});
  } else {
    const double longest = std::max(lambda / far_factor, stiffest / slowest_examined);
    list.push_back({"lambda", lambda, std::min(lambda * far_factor, p * fastest_pulse),
                    of_motions(set_lambda), std::min(lambda, longest), growth});
  }
  const auto set_p = of_motions(in_problem(&PulseProblem::p));
  if (problem.p_high) {
    list.push_back({"p_low", p, stiffest, set_p});
    list.push_back({"p_high", stiffest, p, of_motions(in_problem(&PulseProblem::p_high))});
  } else {
    const double softest = std::max(p / far_factor, shortest / fastest_pulse * above_rounding);
    list.push_back({"p", p, std::max(p, std::min(p * far_factor, lambda * slowest_examined)), set_p,
                    softest, growth});
  }
  list.push_back(
      {"beta", problem.beta, problem.beta * far_factor, in_problem(&PulseProblem::beta)});
  return list;
}

}  // namespace

std::optional<Criterion> criterion_mend(const PulseProblem& problem, const Limits& limits,
                                        const std::shared_ptr<const WorstReturn>& profile) {
  const PulseCase base{problem, limits, profile};  // the motions do not depend on the criterion
  return fits(base) ? std::nullopt : exact_if_it_fits(base, fits);
}

PulseMends mends(const PulseProblem& problem, const Limits& limits,
                 const std::shared_ptr<const WorstReturn>& profile) {
  const PulseCase base{problem, limits, profile};
  if (fits(base)) {
    return {};
  }
  Budget budget;
  const auto tried = [&budget](const PulseCase& now) {
    budget.costs(cost_of(now.problem));
    return fits(now);
  };
  std::vector<Input<PulseCase>> inputs = inputs_of(problem);
  std::ranges::move(limit_inputs<PulseCase>(limits), std::back_inserter(inputs));
  PulseMends found;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto search = [&] { return inputs[i].mend(base, tried, close); };
    if (const auto mend = budget.within(search, inputs.size() - i)) {
      found.list.push_back(*mend);
    }
  }
  found.cut_short = budget.was_spent();
  return found;
}

}  // namespace stillpoint::design
