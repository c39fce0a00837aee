// SPDX-License-Identifier: MIT
#include "pulse/task.hpp"

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

namespace {

/// The best f of the samples and of the ends, a start for NLopt; the middle for `robust`.
double start_of(const PulseTask& task) {
  const auto [low, high] = task.middles();
  if (task.objective == Objective::robust) {
    return std::clamp(std::sqrt(task.part.low) * std::sqrt(task.part.high), low, high);
  }
  PulseBest best;
  best.consider(task, low);
  best.consider(task, high);
  for (const FirstReturn& now : task.region.profile()->samples()) {
    if (low < now.f && now.f < high) {
      best.consider(task, now.f);
    }
  }
  return *best.f;
}

/// By the difference to a value nearby, above it if that is within bounds.
template <class Value>
double slope(const Value& value, double at, const Island& within) {
  constexpr double part = 1e-7;
  const double above = at * (1 + part);
  const double other = above <= within.high ? above : std::max(within.low, at * (1 - part));
  return other != at ? (value(other) - value(at)) / (other - at) : 0;
}

/// The least cost of x = f / high of the interval.
NloptProblem along_f(const PulseTask& task, double scale,
                     const std::function<void(double)>& visit) {
  const double unit = task.part.high;
  const Island middles = task.middles();
  NloptProblem posed;
  posed.lower = Eigen::VectorXd::Constant(1, middles.low / unit);
  posed.upper = Eigen::VectorXd::Constant(1, middles.high / unit);
  posed.start = Eigen::VectorXd::Constant(1, start_of(task) / unit);
  posed.objective = [=, &task](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
    const double f = std::clamp(x[0] * unit, middles.low, middles.high);
    visit(f);
    const auto cost = [&](double now) { return task.cost(now) / scale; };
    if (gradient.size() > 0) {
      gradient[0] = slope(cost, f, middles) * unit;
    }
    return cost(f);
  };
  return posed;
}

void store(Eigen::VectorXd& gradient, double by_x, double by_t) {
  gradient = Eigen::Vector2d(by_x, by_t).head(gradient.size());
}

/// The box lies in the interval.
void add_edges(NloptProblem& posed, const PulseTask& task) {
  const double least = task.part.low / task.part.high;
  const double down = task.region.shape().f_low;
  const double up = task.region.shape().f_high;
  posed.constraints.emplace_back([=](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
    store(gradient, -(1 - down * x[1]), down * x[0]);
    return least - x[0] * (1 - down * x[1]);
  });
  posed.constraints.emplace_back([=](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
    store(gradient, 1 + up * x[1], up * x[0]);
    return x[0] * (1 + up * x[1]) - 1;
  });
}

/// NLopt converges on the edge of delta_max from outside.
double most_use(const PulseTask& task) {
  constexpr double inset = 1e-9;
  return task.most_use * (1 - inset);
}

/// delta_max allows the need at that end of the box: `side` is -1 or 1 times its part of t.
void add_need(NloptProblem& posed, const PulseTask& task, double side) {
  posed.constraints.emplace_back([=, &task](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
    const auto& [low, high] = task.part;
    const Criterion criterion = task.region.criterion();
    const double t = x[1];
    const double unclamped = x[0] * high * (1 + side * t);
    const double end = std::clamp(unclamped, low, high);
    const double use = task.region.use_per_need(t) * task.known.at(end).need(criterion);
    if (gradient.size() > 0) {
      const double by_end =
          end == unclamped ? task.region.use_per_need(t) * task.known.need_slope(end, criterion)
                           : 0;
      store(gradient, by_end * (1 + side * t) * high,
            by_end * side * x[0] * high + use * task.region.use_growth(t));
    }
    return use - most_use(task);
  });
}

/// The same between both ends.
void add_need_between(NloptProblem& posed, const PulseTask& task) {
  posed.constraints.emplace_back([&task](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
    const BoxShape& shape = task.region.shape();
    const double f = x[0] * task.part.high;
    const double use =
        task.region.use_per_need(x[1]) *
        task.region.profile()->need_of_samples(
            f * (1 - shape.f_low * x[1]), f * (1 + shape.f_high * x[1]), task.region.criterion());
    store(gradient, 0, use * task.region.use_growth(x[1]));
    return use - most_use(task);
  });
}

/// x = f / high of the interval, and t: the least -t with
///   low / high - x (1 - t) <= 0,  x (1 + t) - 1 <= 0,  need (1 + t) / ((1 - t) delta_max) - 1 <=
///   0 at each end of the box, and between them,
/// t times the part of its own on each side.
NloptProblem over_boxes(const PulseTask& task, const std::function<void(double)>& visit) {
  const auto& [low, high] = task.part;
  const double asked = task.region.asked();
  NloptProblem posed;
  posed.lower = Eigen::Vector2d(low / high, asked);
  posed.upper = Eigen::Vector2d(1, task.region.most_tolerance());
  posed.start = Eigen::Vector2d(start_of(task) / high, asked);
  posed.objective = [visit, unit = high](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
    visit(x[0] * unit);
    store(gradient, 0, -1);
    return -x[1];
  };
  add_edges(posed, task);
  if (std::isfinite(task.region.delta_max())) {
    add_need(posed, task, -task.region.shape().f_low);
    add_need(posed, task, task.region.shape().f_high);
    if (task.has_top()) {
      add_need_between(posed, task);
    }
  }
  return posed;
}

}  // namespace

NloptProblem posed(const PulseTask& task, const NloptAlgorithm& algorithm, double scale,
                   const std::function<void(double)>& visit) {
  return task.objective == Objective::robust && algorithm.constraints == ConstraintSupport::yes
             ? over_boxes(task, visit)
             : along_f(task, scale, visit);
}

}  // namespace stillpoint::design
