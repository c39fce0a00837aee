// SPDX-License-Identifier: MIT
#include "comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <utility>
#include <variant>

namespace stillpoint::bench {

namespace {

Verdict judge(const peers::ReferenceScene& scene, const peers::Result& result) {
  const peers::Result& truth = scene.truth;
  Verdict verdict;
  verdict.peak = std::abs(result.peak - truth.peak);
  verdict.end = scene.free ? std::abs(result.end_time - truth.end_time)
                           : std::max(std::abs(result.x - truth.x), std::abs(result.v - truth.v));
  verdict.counts = counts_of(result);
  verdict.counts_right = result.finished && verdict.counts == counts_of(truth) &&
                         (!scene.free || result.outcome == truth.outcome);
  return verdict;
}

SceneRows compare(const peers::ReferenceScene& scene, const peers::MeasureOptions& options) {
  SceneRows found{scene, {}};
  std::vector<std::function<void()>> calls;
  volatile double sink = 0;
  for (Method& method : methods(scene)) {
    MethodRows& rows = found.methods.emplace_back(MethodRows{std::move(method), {}});
    for (const double setting : rows.method.settings) {
      const auto run = [&sink, &input = scene.scene, setting, call = rows.method.run] {
        const peers::Result result = call(input, setting);
        sink = result.peak;
        return result;
      };
      rows.rows.push_back({setting, {}, judge(scene, run())});
      calls.emplace_back(run);
    }
  }
  const std::vector<peers::Timing> timings = measure(calls, options);
  auto timing = timings.begin();
  for (MethodRows& method : found.methods) {
    for (Row& row : method.rows) {
      row.time = *timing++;
    }
  }
  return found;
}

}  // namespace

std::string counts_of(const peers::Result& result) {
  return fmt::format("{}, {}, {}", result.passages, result.turns, result.sticks);
}

const Row* MethodRows::cheapest(double bound) const {
  const Row* best = nullptr;
  for (const Row& row : rows) {
    if (row.verdict.reaches(bound) && (best == nullptr || row.time.median < best->time.median)) {
      best = &row;
    }
  }
  return best;
}

std::optional<Rival> best_rival(const SceneRows& scene, double bound) {
  std::optional<Rival> best;
  for (const MethodRows& method : scene.methods) {
    const Row* row = method.method.rival ? method.cheapest(bound) : nullptr;
    if (row != nullptr && (!best || row->time.median < best->row->time.median)) {
      best = Rival{&method, row, row->time.median / scene.kernel().time.median};
    }
  }
  return best;
}

Comparison compare(const std::vector<peers::ReferenceScene>& scenes,
                   const peers::MeasureOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  Comparison all;
  all.machine = this_machine();
  all.options = options;
  for (const peers::ReferenceScene& scene : scenes) {
    fmt::print(stderr, "bench: {}, {}\n", scene.name, scene.legend);
    all.scenes.push_back(compare(scene, options));
    if (scene.name == "S2") {
      all.free_modes = free_modes(scene.scene, options);
    }
    if (scene.name == "S5") {
      fmt::print(stderr, "bench: S6, eleven records and 10^4 dampers\n");
      all.many = many_dampers(std::get<Record>(scene.scene.excitation), options);
    }
  }
  all.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return all;
}

}  // namespace stillpoint::bench
