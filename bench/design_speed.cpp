// SPDX-License-Identifier: MIT

// Measures what a design costs in the library, in microseconds of processor time.
//
//   stillpoint_design_speed [ROUNDS [CASE]]
//
// Each round measures every case once, and the shortest time of each counts, since other work of
// the machine can only add to it. With CASE only those whose names contain it. A case is repeated
// for beta from 0.8 to 1.2, so that no single task decides. "random" measures 600 random tasks of
// each pulse, p/lambda from 0.02 to 5, and gives the median and nine tenths of those that have a
// design.

#include "pulse/first_return.hpp"
#include "pulse/region.hpp"

#include <stillpoint/design.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::bench {

namespace {

using design::Criterion;
using design::Limits;
using design::Objective;
using design::Part;
using design::Problem;
using design::SearchOptions;

constexpr int tasks = 40;

struct Case {
  std::string name;
  std::function<void(double)> run;  ///< with that beta
  double microseconds{HUGE_VAL};
};

Problem problem(double beta, std::int64_t arrivals = 1) {
  return {.v0 = 1, .p = 1, .beta = beta, .criterion = Criterion::published, .arrivals = arrivals};
}

double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void measure(Case& one) {
  constexpr double least_beta = 0.8;
  constexpr double most_beta = 1.2;
  const double begin = processor_time();
  for (int i = 0; i < tasks; ++i) {
    one.run(least_beta + (most_beta - least_beta) * i / (tasks - 1));
  }
  one.microseconds = std::min(one.microseconds, 1e6 * (processor_time() - begin) / tasks);
}

std::vector<Part> thousand_parts() {
  constexpr int sizes_of_f = 40;
  constexpr int sizes_of_delta = 25;
  std::vector<Part> parts;
  parts.reserve(sizes_of_f * sizes_of_delta);
  for (int i = 0; i < sizes_of_f; ++i) {
    for (int j = 0; j < sizes_of_delta; ++j) {
      parts.push_back({fmt::format("part {}-{}", i, j), 0.01 * i, 0.02 * j});
    }
  }
  return parts;
}

constexpr Limits within_10_percent{.tolerance = 0.1};

/// A task, and with ranges and a residual.
void add_searches(std::vector<Case>& all) {
  const std::vector<std::pair<std::string, std::function<void(Problem&)>>> variations{
      {"", [](Problem&) {}},
      {"v0 0.9:1, ", [](Problem& task) { task.v0_low = 0.9; }},
      {"v0 0:1, ", [](Problem& task) { task.v0_low = 0; }},
      {"residual 0.05, ", [](Problem& task) { task.residual = 0.05; }},
      {"v0 and p 0.95:1, residual 0.05, ", [](Problem& task) {
         task.v0_low = task.p = 0.95;
         task.p_high = 1;
         task.residual = 0.05;
       }}};
  for (const std::int64_t arrivals : {1, 4}) {
    for (const auto& variation : variations) {
      for (const auto& [objective, name] : enumerators(Objective())) {
        const SearchOptions options{.objective = objective};
        const Limits limits{.tolerance = objective == Objective::robust ? 0 : 0.02};
        all.push_back({fmt::format("search, {}, {}arrivals {}", name, variation.first, arrivals),
                       [=](double beta) {
                         Problem task = problem(beta, arrivals);
                         variation.second(task);
                         (void)design::search(task, limits, options);
                       }});
      }
    }
  }
}

void add_answers(std::vector<Case>& all) {
  const auto parts = thousand_parts();
  for (const std::int64_t arrivals : {1, 4}) {
    all.push_back({fmt::format("region, arrivals {}", arrivals),
                   [=](double beta) { (void)design::admissible_region(problem(beta, arrivals)); }});
    all.push_back({fmt::format("whole design with its checks, arrivals {}", arrivals),
                   [=](double beta) { (void)design::design({problem(beta, arrivals)}); }});
    all.push_back({fmt::format("1000 parts ranked, arrivals {}", arrivals), [=](double beta) {
                     (void)design::ranked(problem(beta, arrivals), within_10_percent,
                                          Objective::robust, parts);
                   }});
    all.push_back({fmt::format("front of 25, arrivals {}", arrivals),
                   [=](double beta) { (void)design::trade_off(problem(beta, arrivals), {}, 25); }});
  }
}

void add_pulse(std::vector<Case>& all, const char* what, const design::Pulse& pulse) {
  // With k = 1 they would swing a mass without friction to 1.5 to 1.9.
  constexpr double most_of_free = 1.2;
  all.push_back({fmt::format("mends, {}", what), [=](double beta) {
                   // A tolerance of 90 % is more than any of them has.
                   const design::PulseProblem task{pulse, 1, most_of_free * beta};
                   (void)design::mends(task, {.delta_max = 0.1, .tolerance = 0.9},
                                       std::make_shared<design::WorstReturn>(task));
                 }});
  all.push_back({fmt::format("search, robust, k, lambda and p 0.9:1, {}", what), [=](double beta) {
                   design::PulseProblem task{pulse, 0.9, most_of_free * beta};
                   task.ranges = {0.9, 1.1 * design::angular_frequency(pulse)};
                   task.p_high = 1;
                   (void)design::search(design::PulseRegion(task, {}), {});
                 }});
  for (const auto& [objective, name] : enumerators(Objective())) {
    const SearchOptions options{.objective = objective};
    const Limits limits = objective == Objective::robust ? Limits() : within_10_percent;
    all.push_back({fmt::format("search, {}, {}", name, what), [=](double beta) {
                     const design::PulseProblem task{pulse, 1, most_of_free * beta};
                     (void)design::search(design::PulseRegion(task, limits), options);
                   }});
  }
}

std::vector<Case> cases() {
  std::vector<Case> all;
  add_searches(all);
  add_answers(all);
  add_pulse(all, "half-sine, p/lambda 0.8", HalfSine{1, 1.25});
  add_pulse(all, "rectangle, p/lambda 0.8", Rectangle{1, 1.25});
  add_pulse(all, "full sine, p/lambda 0.8", FullSine{1, 1.25});
  add_pulse(all, "half-sine, p/lambda 4", HalfSine{1, 0.25});
  add_pulse(all, "full sine, p/lambda 4", FullSine{1, 0.25});
  return all;
}

constexpr std::string_view random_name = "random";

struct RandomTask {
  design::PulseProblem problem;
  Limits limits;
  SearchOptions options;
};

RandomTask random_task(int kind, std::mt19937_64& engine) {
  const auto uniform = [&](double low, double high) {
    constexpr double unit = 0x1p-53;
    return low + (high - low) * static_cast<double>(engine() >> 11) * unit;
  };
  const double lambda = std::exp(uniform(std::log(1.0 / 5), std::log(1 / 0.02)));
  const std::array<design::Pulse, 3> pulses{HalfSine{1, lambda}, Rectangle{1, lambda},
                                            FullSine{1, lambda}};
  RandomTask task{{pulses[static_cast<std::size_t>(kind)]}, {}, {}};
  const design::FirstReturn free = design::first_return(task.problem.pulse, 1, 1e-3);
  task.problem.beta = uniform(0.35, 1.2) * free.peak;
  task.problem.criterion = engine() % 2 == 0 ? Criterion::published : Criterion::exact;
  task.limits.tolerance = engine() % 2 == 0 ? uniform(0, 0.3) : 0;
  if (engine() % 4 == 0) {
    task.limits.delta_max = uniform(0.2, 1.5) * free.exact_need;
  }
  const auto objectives = enumerators(Objective());
  task.options.objective = objectives[engine() % objectives.size()].first;
  return task;
}

void measure_random_pulses(int rounds) {
  constexpr int count = 600;
  constexpr unsigned seed = 20261122;
  constexpr std::array names{"half-sines", "rectangles", "full sines"};
  for (int kind = 0; kind < 3; ++kind) {
    std::mt19937_64 engine(seed);
    std::vector<double> microseconds;
    for (int i = 0; i < count; ++i) {
      const auto [problem, limits, options] = random_task(kind, engine);
      double least = HUGE_VAL;
      bool found = false;
      for (int round = 0; round < rounds; ++round) {
        const double begin = processor_time();
        found = design::search(design::PulseRegion(problem, limits), options).has_value();
        least = std::min(least, 1e6 * (processor_time() - begin));
      }
      if (found) {
        microseconds.push_back(least);
      }
    }
    std::ranges::sort(microseconds);
    fmt::print("{} {}, {} designs: median {:.1f} us, nine tenths below {:.1f} us\n", random_name,
               names[static_cast<std::size_t>(kind)], microseconds.size(),
               microseconds[microseconds.size() / 2], microseconds[microseconds.size() * 9 / 10]);
  }
}

}  // namespace

}  // namespace stillpoint::bench

int main(int count, char** arguments) {
  const int rounds = count > 1 ? std::max(1, std::atoi(arguments[1])) : 5;
  auto all = stillpoint::bench::cases();
  if (count > 2) {
    std::erase_if(
        all, [&](const auto& one) { return one.name.find(arguments[2]) == std::string::npos; });
  }
  for (int round = 0; round < rounds; ++round) {
    std::ranges::for_each(all, stillpoint::bench::measure);
  }
  for (const auto& one : all) {
    fmt::print("{:<70}{:>10.1f} us\n", one.name, one.microseconds);
  }
  if (count <= 2 || arguments[2] == stillpoint::bench::random_name) {
    stillpoint::bench::measure_random_pulses(rounds);
  }
}
