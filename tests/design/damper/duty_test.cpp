// SPDX-License-Identifier: MIT
#include "damper.hpp"

#include <stillpoint/design/duty.hpp>

BOOST_AUTO_TEST_SUITE(duty_test)

using namespace stillpoint::design_test;

/// A few roundings.
constexpr double by_hand = 1e-13;

// p = 1, V0 = 1, f = 7/24: A = sqrt(f^2 + 1) - f = 25/24 - 7/24 = 3/4, so the path to the stop at
// x = 0 is 3/2, and w^2/2 = A^2/2 - f A = 9/32 - 7/32 = 1/16. Delta = 1/4 stops it.
const RegionRequest task{{.v0 = 1, .p = 1, .beta = 0.9}, {}, 7.0 / 24, 0.25};

Duty duty_of_task(const RegionRequest& request) {
  return duty_of(shown_damper(request, answer(request)));
}

BOOST_AUTO_TEST_CASE(of_a_hit_is_what_the_paper_gives) {
  const Duty duty = duty_of_task(task);
  BOOST_TEST(duty.motion == "hit");
  BOOST_TEST(duty.stroke == 0.75, tt::tolerance(by_hand));
  BOOST_TEST(duty.peak_velocity == 1);
  BOOST_TEST(duty.most.slip_path == 1.5, tt::tolerance(by_hand));
  BOOST_TEST(duty.most.friction == 7.0 / 16, tt::tolerance(by_hand));
  BOOST_TEST(duty.most.notch == 1.0 / 16, tt::tolerance(by_hand));
  BOOST_TEST(duty.most.damping == 0);
  const FullCycle cycle = duty.cycle.value();
  // 1 + f/A; 4 f A + 2 Delta; that over 2 pi k A^2.
  BOOST_TEST(cycle.secant_stiffness == 25.0 / 18, tt::tolerance(by_hand));
  BOOST_TEST(cycle.energy == 11.0 / 8, tt::tolerance(by_hand));
  BOOST_TEST(cycle.equivalent_damping.value() == 22 / (25 * std::numbers::pi),
             tt::tolerance(by_hand));
}

/// The weakest friction lets it go farthest: sqrt(1 + (0.9 f)^2) - 0.9 f.
BOOST_AUTO_TEST_CASE(within_a_tolerance_has_the_stroke_of_the_weakest_friction) {
  RegionRequest request = task;
  request.limits.tolerance = 0.1;
  const double weakest = 0.9 * 7 / 24;
  BOOST_TEST(duty_of_task(request).stroke_worst.value() == std::hypot(1, weakest) - weakest,
             tt::tolerance(by_hand));
  // Without one it is that of the largest, which reaches beta unless another limit binds first.
  const RegionAnswer largest = answer(task);
  const double f = 7.0 / 24 * (1 - *largest.tolerance);
  BOOST_TEST(duty_of_task(task).stroke_worst.value() == std::hypot(1, f) - f,
             tt::tolerance(by_hand));
}

/// A rectangle of k longer than the way out pushes until it turns: A = 2 (k - f) for p = 1.
BOOST_AUTO_TEST_CASE(under_a_pulse_is_that_of_the_forced_motion) {
  RegionRequest request{{.p = 1, .beta = 2}, {}, 0.25, 1};
  request.limits.tolerance = 0.2;
  request.pulse = Rectangle{1, 0.9};
  const Duty duty = duty_of_task(request);
  BOOST_TEST(duty.motion == "rectangle");
  BOOST_TEST(duty.stroke == 1.5, tt::tolerance(by_hand));
  BOOST_TEST(duty.stroke_worst.value() == 1.6, tt::tolerance(1e-9));  // the search's
}

/// zeta p / sqrt(k) more, and pi c w A^2 with c = 2 zeta p and w^2 = k.
BOOST_AUTO_TEST_CASE(of_a_damped_mass_adds_the_damping_of_the_secant_spring) {
  // p = 1, f = 3, A = 1: k = 4.
  const FullCycle plain = full_cycle({.p = 1, .f = 3, .delta = 1}, 1).value();
  const FullCycle damped = full_cycle({.p = 1, .f = 3, .delta = 1, .zeta = 0.1}, 1).value();
  BOOST_TEST(plain.secant_stiffness == 4);
  BOOST_TEST(plain.energy == 14);
  BOOST_TEST(damped.secant_stiffness == 4);
  BOOST_TEST(damped.energy == 14 + 0.4 * std::numbers::pi, tt::tolerance(by_hand));
  BOOST_TEST(damped.equivalent_damping.value() == 14 / (8 * std::numbers::pi) + 0.05,
             tt::tolerance(by_hand));
}

/// F = f + Delta/w all along: 1 + 2/4 with A = 1 < 4/2; 4 F A = 6.
BOOST_AUTO_TEST_CASE(within_a_notch_has_its_friction_and_no_passage) {
  const Oscillator damper{.p = 1, .f = 1, .delta = 2};
  const FullCycle inside = full_cycle(damper, 1, 4).value();
  BOOST_TEST(inside.secant_stiffness == 2.5);
  BOOST_TEST(inside.energy == 6);
  BOOST_TEST(full_cycle(damper, 2, 4)->energy == 12);  // 4 f A + 2 Delta from there on
  BOOST_TEST(!full_cycle(damper, 0).has_value());
}

/// Of two hits the stronger moves it farther; the energies are the larger ones of both.
BOOST_AUTO_TEST_CASE(of_a_case_is_the_largest_of_its_motions) {
  RecordDesignRequest request;
  request.cases = {{.name = "strong", .v0 = 1, .limits = {.peak = 0.9}},
                   {.name = "weak", .v0 = 0.9, .limits = {.peak = 0.9}}};
  request.f = Interval{7.0 / 24, 7.0 / 24};
  request.delta = Interval{0.25, 0.25};
  request.tolerance = {{}, {}, {}, {}};
  request.judges = true;
  const std::vector<Duty> duties = duties_of(stillpoint::design::design(request));
  BOOST_TEST_REQUIRE(duties.size() == 2U);
  BOOST_TEST(duties[0].stroke == 0.75, tt::tolerance(1e-9));  // forced runs
  BOOST_TEST(duties[0].most.notch == 1.0 / 16, tt::tolerance(1e-9));
  BOOST_TEST(!duties[0].stroke_worst.has_value());
  const double a = std::hypot(7.0 / 24, 0.9) - 7.0 / 24;
  BOOST_TEST(duties[1].stroke == a, tt::tolerance(1e-9));
  BOOST_TEST(duties[1].most.friction == 7.0 / 24 * 2 * a, tt::tolerance(1e-9));
}

BOOST_AUTO_TEST_SUITE_END()
