// SPDX-License-Identifier: MIT
#include "record/suite.hpp"
#include "suites_of_records.hpp"

#include <iomanip>

BOOST_AUTO_TEST_SUITE(record_design_test)

using namespace stillpoint::design_test;

/// Of an optimum, relative: what the docs promise of a box.
constexpr double boxes_tolerance = 5e-3;
/// Of a figure worked out by hand.
constexpr double hand_tolerance = 1e-14;

/// The three samples with dampers without a notch.
RecordDesignRequest with_friction(const Interval& f) {
  RecordDesignRequest request = three_samples();
  request.f = f;
  request.delta = Interval{0, 0};
  return request;
}

/// The first of the short records.
RecordDesignRequest short_record() {
  RecordDesignRequest request = short_records();
  request.cases.front().records.resize(1, request.cases.front().records.front());
  return request;
}

RecordDesignRequest with_capacity() {
  RecordDesignRequest request = short_records();
  request.hold = 0.05;
  request.cases.front().limits.jump = 1;
  request.scan_points = 400;
  request.threads = 1;
  return request;
}

/// Shared by several cases.
const RecordDesign& design_with_capacity() {
  static const RecordDesign found = design::design(with_capacity());
  return found;
}

void check_same(const RecordDesign& one, const RecordDesign& other) {
  BOOST_REQUIRE(one.finding.has_value());
  BOOST_REQUIRE(other.finding.has_value());
  BOOST_TEST(one.finding->point.damper.f == other.finding->point.damper.f);
  BOOST_TEST(one.finding->point.damper.delta == other.finding->point.damper.delta);
  BOOST_TEST(one.search.evaluations == other.search.evaluations);
  BOOST_TEST(one.search.scan.value().feasible == other.search.scan.value().feasible);
  BOOST_TEST(one.finding->box.worst.front().residual == other.finding->box.worst.front().residual);
}

BOOST_AUTO_TEST_CASE(a_watched_search_finds_the_same) {
  RecordDesignRequest request = with_capacity();
  request.threads = 2;
  std::int64_t evaluations = 0;
  std::int64_t expected = 0;
  bool counted = true;
  SuitePoint best;
  const RecordDesign watched = design::design(request, [&](const RecordProgress& progress) {
    counted = counted && progress.evaluations > evaluations &&
              (evaluations == 0 || progress.expected == expected);
    evaluations = progress.evaluations;
    expected = progress.expected;
    best = progress.best.value_or(best);
    return true;
  });
  check_same(design_with_capacity(), watched);
  BOOST_TEST(counted);
  BOOST_TEST(!watched.search.interrupted);
  BOOST_TEST(evaluations > watched.search.scan.value().points);
  BOOST_TEST((evaluations > expected / 2 && evaluations < expected * 2));
  BOOST_TEST(best.figures.front().acceleration >= watched.nearest.figures.front().acceleration);
}

// A damper that is shown or returned has been tried as a whole, wherever the search was stopped.
BOOST_AUTO_TEST_CASE(a_stopped_search_has_the_best_verified_so_far) {
  for (const std::int64_t last : {700, 12'000, 20'000}) {
    std::int64_t evaluations = 0;
    std::optional<SuitePoint> best;
    const RecordDesign stopped =
        design::design(with_capacity(), [&](const RecordProgress& progress) {
          BOOST_TEST(evaluations < last);
          evaluations = progress.evaluations;
          best = progress.best;
          return evaluations < last;
        });
    BOOST_TEST_CONTEXT("stopped after " << last) {
      BOOST_TEST(stopped.search.interrupted);
      BOOST_TEST(stopped.finding.has_value() == best.has_value());
      BOOST_TEST(stopped.finding.has_value() == (last > 10'000));
      if (stopped.finding) {
        BOOST_TEST(stopped.nearest.damper.f == best->damper.f);
        BOOST_TEST(stopped.nearest.damper.delta == best->damper.delta);
        BOOST_TEST(stopped.finding->box.samples >= 4000);
        BOOST_TEST(admissible(stopped.finding->box.worst, limits_of(stopped.request)));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_stopped_search_suggests_no_relaxed_limit) {
  RecordDesignRequest request = two_records();
  request.cases.front().limits = {0.5 * metre, 0.1, 0.001 * metre, {}, {}};
  const RecordDesign stopped = design::design(request, [](const RecordProgress&) { return false; });
  BOOST_TEST(!stopped.finding.has_value());
  BOOST_TEST(stopped.mends.empty());
}

BOOST_AUTO_TEST_CASE(a_damper_that_does_not_move_passes_the_load_on) {
  RecordDesignRequest request = with_friction({2, 2});
  request.cases.front().records.push_back(request.cases.front().records.front());
  request.cases.front().records.back().scale = -3;  // its largest load is 1.2
  const RecordDesign worst = design::design(request);
  BOOST_REQUIRE(worst.finding.has_value());
  BOOST_TEST((worst.request.cases.front().combine == Combine::max));
  BOOST_TEST(std::abs(worst.finding->point.figures.front().acceleration - 1.2) <= hand_tolerance);
  BOOST_TEST(worst.finding->point.figures.front().peak == 0);
  BOOST_TEST(worst.finding->cross_check.passed);
  BOOST_TEST(!isolates(worst));
  request.cases.front().combine = Combine::mean;  // of 0.4 and 1.2
  const RecordDesign mean = design::design(request);
  BOOST_REQUIRE(mean.finding.has_value());
  BOOST_TEST(std::abs(mean.finding->point.figures.front().acceleration - 0.8) <= hand_tolerance);
}

BOOST_AUTO_TEST_CASE(a_damper_without_friction_never_rests) {
  RecordDesignRequest request = with_friction({0, 0});
  const RecordDesign result = design::design(request);
  BOOST_TEST(!result.finding.has_value());
  BOOST_TEST(!result.nearest.figures.front().settled);
  BOOST_TEST(summary(result) ==
             "no damper: the nearest, p = 1, f = 0, delta = 0, does not come to rest");
}

/// However far off they are.
BOOST_AUTO_TEST_CASE(the_nearest_is_as_near_to_the_limits_as_any_friction_alone) {
  RecordDesignRequest request = short_record();
  request.delta = Interval{0, 0};
  request.tolerance.f = {0.01, 0.01};
  for (const double most : {0.08, 0.04, 0.01}) {
    request.cases.front().limits = {0.2, most, {}, {}, {}};
    const RecordDesign none = design::design(request);
    BOOST_REQUIRE(!none.finding.has_value());
    const std::vector<SuiteLimits> limits = limits_of(none.request);
    const Suites suite(none.request);
    double least = HUGE_VAL;
    for (double f = 1e-3; f < 1; f *= 1.05) {
      least = std::min(least, excess(suite.figures(SuiteDamper{none.request.p.low, f, 0}), limits));
    }
    constexpr double steps_apart = 1.15;  // of this scan, and of the box
    BOOST_TEST(excess(none.nearest.figures, limits) <= steps_apart * least);
  }
}

BOOST_AUTO_TEST_CASE(a_free_period_is_at_least_as_good_as_any_single_one) {
  RecordDesignRequest request = short_record();
  request.delta = Interval{0, 0};
  request.p = {0.8, 1.6};
  const RecordDesign free = design::design(request);
  BOOST_REQUIRE(free.finding.has_value());
  BOOST_TEST(free.finding->point.damper.p >= 0.8);
  BOOST_TEST(free.finding->point.damper.p <= 1.6);
  int compared = 0;
  for (const double p : {0.8, 1.2, 1.6}) {
    request.p = {p, p};
    const RecordDesign single = design::design(request);
    if (single.finding) {
      ++compared;
      BOOST_TEST(free.nearest.figures.front().acceleration <=
                 single.nearest.figures.front().acceleration * (1 + boxes_tolerance));
    }
  }
  BOOST_TEST(compared > 0);
}

// Friction holds the mass as long as it exceeds the load of 0.4, down to f (1 - R) = 0.4, and f may
// be up to 0.8: R = 1 - 0.4/0.8. Where the load exceeds f by d, it does so for some 5 d, and the
// mass moves by some 4 d^3: the limit admits d = 3e-7.
BOOST_AUTO_TEST_CASE(the_largest_tolerance_of_a_mass_that_is_held_is_known) {
  RecordDesignRequest request = with_friction({0.1, 0.8});
  request.objective = SuiteObjective::robust;
  request.cases.front().limits = {1e-19, {}, {}, {}, {}};
  const RecordDesign held = design::design(request);
  BOOST_REQUIRE(held.finding.has_value());
  constexpr double of_tolerance = 0.005;
  BOOST_TEST(std::abs(held.largest_tolerance.value() - 0.5) <= of_tolerance,
             *held.largest_tolerance);
  BOOST_TEST(held.finding->box.f.low >= 0.4 * (1 - 1e-6));
}

// Half of what the weak record asks for is enough, and it is the strong one that moves the mass.
BOOST_AUTO_TEST_CASE(the_record_that_binds_a_limit_is_named) {
  RecordDesignRequest request = with_friction({0.25, 0.25});
  request.cases.front().records.push_back(
      {"weak", request.cases.front().records.front().record, 0.5});
  request.cases.front().limits.peak = 1e-3;
  const RecordDesign none = design::design(request);
  BOOST_TEST(!none.finding.has_value());
  BOOST_REQUIRE(none.constraints.size() == 1U);
  BOOST_TEST(none.constraints[0].motion.value().file == request.cases.front().records.front().name);
}

// 1e-4 of friction gives the least residual, after hundreds of periods; within 20 it is larger.
BOOST_AUTO_TEST_CASE(the_least_residual_is_that_of_a_mass_that_rests_soon) {
  RecordDesignRequest request = three_samples();
  request.objective = SuiteObjective::residual;
  const RecordDesign result = design::design(request);
  BOOST_REQUIRE(result.finding.has_value());
  BOOST_TEST(result.finding->box.worst.front().late <= 20);
  const double end = 2;
  for (const ForcedResponse& response : result.finding->responses.front()) {
    BOOST_TEST(response.stop_time.value() <= end + 20 * 2 * std::numbers::pi);
  }
}

/// Whether a number has at most so many digits.
bool has_few_digits(double value, int digits) {
  std::ostringstream text;
  text << std::setprecision(digits) << value;
  return std::abs(std::stod(text.str()) - value) <= hand_tolerance * value;
}

BOOST_AUTO_TEST_CASE(a_printed_design_has_the_digits_that_its_tolerance_deserves) {
  RecordDesignRequest request = with_capacity();
  const double centimetres = 100 / metre;
  const RecordDesign& exact = design_with_capacity();
  request.printed = {centimetres};
  const RecordDesign design = design::design(request);
  BOOST_REQUIRE(design.finding.has_value());
  const auto& [damper, figures] = design.finding->point;
  constexpr int few = 4;
  BOOST_TEST(has_few_digits(damper.f, few));
  BOOST_TEST(has_few_digits(damper.delta * centimetres, few));
  BOOST_TEST(design.nearest.damper.f == damper.f);
  BOOST_TEST(damper.p == 1);
  BOOST_TEST(design.nearest.figures.front().acceleration <=
             exact.nearest.figures.front().acceleration * (1 + boxes_tolerance));
  BOOST_TEST(figures.front().peak == figures_of(design.request, damper).front().peak);
  BOOST_TEST(figures.front().peak ==
             std::ranges::max(design.finding->responses.front(), {}, [](const auto& one) {
               return one.peak_amplitude;
             }).peak_amplitude);
}

// Twice the limit of the stroke, and half as much again as that of the residual.
BOOST_AUTO_TEST_CASE(the_excess_is_the_sum_over_the_limits) {
  const SuiteLimits limits{.peak = 1, .residual = 2};
  BOOST_TEST(excess({.peak = 2, .acceleration = 9, .residual = 3}, limits) == 1.5);
  BOOST_TEST(excess({.peak = 1, .residual = 2}, limits) == 0);
  BOOST_TEST(excess({.peak = 4, .residual = 1}, {.residual = 0}) == 0.25);  // of the peak
  BOOST_TEST(excess({.peak = 1, .settled = false}, limits) == 1e9);
}

/// With what a mend says.
RecordDesignRequest mended(RecordDesignRequest request, const Mend& mend) {
  LoadCase& load = request.cases[mend.in_case == "residual" ? 1 : 0];
  if (mend.field == "v0") {
    load.v0 = mend.value;
  } else if (mend.field == "p") {
    request.p = {mend.value, mend.value};
  } else if (mend.field == "scale") {
    for (SuiteRecord& record : load.records) {
      record.scale *= mend.value;
    }
  } else {
    load.limits.*std::ranges::find(suite_figure_kinds, mend.field, &SuiteFigureKind::field)->limit =
        mend.value;
  }
  return request;
}

// Mends need no tolerance, and are at most 2e-3 beyond the best that was found.
BOOST_AUTO_TEST_CASE(each_mend_suffices) {
  constexpr double less = 0.01;
  struct Row {
    RecordDesignRequest request;
    std::vector<std::string_view> fields;  ///< of the mends that there must be
    bool of_records{true};                 ///< whose search is too coarse to say what is least
  };
  const RecordDesignRequest hit = under_hit({0.05, 0.05}, 0.5);
  RecordDesignRequest soft = hit;  // no single limit helps
  soft.cases.front().limits.acceleration = 0.6;
  RecordDesignRequest one = short_record();
  one.cases.front().limits = {0.4, 0.15, 0.02, {}, {}};
  RecordDesignRequest two = split(short_records());
  two.scan_points = 400;
  two.delta = Interval{0, 0};
  two.f = Interval{0.01, 0.2};
  two.cases[0].limits.peak = 0.02;
  // It does not move, so that it feels 0.4 g whatever the stroke.
  RecordDesignRequest held = with_friction({2, 2});
  held.cases.front().limits = {1, 0.1, 0, {}, {}};
  for (const auto& [request, fields, of_records] :
       {Row{hit, {"beta", "v0", "p"}, false}, Row{soft, {"v0"}, false}, Row{one, {"scale"}},
        Row{two, {}}, Row{held, {"acceleration_max"}}}) {
    const RecordDesign none = design::design(request);
    BOOST_TEST(!none.finding.has_value());
    BOOST_TEST(none.mends.size() >= std::max<std::size_t>(fields.size(), 1));
    for (const std::string_view field : fields) {
      BOOST_TEST(std::ranges::count(none.mends, field, &Mend::field) == 1, field);
    }
    for (const Mend& mend : none.mends) {
      BOOST_TEST_CONTEXT(mend.in_case << " " << mend.field << " = " << mend.value) {
        BOOST_TEST(design::design(mended(request, mend)).finding.has_value());
        Mend smaller = mend;
        smaller.value *= mend.upwards ? 1 - less : 1 + less;
        BOOST_TEST((of_records || !design::design(mended(request, smaller)).finding));
      }
    }
    for (std::size_t k = 0; k < none.constraints.size() && request.cases.size() == 1; ++k) {
      const auto* const kind = std::ranges::find(suite_figure_kinds, none.constraints[k].name,
                                                 &SuiteFigureKind::constraint);
      BOOST_TEST((kind == suite_figure_kinds.end() ||
                  none.constraints[k].value == none.nearest.figures.front().*kind->value));
    }
  }
  BOOST_TEST(design::design(soft).mends.size() == 1U);
  const RecordDesign only = design::design(held);
  BOOST_TEST(only.mends.size() == 1U);
  BOOST_TEST(std::abs(only.mends.at(0).value - 0.4008) <= hand_tolerance);
}

BOOST_AUTO_TEST_CASE(wrong_input_is_refused) {
  using Request = RecordDesignRequest;
  using Spoil = std::function<void(Request&)>;
  const auto set = [](const auto& value, auto... members) -> Spoil {
    return [=](Request& request) { (request.*....*members) = value; };
  };
  const auto of_case = [](const auto& value, auto... members) -> Spoil {
    return [=](Request& request) { (request.cases.front().*....*members) = value; };
  };
  const auto limit = [&](auto member, double value) {
    return of_case(value, &LoadCase::limits, member);
  };
  const auto tolerance = [&](auto member, const Spread& value) {
    return set(value, &Request::tolerance, member);
  };
  const auto refused = [](const Request& right,
                          const std::vector<std::pair<std::string, Spoil>>& rows) {
    for (const auto& [field, spoil] : rows) {
      Request wrong = right;
      spoil(wrong);
      test::check_refused(field, [&] { return design::design(wrong); });
    }
  };
  refused(three_samples(),
          {{"records", of_case(std::vector<SuiteRecord>(), &LoadCase::records)},
           {"scale", [](Request& request) { request.cases.front().records[0].scale = 0; }},
           {"p", set(Interval{2, 1}, &Request::p)},
           {"p", set(Interval{0, 1}, &Request::p)},
           {"f", set(Interval{-1, 1}, &Request::f)},
           {"delta", set(Interval{1, 0}, &Request::delta)},
           {"beta", limit(&SuiteLimits::peak, 0)},
           {"residual", limit(&SuiteLimits::residual, -1)},
           {"acceleration-max", limit(&SuiteLimits::acceleration, 0)},
           {"jump-max-v", limit(&SuiteLimits::jump, -1)},
           {"tolerance-f", tolerance(&SuiteTolerance::f, {1, 0})},
           {"tolerance-period", tolerance(&SuiteTolerance::period, {0, -1})},
           {"max-displacement", set(SuiteObjective::robust, &Request::objective)},
           {"hold", set(-1, &Request::hold)},
           {"notch-width", set(Interval{0, 0}, &Request::width)},
           {"scan_points", set(0, &Request::scan_points)},
           {"threads", set(-1, &Request::threads)}});
  Request exact = exactly(three_samples());
  exact.objective = SuiteObjective::robust;
  refused(exact, {{"tolerance", [](Request&) {}}});
  refused(under_hit({0, 0}, 1),
          {{"cases", set(std::vector<LoadCase>(), &Request::cases)},
           {"records", set(std::vector<LoadCase>(2), &Request::cases)},
           {"v0", of_case(0, &LoadCase::v0)},
           {"k", of_case(LoadCase{.name = "pulse", .pulse = HalfSine{0, 1}})},
           {"arrivals", limit(&SuiteLimits::passages, -1)},
           {"delta", set(Interval{0.5, 1}, &Request::delta)},
           {"residual", set(Interval{0.1, 0.1}, &Request::width)},
           {"damping", set(Interval{-0.1, 0.1}, &Request::zeta)},
           {"damping", set(Interval{0.1, 0.05}, &Request::zeta)},
           {"damping", set(Interval{0.1, 1}, &Request::zeta)},
           {"damping", set(Interval{0.1, 0.95}, &Request::zeta)},  // it would creep
           {"breakaway", set(0.9, &Request::breakaway)}});
}

BOOST_AUTO_TEST_SUITE_END()
