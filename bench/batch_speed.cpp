// SPDX-License-Identifier: MIT

// Measures the batch interface in multiples of the time of one square root among many, which is
// measured in the same run: docs/batch.md. The work is 1e6 motions with v0 = p = 1 on a logarithmic
// grid, f from 1e-3 to 0.1 and delta from 1e-4 to 0.1.
//
//   stillpoint_batch_speed [ROUNDS]
//
// Each round measures everything once, and the shortest time of each counts, since other work of
// the machine can only add to it. It is processor time for one thread, and elapsed time where two
// threads are compared with one.

#include "machine.hpp"
#include "sqrt_floor.hpp"

#include <stillpoint/core/batch.hpp>
#include <stillpoint/core/free_motion.hpp>

#include <hwy/targets.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <utility>
#include <vector>

namespace stillpoint::bench {

namespace {

constexpr Eigen::Index side = 1000;

struct Dampers {
  Eigen::ArrayXd f{side * side};
  Eigen::ArrayXd delta{side * side};
};

Dampers grid() {
  Dampers dampers;
  for (Eigen::Index i = 0; i < side * side; ++i) {
    const Eigen::Index row = i / side;
    const Eigen::Index column = i % side;
    dampers.f[i] = std::pow(10, -3 + 2 * static_cast<double>(row) / (side - 1));
    dampers.delta[i] = std::pow(10, -4 + 3 * static_cast<double>(column) / (side - 1));
  }
  return dampers;
}

Dampers shuffled(const Dampers& ordered) {
  Dampers dampers = ordered;
  std::mt19937_64 engine(1);
  for (Eigen::Index i = side * side - 1; i > 0; --i) {
    const auto j = static_cast<Eigen::Index>(engine() % static_cast<std::uint64_t>(i + 1));
    std::swap(dampers.f[i], dampers.f[j]);
    std::swap(dampers.delta[i], dampers.delta[j]);
  }
  return dampers;
}

struct Nanoseconds {
  double of_processor;
  double elapsed;
};

template <class Action>
Nanoseconds timed(const Action& action) {
  const auto begin = std::chrono::steady_clock::now();
  const std::clock_t processor_begin = std::clock();
  action();
  const std::clock_t processor_time = std::clock() - processor_begin;
  const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - begin;
  return {static_cast<double>(processor_time) * (1e9 / CLOCKS_PER_SEC), time.count()};
}

void keep_least(double& least, double value) {
  least = std::min(least, value);
}

constexpr double never = 1e300;
constexpr double few_per_cent = 0.05;

/// Nanoseconds for a square root, otherwise for all half-cycles.
struct Times {
  double floor{never};
  double in_order{never};
  double in_random_order{never};
  double in_order_with_times{never};
  double in_random_order_with_times{never};
  double alike{never};           ///< of one half-cycle
  double elapsed_by_one{never};  ///< in order, as is the next
  double elapsed_by_two{never};
  double damped{never};             ///< in random order with times, as is the next
  double damped_half_cycle{never};  ///< of one half-cycle
};

class Measurement {
 public:
  void one_round(std::int64_t target, Times& least) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    keep_least(least.floor, sqrt_floor());
    const Nanoseconds in_order = batch(ordered_, false, 1);
    keep_least(least.in_order, in_order.of_processor);
    keep_least(least.elapsed_by_one, in_order.elapsed);
    keep_least(least.elapsed_by_two, batch(ordered_, false, 2).elapsed);
    keep_least(least.in_random_order, batch(random_, false, 1).of_processor);
    keep_least(least.alike, alike());
    keep_least(least.in_order_with_times, batch(ordered_, true, 1).of_processor);
    keep_least(least.in_random_order_with_times, batch(random_, true, 1).of_processor);
    const double damped = batch(random_, true, 1, damping_).of_processor;
    keep_least(least.damped, damped);
    keep_least(least.damped_half_cycle, damped / result_with_times_.half_cycles.sum());
  }

  /// Every hundredth motion by free_response, one after another.
  [[nodiscard]] double scalar(bool times, double zeta = 0) const {
    double half_cycles = 0;
    const Nanoseconds time = timed([&] {
      for (Eigen::Index i = 0; i < side * side; i += 100) {
        const Oscillator oscillator{
            .p = 1, .f = random_.f[i], .delta = random_.delta[i], .zeta = zeta};
        half_cycles += free_response(oscillator, {0, 1}, {.times = times, .margin = false})
                           .half_cycles.value();
      }
    });
    return time.of_processor / half_cycles;
  }

  /// Time of a half-cycle where all motions are alike and long.
  [[nodiscard]] double alike() {
    const Eigen::ArrayXd f = Eigen::ArrayXd::Constant(20000, 1e-4);
    const Eigen::ArrayXd delta = Eigen::ArrayXd::Constant(20000, 3.8e-4);
    const Nanoseconds time = timed([&] { free_batch(1, 1, f, delta, {.threads = 1}, alike_); });
    return time.of_processor / alike_.half_cycles.sum();
  }

  [[nodiscard]] double half_cycles() {
    batch(ordered_, false, 1);
    return result_.half_cycles.sum();
  }

 private:
  Nanoseconds batch(const Dampers& dampers, bool times, int threads,
                    const Eigen::ArrayXd& zeta = {}) {
    BatchResult& result = times ? result_with_times_ : result_;
    const BatchOptions options{.zeta = zeta, .times = times, .threads = threads};
    return timed([&] { free_batch(1, 1, dampers.f, dampers.delta, options, result); });
  }

  Dampers ordered_ = grid();
  Dampers random_ = shuffled(ordered_);
  Eigen::ArrayXd damping_ = Eigen::ArrayXd::Constant(side * side, few_per_cent);
  BatchResult result_;
  BatchResult result_with_times_;
  BatchResult alike_;
};

void print(const char* name, const Times& least, double half_cycles) {
  const auto ratio = [&](double time) { return time / half_cycles / least.floor; };
  std::printf("| %s | %.3f | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f |\n", name, least.floor,
              ratio(least.in_order), ratio(least.in_random_order), ratio(least.in_order_with_times),
              ratio(least.in_random_order_with_times), least.alike / least.floor,
              least.elapsed_by_one / least.elapsed_by_two);
}

void run(int rounds) {
  const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
  std::vector<Times> least(targets.size());
  Measurement measurement;
  const double half_cycles = measurement.half_cycles();
  double scalar = never;
  double scalar_with_times = never;
  double scalar_damped = never;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < targets.size(); ++i) {
      measurement.one_round(targets[i], least[i]);
    }
    keep_least(scalar, measurement.scalar(false));
    keep_least(scalar_with_times, measurement.scalar(true));
    keep_least(scalar_damped, measurement.scalar(true, few_per_cent));
  }
  const Machine machine = this_machine();
  std::printf("%s; %s, %s; %d rounds; %.1f half-cycles a motion\n\n", machine.processor.c_str(),
              machine.compiler.c_str(), machine.flags.c_str(), rounds, half_cycles / (side * side));
  std::printf(
      "| instruction set | square root, ns | in order | random order | in order, times | random "
      "order, times | all alike, 983 | two threads |\n|---|---|---|---|---|---|---|---|\n");
  for (std::size_t i = 0; i < targets.size(); ++i) {
    print(hwy::TargetName(targets[i]), least[i], half_cycles);
  }
  std::printf("\nfree_response: %.2f ns a half-cycle, %.2f ns with times\n", scalar,
              scalar_with_times);
  std::printf(
      "\nWith 5 %% of critical damping, in random order with times:\n\n| | a half-cycle, ns | a "
      "sweep, "
      "relative to no damping |\n|---|---|---|\n");
  for (std::size_t i = 0; i < targets.size(); ++i) {
    std::printf("| %s | %.1f | %.2f |\n", hwy::TargetName(targets[i]), least[i].damped_half_cycle,
                least[i].damped / least[i].in_random_order_with_times);
  }
  std::printf("| free_response | %.1f | |\n", scalar_damped);
}

}  // namespace

}  // namespace stillpoint::bench

int main(int argc, char** argv) {
  stillpoint::bench::run(argc > 1 ? std::max(1, std::atoi(argv[1])) : 15);
  return 0;
}
