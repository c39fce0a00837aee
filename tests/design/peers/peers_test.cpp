// SPDX-License-Identifier: MIT
#include "design/peers/reference_scenes.hpp"
#include "testing/scene_s5.hpp"

#include <stillpoint/peers/exact.hpp>

#include <variant>

// The speed comparison is only as good as the methods that it compares: each must find the
// reference motions with a fine setting, and be shown with its errors with a coarse one.

namespace stillpoint::peers {

BOOST_AUTO_TEST_SUITE(peers_test)

/// Counts, and every other metric within `tolerance`.
void finds(const ReferenceScene& scene, const Result& result, double tolerance) {
  BOOST_TEST_CONTEXT(scene.name) {
    BOOST_TEST(result.finished);
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

BOOST_AUTO_TEST_CASE(dopri5_and_runge_kutta4_find_the_references) {
  struct Row {
    const char* name;
    double of_dopri5;  ///< 1e-12 per step; resonance amplifies it, 424 half-cycles add theirs up
    double step;
    double of_rk4;  ///< some step^4 per unit of time, and more at resonance
  };
  for (const Row& row : {Row{"S1", 1e-10, 0.005, 1e-8}, Row{"S2", 1e-7, 0.01, 1e-6},
                         Row{"FR", 1e-10, 0.005, 1e-9}, Row{"S3", 2e-9, 0.005, 1e-7},
                         Row{"S4", 1e-10, 0.005, 1e-9}, Row{"S5", 1e-11, 0.005, 1e-10}}) {
    const Scene& now = scene(row.name).scene;
    finds(scene(row.name), dopri5(now, 1e-12), row.of_dopri5);
    finds(scene(row.name), runge_kutta4(now, row.step), row.of_rk4);
    BOOST_TEST(regularised(now, 1e-2).finished);
  }
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

BOOST_AUTO_TEST_CASE(the_record_is_that_of_the_reference) {
  const auto& record = std::get<Record>(scene("S5").scene.excitation);
  BOOST_TEST(record.values == test::rounded_record_s5().values, tt::per_element());
}

BOOST_AUTO_TEST_CASE(missing_tables_are_an_error) {
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
