// SPDX-License-Identifier: MIT
#include "accuracy.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/peers/kernel.hpp>
#include <stillpoint/peers/methods.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <variant>

namespace stillpoint::cli {

namespace {

/// As many take some seconds in 50 digits.
constexpr double most_half_cycles = 1e5;
/// Of an integrator; as many take some seconds.
constexpr double most_steps = 2e7;

bool is_free(const SimulateInput& input) {
  return !input.excitation;
}

/// The largest rate at which the motion changes: its own, or the excitation's.
double rate(const peers::Scene& scene) {
  return std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.lambda; }) {
          return std::max(scene.oscillator.p, kind.lambda);
        } else if constexpr (requires { kind.values; }) {
          const double last = duration(scene.excitation);
          return std::max(scene.oscillator.p,
                          last > 0 ? static_cast<double>(kind.values.size()) / last : 0);
        } else {
          return scene.oscillator.p;
        }
      },
      scene.excitation);
}

/// Up to when the integrators are followed: past the rest, so that they have room to miss it.
double far_enough(const SimulateInput& input) {
  constexpr double past_the_rest = 4;
  if (input.t_end) {
    return *input.t_end;
  }
  std::optional<double> stop_time;
  if (is_free(input)) {
    Ask ask;
    ask.half_cycle_limit = most_half_cycles;
    stop_time = free_response(input.oscillator, input.start, ask).stop_time;
  } else {
    ForcedAsk ask;
    ask.half_cycle_limit = most_half_cycles;
    stop_time =
        forced_response(input.oscillator, input.start, input.excitation->excitation, ask).stop_time;
  }
  if (!stop_time) {
    throw UsageError("the motion never stops: give it some friction, or an excitation and --t-end");
  }
  return *stop_time > 0 ? past_the_rest * *stop_time : 1;
}

peers::Scene scene_of(const SimulateInput& input) {
  peers::Scene scene{input.oscillator, input.start,
                     input.excitation ? input.excitation->excitation : NoExcitation{},
                     far_enough(input)};
  if (!is_free(input) && scene.t_end * rate(scene) > most_half_cycles * std::numbers::pi) {
    throw UsageError(fmt::format(
        "t-end = {}: the motion up to there is too long for 50 digits, at most {:.3g} for this one",
        scene.t_end, most_half_cycles * std::numbers::pi / rate(scene)));
  }
  return scene;
}

std::string reason(const SimulateInput& input) {
  const auto& [p, f, delta] = input.oscillator;
  if (is_free(input)) {
    return f > 0 && delta > 0
               ? "the half-cycle map is exact from peak to peak, one square root each, and has no "
                 "step or tolerance to choose"
               : "one friction alone ends in a closed form, an exact remainder, however many "
                 "half-cycles it takes";
  }
  return std::holds_alternative<Record<>>(input.excitation->excitation)
             ? "between samples the motion is a closed form with constant coefficients, and each "
               "interval is proved to hold no event or searched for it"
             : "between events the motion is a closed form, and the first event is found by a "
               "bound "
               "that cannot step over it";
}

using Call = std::function<peers::Result(const peers::Scene&)>;

struct Contestant {
  std::string_view name;
  std::string setting;
  double steps;  ///< about so many, for the scene
  Call call;
};

/// Settings from coarse to fine, as somebody would try them.
std::vector<Contestant> contestants(const peers::Scene& scene, double speed) {
  std::vector<Contestant> list;
  const double length = scene.t_end * rate(scene);
  list.push_back({"stillpoint", "", 0, peers::kernel});
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    list.push_back({"dopri5", fmt::format("tolerance {:.0e}", tolerance),
                    length * std::pow(tolerance, -0.2),
                    [=](const peers::Scene& now) { return peers::dopri5(now, tolerance); }});
  }
  for (const double part : {0.1, 0.01, 0.001}) {
    const double step = part / rate(scene);
    list.push_back({"RK4", fmt::format("step {:.3g}", step), length / part,
                    [=](const peers::Scene& now) { return peers::runge_kutta4(now, step); }});
  }
  for (const double part : {1e-2, 1e-3}) {
    const double width = part * speed;
    list.push_back({"regularised", fmt::format("width {:.2g}", width), length / part * 10,
                    [=](const peers::Scene& now) { return peers::regularised(now, width); }});
  }
  return list;
}

void judge(MethodFigures& figures, const peers::Scene& scene, const peers::ExactResult& exact) {
  const peers::Result& truth = exact.rounded;
  const peers::Result& result = figures.result;
  figures.peak_error = exact.peak.error_of(result.peak);
  const bool stops = truth.outcome != Outcome::running;
  figures.end_error =
      std::max(exact.x.error_of(result.x),
               stops ? exact.end_time.error_of(result.end_time) : exact.v.error_of(result.v));
  figures.counts_right =
      result.passages == truth.passages && result.turns == truth.turns &&
      (std::holds_alternative<NoExcitation>(scene.excitation) || result.sticks == truth.sticks) &&
      result.outcome == truth.outcome;
}

}  // namespace

AccuracyAnswer compare_methods(const SimulateInput& input) {
  AccuracyAnswer answer;
  answer.scene = scene_of(input);
  answer.exact = peers::exact(answer.scene, most_half_cycles);
  answer.why = reason(input);
  const double speed = std::max(answer.exact.rounded.peak * answer.scene.oscillator.p, 1e-300);
  std::vector<std::function<void()>> calls;
  std::vector<std::size_t> timed;
  for (const Contestant& one : contestants(answer.scene, speed)) {
    MethodFigures figures;
    figures.name = one.name;
    figures.setting = one.setting;
    figures.used = answer.methods.empty();
    figures.too_long = one.steps > most_steps;
    if (!figures.too_long) {
      figures.result = one.call(answer.scene);
      judge(figures, answer.scene, answer.exact);
      timed.push_back(answer.methods.size());
      calls.emplace_back([&scene = answer.scene, call = one.call] {
        volatile double sink = call(scene).peak;
        static_cast<void>(sink);
      });
    }
    answer.methods.push_back(std::move(figures));
  }
  peers::MeasureOptions options;
  options.slow = 0.05;
  const std::vector<peers::Timing> timings = peers::measure(calls, options);
  for (std::size_t i = 0; i < timed.size(); ++i) {
    answer.methods[timed[i]].time = timings[i];
  }
  return answer;
}

}  // namespace stillpoint::cli
