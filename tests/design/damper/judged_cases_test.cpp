// SPDX-License-Identifier: MIT
#include "record/suite.hpp"
#include "record/suite_served.hpp"
#include "suites_of_records.hpp"

BOOST_AUTO_TEST_SUITE(judged_cases_test)

// A given damper in load cases, the parts of a catalogue, the front, and what a damper works for.

using namespace stillpoint::design_test;

/// Of the tolerance of a damper, absolute, that samples of its box may miss.
constexpr double of_tolerance = 2e-3;
/// Of the end of an interval, relative: a millionth of a step of one per cent.
constexpr double of_end = 1e-7;
constexpr double of_hit_end = 1e-6;

bool keeps(const RecordDesignRequest& request, const SuiteDamper& damper) {
  return admissible(figures_of(request, damper), limits_of(request));
}

RecordDesignRequest completed_records() {
  RecordDesignRequest request = short_records();
  request.cases.front().combine = Combine::max;
  return request;
}

BOOST_AUTO_TEST_CASE(what_can_be_manufactured_holds_for_the_whole_box) {
  RecordDesignRequest request = judge(completed_records(), 0.2, 0);
  request.cases.front().limits = {.peak = 10};
  for (const auto& [most, admissible] : {std::pair(0.23, true), std::pair(0.21, false)}) {
    request.f_max = most;
    const RecordDesign judged = design::design(request);
    BOOST_REQUIRE(judged.finding.has_value());
    BOOST_TEST(judged.finding->admissible == admissible);
    BOOST_TEST(judged.constraints.back().name == "f_max");
    BOOST_TEST(judged.constraints.back().value == 0.2 * 1.1);
    BOOST_TEST(judged.largest_tolerance.value() <= most / 0.2 - 1);
  }
}

/// By a notch that takes V0^2/2 = 0.5, or friction that holds 2 f against k = 0.5.
BOOST_AUTO_TEST_CASE(what_holds_the_mass_where_it_is_is_told) {
  const RecordDesignRequest hit = under_hit({0, 0}, 1);
  const RecordDesignRequest pulse{.cases = {{.name = "pulse",
                                             .pulse = Rectangle{0.5, 1},
                                             .limits = {.peak = 2, .residual = 0, .passages = 0}}},
                                  .breakaway = 2};
  for (const auto& [request, f, delta, limit] :
       {std::tuple(hit, 0.2, 0.49, 0.5), {hit, 0.2, 0.51, 0.5}, {pulse, 0.26, 0.3, 0.25}}) {
    const RecordDesign judged = design::design(exactly(judge(request, f, delta)));
    const Constraint& start = judged.constraints.back();
    BOOST_TEST(start.name == "start");
    BOOST_TEST(start.limit == limit, tt::tolerance(1e-8));
    BOOST_TEST(start.satisfied == (delta == 0.49));
    BOOST_TEST((judged.finding && judged.finding->admissible) == start.satisfied);
  }
}

// The engine of hits knows the tolerance of any damper over ranges by its corners.
BOOST_AUTO_TEST_CASE(a_damper_has_the_tolerance_that_the_engine_of_hits_proves) {
  RandomSource random(3911);
  int met = 0;
  for (int i = 0; i < 60; ++i) {
    const double weakest = i % 3 == 0 ? 1 : random.uniform(0.7, 1);
    const double stiffest = i % 2 == 0 ? 1 : random.uniform(1, 1.15);
    const double beta = random.uniform(0.85, 1.2);
    const Problem problem{.beta = beta,
                          .criterion = Criterion::exact,
                          .v0_low = weakest < 1 ? std::optional(weakest) : std::nullopt,
                          .p_high = stiffest > 1 ? std::optional(stiffest) : std::nullopt};
    const double f = random.uniform(0.15, 0.35);
    const double delta = random.uniform(0.1, 0.45);
    const std::optional<double> known = largest_tolerance(problem, {}, f, delta);
    RecordDesignRequest request = exactly(under_hit({0, 0}, beta));
    request.cases.front().weakest = weakest;
    request.spring = {1 - 1 / stiffest, 0};
    const RecordDesign judged = design::design(judge(request, f, delta));
    BOOST_REQUIRE(judged.finding.has_value());
    BOOST_TEST_CONTEXT("f = " << f << ", delta = " << delta << ", beta = " << beta << ", v0 from "
                              << weakest << ", p to " << stiffest) {
      BOOST_TEST(judged.finding->admissible == known.has_value());
      if (known && judged.largest_tolerance) {
        BOOST_TEST(std::abs(*judged.largest_tolerance - std::min(*known, 0.95)) <= of_tolerance);
        ++met;
      }
    }
  }
  BOOST_TEST(met > 15);
}

/// Of a hit, with damping and friction that holds more at rest, or of records.
BOOST_AUTO_TEST_CASE(a_damper_works_up_to_the_ends_and_no_farther) {
  RandomSource random(3912);
  int ended = 0;
  for (int i = 0; i < 60; ++i) {
    const bool hit = i % 2 == 0;
    const double zeta = random.uniform(0, 0.1);
    RecordDesignRequest request =
        hit ? under_hit({zeta, i % 4 == 0 ? zeta : 2 * zeta}, 0.9) : completed_records();
    LoadCase& load = request.cases.front();
    load.combine = Combine::max;
    if (hit) {
      request.breakaway = random.uniform(1, 3);
    } else {
      request.width = Interval{0.05, 0.05};
      load.limits = {.peak = random.uniform(0.2, 0.6), .residual = random.uniform(0.01, 0.1)};
    }
    const SuiteDamper damper{1, random.uniform(0.05, 0.3), hit ? random.uniform(0.1, 0.45) : 0.02,
                             hit ? 0 : 0.05};
    const auto holds = [&](const RecordDesignRequest& with) {
      SuiteDamper now = damper;
      now.p = with.p.low;
      return hit ? is_admissible(with, now.f, now.delta) : keeps(with, now);
    };
    const auto served = works_for(request, damper);
    BOOST_TEST(served.has_value() == holds(request));
    if (!served) {
      continue;
    }
    const auto under = [&](double factor) {
      RecordDesignRequest scaled = request;
      scaled.cases.front().v0 = hit ? std::optional(factor) : std::nullopt;
      for (SuiteRecord& record : scaled.cases.front().records) {
        record.scale *= factor;
      }
      return holds(scaled);
    };
    const auto on = [&](double p) {
      RecordDesignRequest other = request;
      other.p = {p, p};
      return holds(other);
    };
    const double inside = hit ? of_hit_end : 1e-12;
    const double outside = hit ? of_hit_end : of_end;
    BOOST_TEST_CONTEXT("damper " << i << ", f = " << damper.f << ", delta = " << damper.delta) {
      BOOST_TEST((served->load == (hit ? ServedLoad::v0 : ServedLoad::scale)));
      for (const auto& [ends, holds_at, most] :
           {std::tuple(served->hit, std::function<bool(double)>(under), 10.0),
            std::tuple(served->p, std::function<bool(double)>(on), 2.0)}) {
        BOOST_TEST(holds_at(ends.low * (1 + inside)));
        const double high = ends.high.value_or(most);  // without an end any
        BOOST_TEST(holds_at(high * (1 - inside)));
        BOOST_TEST((!hit || !holds_at(ends.low * (1 - outside))));
        if (high < most) {
          BOOST_TEST(!holds_at(high * (1 + outside)));
          ++ended;
        }
      }
    }
  }
  BOOST_TEST(ended > 30);
}

BOOST_AUTO_TEST_CASE(the_best_part_is_the_best_of_those_judged_by_themselves) {
  RandomSource random(3913);
  RecordDesignRequest request = short_records();
  request.cases.front().limits.peak = 0.1;
  request.width = Interval{0.05, 0.05};
  for (int i = 0; i < 12; ++i) {
    request.parts.push_back(
        {std::to_string(i), random.uniform(0.005, 0.3), random.uniform(0, 0.008)});
  }
  const RecordDesign chosen = design::design(request);
  BOOST_REQUIRE(chosen.parts.size() == 12U);
  BOOST_REQUIRE(chosen.finding.has_value());
  BOOST_TEST(chosen.finding->part == chosen.parts.front().part.name);
  double before = 0;
  std::size_t fit = 0;
  for (const RatedPart& rated : chosen.parts) {
    RecordDesignRequest alone = judge(request, rated.part.f, rated.part.delta);
    alone.parts.clear();
    const RecordDesign judged = design::design(alone);
    BOOST_TEST(rated.admissible == (judged.finding && judged.finding->admissible));
    BOOST_TEST(rated.admissible == rated.violated.empty());
    if (rated.admissible) {
      const double felt = largest(judged.finding->box.worst).acceleration;
      BOOST_TEST(felt >= before);
      before = felt;
      ++fit;
    }
  }
  BOOST_TEST(fit > 0U);
  BOOST_TEST(fit < 12U);
}

BOOST_AUTO_TEST_CASE(no_damper_of_a_front_is_better_in_both) {
  RecordDesignRequest request = short_records();
  request.scan_points = 900;
  request.width = Interval{0.05, 0.05};
  request.trade_offs = 6;
  const RecordDesign found = design::design(request);
  const std::vector<SuitePoint>& front = found.trade_off;
  BOOST_REQUIRE(front.size() >= 3U);
  BOOST_REQUIRE(front.size() <= 6U);
  for (std::size_t i = 0; i < front.size(); ++i) {
    BOOST_TEST(admissible(front[i].figures, limits_of(found.request)));
    BOOST_TEST(keeps(found.request, front[i].damper));
    if (i > 0) {
      const SuiteFigures one = largest(front[i - 1].figures);
      const SuiteFigures other = largest(front[i].figures);
      BOOST_TEST(one.peak < other.peak);
      BOOST_TEST(one.acceleration > other.acceleration);
    }
  }
  constexpr double about = 0.01;  // the front is looked for briefly
  BOOST_TEST(largest(front.back().figures).acceleration <=
             (1 + about) * largest(found.finding->box.worst).acceleration);
}

BOOST_AUTO_TEST_CASE(the_least_time_to_rest_is_that_of_the_design_for_the_hit) {
  const Problem problem{.beta = 0.9, .criterion = Criterion::exact};
  const DesignResult known =
      design::design(DesignRequest{.problem = problem, .search = {.objective = Objective::time}});
  RecordDesignRequest request = exactly(under_hit({0, 0}, 0.9));
  request.objective = SuiteObjective::time;
  const RecordDesign found = design::design(request);
  BOOST_REQUIRE(found.finding.has_value());
  constexpr double about = 2e-3;  // it is on an edge, from which this search keeps away
  BOOST_TEST(
      std::abs(found.finding->point.figures.front().stop_time / *known.finding->response.stop_time -
               1) <= about);
  request.cases.push_back(short_records().cases.front());
  BOOST_CHECK_THROW(static_cast<void>(design::design(request)), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
