// SPDX-License-Identifier: MIT
#include "damper.hpp"
#include "pulse/edge.hpp"
#include "pulse/first_return.hpp"
#include "pulse/worst_return.hpp"
#include "pulse_task.hpp"

BOOST_AUTO_TEST_SUITE(pulse_profile_test)

// What the samples of f know of the motions between them: whether the mass returns, the largest
// peak, and each local maximum of the need. They are no proof, so this counts.

using namespace stillpoint::design_test;

/// A need that rises above what a box knows that ends on either side of it, as a part of that.
double hidden_top(const std::vector<double>& needs) {
  std::vector<double> behind(needs.size());
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = needs.size(); i-- > 0;) {
    least = behind[i] = std::min(least, needs[i]);
  }
  double hidden = 0;
  least = needs.front();
  for (std::size_t i = 0; i < needs.size(); ++i) {
    least = std::min(least, needs[i]);
    hidden = std::max(hidden, needs[i] / std::max(least, behind[i]) - 1);
  }
  return hidden;
}

struct Missed {
  int returns{0};
  double peak{0};  ///< above the larger of both neighbours, as a part of it
  double need{0};
};

/// Over 30 motions between each two neighbours.
Missed missed_by(const WorstReturn& profile, Criterion criterion) {
  constexpr int steps = 30;
  Missed missed;
  const auto& samples = profile.samples();
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const FirstReturn& a = samples[i - 1];
    const FirstReturn& b = samples[i];
    if (a.returns != b.returns || b.f - a.f <= 4 * edge_width(a.f, b.f)) {
      continue;
    }
    std::vector<double> needs{a.need(criterion)};
    for (int j = 1; j < steps; ++j) {
      const FirstReturn now = profile.at(a.f + (b.f - a.f) * j / steps);
      missed.returns += now.returns != a.returns ? 1 : 0;
      if (now.returns && a.returns) {
        missed.peak = std::max(missed.peak, now.peak / std::max(a.peak, b.peak) - 1);
        needs.push_back(now.need(criterion));
      }
    }
    needs.push_back(b.need(criterion));
    missed.need = a.returns ? std::max(missed.need, hidden_top(needs)) : missed.need;
  }
  return missed;
}

constexpr double slowest = 5.6;  // p/lambda

// The numbers are those of docs/theory.md section 8.
BOOST_AUTO_TEST_CASE(samples_know_every_local_maximum_between_them) {
  RandomSource random(20261122);
  constexpr int pulses = 3000;
  constexpr double visible = 1e-4;
  int above = 0;
  double most = 0;
  for (int i = 0; i < pulses; ++i) {
    const double slowness = random.log_uniform(0.01, slowest);
    const Pulse pulse = random_pulse(random, 1, 1 / slowness);
    const auto criterion = i % 2 == 0 ? Criterion::exact : Criterion::published;
    const WorstReturn profile({.pulse = pulse, .criterion = criterion});
    const Missed missed = missed_by(profile, criterion);
    BOOST_TEST_CONTEXT("pulse " << i << ", " << name(pulse) << ", p/lambda " << slowness) {
      BOOST_TEST(missed.returns == 0);
      BOOST_TEST(missed.peak <= 1e-6);
      BOOST_TEST(missed.need <= 10 * visible);
    }
    above += missed.need > visible ? 1 : 0;
    most = std::max(most, missed.need);
  }
  BOOST_TEST_MESSAGE(above << " of " << pulses << " need more than their samples by " << visible
                           << ", " << most << " more at most");
  BOOST_TEST(above <= pulses / 1000);
}

// Near lambda = 0.1615 the mass comes back for all f below 0.3 but those of a gap, which ends
// there.
BOOST_AUTO_TEST_CASE(samples_know_a_gap_of_the_return) {
  int gaps = 0;
  constexpr int pulses = 200;
  for (int i = 0; i < pulses; ++i) {
    const double lambda = 0.1605 + 0.0015 * i / pulses;
    const WorstReturn profile({.pulse = HalfSine{1, lambda}, .criterion = Criterion::exact});
    const auto misses = [](const FirstReturn& now) { return now.f < 0.15 && !now.returns; };
    bool missed = false;
    for (int j = 0; j < 1000; ++j) {
      missed = missed || misses(profile.at(0.07 + 0.06 * j / 1000));
    }
    gaps += missed ? 1 : 0;
    BOOST_TEST((!missed || std::ranges::any_of(profile.samples(), misses)), "lambda " << lambda);
  }
  BOOST_TEST(gaps >= pulses / 2);
}

// Between two values that a coarse look would take, the need rises by 3 % and falls again.
BOOST_AUTO_TEST_CASE(a_box_asks_for_the_largest_need_within_it) {
  const PulseRequest request = request_of(HalfSine{1, 1 / 4.937611}, 10);
  constexpr double low = 0.0390625;
  constexpr double high = 0.046333936;
  double largest = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double f = low + (high - low) * i / 1000;
    largest = std::max(largest, scanned(request, request.problem.pulse, 1, f).need);
  }
  const WorstReturn worst(request.problem);
  BOOST_TEST(largest >= 1.03 * worst.at(low).exact_need);
  BOOST_TEST(largest >= 1.03 * worst.at(high).exact_need);
  const double need = KnownMotions(worst).need_between(low, high, Criterion::exact);
  BOOST_TEST(need >= largest * (1 - 1e-12));
  BOOST_TEST(need <= largest * (1 + 1e-5));
}

// While the mass is held from the first turn on, f >= 1/3, it comes back otherwise than below.
BOOST_AUTO_TEST_CASE(a_rectangle_has_its_kinks_as_samples) {
  const WorstReturn profile({.pulse = Rectangle{1, 0.3}, .criterion = Criterion::exact});
  for (const double kink : {1.0 / 3, 1.0 / 5, 1.0 / 7}) {
    BOOST_TEST(std::ranges::count(profile.samples(), kink, &FirstReturn::f) == 1);
  }
}

// Without friction too: the others would cost a hundred times as much.
BOOST_AUTO_TEST_CASE(of_one_f_there_is_one_sample) {
  for (const double f : {0.0, 0.1}) {
    const WorstReturn profile({.pulse = HalfSine{1, 1}}, true, {f, f});
    BOOST_TEST_REQUIRE(profile.samples().size() == 1);
    BOOST_TEST(profile.samples().front().f == f);
  }
}

// The slope of the need is that of two motions nearby.
BOOST_AUTO_TEST_CASE(slopes_are_those_of_differences) {
  RandomSource random(20261124);
  int compared = 0;
  for (int i = 0; i < 5000; ++i) {
    const double slowness = random.log_uniform(0.02, 8);
    const Pulse pulse = random_pulse(random, 1, 1 / slowness);
    const double f = random.uniform(0, std::min(0.999, 2 * slowness));
    const double aside = 1e-6 * f;
    const FirstReturn now = first_return(pulse, 1, f);
    const FirstReturn below = first_return(pulse, 1, f - aside);
    const FirstReturn above = first_return(pulse, 1, f + aside);
    if (!(below.returns && now.returns && above.returns) || below.turns != above.turns) {
      continue;
    }
    ++compared;
    const double slope = (above.exact_need - below.exact_need) / (2 * aside);
    // The one of a kind without a closed form is a difference as well, but to one side.
    const double close = closed_return(pulse, f) ? 1e-5 : 1e-4;
    BOOST_TEST(std::abs(now.need_slope - slope) <= close * (std::abs(slope) + now.exact_need / f),
               name(pulse) << ", p/lambda " << slowness << ", f " << f);
  }
  BOOST_TEST(compared >= 1500);
}

BOOST_AUTO_TEST_SUITE_END()
