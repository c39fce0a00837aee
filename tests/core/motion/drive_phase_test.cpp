// SPDX-License-Identifier: MIT
#include "kernel/drive_phase.hpp"
#include "kernel/exact_sum.hpp"
#include "kernel/harmonic_flow.hpp"
#include "kernel/linear_piece.hpp"
#include "kernel/positivity.hpp"
#include "motion.hpp"

// The parts of the forced kernel on which its accuracy and its proofs rest, against 50 digits.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(drive_phase_test)

double off(double value, const Exact& right) {
  return std::abs(static_cast<double>(value - right));
}

/// The point in 50 digits.
HarmonicPoint<Exact> widened(const HarmonicPoint<double>& point) {
  return {point.y, point.v, point.a, point.w, point.q};
}

BOOST_AUTO_TEST_CASE(a_sum_of_a_million_times_loses_nothing) {
  ExactSum<double> sum;
  Exact right = 0;
  Dice dice(1);
  for (int i = 0; i < 1000000; ++i) {
    const double h = dice.power_of_ten(-3, 1);
    sum.add(h);
    right += h;
  }
  BOOST_TEST(static_cast<double>(abs(Exact(Exact(sum.high()) + sum.low() - right)) / right) <=
             1e-26);
}

BOOST_AUTO_TEST_CASE(a_million_steps_keep_the_phase) {
  const double lambda = 0.7;
  const double p = 0.3;
  DrivePhase<double> phase(lambda, p, 1e6);
  DrivePhase<Exact> right(Exact(lambda), Exact(p), Exact(1e6));
  Dice dice(2);
  for (int i = 0; i < 1000000; ++i) {
    const double h = dice.power_of_ten(-3, 1);
    phase.advance(h);
    right.advance(Exact(h));
  }
  BOOST_TEST(off(phase.sin_cos().sine, right.sin_cos().sine) <= 2e-16);
  BOOST_TEST(off(phase.sin_cos().cosine, right.sin_cos().cosine) <= 2e-16);
}

BOOST_AUTO_TEST_CASE(the_closed_form_has_one_accuracy_for_every_detuning) {
  Dice dice(3);
  for (const double r : {1e-6, 0.5, 1 - 1e-3, 1 - 1e-9, 1.0, 1 + 1e-12, 1 + 1e-6, 1.5, 1.999, 2.001,
                         7.0, 1e3, 1e6}) {
    for (int i = 0; i < 200; ++i) {
      const double psi = dice.uniform(-3, 3);
      const DrivePhase<double> phase(r, 1, psi);
      const DrivePhase<Exact> exact_phase(Exact(r), Exact(1), Exact(psi));
      const auto [sine, cosine] = phase.sin_cos();
      const HarmonicPoint<double> start{dice.uniform(-2, 2), dice.uniform(0, 2),
                                        dice.uniform(-2, 2), sine, cosine};
      const auto [exact_sine, exact_cosine] = exact_phase.sin_cos();
      HarmonicPoint<Exact> exact_start = widened(start);
      exact_start.w = exact_sine;
      exact_start.q = exact_cosine;
      const double h = dice.uniform(0, 6.2);
      const auto point = HarmonicFlow<double>(phase, start, 1).at(h);
      const auto right = HarmonicFlow<Exact>(exact_phase, exact_start, Exact(1)).at(Exact(h));
      BOOST_TEST(off(point.y, right.y) <= 1e-14, "r " << r << " h " << h);
      BOOST_TEST(off(point.v, right.v) <= 1e-14, "r " << r << " h " << h);
      BOOST_TEST(off(point.a, right.a) <= 1e-14, "r " << r << " h " << h);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_series_keeps_the_digits_of_a_motion_that_begins_like_h3) {
  // From v = a = 0 at w = 0, q = -1: v = h^2 r / 2 + ..., y = h^3 r / 6 + ...
  for (const double h : {1.0, 1e-2, 1e-5, 1e-9}) {
    const HarmonicPoint<double> start{0, 0, 0, 0, -1};
    const auto point = shifted(start, 0.9, h);
    const auto right = shifted(widened(start), Exact(0.9), Exact(h));
    BOOST_TEST(off(point.y, right.y) <= 4e-16 * std::abs(point.y));
    BOOST_TEST(off(point.v, right.v) <= 4e-16 * std::abs(point.v));
  }
}

BOOST_AUTO_TEST_CASE(the_terms_of_a_linear_piece_keep_their_digits) {
  for (const double h : {1e-12, 1e-3, 0.02, 0.1, 0.1249, 0.1251, 0.5, 0.999, 1.001, 3.0, 6.28}) {
    const LinearTerms<double> terms(h);
    const LinearTerms<Exact> right{Exact(h)};
    BOOST_TEST(off(terms.sine, right.sine) <= 3e-16 * std::fmax(std::abs(terms.sine), 1e-3 * h));
    BOOST_TEST(off(terms.versine, right.versine) <= 4e-16 * terms.versine);
    BOOST_TEST(off(terms.lag, right.lag) <= 2e-15 * terms.lag);
  }
}

BOOST_AUTO_TEST_CASE(the_bounds_of_sine_and_cosine_are_bounds) {
  for (int i = 1; i <= 314; ++i) {
    const Exact h = Exact(i) / 100;
    const SineBounds<Exact> bound(h);
    BOOST_TEST((bound.sine_low <= sin(h) && sin(h) <= bound.sine_high));
    BOOST_TEST((bound.cosine_low <= cos(h) && 1 - cos(h) <= bound.versine_high));
  }
}

BOOST_AUTO_TEST_CASE(what_is_proved_positive_is_positive) {
  Dice dice(4);
  int proved = 0;
  for (int i = 0; i < 20000; ++i) {
    const double r = dice.power_of_ten(-1, 1.3);
    const double psi = dice.uniform(-3.1, 3.1);
    const double k = dice.power_of_ten(-2, 1);
    const DrivePhase<double> phase(r, 1, psi);
    const auto [sine, cosine] = phase.sin_cos();
    const HarmonicPoint<double> start{0, dice.once_in(4) ? 0 : dice.uniform(0, 1),
                                      dice.uniform(-1, 1), k * sine, k * cosine};
    const HarmonicFlow<double> flow(phase, start, k);
    const double h = dice.uniform(0.01, 6.2);
    if (!(flow.at(h).v >= 0) || !positive_between(start, flow.at(h), r, k, h)) {
      continue;
    }
    ++proved;
    for (int look = 1; look < 60; ++look) {
      BOOST_REQUIRE(flow.at(h * look / 60).v > 0);
    }
  }
  BOOST_TEST(proved > 500);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
