// SPDX-License-Identifier: MIT
#include "record/suite.hpp"
#include "check/runge_kutta.hpp"
#include "record/known_dampers.hpp"

#include "suites_of_records.hpp"

BOOST_AUTO_TEST_SUITE(suite_test)

using namespace stillpoint::design_test;

/// That of the check of a design: what narrow decisions make of Runge-Kutta's 5e-16 a radian.
constexpr double integrator_tolerance = 1e-6;
/// For a motion that amplifies an error ten thousand times more than its neighbours.
constexpr double narrow_tolerance = 1e-9;
/// Of a figure worked out by hand.
constexpr double hand_tolerance = 1e-14;

/// Of many dampers at once, by two threads, and of each alone, as the kernel has them.
BOOST_AUTO_TEST_CASE(figures_are_those_of_each_motion_by_itself) {
  RandomSource random(3901);
  std::vector<SuiteDamper> dampers{{1, 0, 0}, {1, 1e-7, 0}, {1, 1e-9, 1e-9}};  // never rest or late
  for (int i = 0; i < 80; ++i) {
    dampers.push_back({random.uniform(0.5, 2), random.log_uniform(1e-3, 0.3),
                       i % 5 == 0 ? 0 : random.log_uniform(1e-3, 0.3),
                       i % 3 == 0 ? random.uniform(0.01, 0.3) : 0});
  }
  const auto records = two_records().cases.front().records;
  for (const LoadCase& load : {LoadCase{.records = records, .combine = Combine::max},
                               {.records = records, .combine = Combine::mean},
                               {.v0 = 0.8, .combine = Combine::max},
                               {.pulse = HalfSine{1, 2}, .combine = Combine::max}}) {
    const Suite suite(load, {});
    const std::vector<SuiteFigures> together = suite.figures(dampers, 2);
    BOOST_TEST_REQUIRE(together.size() == dampers.size());
    for (std::size_t i = 0; i < dampers.size(); ++i) {
      const SuiteFigures alone = suite.figures(dampers[i]);
      BOOST_TEST(together[i].settled == alone.settled);
      std::vector<SuiteFigures> each;
      for (const CaseMotion& motion : suite.motions()) {
        if (alone.settled) {
          each.push_back(
              suite_figures(forced_response(suite.oscillator(dampers[i]), motion.start, motion.load,
                                            {}, Suite::surface(dampers[i]))));
        }
      }
      for (const auto figure : {&SuiteFigures::peak, &SuiteFigures::acceleration,
                                &SuiteFigures::residual, &SuiteFigures::jump, &SuiteFigures::margin,
                                &SuiteFigures::late, &SuiteFigures::passages}) {
        const double its = alone.*figure;
        const bool are_passages = figure == &SuiteFigures::passages;  // not of a batch
        BOOST_TEST((are_passages || together[i].*figure == its));
        const bool of_load = std::ranges::count(figures_of_load, figure) > 0;
        if (alone.settled && (of_load || are_passages)) {
          const double one = each.front().*figure;
          const double other = each.back().*figure;
          const bool is_mean = of_load && load.combine == Combine::mean;
          BOOST_TEST(its == (is_mean ? (one + other) / 2 : std::max(one, other)));
        }
      }
    }
  }
}

// After the record a single friction has a closed form, which the kernel computes for any length.
BOOST_AUTO_TEST_CASE(a_rest_after_more_than_ten_thousand_half_cycles_does_not_count) {
  const Suite suite(design::design(three_samples()).request.cases.front(), {});
  const std::vector<SuiteDamper> dampers{{1, 1e-6, 0}, {1, 1e-4, 0}, {1, 0, 1e-7}, {1, 0, 1e-5}};
  const std::vector<SuiteFigures> together = suite.figures(dampers, 1);
  for (std::size_t i = 0; i < dampers.size(); ++i) {
    const ForcedResponse motion =
        forced_response(suite.oscillator(dampers[i]), {}, suite.motions()[0].load);
    const bool in_time = i % 2 == 1;
    BOOST_TEST((motion.half_cycles.value() <= 10'000) == in_time);
    BOOST_TEST(suite.figures(dampers[i]).settled == in_time);
    BOOST_TEST(together[i].settled == in_time);
  }
}

BOOST_AUTO_TEST_CASE(the_check_sees_the_same_motions_of_random_dampers) {
  RandomSource random(1301);
  const LoadCase suite = two_records().cases.front();
  int decided = 0;
  for (int i = 0; i < 120; ++i) {
    Oscillator oscillator{random.uniform(0.7, 1.5), random.uniform(0.001, 0.2),
                          i % 4 == 0 ? 0 : random.uniform(0.0001, 0.01)};
    Surface surface;
    if (i % 4 == 1) {
      surface.notch_width = random.uniform(0.01, 0.1) * metre;
    } else if (i % 4 == 2) {
      oscillator.hold = random.uniform(0, 0.2);
    }
    const Record& record = suite.records[static_cast<std::size_t>(i % 2)].record;
    const ForcedResponse kernel = forced_response(oscillator, {}, record, {}, surface);
    if (kernel.decision_margin.value_or(1) < least_suite_margin) {
      continue;
    }
    ++decided;
    const SuiteFigures other = integrate_to_rest(oscillator, surface, record);
    BOOST_TEST_CONTEXT("damper " << i << ": p = " << oscillator.p << ", f = " << oscillator.f
                                 << ", delta = " << oscillator.delta
                                 << ", hold = " << oscillator.hold.value_or(-1)
                                 << ", width = " << surface.notch_width.value_or(0)) {
      const double size = kernel.peak_amplitude;
      BOOST_TEST(other.settled);
      BOOST_TEST(std::abs(other.peak - size) <= integrator_tolerance * size);
      BOOST_TEST(std::abs(other.acceleration - kernel.peak_absolute_acceleration) <=
                 integrator_tolerance * kernel.peak_absolute_acceleration);
      BOOST_TEST(std::abs(other.residual - std::abs(kernel.stop_position.value())) <=
                 integrator_tolerance * size);
    }
  }
  BOOST_TEST(decided >= 110);
}

// From rest, W exceeds f = 1 for g before its crest at 1 + g and then falls as it rose: v vanishes
// (1 + sqrt(2)) g after the crest, where x is g^3 (1/6 + c/2 + c^2/2 - c^3/6), c = 1 + sqrt(2), all
// over (1 + g)^2. The spring hardly matters within so short a time, a small part of a step.
BOOST_AUTO_TEST_CASE(the_check_finds_the_turn_of_a_slip_that_is_faster_first) {
  constexpr double g = 1e-5;
  const double c = 1 + std::sqrt(2.0);
  const double peak = g * g * g / (1 + g) / (1 + g) * (1.0 / 6 + c / 2 + c * c / 2 - c * c * c / 6);
  const SuiteFigures found = integrate_to_rest({1, 1, 0}, {}, Record{{0, 1 + g, 0}, 1, {}});
  BOOST_TEST(found.peak == peak, tt::tolerance(narrow_tolerance));
}

// Steps of 1/200 are 3e-7 off here, where they are 3e-11 off at p = 0.995.
BOOST_AUTO_TEST_CASE(the_check_has_digits_left_where_the_motion_enlarges_errors) {
  const Oscillator oscillator{0.99400696, 0, 0.037056, 0.1};
  const Record record = recorded("strong_motion.AT2").record;
  const ForcedResponse kernel = forced_response(oscillator, {}, record);
  const SuiteFigures other = integrate_to_rest(oscillator, {}, record);
  BOOST_TEST(kernel.decision_margin.value() >= 1e-3);
  BOOST_TEST(std::abs(other.peak - kernel.peak_amplitude) <=
             narrow_tolerance * kernel.peak_amplitude);
}

// The notch that takes as much as spring and load can give on the way back from the limit of the
// peak stops every return of an admissible motion, and so does one that takes ten times as much.
BOOST_AUTO_TEST_CASE(a_delta_beyond_the_default_range_makes_no_difference) {
  RandomSource random(1302);
  int compared = 0;
  for (int i = 0; i < 200; ++i) {
    RecordDesignRequest request = two_records();
    const double p = random.uniform(0.7, 1.5);
    request.cases.front().records.erase(request.cases.front().records.begin() + i % 2);
    request.p = {p, p};
    request.hold = i % 4 < 2 ? std::optional(random.uniform(0, 0.2)) : std::nullopt;
    request.cases.front().limits.jump = 9;
    request.f = Interval{0.2, 0.2};
    RecordDesignRequest probe = request;
    probe.delta.reset();
    const double most =
        suite_map(probe, {p, 0.2, 0, 0}, false, 1).delta.front() * 2;  // the middle of the one cell
    const double f = random.uniform(0.01, 0.15);
    const Record& load = request.cases.front().records.front().record;
    const ForcedResponse at_most = forced_response({p, f, most, request.hold}, {}, load);
    if (at_most.peak_amplitude > *request.cases.front().limits.peak) {
      continue;
    }
    ++compared;
    const ForcedResponse beyond = forced_response({p, f, 10 * most, request.hold}, {}, load);
    BOOST_TEST(at_most.peak_amplitude == beyond.peak_amplitude);
    BOOST_TEST(at_most.peak_absolute_acceleration == beyond.peak_absolute_acceleration);
    BOOST_TEST(at_most.stop_position.value() == beyond.stop_position.value());
  }
  BOOST_TEST(compared >= 50);
}

// From f = 0.2 to 0.4 in ten cells: about 0.29, the fifth, the middles from 0.29 x 0.9 = 0.261 to
// 0.319 are 0.27, 0.29 and 0.31.
BOOST_AUTO_TEST_CASE(a_map_of_boxes_has_the_worst_about_each_place) {
  RecordDesignRequest request = design::design(three_samples()).request;
  request.f = Interval{0.2, 0.4};
  request.delta = Interval{0, 0};
  const SuiteMap map = suite_map(request, {1, 0, 0, 0}, true, 10);
  const Suite suite(request.cases.front(), {});
  SuiteFigures worst;
  for (const double f : {0.27, 0.29, 0.31}) {
    worst = worse(worst, suite.figures({1, f, 0, 0}));
  }
  BOOST_REQUIRE(map.figures.size() == 100);
  BOOST_TEST(std::abs(map.figures[40].front().peak - worst.peak) <= hand_tolerance);
  BOOST_TEST(std::abs(map.figures[40].front().acceleration - worst.acceleration) <= hand_tolerance);
}

/// Whatever the rounding of 1/p, from which a period is read back.
BOOST_AUTO_TEST_CASE(a_box_knows_its_own_corners) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> value(0.5, 2);
  for (int i = 0; i < 1000; ++i) {
    RecordDesignRequest request;
    const double p = value(random);
    request.p = {p, p};
    request.f = Interval{0.01, 1};
    request.delta = Interval{0, 0};
    request.tolerance.f = {0.1, 0.2};
    request.tolerance.period = {0.05, 0.03};
    const SuiteSpace space(request, SuiteFrictions::constant);
    const SuiteDamper nominal{p, 0.1 * value(random), 0, 0};
    for (const SuitePlace& corner : {SuitePlace{-1, -1}, {-1, 1}, {1, -1}, {1, 1}}) {
      SuiteFigures figures;
      figures.peak = 1;
      KnownDampers known(space);
      known.add(std::array{space.off(nominal, corner)}, std::array{TaskFigures(1, figures)});
      BOOST_TEST(known.worst(nominal).front().peak == 1, "p = " << p << ", f = " << nominal.f);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
