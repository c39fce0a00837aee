// SPDX-License-Identifier: MIT
#include "testing/forced_scene.hpp"
#include "testing/printing.hpp"
#include "testing/scene_s5.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/peers/comparison.hpp>
#include <stillpoint/peers/exact.hpp>
#include <stillpoint/peers/methods.hpp>
#include <stillpoint/peers/reference.hpp>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

// The speed comparison is only as good as the methods that it compares: each must find the
// reference motions with a fine setting, and be shown with its errors with a coarse one.

namespace stillpoint::peers {

BOOST_AUTO_TEST_SUITE(peers_test)

namespace {

const std::vector<ReferenceScene>& scenes() {
  static const std::vector<ReferenceScene> all =
      reference_scenes(std::string(STILLPOINT_DATA_DIR) + "/reference");
  return all;
}

const ReferenceScene& scene(const std::string& name) {
  const auto found = std::find_if(scenes().begin(), scenes().end(),
                                  [&](const ReferenceScene& one) { return one.name == name; });
  BOOST_REQUIRE(found != scenes().end());
  return *found;
}

void counts_are_right(const ReferenceScene& scene, const Result& result) {
  BOOST_TEST(result.passages == scene.truth.passages);
  BOOST_TEST(result.turns == scene.truth.turns);
  BOOST_TEST(result.sticks == scene.truth.sticks);
  BOOST_TEST(result.outcome == scene.truth.outcome);
}

/// Counts, and every other metric within `tolerance`.
void finds(const ReferenceScene& scene, const Result& result, double tolerance) {
  BOOST_TEST_CONTEXT(scene.name) {
    counts_are_right(scene, result);
    const auto near = [&](const char* what, double value, double truth) {
      BOOST_TEST(std::abs(value - truth) <= tolerance,
                 what << ": " << value << ", true " << truth << ", off by " << value - truth);
    };
    near("peak", result.peak, scene.truth.peak);
    near("x", result.x, scene.truth.x);
    near("v", result.v, scene.truth.v);
    if (scene.free) {
      near("stop time", result.end_time, scene.truth.end_time);
    }
  }
}

Scene with(const Excitation& excitation, const Oscillator& oscillator, const Start& start,
           double t_end) {
  return {oscillator, start, excitation, t_end};
}

}  // namespace

BOOST_AUTO_TEST_CASE(dopri5_finds_the_references) {
  // 1e-12 per step; resonance amplifies the errors, and 424 half-cycles add theirs up.
  finds(scene("S1"), dopri5(scene("S1").scene, 1e-12), 1e-10);
  finds(scene("S2"), dopri5(scene("S2").scene, 1e-12), 1e-7);
  finds(scene("FR"), dopri5(scene("FR").scene, 1e-12), 1e-10);
  finds(scene("S3"), dopri5(scene("S3").scene, 1e-12), 2e-9);
  finds(scene("S4"), dopri5(scene("S4").scene, 1e-12), 1e-10);
  finds(scene("S5"), dopri5(scene("S5").scene, 1e-12), 1e-11);
}

BOOST_AUTO_TEST_CASE(runge_kutta4_finds_the_references) {
  // Its error is some step^4 per unit of time, and more at resonance.
  finds(scene("S1"), runge_kutta4(scene("S1").scene, 0.005), 1e-8);
  finds(scene("S2"), runge_kutta4(scene("S2").scene, 0.01), 1e-6);
  finds(scene("FR"), runge_kutta4(scene("FR").scene, 0.005), 1e-9);
  finds(scene("S3"), runge_kutta4(scene("S3").scene, 0.005), 1e-7);
  finds(scene("S4"), runge_kutta4(scene("S4").scene, 0.005), 1e-9);
  finds(scene("S5"), runge_kutta4(scene("S5").scene, 0.005), 1e-10);
}

BOOST_AUTO_TEST_CASE(runge_kutta4_is_of_fourth_order_across_events) {
  for (const char* name : {"S1", "S4"}) {
    const ReferenceScene& s = scene(name);
    const auto error = [&](double step) {
      const Result result = runge_kutta4(s.scene, step);
      return s.free ? std::abs(result.end_time - s.truth.end_time) : std::abs(result.v - s.truth.v);
    };
    const double order = std::log2(error(0.04) / error(0.02));
    BOOST_TEST(std::abs(order - 4) < 0.5, name << ": order " << order);
  }
}

BOOST_AUTO_TEST_CASE(coarse_settings_are_shown_as_they_are) {
  // One half-cycle too many.
  const Result coarse = dopri5(scene("S1").scene, 1e-3);
  BOOST_TEST(coarse.turns == 12);
  BOOST_TEST(scene("S1").truth.turns == 11);
  // Its gain of energy outweighs the friction: still moving at four times the true stop time, and
  // farther than it ever started.
  const Result endless = dopri5(scene("S2").scene, 1e-3);
  BOOST_TEST(endless.outcome == Outcome::running);
  BOOST_TEST(endless.end_time == scene("S2").scene.t_end);
  BOOST_TEST(endless.peak > 1.5);
}

BOOST_AUTO_TEST_CASE(the_regularised_model_tends_to_the_motion) {
  for (const char* name : {"S1", "S3", "S4"}) {
    const ReferenceScene& s = scene(name);
    const auto error = [&](double width) {
      const Result result = regularised(s.scene, width);
      return s.free ? std::abs(result.end_time - s.truth.end_time)
                    : std::abs(result.x - s.truth.x) + std::abs(result.v - s.truth.v);
    };
    const double coarse = error(1e-2);
    const double fine = error(1e-3);
    BOOST_TEST(fine < coarse / 2, name << ": " << coarse << " then " << fine);
  }
}

BOOST_AUTO_TEST_CASE(peers_give_up_when_told) {
  const Scene& long_one = scene("S2").scene;
  constexpr std::int64_t most = 100;
  for (const Result& result : {dopri5(long_one, 1e-9, {}, most), runge_kutta4(long_one, 1e-2, most),
                               regularised(long_one, 1e-2, {}, most)}) {
    BOOST_TEST(!result.finished);
    BOOST_TEST(result.steps <= most);
    BOOST_TEST(result.outcome == Outcome::running);
    BOOST_TEST(result.end_time > 0);
    BOOST_TEST(result.end_time < long_one.t_end);
  }
  // Held for long by friction under a fast load that ends: checks of the load are effort too.
  const Scene held = with(Harmonic{0.05, 1000, 0, 900}, {1, 0.1, 0}, {0, 0}, 1000);
  BOOST_TEST(!runge_kutta4(held, 1e-2, most).finished);
  BOOST_TEST(runge_kutta4(held, 1e-2).finished);
}

BOOST_AUTO_TEST_CASE(peers_that_come_to_the_end_have_finished) {
  for (const ReferenceScene& now : scenes()) {
    BOOST_TEST(dopri5(now.scene, 1e-9).finished);
    BOOST_TEST(runge_kutta4(now.scene, 1e-2).finished);
    BOOST_TEST(regularised(now.scene, 1e-2).finished);
  }
}

// The same motion in units 2^-17 times as large (f by it, Delta by its square): the arithmetic is
// the same except for exponents, so a method that knows the size gives the same result.
BOOST_AUTO_TEST_CASE(a_scene_in_other_units_is_no_other_problem) {
  const double unit = std::ldexp(1, -17);
  const Scene& s = scene("S1").scene;
  const Scene small =
      with(NoExcitation{}, {1, unit * s.oscillator.f, unit * unit * s.oscillator.delta},
           {0, unit * s.start.v0}, s.t_end);
  const Size size{unit, unit, 1};
  const auto same = [&](const Result& of_small, const Result& of_unit) {
    BOOST_TEST(of_small.turns == of_unit.turns);
    BOOST_TEST(of_small.passages == of_unit.passages);
    BOOST_TEST(of_small.steps == of_unit.steps);
    BOOST_TEST(of_small.peak == unit * of_unit.peak);
    BOOST_TEST(of_small.end_time == of_unit.end_time);
  };
  for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
    same(dopri5(small, tolerance, size), dopri5(s, tolerance));
  }
  same(regularised(small, 1e-2, size), regularised(s, 1e-2));
  // Without the size, it treats the small motion as nearly nothing.
  BOOST_TEST(dopri5(small, 1e-6).turns != scene("S1").truth.turns);
}

namespace {

void every_peer_is(Run run, const Comparison& comparison) {
  for (std::size_t i = 1; i < comparison.rows.size(); ++i) {
    BOOST_TEST(comparison.rows[i].run == run, comparison.rows[i].name);
  }
  BOOST_TEST(comparison.rows.front().run == Run::done);
  BOOST_TEST(comparison.rows.front().counts_right);
}

}  // namespace

BOOST_AUTO_TEST_CASE(where_nothing_moves_no_peer_is_run) {
  const auto nothing_moves = [](const Scene& s) { every_peer_is(Run::nothing_moves, compare(s)); };
  nothing_moves(with(NoExcitation{}, {1, 0.1, 0.2}, {0, 0.1}, 1));    // caught at the start
  nothing_moves(with(NoExcitation{}, {1, 0.5, 0}, {0.25, 0}, 1));     // in the dead zone
  nothing_moves(with(Rectangle{0.05, 1}, {1, 0.1, 0}, {0, 0}, 1));    // k < f
  nothing_moves(with(Harmonic{0.05, 1}, {1, 0.1, 0}, {0, 0}, 1000));  // held for ever
  every_peer_is(Run::done, compare(with(NoExcitation{}, {1, 0.5, 0}, {1, 0}, 10)));
}

BOOST_AUTO_TEST_CASE(what_has_no_end_to_follow_it_to_is_refused) {
  const auto scene_of = [](const Oscillator& oscillator) {
    return comparison_scene({.oscillator = oscillator, .start = {0, 1}, .half_cycle_limit = {}});
  };
  BOOST_CHECK_THROW(static_cast<void>(scene_of({1, 0, 0})), InputError);
  // 1e9 half-cycles by the map, 1e150 by the closed form, which no integer counts.
  BOOST_CHECK_THROW(static_cast<void>(scene_of({1, 1e-9, 1e-9})), TooManyHalfCycles);
  BOOST_CHECK_THROW(static_cast<void>(scene_of({1e150, 1, 0})), TooManyHalfCycles);
}

// f just below k: the mass moves by 1e-23, and the width of the regularised model is then so small
// that its run would take for ever.
BOOST_AUTO_TEST_CASE(what_hardly_moves_is_given_up) {
  const Comparison found = compare(with(FullSine{1, 0.5}, {1, 0.999999999999, 0.125}, {0, 0}, 30));
  BOOST_TEST(found.rows.front().result.turns == 1);
  BOOST_TEST(found.rows.front().peak_error < 1e-8);
  BOOST_TEST(found.rows.back().run == Run::too_long);
  BOOST_TEST(found.rows.back().name == "regularised");
}

// dopri5's errors of S1 follow its tolerance in any units, since both are relative to the peak.
BOOST_AUTO_TEST_CASE(errors_are_relative) {
  for (const double unit : {1.0, 1e-5, 1e-100, 1e100}) {
    const Comparison found =
        compare(with(NoExcitation{}, {1, 0.02 * unit, 0.02 * unit * unit}, {0, unit}, 140));
    const MethodRow& loose = found.rows[1];
    BOOST_TEST(loose.name == "dopri5");
    BOOST_TEST(loose.setting == 1e-6);
    BOOST_TEST(loose.counts_right, "unit " << unit);
    BOOST_TEST(loose.peak_error > 1e-8);
    BOOST_TEST(loose.peak_error < 1e-6);
    BOOST_TEST(loose.end_error < 2e-6);
    BOOST_TEST(found.rows.front().peak_error < 4e-16);
    BOOST_TEST(found.rows.front().end_error < 1e-15);
  }
}

// Pulses, an excitation that ends, a start at x0, an uneven record: the rules beyond the scenes,
// against the exact kernel.
BOOST_AUTO_TEST_CASE(other_excitations_follow_the_same_rules) {
  Record uneven;
  uneven.values = {0.3, -0.2, 0.25, 0.1, -0.3};
  uneven.times = {0.5, 2, 3.25, 6, 8};
  const std::vector<Scene> all{
      with(HalfSine{0.5, 2}, {1, 0.05, 0.01}, {0, 0}, 20),
      with(FullSine{0.5, 1.5}, {1.3, 0.04, 0}, {0, 0.3}, 20),
      with(Rectangle{0.4, 1}, {0.8, 0.06, 0.02}, {0.5, -0.2}, 20),
      with(Harmonic{0.3, 0.9, 0.7, 12}, {1, 0.05, 0.005}, {-0.4, 0}, 40),
      with(uneven, {1, 0.04, 0.001}, {0, 0.5}, 12),
      with(Harmonic{0.05, 1.3}, {1, 0.1, 0.01}, {0, 1}, 60),  // held for ever in the end: k < f
      with(NoExcitation{}, {2, 0.1, 0.01}, {0.3, -1}, 30),
      with(NoExcitation{}, {1, 0.1, 0.6}, {0, 1}, 5),  // caught at the start
  };
  constexpr double tolerance = 1e-9;
  for (const Scene& s : all) {
    const ForcedResponse exact =
        forced_response(s.oscillator, s.start, s.excitation, {.t_end = s.t_end});
    BOOST_TEST_CONTEXT("excitation " << s.excitation.index()) {
      for (const Result& result : {dopri5(s, 1e-13), runge_kutta4(s, 1e-3)}) {
        BOOST_TEST(result.outcome == exact.outcome);
        BOOST_TEST(std::abs(result.peak - exact.peak_amplitude) < tolerance);
        BOOST_TEST(std::abs(result.x - *exact.final_position) < tolerance);
        BOOST_TEST(std::abs(result.v - *exact.final_velocity) < tolerance);
        BOOST_TEST(std::abs(result.end_time - *exact.end_time) < tolerance);
        BOOST_TEST(static_cast<double>(result.passages) == *exact.zero_passages);
        BOOST_TEST(static_cast<double>(result.turns) == *exact.turning_points);
        BOOST_TEST(static_cast<double>(result.sticks) == exact.sticks);
      }
    }
  }
}

// Notches that hold only so much or have a width, and friction in zones: docs/notches.md section 2.
// The peers share only the rules with the kernel.
BOOST_AUTO_TEST_CASE(random_real_notches_follow_the_same_rules) {
  test::Dice dice(40403);
  constexpr int count = 400;
  constexpr double decided_margin = 1e-6;
  constexpr double tolerance = 1e-8;  // 1e-13 per step, and what the motion enlarges
  int undecided = 0;
  for (int i = 0; i < count; ++i) {
    const test::ForcedScene<> drawn = test::random_notched_scene(dice);
    const Scene s{drawn.oscillator(), drawn.motion.start(), drawn.excitation,
                  std::min(drawn.t_end, 25 / drawn.motion.p), drawn.surface};
    const ForcedResponse exact =
        forced_response(s.oscillator, s.start, s.excitation, {.t_end = s.t_end}, s.surface);
    if (!exact.decision_margin || exact.decision_margin < decided_margin) {
      ++undecided;
      continue;
    }
    const double length = std::max(exact.peak_amplitude, 1e-300);
    const Size size{length, s.oscillator.p * length, 1 / s.oscillator.p};
    const Result result = dopri5(s, 1e-13, size);
    BOOST_TEST_CONTEXT(drawn) {
      BOOST_TEST(result.finished);
      BOOST_TEST(static_cast<double>(result.passages) == *exact.zero_passages);
      BOOST_TEST(static_cast<double>(result.turns) == *exact.turning_points);
      BOOST_TEST(static_cast<double>(result.sticks) == exact.sticks);
      BOOST_TEST(result.outcome == exact.outcome);
      BOOST_TEST(std::abs(result.peak - exact.peak_amplitude) <= tolerance * size.length);
      BOOST_TEST(std::abs(result.x - *exact.final_position) <= tolerance * size.length);
      BOOST_TEST(std::abs(result.v - *exact.final_velocity) <= tolerance * size.speed);
      BOOST_TEST(std::abs(result.end_time - *exact.end_time) <= tolerance * s.t_end);
    }
  }
  BOOST_TEST(undecided <= count / 10);
}

// Nothing holds the mass, and the load begins at 0: x'' + x = -k sin(lambda t).
BOOST_AUTO_TEST_CASE(a_load_that_begins_at_what_friction_holds_moves_the_mass_at_once) {
  const Scene s = with(Harmonic{0.1, 0.5}, {1, 0, 0}, {0, 0}, 10);
  const double x = -0.1 * (std::sin(5.0) - 0.5 * std::sin(10.0)) / (1 - 0.25);
  BOOST_TEST(std::abs(dopri5(s, 1e-12).x - x) < 1e-10);
  BOOST_TEST(std::abs(runge_kutta4(s, 1e-3).x - x) < 1e-10);
}

BOOST_AUTO_TEST_CASE(real_notches_are_compared_with_50_digits) {
  const auto request = [](const Oscillator& oscillator, const Surface& surface,
                          const Excitation& excitation = {}) {
    return SimulationRequest{.oscillator = oscillator,
                             .start = {0, 1},
                             .excitation = excitation,
                             .surface = surface,
                             .half_cycle_limit = {}};
  };
  for (const SimulationRequest& one :
       {request({1, 0.26, 0.37}, {0.05, {}}), request({1, 0.02, 0.02}, {0.1, {{0.3, 0.04}}}),
        request({1, 0.05, 0.05}, {0.1, {}}, HalfSine{0.5, 1}),
        request({1, 0.1, 0}, {{}, {{0.2, 0.3}, {0.5, 0.15}}}),
        request({1, 0.05, 0.05, 0.2}, {}, HalfSine{0.5, 1})}) {
    const Comparison found = compare(comparison_scene(one));
    BOOST_TEST(found.rows.front().counts_right);
    BOOST_TEST(found.rows.front().peak_error <= 1e-15);
    BOOST_TEST(found.rows.front().end_error <= 1e-14);
    bool regularised = false;
    for (const MethodRow& row : found.rows) {
      regularised = regularised || row.name == "regularised";
      if ((row.name == "dopri5" && row.setting == 1e-12) ||
          (row.name == "RK4" && row.setting < 0.002)) {
        BOOST_TEST(row.counts_right);
        BOOST_TEST(row.end_error <= 1e-8);
      }
    }
    BOOST_TEST(regularised == std::isinf(one.oscillator.hold));  // the model has no hold
  }
}

BOOST_AUTO_TEST_CASE(the_regularised_model_knows_widths_and_zones) {
  const Scene s{{1, 0.02, 0.02}, {0, 1}, NoExcitation{}, 140, {0.1, {{0.3, 0.04}}}};
  const Result truth = kernel(s);
  const auto error = [&](double width) {
    return std::abs(regularised(s, width).end_time - truth.end_time);
  };
  BOOST_TEST(error(1e-3) < error(1e-2) / 2);
  BOOST_TEST(regularised(s, 1e-3).outcome == Outcome::stopped_in_notch);
  BOOST_TEST(regularised(s, 1e-3).passages == truth.passages);
}

// k < f: the mass comes to rest for good although the load never ends.
BOOST_AUTO_TEST_CASE(a_rest_that_a_harmonic_load_cannot_end_is_final) {
  const Comparison found = compare(with(Harmonic{0.05, 1.3}, {1, 0.1, 0.01}, {0, 1}, 60));
  BOOST_TEST(found.exact.rounded.outcome != Outcome::running);
  for (const MethodRow& row : found.rows) {
    const bool fine = row.name != "dopri5" || row.setting < 1e-6;
    BOOST_TEST((row.counts_right || !fine), row.name << ' ' << row.setting);
  }
}

BOOST_AUTO_TEST_CASE(the_record_is_that_of_the_reference) {
  const auto& record = std::get<Record>(scene("S5").scene.excitation);
  BOOST_TEST(record.values == test::rounded_record_s5().values, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(tables_that_are_not_there_are_an_error) {
  BOOST_CHECK_THROW(static_cast<void>(reference_scenes("/nowhere")), std::runtime_error);
}

// The tables were made by another method than the kernel's rules in 50 digits.
BOOST_AUTO_TEST_CASE(fifty_digits_and_the_tables_agree) {
  for (const ReferenceScene& now : scenes()) {
    BOOST_TEST_CONTEXT(now.name) {
      const ExactResult result = exact(now.scene, 1e4);
      counts_are_right(now, result.rounded);
      const auto near = [](const Wide& value, double truth) {
        return value.error_of(truth) <= 2e-16 * std::max(1.0, std::abs(truth));
      };
      BOOST_TEST(near(result.peak, now.truth.peak));
      if (now.free) {
        BOOST_TEST(near(result.end_time, now.truth.end_time));
      } else {
        BOOST_TEST(near(result.x, now.truth.x));
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::peers
