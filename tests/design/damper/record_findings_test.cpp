// SPDX-License-Identifier: MIT
// What a design under records must say beyond its figures.
#include "suites_of_records.hpp"

BOOST_AUTO_TEST_SUITE(record_findings_test)

using namespace stillpoint::design_test;

bool says(const RecordDesign& result, FindingKind kind) {
  return std::ranges::count(result.findings, kind, &Finding::kind) > 0;
}

const Finding& finding(const RecordDesign& result, FindingKind kind) {
  const auto found = std::ranges::find(result.findings, kind, &Finding::kind);
  BOOST_REQUIRE(found != result.findings.end());
  return *found;
}

template <class Value = double>
Value value(const Finding& of, std::string_view name) {
  const auto found = std::ranges::find(of.values, name, &FindingValue::name);
  BOOST_REQUIRE(found != of.values.end());
  return std::get<Value>(found->value);
}

/// Of 0.4 g, then 0.2 g the other way.
RecordDesignRequest judged(double f, double delta) {
  RecordDesignRequest request = three_samples();
  request.f = Interval{f, f};
  request.delta = Interval{delta, delta};
  request.cases.front().limits.jump = 9;
  return request;
}

// Friction of 0.5 g holds it against 0.4 g.
BOOST_AUTO_TEST_CASE(a_mass_that_never_moves_is_not_isolated) {
  const RecordDesign held = design::design(judged(0.5, 0));
  BOOST_TEST(value(finding(held, FindingKind::never_moves), "largest_load") == 0.4);
  BOOST_TEST(value(finding(held, FindingKind::does_not_isolate), "largest_load") == 0.4);
  BOOST_TEST(!says(held, FindingKind::locks));
  BOOST_TEST(says(design::design(judged(0.39, 0)), FindingKind::does_not_isolate));
  const RecordDesign isolated = design::design(judged(0.1, 0));
  BOOST_TEST(!says(isolated, FindingKind::does_not_isolate));
  BOOST_TEST(!says(isolated, FindingKind::never_moves));
}

// The notch stops the mass that it has let go, and holds it while a small load goes on.
BOOST_AUTO_TEST_CASE(a_notch_jolts_and_locks) {
  RecordDesignRequest request = judged(0.05, 0.2);
  request.cases.front().records = {
      {"tail", Record{{0.4, -0.2, 0, 0.01, 0.01}, 0, {0, 1, 2, 3, 40}}, 1}};
  request.tolerance = {{}, {}, {}, {}};
  const RecordDesign caught = design::design(request);
  BOOST_REQUIRE(caught.finding.has_value());
  const ForcedResponse& response = caught.finding->responses.front().front();
  BOOST_TEST(response.jump > 0);
  BOOST_REQUIRE(response.locked_from.has_value());
  BOOST_TEST(value(finding(caught, FindingKind::jolts), "jump") == response.jump);
  const Finding& lock = finding(caught, FindingKind::locks);
  BOOST_TEST(value(lock, "largest_load_while_locked") == *response.largest_load_while_locked);
  BOOST_TEST(value<std::int64_t>(lock, "records") == 1);
  BOOST_TEST(says(caught, FindingKind::exact_only));
  BOOST_TEST(!says(design::design(judged(0.1, 0)), FindingKind::exact_only));
  BOOST_TEST(!says(design::design(judged(0.1, 0)), FindingKind::jolts));
}

// Of loads of 0.4 and 0.2 g friction of 0.5 g holds both: the mean is 0.3 g.
BOOST_AUTO_TEST_CASE(a_record_beyond_the_limit_of_a_mean_is_named) {
  RecordDesignRequest request = judged(0.5, 0);
  request.cases.front().records.push_back(
      {"weak", request.cases.front().records.front().record, 0.5});
  request.cases.front().combine = Combine::mean;
  request.cases.front().limits.acceleration = 0.35;
  const RecordDesign hidden = design::design(request);
  const Finding& beyond = finding(hidden, FindingKind::records_exceed_limit);
  BOOST_TEST(value<std::string>(beyond, "record") == "three");
  BOOST_TEST(value(beyond, "value") == 0.4);
  BOOST_TEST(value(beyond, "limit") == 0.35);
  BOOST_TEST(value<std::int64_t>(beyond, "records") == 1);
  BOOST_TEST(value<std::int64_t>(beyond, "of_records") == 2);
  request.cases.front().limits.acceleration = 0.4;
  BOOST_TEST(!says(design::design(request), FindingKind::records_exceed_limit));
}

// Held against 0.4 g by 0.41 g, it moves where the record has 0.42 g: with a limit of 0 that
// breaks.
BOOST_AUTO_TEST_CASE(what_a_scale_that_is_off_breaks_is_said) {
  RecordDesignRequest request = judged(0.41, 0);
  request.tolerance = {{}, {}, {}, {}};
  request.cases.front().limits.residual = 0;
  const RecordDesign held = design::design(request);
  const Finding& broken = finding(held, FindingKind::fails_if_off);
  BOOST_TEST(value<std::string>(broken, "input") == "scale");
  BOOST_TEST(value<std::string>(broken, "figure") == "residual");
  BOOST_TEST(value(broken, "value") > 0);
  request.cases.front().limits.residual = 1;
  BOOST_TEST(!says(design::design(request), FindingKind::fails_if_off));
  RecordDesign restless = held;
  restless.finding->outlook.period.front().settled = false;
  restless.findings = findings_of(restless, request);
  BOOST_TEST(value<std::string>(finding(restless, FindingKind::fails_if_off), "figure") == "rest");
}

// Without units f is not a share of the weight.
BOOST_AUTO_TEST_CASE(friction_above_the_weight_is_a_brake) {
  RecordDesignRequest request = judged(1.5, 0);
  BOOST_TEST(!says(design::design(request), FindingKind::friction_above_weight));
  request.printed = {1, 1};
  BOOST_TEST(says(design::design(request), FindingKind::friction_above_weight));
  request.f = Interval{0.9, 0.9};
  BOOST_TEST(!says(design::design(request), FindingKind::friction_above_weight));
}

BOOST_AUTO_TEST_CASE(a_check_that_fails_is_a_fault) {
  RecordDesign result = design::design(judged(0.1, 0));
  BOOST_TEST(!says(result, FindingKind::check_failed));
  result.finding->cross_check.methods.front().passed = false;
  result.findings = findings_of(result, result.request);
  BOOST_TEST((finding(result, FindingKind::check_failed).severity == Severity::fault));
}

// A notch of next to nothing gains nothing. Friction alone is verified first, so a search that is
// stopped then does not know what a notch would gain.
BOOST_AUTO_TEST_CASE(a_notch_that_is_left_out_gains_little_only_if_it_was_tried) {
  RecordDesignRequest request = short_records();
  request.cases.front().limits.jump = 1;
  request.hold = 0.05;
  request.threads = 1;
  request.delta = Interval{0, 1e-9};
  request.scan_points = 400;
  const RecordDesign whole = design::design(request);
  BOOST_REQUIRE(whole.finding.has_value());
  BOOST_TEST(whole.finding->point.damper.delta == 0);
  BOOST_TEST(says(whole, FindingKind::notch_gains_little));
  BOOST_TEST(!says(whole, FindingKind::interrupted));
  const RecordDesign stopped = design::design(
      request, [](const RecordProgress& progress) { return !progress.best.has_value(); });
  BOOST_REQUIRE(stopped.finding.has_value());
  BOOST_TEST(stopped.finding->point.damper.delta == 0);
  BOOST_TEST(says(stopped, FindingKind::interrupted));
  BOOST_TEST(!says(stopped, FindingKind::notch_gains_little));
}

BOOST_AUTO_TEST_CASE(a_notch_needs_a_width_or_a_limit_of_its_jumps_where_acceleration_counts) {
  RecordDesignRequest request = short_records();
  request.scan_points = 100;
  const auto needs_width = [&] {
    return says(design::design(request), FindingKind::notch_needs_width);
  };
  BOOST_TEST(needs_width());
  BOOST_TEST(design::design(request).request.delta->high == 0);
  request.delta = Interval{0, 0};
  BOOST_TEST(!needs_width());
  request.delta = Interval{0.001, 0.01};
  check_refused("search-delta-m", [&] { return design::design(request); });
  request.cases.front().limits.jump = 1;
  BOOST_TEST(!needs_width());
  request.cases.front().limits.jump.reset();
  request.width = Interval{0.05, 0.05};
  BOOST_TEST(!needs_width());
  request.width.reset();
  request.delta.reset();
  request.objective = SuiteObjective::amplitude;
  BOOST_TEST(design::design(request).request.delta->high > 0);
  request.cases.front().limits.acceleration = 0.3;
  BOOST_TEST(design::design(request).request.delta->high == 0);
}

BOOST_AUTO_TEST_SUITE_END()
