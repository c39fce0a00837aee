// SPDX-License-Identifier: MIT

// A fixed amount of work, for counting instructions. `stillpoint_workload NAME` does it twice: once
// to set everything up (Highway times the clock, the loader binds names, memory is allocated) and
// once in stillpoint_counted(), where callgrind counts. So the count depends on the machine only
// through its mathematical library.

#include <stillpoint/core/batch.hpp>
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/free_motion.hpp>

#include <hwy/targets.h>

#include <cstdio>
#include <map>
#include <string>

/// Calls `work`; in C and out of line, so that callgrind finds it by its name.
extern "C" [[gnu::noinline]] double stillpoint_counted(double (*work)());

double stillpoint_counted(double (*work)()) {
  return work();
}

namespace stillpoint::bench {

namespace {

/// The half-cycle map with times and margin: 424 half-cycles.
double scalar_map() {
  return free_response({1, 1e-3, 1e-4}, {0, 1}).stop_time.value();
}

/// Harmonic pieces at resonance, passages and turns: scene S3 to tau = 200.
double forced_harmonic() {
  return forced_response({1, 0.05, 0.01}, {0, 0.5}, Harmonic{0.2, 1}, {.t_end = 200})
      .final_position.value();
}

/// Record intervals: a saw of 3000 samples.
double forced_record() {
  static const Excitation saw = [] {
    constexpr int samples = 3000;
    constexpr int tooth = 37;
    Record record;
    record.step = 0.02;
    for (int i = 0; i < samples; ++i) {
      record.values.push_back(0.3 * (i % tooth) / tooth - 0.15);
    }
    return Excitation(record);
  }();
  return forced_response({1, 0.05, 0}, {0, 0}, saw, {.t_end = 59}).final_position.value();
}

/// The lanes with SSE4, which every current x86-64 has: 4096 motions on a grid, one thread.
double batch() {
  constexpr Eigen::Index side = 64;
  static const Eigen::ArrayXd f = Eigen::ArrayXd::LinSpaced(side, 0.001, 0.1).replicate(side, 1);
  static const Eigen::ArrayXd delta = [] {
    Eigen::ArrayXd values(side * side);
    for (Eigen::Index i = 0; i < side; ++i) {
      values.segment(i * side, side) = 1e-4 + 1e-3 * static_cast<double>(i);
    }
    return values;
  }();
  return free_batch(1, 1, f, delta, {.threads = 1}).peak_amplitude.sum();
}

int run(int count, char** arguments) {
  const std::map<std::string, double (*)()> work{{"scalar_map", scalar_map},
                                                 {"forced_harmonic", forced_harmonic},
                                                 {"forced_record", forced_record},
                                                 {"batch", batch}};
  const auto found = count == 2 ? work.find(arguments[1]) : work.end();
  if (found == work.end()) {
    std::fputs("usage: stillpoint_workload scalar_map|forced_harmonic|forced_record|batch\n",
               stderr);
    return 2;
  }
  hwy::SetSupportedTargetsForTest(HWY_SSE4);
  const double first = found->second();
  const double counted = stillpoint_counted(found->second);
  std::printf("%.17g %.17g\n", first, counted);
  return 0;
}

}  // namespace

}  // namespace stillpoint::bench

int main(int count, char** arguments) {
  return stillpoint::bench::run(count, arguments);
}
