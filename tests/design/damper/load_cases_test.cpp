// SPDX-License-Identifier: MIT
#include "record/suite.hpp"
#include "suites_of_records.hpp"

BOOST_AUTO_TEST_SUITE(load_cases_test)

// A design with several load cases: against each load by itself, and against the engines that know
// hits and pulses exactly.

using namespace stillpoint::design_test;

/// Of the largest tolerance, absolute: what the docs promise of a box.
constexpr double of_tolerance = 5e-3;

BOOST_AUTO_TEST_CASE(limits_of_one_case_may_stand_in_two) {
  RecordDesignRequest request = short_records();
  request.scan_points = 400;
  request.delta = Interval{0, 0};
  const RecordDesign one = design::design(request);
  const RecordDesign two = design::design(split(request));
  BOOST_REQUIRE(one.finding.has_value());
  BOOST_REQUIRE(two.finding.has_value());
  BOOST_TEST(two.nearest.damper.f == one.nearest.damper.f);
  BOOST_REQUIRE(two.constraints.size() == 2U);
  BOOST_TEST(two.constraints[0].in_case == "stroke");
  BOOST_TEST(two.constraints[1].in_case == "residual");
  BOOST_TEST(two.constraints[0].value == one.constraints[0].value);
  BOOST_TEST(two.constraints[1].value == one.constraints[1].value);
  const auto of_stroke = governing(two, 0);
  BOOST_REQUIRE(of_stroke.has_value());
  BOOST_TEST(of_stroke->constraint.name == "amplitude");
  BOOST_TEST(of_stroke->part_left == two.constraints[0].slack / two.constraints[0].limit);
  // The damper of the box and the record with that stroke.
  const SimulationRequest motion =
      motion_of(two.request, of_stroke->damper,
                motions_of(two.request.cases[0])[two.finding->box.in[0].front()]);
  BOOST_TEST(simulate(motion).response.peak_amplitude == two.constraints[0].value);
}

/// Of length pi.
Record rectangle(double k) {
  constexpr double edge = 1e-9;
  constexpr double pi = std::numbers::pi;
  return {{k, k, 0, 0}, 0, {0, pi, pi + edge, 2 * pi}};
}

// The engine of pulses knows the largest box from one motion per f. As a record a first return is a
// residual of 0, at any return; later ones have smaller boxes here. docs/theory.md has 41.6 %.
BOOST_AUTO_TEST_CASE(a_pulse_as_a_record_has_the_box_of_the_design_for_it) {
  const double most =
      design::design(DesignRequest{.problem = {.beta = 0.8}, .pulse = Rectangle{0.5, 1}})
          .finding.value()
          .point.tolerance;
  const RecordDesign found = design::design({.cases = {{.records = {{"pulse", rectangle(0.5), 1}},
                                                        .limits = {.peak = 0.8, .residual = 0}}},
                                             .objective = SuiteObjective::robust});
  BOOST_REQUIRE(found.finding.has_value());
  BOOST_TEST(std::abs(found.largest_tolerance.value() - most) <= of_tolerance,
             *found.largest_tolerance << ", the design for it has " << most);
  BOOST_TEST(found.finding->cross_check.passed);
}

// A notch without a width that takes all of a hit would hold the mass where it is.
BOOST_AUTO_TEST_CASE(every_damper_of_a_box_lets_a_hit_start) {
  RecordDesignRequest request{.cases = {hit_case(0.5, 1)}, .objective = SuiteObjective::amplitude};
  request.cases.front().limits = {.peak = 1, .residual = 0.5, .passages = 3};
  const RecordDesign found = design::design(request);
  BOOST_REQUIRE(found.finding.has_value());
  BOOST_TEST(found.finding->box.delta.high < 0.125);
  BOOST_TEST(found.nearest.figures.front().peak > 0);
}

BOOST_AUTO_TEST_CASE(the_objective_is_the_largest_of_all_cases_or_that_of_one) {
  const TaskFigures figures{{.acceleration = 0.3}, {.acceleration = 0.2}};
  SuiteGoal goal{&SuiteFigures::acceleration, {}, {{}, {}}};
  BOOST_TEST(goal.value(figures) == 0.3);
  goal.in_case = 1;
  BOOST_TEST(goal.value(figures) == 0.2);
}

BOOST_AUTO_TEST_SUITE_END()
