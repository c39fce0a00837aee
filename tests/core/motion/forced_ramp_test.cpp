// SPDX-License-Identifier: MIT
#include "motion.hpp"

// Records that go on rising: v only touches 0 once a period, rule 5 and (F33) of docs/forced.md.

BOOST_AUTO_TEST_SUITE(forced_ramp_test)

using namespace stillpoint;

constexpr double position_tolerance = 1e-13;  // of the largest x
constexpr double t_end = 343;                 // about 54 periods of p = 1

/// W = jump + slope tau, until t_end at least.
Record ramp(double jump, double slope, double step) {
  Record record{{}, step, {}};
  for (std::size_t i = 0; i < 2 || static_cast<double>(i - 1) * step < t_end; ++i) {
    record.values.push_back(jump + slope * (static_cast<double>(i) * step));
  }
  return record;
}

/// Until t_end, with at most `most` pieces.
ForcedResponse within(int most, const Oscillator& oscillator, const Start& start,
                      const Record& record, double until = t_end) {
  ForcedOptions options{.t_end = until, .ask_every = 1};
  options.go_on = [most, pieces = 0](double /*tau*/) mutable { return ++pieces <= most; };
  const ForcedResponse response = forced_response(oscillator, start, record, options);
  BOOST_TEST(!response.cancelled);
  return response;
}

BOOST_AUTO_TEST_CASE(a_mass_on_a_ramp_pauses_once_a_period_and_never_turns) {
  for (const double step : {0.1, 1.0, 7.0, 50.0, 343.0, 2 * std::numbers::pi}) {
    for (const double slope : {0.5, -0.3}) {
      for (const double p : {1.0, 2.6, 11.0}) {
        for (const double f : {0.0, 0.01}) {
          const Record record = ramp(0, slope, step);
          const int intervals = static_cast<int>(record.values.size());
          const int periods = static_cast<int>(p * t_end / (2 * std::numbers::pi)) + 1;
          const auto run = within(3 * (intervals + periods), {p, f, 0.1}, {0, 0}, record);
          const double wait = f / std::abs(slope);
          const double t = t_end - wait;
          const double x = -slope / (p * p) * (t - std::sin(p * t) / p);
          BOOST_TEST_CONTEXT("step " << step << " slope " << slope << " p " << p << " f " << f) {
            BOOST_TEST(run.turning_points.value() == 0);
            BOOST_TEST(std::abs(run.final_position.value() - x) <=
                       position_tolerance * std::abs(x));
            BOOST_TEST(run.sticks == (f > 0 ? 1 : 0));
            BOOST_TEST(std::abs(run.stick_time - wait) <= 1e-15);
            BOOST_TEST(run.decision_margin.value() == 0);
          }
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_ramp_that_begins_with_a_jump_turns_the_mass_twice_a_period) {
  // v = jump sin t + slope (1 - cos t) to the left, which is below 0 at the end of each period.
  for (const double step : {0.1, 1.0, 343.0}) {
    for (const double jump : {1e-1, 1e-3, 1e-6}) {
      const auto run = within(20000, {1, 0, 0}, {0, 0}, ramp(jump, 0.5, step), 20);
      BOOST_TEST_CONTEXT("step " << step << " jump " << jump) {
        BOOST_TEST(run.turning_points.value() == 6);
        const double x = -(jump * (1 - std::cos(20.0)) + 0.5 * (20 - std::sin(20.0)));
        BOOST_TEST(std::abs(run.final_position.value() - x) <= position_tolerance * std::abs(x));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(after_a_touch_on_a_sample_the_next_load_decides) {
  // W sets the mass off at f, at a rate of 0.5 for a period, and then falls by less than 2 f.
  const double period = 2 * std::numbers::pi;
  const double top = 0.1 + 0.5 * period;
  Record record{{0.1, top, top - 0.15, top - 0.15}, period, {}};
  const auto run = within(100, {1, 0.1, 0.1}, {0, 0}, record, 2.5 * period);
  BOOST_TEST(run.turning_points.value() == 1);
  BOOST_TEST(run.sticks == 1);
  BOOST_TEST(std::abs(run.stick_time - 1.5 * period) <= 1e-7);  // v is as flat as that there
  BOOST_TEST(std::abs(run.final_position.value() + 0.5 * period) <= position_tolerance);
}

BOOST_AUTO_TEST_CASE(a_turn_where_the_load_hardly_exceeds_friction_and_falls_comes_once) {
  // |W + p^2 x| exceeds f by rounding alone: the mass is held after some 1e-16, within an ulp of
  // the time since the sample.
  struct Scene {
    double p, f, v0, w, fall;
  };
  for (const Scene& scene : {Scene{1.4498545161345198, 0.52574080408425439, 0.046915144976313904,
                                   0.52889924608138494, 0.12020427351594103},
                             Scene{1.4418152495245318, 0.4210040011248668, 0.034626287053206244,
                                   0.42601690284111138, 0.15825278097918394}}) {
    Record record{{scene.w, scene.w - scene.fall * 10}, 10, {}};
    const auto run = within(100, {scene.p, scene.f, 0}, {0, scene.v0}, record, 9.9);
    BOOST_TEST(run.turning_points.value() <= 4);
    BOOST_TEST(run.decision_margin.value() < 1e-15);
  }
}

BOOST_AUTO_TEST_SUITE_END()
