// SPDX-License-Identifier: MIT
// How a notch of width w tends to the paper's as w -> 0, and what a run with zones costs: the
// tables of docs/notches.md.

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/free_motion.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace stillpoint::bench {

namespace {

struct Scene {
  const char* name;
  Oscillator oscillator;
  Start start;
  Excitation excitation;
  std::optional<double> t_end;
};

ForcedResponse run(const Scene& scene, const Surface& surface) {
  return forced_response(scene.oscillator, scene.start, scene.excitation, {.t_end = scene.t_end},
                         surface);
}

Surface notch(double width) {
  return {.notch_width = width};
}

void print_convergence(const Scene& scene) {
  const ForcedResponse paper = run(scene, {});
  fmt::print("\n{}: f = {:.4g}, delta = {:.4g}; the paper's {}\n\n", scene.name, scene.oscillator.f,
             scene.oscillator.delta, summary(paper));
  fmt::print(
      "| w | passages | rest / w | change of stop time / w | of the peak / w | transmitted |\n"
      "|---|---|---|---|---|---|\n");
  for (const double w : {0.2, 0.1, 0.05, 0.02, 0.01, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const ForcedResponse built = run(scene, notch(w));
    fmt::print("| {} | {} | {:.5f} | {:.5f} | {:.5f} | {:.4g} |\n", w, *built.zero_passages,
               built.stop_position.value_or(0) / w,
               (built.stop_time.value_or(0) - paper.stop_time.value_or(0)) / w,
               (built.peak_amplitude - paper.peak_amplitude) / w, built.peak_absolute_acceleration);
  }
}

/// The best of a few rounds, in microseconds per run.
double time_of(const Scene& scene, const Surface& surface) {
  using Clock = std::chrono::steady_clock;
  constexpr int rounds = 400;
  constexpr int runs = 10;  // so short that other work seldom interrupts one round
  double best = 1e300;
  double sum = 0;  // so that the runs are not left out
  for (int round = 0; round < rounds; ++round) {
    const auto begin = Clock::now();
    for (int i = 0; i < runs; ++i) {
      sum += run(scene, surface).peak_amplitude;
    }
    const std::chrono::duration<double> taken = Clock::now() - begin;
    best = std::min(best, 1e6 * taken.count() / runs);
  }
  return std::isfinite(sum) ? best : 0;
}

Record saw() {
  Record record;
  record.step = 0.02;
  for (int i = 0; i < 3000; ++i) {
    record.values.push_back(0.3 * (i % 37) / 37 - 0.15);
  }
  return record;
}

void print_tables() {
  print_convergence({"a first return", {1, 0.26, 0.37}, {0, 1}, {}, {}});
  print_convergence({"many passages", {1, 0.02, 0.02}, {0, 1}, {}, {}});
  print_convergence({"a half-sine", {1, 0.05, 0.05}, {0.3, 0}, HalfSine{0.5, 2}, {}});
  const Surface zones{{}, {{0.05, 0.06}, {0.15, 0.04}}};
  fmt::print(
      "\n| one run, us | the paper's | a notch 0.02 wide | two zones |\n|---|---|---|---|\n");
  for (const Scene& scene :
       std::vector<Scene>{{"free, f = delta = 0.005", {1, 0.005, 0.005}, {0, 1}, {}, 200},
                          {"harmonic, k = 0.3, lambda = 0.8, to tau = 200",
                           {1, 0.05, 0.01},
                           {0, 0.3},
                           Harmonic{0.3, 0.8},
                           200},
                          {"record of 3000 samples", {1, 0.05, 0}, {0, 0}, saw(), 59}}) {
    Scene narrow = scene;
    narrow.oscillator.delta = std::max(scene.oscillator.delta, 1e-4);
    fmt::print("| {} | {:.2f} | {:.2f} | {:.2f} |\n", scene.name, time_of(scene, {}),
               time_of(narrow, notch(0.02)), time_of(scene, zones));
  }
}

}  // namespace

}  // namespace stillpoint::bench

int main() {
  stillpoint::bench::print_tables();
}
