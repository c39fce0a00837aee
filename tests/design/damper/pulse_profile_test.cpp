// SPDX-License-Identifier: MIT
#include "pulse/profile.hpp"
#include "random_pulse.hpp"
#include "random_source.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

BOOST_AUTO_TEST_SUITE(pulse_profile_test)

// What the samples of f show of the motions between them. They are not a proof, so this counts.

namespace {

using namespace stillpoint;
using namespace stillpoint::design;
using namespace stillpoint::design_test;

struct Missed {
  int returns{0};
  double peak{0};  ///< above the larger of both neighbours, as a part of it
  double need{0};
};

Missed missed_by(const PulseProfile& profile) {
  Missed missed;
  const auto& samples = profile.samples();
  constexpr int steps = 500;
  for (int i = 0; i < steps; ++i) {
    const double part = (i + 0.5) / steps;
    const double f = i % 2 == 0 ? part : std::pow(10, 6 * (part - 1));
    const auto above = std::ranges::upper_bound(samples, f, {}, &FirstReturn::f);
    if (above == samples.begin() || above == samples.end()) {
      continue;
    }
    const FirstReturn now = profile.at(f);
    const FirstReturn& before = *(above - 1);
    if (before.returns == above->returns && now.returns != before.returns) {
      ++missed.returns;
    } else if (now.returns && before.returns && above->returns) {
      missed.peak = std::max(missed.peak, now.peak / std::max(before.peak, above->peak) - 1);
      missed.need = std::max(missed.need,
                             now.exact_need / std::max(before.exact_need, above->exact_need) - 1);
    }
  }
  return missed;
}

}  // namespace

// The numbers are those of docs/theory.md section 8.
BOOST_AUTO_TEST_CASE(samples_know_nearly_all_between_them) {
  RandomSource random(20261122);
  constexpr int pulses = 2000;
  constexpr double visible = 1e-3;
  int above = 0;
  int above_of_long = 0;
  double most = 0;
  for (int i = 0; i < pulses; ++i) {
    const double slowness = random.log_uniform(0.01, 5.6);
    const Pulse pulse = random_pulse(random, 1, 1 / slowness);
    const Missed missed = missed_by(PulseProfile(pulse, 1, Criterion::exact));
    BOOST_TEST_CONTEXT("pulse " << i << ", " << name(pulse) << ", p/lambda " << slowness) {
      BOOST_TEST(missed.returns == 0);
      BOOST_TEST(missed.peak <= 1e-6);
    }
    above += missed.need > visible ? 1 : 0;
    above_of_long += missed.need > visible && slowness > 4 ? 1 : 0;
    most = std::max(most, missed.need);
  }
  BOOST_TEST_MESSAGE(above << " of " << pulses << " need more than their samples, " << above_of_long
                           << " of them with p/lambda > 4, " << most << " more at most");
  BOOST_TEST(above <= 0.02 * pulses);
  BOOST_TEST(above - above_of_long <= 0.003 * pulses);
  BOOST_TEST(most <= 0.1);
}

BOOST_AUTO_TEST_SUITE_END()
