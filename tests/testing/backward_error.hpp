// SPDX-License-Identifier: MIT
#pragma once

// The promise of stillpoint/core/free_motion.hpp: each metric is that of inputs changed by a
// relative `backward_error` * (2 + half-cycles) at most. To first order that bounds the forward
// error by the same number times the condition, sum over the inputs of |d metric / d ln input|.

#include "testing/exact_run.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cstddef>

namespace stillpoint::test {

inline constexpr double backward_error = 2e-16;

inline double allowed_change(double half_cycles) {
  return backward_error * (2 + half_cycles);
}

/// sum |d metric / d ln input| by one-sided differences of relative size `step`, which must be far
/// above Real's rounding and far below the distance to any decision. If a count or the outcome
/// changes on one side, the other side is used; if on both, the input is left out. A change of
/// units keeps every tie: x0 by 1 + e with p and f by 1 - e changes lengths and times by 1 + e and
/// accelerations by 1 - e; x0, v0, f by 1 + e with delta by 1 + 2e changes speeds by 1 + e. So the
/// sum is never below 1 |metric|, and 1/2 |metric| for the speed.
template <class Real>
std::array<Real, 5> conditions(const Scene<Real>& scene, const Run<Real>& run, const Real& step) {
  using std::abs;
  std::array<Real, 5> sums{};
  std::array<Real, 5> least{};
  for (std::size_t i = 0; i < sums.size(); ++i) {
    least[i] =
        run.metrics[i] ? abs(Real(*run.metrics[i])) * (i == 4 ? Real(0.5) : Real(1)) : Real(0);
  }
  for (const auto input : inputs<Real>) {
    if (scene.*input == 0) {
      continue;
    }
    for (const int direction : {1, -1}) {
      Scene<Real> moved = scene;
      moved.*input *= 1 + direction * step;
      const Run<Real> there = run_in(moved);
      if (there.end == run.end) {
        for (std::size_t i = 0; i < sums.size(); ++i) {
          if (run.metrics[i]) {
            sums[i] += abs(Real(*there.metrics[i] - *run.metrics[i])) / step;
          }
        }
        break;
      }
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    sums[i] = sums[i] > least[i] ? sums[i] : least[i];
  }
  return sums;
}

inline std::array<Exact, 5> conditions(const Scene<double>& scene, const Run<Exact>& run) {
  return conditions(widened<Exact>(scene), run, Exact("1e-20"));
}

/// Counts and outcome may differ only where a decision lies within the allowed change.
inline bool ends_agree(const Run<double>& run, const Run<Exact>& exact) {
  if (run.end == exact.end) {
    return true;
  }
  const double allowed = allowed_change(std::max(run.end.half_cycles, exact.end.half_cycles));
  const bool near_tie =
      (run.margin && *run.margin <= allowed) || (exact.margin && *exact.margin <= allowed);
  BOOST_TEST(near_tie, "got " << run.end << ", margin " << run.margin.value_or(-1) << "; expected "
                              << exact.end << ", margin "
                              << exact.margin.value_or(Exact(-1)).str(6));
  return false;
}

/// Every metric of `run` within the promise about `exact`.
inline void metrics_agree(const Run<double>& run, const Run<Exact>& exact,
                          const std::array<Exact, 5>& sums) {
  const Exact allowed = allowed_change(exact.end.half_cycles);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const auto& got = run.metrics[i];
    const auto& expected = exact.metrics[i];
    BOOST_TEST(got.has_value() == expected.has_value(), metric_names[i]);
    if (!got || !expected) {
      continue;
    }
    const Exact error = abs(Exact(*got - *expected));
    const Exact bound = allowed * sums[i];
    BOOST_TEST(error <= bound, metric_names[i]
                                   << " = " << *got << ", expected " << expected->str(20)
                                   << ": error/bound = " << Exact(error / bound).str(6)
                                   << ", margin " << exact.margin.value_or(Exact(-1)).str(6));
  }
}

/// The whole promise for one scene.
inline void keeps_the_promise(const Scene<double>& scene) {
  BOOST_TEST_CONTEXT("scene " << scene) {
    const Run<double> run = as_run(response(scene));
    const Run<Exact> exact = run_in(widened<Exact>(scene));
    if (ends_agree(run, exact)) {
      metrics_agree(run, exact, conditions(scene, exact));
    }
  }
}

}  // namespace stillpoint::test
