// SPDX-License-Identifier: MIT
#include <stillpoint/peers/comparison.hpp>

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/peers/methods.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <variant>

namespace stillpoint::peers {

namespace {

/// The effort of an integrator (methods.hpp), about 0.1 to 0.5 microseconds each. In steps, not
/// seconds, so that the result does not depend on the machine.
constexpr std::int64_t most_effort = 3'000'000;

bool is_free(const Scene& scene) {
  return std::holds_alternative<NoExcitation>(scene.excitation);
}

/// The largest rate at which the motion changes: its own, or the excitation's.
double rate(const Scene& scene) {
  return std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.lambda; }) {
          return std::max(scene.oscillator.p, kind.lambda);
        } else if constexpr (requires { kind.values; }) {
          const double last = duration(scene.excitation).value();
          return std::max(scene.oscillator.p,
                          last > 0 ? static_cast<double>(kind.values.size()) / last : 0);
        } else {
          return scene.oscillator.p;
        }
      },
      scene.excitation);
}

/// A motion that leaves its start has a turn, or moves or is elsewhere at the end.
bool moves(const Scene& scene, const Result& truth) {
  return truth.turns > 0 || truth.x != scene.start.x0 || truth.v != 0;
}

Size size_of(const Scene& scene, const Result& truth) {
  constexpr double least = std::numeric_limits<double>::min();  // p times a tiny peak may underflow
  return {std::max(truth.peak, least), std::max(scene.oscillator.p * truth.peak, least),
          1 / rate(scene)};
}

using Call = std::function<Result(const Scene&)>;

struct Contestant {
  MethodRow row;
  Call call;
};

/// Settings from coarse to fine, as a user would try them.
std::vector<Contestant> contestants(const Scene& scene, const Size& size) {
  std::vector<Contestant> list;
  const auto add = [&](const char* name, const std::optional<Setting>& setting, const Call& call) {
    list.push_back({{.name = name, .setting = setting}, call});
  };
  add("stillpoint", {}, kernel);
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    add("dopri5", Setting{"tolerance", tolerance},
        [=](const Scene& now) { return dopri5(now, tolerance, size, most_effort); });
  }
  for (const double part : {0.1, 0.01, 0.001}) {
    const double step = part / rate(scene);
    add("RK4", Setting{"step", step},
        [=](const Scene& now) { return runge_kutta4(now, step, most_effort); });
  }
  const bool holds_more =
      (scene.oscillator.delta > 0 && scene.oscillator.hold) || scene.oscillator.breakaway > 1;
  for (const double width : {1e-2, 1e-3}) {
    if (holds_more) {
      break;  // which the model does not know
    }
    add("regularised", Setting{"width", width},
        [=](const Scene& now) { return regularised(now, width, size, most_effort); });
  }
  return list;
}

void judge(MethodRow& row, const Scene& scene, const ExactResult& exact, const Size& size) {
  const Result& truth = exact.rounded;
  const Result& result = row.result;
  row.peak_error = exact.peak.error_of(result.peak) / size.length;
  const bool stops = truth.outcome != Outcome::running;
  const double of_time = exact.end_time.error_of(result.end_time);
  const double of_end = !stops           ? exact.v.error_of(result.v) / size.speed
                        : of_time == 0.0 ? 0.0
                                         : of_time / truth.end_time;
  row.end_error = std::max(exact.x.error_of(result.x) / size.length, of_end);
  row.counts_right = result.passages == truth.passages && result.turns == truth.turns &&
                     (is_free(scene) || result.sticks == truth.sticks) &&
                     result.outcome == truth.outcome;
}

/// The end of the run where none was asked for.
double far_enough(const SimulationRequest& request) {
  const Oscillator& oscillator = request.oscillator;
  const Start& start = request.start;
  const Excitation& excitation = request.excitation;
  const Surface& surface = request.surface;
  constexpr double past_the_rest = 4;
  constexpr double past_the_load = 1.25;
  constexpr double most_counted = 0x1p53;  // closed forms end however long a motion is
  std::optional<double> stop_time;
  if (!is_forced(request) && surface.plain()) {
    FreeOptions options;
    options.half_cycle_limit = most_half_cycles;
    const Response response = free_response(oscillator, start, options);
    if (response.half_cycles > most_counted) {
      throw TooManyHalfCycles(*response.half_cycles, most_counted);
    }
    stop_time = response.stop_time;
  } else {
    ForcedOptions options;
    options.half_cycle_limit = most_half_cycles;
    stop_time = forced_response(oscillator, start, excitation, options, surface).stop_time;
  }
  if (!stop_time) {
    throw InputError("f", oscillator.f,
                     "must be more than 0 if delta is 0: without friction the motion never stops");
  }
  // A rest under a load is final once the load is over.
  const double moving = *stop_time > 0 ? past_the_rest * *stop_time : 1;
  return std::max(moving, past_the_load * duration(excitation).value());
}

/// The largest t_end of a forced scene.
double longest(const Scene& scene) {
  constexpr double most = 3e4;  // of the faster of motion and load: a few seconds in 50 digits
  return most * std::numbers::pi / rate(scene);
}

}  // namespace

Scene comparison_scene(const SimulationRequest& request) {
  const double t_end = request.t_end ? *request.t_end : far_enough(request);
  Scene scene{request.oscillator, request.start, request.excitation, t_end, request.surface};
  if (!is_free(scene) && scene.t_end > longest(scene)) {
    throw InputError(
        "t-end", scene.t_end,
        fmt::format(
            "must be at most {:.3g} for this motion: up to there it is too long for 50 digits",
            longest(scene)));
  }
  return scene;
}

Comparison compare(const Scene& scene) {
  Comparison all;
  all.exact = exact(scene, most_half_cycles);
  const Size size = size_of(scene, all.exact.rounded);
  const bool moving = moves(scene, all.exact.rounded);
  const std::vector<Contestant> list = contestants(scene, size);
  std::vector<std::function<void()>> calls;
  for (const Contestant& one : list) {
    all.rows.push_back(one.row);
    if (!moving && !calls.empty()) {
      all.rows.back().run = Run::nothing_moves;
      continue;
    }
    calls.emplace_back([&, i = calls.size()] { all.rows[i].result = list[i].call(scene); });
  }
  const std::vector<Timing> timings = measure(calls, {.slow = 0.01});
  for (std::size_t i = 0; i < calls.size(); ++i) {
    MethodRow& row = all.rows[i];
    if (!row.result.finished) {
      row = list[i].row;
      row.run = Run::too_long;
      continue;
    }
    row.time = timings[i];
    judge(row, scene, all.exact, size);
  }
  return all;
}

}  // namespace stillpoint::peers
