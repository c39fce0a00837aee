// SPDX-License-Identifier: MIT
#include "nearest_fit.hpp"
#include "pulse/region.hpp"
#include "region/mend_list.hpp"

#include <stillpoint/core/cancellation.hpp>
#include <stillpoint/core/oscillator.hpp>

#include <algorithm>
#include <functional>
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

/// What a motion costs, in those of a short pulse: measured are 0.15 us and as much for each radian
/// of the spring in 1/lambda, and 40 us without a closed form.
double cost_of(const PulseProblem& problem) {
  constexpr double without_form = 250;
  const double lambda = angular_frequency(problem.pulse);
  const double p = problem.p_high.value_or(problem.p);
  const bool closed = closed_return(unit_pulse(problem.pulse, problem.p), 0.5).has_value();
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
  std::visit(
      [&](auto& kind) {
        kind.k = k;
        kind.lambda = lambda;
      },
      now.problem.pulse);
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

/// The searches for a change of one input each.
class Searches {
 public:
  Searches(const PulseCase& base, Budget& budget) : base_(base), budget_(budget) {}

  void add(const Input<PulseCase>& input) {
    list_.emplace_back([this, input]() -> std::optional<Mend> {
      const auto value = nearest_fit(
          input.from, input.to, [&](double now) { return tried(input.in(base_, now)); }, close);
      return value ? std::optional(input.mend(*value)) : std::nullopt;
    });
  }
  /// By steps that grow.
  void add_either_way(std::string_view field, double from, double least, double most,
                      void (*set)(PulseCase&, double)) {
    list_.emplace_back([=, this]() -> std::optional<Mend> {
      constexpr double growth = 1.12;
      const auto value = nearest_either_way(
          from, least, most, growth,
          [&](double now) {
            PulseCase changed = base_;
            set(changed, now);
            return tried(changed);
          },
          close);
      return value ? std::optional(Mend{field, *value, *value > from}) : std::nullopt;
    });
  }
  [[nodiscard]] std::vector<Mend> found() const {
    std::vector<Mend> mends;
    for (std::size_t i = 0; i < list_.size(); ++i) {
      if (const auto mend = budget_.within(list_[i], list_.size() - i)) {
        mends.push_back(*mend);
      }
    }
    return mends;
  }

 private:
  [[nodiscard]] bool tried(const PulseCase& now) const {
    budget_.costs(cost_of(now.problem));
    return fits(now);
  }

  const PulseCase& base_;
  Budget& budget_;
  std::vector<std::function<std::optional<Mend>()>> list_;
};

/// In units of k a weaker pulse is a larger beta and larger limits: it can only help. So does a
/// range that is narrower.
void add_load(Searches& searches, const PulseProblem& problem) {
  const auto& [k_low, lambda_high] = problem.ranges;
  const double k = peak_load(problem.pulse);
  if (k_low) {
    searches.add({"k_low", *k_low, k, [](PulseCase& now, double value) {
                    now.problem.ranges.k_low = value;
                    now.profile.reset();
                  }});
    searches.add({"k_high", k, *k_low, set_k});
  } else {
    searches.add({"k", k, k / far_factor, set_k});
  }
  const double p = problem.p;
  const double lambda = angular_frequency(problem.pulse);
  if (lambda_high) {
    searches.add({"lambda_low", lambda, *lambda_high, set_lambda});
    searches.add({"lambda_high", *lambda_high, lambda, [](PulseCase& now, double value) {
                    now.problem.ranges.lambda_high = value;
                    now.profile.reset();
                  }});
  } else {
    const double longest =
        std::max(lambda / far_factor, problem.p_high.value_or(p) / slowest_examined);
    searches.add_either_way("lambda", lambda, std::min(lambda, longest),
                            std::min(lambda * far_factor, p * fastest_pulse), set_lambda);
  }
}

void add_spring(Searches& searches, const PulseProblem& problem) {
  const double p = problem.p;
  const double lambda = angular_frequency(problem.pulse);
  if (problem.p_high) {
    searches.add({"p_low", p, *problem.p_high, set_p});
    searches.add({"p_high", *problem.p_high, p, [](PulseCase& now, double value) {
                    now.problem.p_high = value;
                    now.profile.reset();
                  }});
  } else {
    const double softest =
        std::max(p / far_factor, problem.ranges.lambda_high.value_or(lambda) / fastest_pulse);
    searches.add_either_way(
        "p", p, softest, std::max(p, std::min(p * far_factor, lambda * slowest_examined)), set_p);
  }
}

}  // namespace

std::optional<Criterion> criterion_mend(const PulseProblem& problem, const Limits& limits,
                                        const std::shared_ptr<const WorstReturn>& profile) {
  PulseCase exact{problem, limits, profile};
  if (problem.criterion == Criterion::exact || fits(exact)) {
    return std::nullopt;
  }
  exact.problem.criterion = Criterion::exact;  // on which the motions do not depend
  return fits(exact) ? std::optional(Criterion::exact) : std::nullopt;
}

PulseMends mends(const PulseProblem& problem, const Limits& limits,
                 const std::shared_ptr<const WorstReturn>& profile) {
  const PulseCase base{problem, limits, profile};
  if (fits(base)) {
    return {};
  }
  Budget budget;
  Searches searches(base, budget);
  add_load(searches, problem);
  add_spring(searches, problem);
  searches.add({"beta", problem.beta, problem.beta * far_factor,
                [](PulseCase& now, double value) { now.problem.beta = value; }});
  for (const Input<PulseCase>& limit : limit_inputs<PulseCase>(limits)) {
    searches.add(limit);
  }
  std::vector<Mend> found = searches.found();
  return {std::move(found), budget.was_spent()};
}

}  // namespace stillpoint::design
