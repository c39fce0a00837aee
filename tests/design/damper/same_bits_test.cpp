// SPDX-License-Identifier: MIT
// Another version of NLopt, or another processor, moves the last digits of what NLopt returns. Here
// each of its runs starts a relative 1e-9 aside, so that every step of it differs, and what it
// returns is 1e-11 off. No bit of a design may change.
#include "any_task.hpp"
#include "damper.hpp"
#include "pulse/pulse_task.hpp"

#include <fmt/format.h>

#include <dlfcn.h>
#include <nlopt.h>

#include <bit>

namespace {

/// -1 or 1; 0 leaves NLopt as it is.
double aside = 0;

void move(nlopt_opt solver, double* x, double relative) {
  if (aside == 0) {  // other tests give it bounds of every kind
    return;
  }
  std::vector<double> low(nlopt_get_dimension(solver));
  std::vector<double> high(low.size());
  nlopt_get_lower_bounds(solver, low.data());
  nlopt_get_upper_bounds(solver, high.data());
  for (std::size_t i = 0; i < low.size(); ++i) {
    x[i] = std::clamp(x[i] * (1 + aside * relative), low[i], high[i]);
  }
}

}  // namespace

// Found before that of the library.
extern "C" nlopt_result nlopt_optimize(nlopt_opt solver, double* x, double* least) {
  static auto* const optimize =
      reinterpret_cast<decltype(&nlopt_optimize)>(::dlsym(RTLD_NEXT, "nlopt_optimize"));
  move(solver, x, 1e-9);
  const nlopt_result result = optimize(solver, x, least);
  move(solver, x, 1e-11);
  return result;
}

BOOST_AUTO_TEST_SUITE(same_bits_test)

using namespace stillpoint::design_test;

/// The last design, as its bits.
using Bits = std::array<std::uint64_t, 3>;

Bits bits_of(const std::optional<DesignPoint>& point) {
  const auto [f, delta, tolerance] = point.value_or(DesignPoint());
  return {std::bit_cast<std::uint64_t>(f), std::bit_cast<std::uint64_t>(delta),
          std::bit_cast<std::uint64_t>(tolerance)};
}

template <class Search>
void check_bits(const Search& search, const std::string& task) {
  aside = 0;
  const auto plain = search();
  for (const double now : {-1.0, 1.0}) {
    aside = now;
    const auto moved = search();
    BOOST_TEST(bits_of(moved) == bits_of(plain), task << ": " << moved.value_or(DesignPoint()).f);
  }
  aside = 0;
}

/// With ranges and residuals in every second.
BOOST_AUTO_TEST_CASE(of_a_design_for_a_hit) {
  for (std::uint64_t seed = 1'302'000; seed < 1'302'600; ++seed) {
    RandomSource random(seed);
    const Task task = seed % 2 == 0 ? any_task(random) : Task{random_feasible_problem(random), {}};
    for (const Objective objective : objectives) {
      check_bits(
          [&] {
            const auto found = search(task.problem, task.limits, {.objective = objective});
            return found ? std::optional(found->point) : std::nullopt;
          },
          fmt::format("seed {}, {}, {}", seed, name(objective), context_of(task)));
    }
  }
}

BOOST_AUTO_TEST_CASE(of_a_design_for_a_pulse) {
  for (std::uint64_t seed = 1'303'000; seed < 1'303'100; ++seed) {
    RandomSource random(seed);
    const PulseRequest request = random_request(random);
    check_bits(
        [&] {
          const DesignResult result = design::design(request);
          return result.finding ? std::optional(result.finding->point) : std::nullopt;
        },
        fmt::format("seed {}", seed));
  }
}

BOOST_AUTO_TEST_SUITE_END()
