// SPDX-License-Identifier: MIT
#include "check/runge_kutta.hpp"
#include "record/suite.hpp"
#include "record/suite_served.hpp"
#include "suites_of_records.hpp"

BOOST_AUTO_TEST_SUITE(damped_design_test)

// Dampers for a mass with viscous damping, or one that friction holds more at rest: against the
// closed forms of a first return (docs/damping.md), and against an integrator.

using namespace stillpoint::design_test;

/// By which the largest tolerance that is found may be too small, absolute: three edges meet there,
/// where the search leaves off by about a point. And by which its samples may miss an edge.
constexpr double of_searched_tolerance = 1e-2;
constexpr double of_edge = 1e-3;
/// Of that of a given damper, whose box is tried by samples.
constexpr double of_tolerance = 2e-3;
/// Of f and of a stroke, relative, to either side of where a first return ends.
constexpr double beside = 1e-6;

std::optional<double> tolerance_of(const RecordDesignRequest& request, double f, double delta) {
  return design::design(exactly(judge(request, f, delta))).largest_tolerance;
}

BOOST_AUTO_TEST_CASE(no_damper_of_a_box_is_worse_than_its_corners) {
  constexpr double of_rounding = 1e-12;
  RandomSource random(4206);
  int boxes = 0;
  for (int i = 0; i < 1000; ++i) {
    const double zeta = random.uniform(0, 1) < 0.3 ? 0 : std::pow(10, random.uniform(-3, -0.3));
    RecordDesignRequest request = under_hit({zeta, zeta}, 10);
    request.cases.front().weakest = random.uniform(0.7, 1);
    request.cases.front().combine = Combine::max;
    const SuiteDamper middle{random.uniform(0.7, 1.4), random.uniform(0, 0.3),
                             random.uniform(0, 0.4)};
    const double off = random.uniform(0.01, 0.4);
    const auto damper = [&](const auto& part) {  // each from -1 to 1
      SuiteDamper now = middle;
      now.f *= 1 + off * part(0);
      now.delta *= 1 + off * part(1);
      now.p *= 1 + off / 3 * part(2);
      now.load = std::lerp(request.cases.front().weakest, 1, (1 + part(3)) / 2);
      return now;
    };
    TaskFigures worst;
    bool all_move = true;  // as the bounds of a start require
    for (unsigned corner = 0; corner < 16; ++corner) {
      const TaskFigures now = figures_of(
          request, damper([&](unsigned axis) { return (corner >> axis) % 2 == 0 ? -1.0 : 1.0; }));
      all_move = all_move && now.front().peak > 0;
      worst = worse(worst, now);
    }
    if (!all_move || !settled(worst) || worst.front().passages > 0 || worst.front().residual > 0) {
      continue;
    }
    ++boxes;
    for (int k = 0; k < 40; ++k) {
      const SuiteFigures now =
          figures_of(request, damper([&](unsigned) { return random.uniform(-1, 1); })).front();
      BOOST_TEST_CONTEXT("box " << i << ", zeta = " << zeta) {
        BOOST_TEST(now.settled);
        BOOST_TEST(now.passages == 0);
        BOOST_TEST(now.residual == 0);
        BOOST_TEST(now.peak <= (1 + of_rounding) * worst.front().peak);
        BOOST_TEST(now.acceleration <= (1 + of_rounding) * worst.front().acceleration);
        BOOST_TEST(now.jump <= (1 + of_rounding) * worst.front().jump);
      }
    }
  }
  BOOST_TEST(boxes > 50);
  RecordDesignRequest request = under_hit({0.05, 0.05}, 0.9);
  BOOST_TEST(design::design(request).finding.value().box.exact);
  request.zeta = {0.04, 0.06};
  BOOST_TEST(!design::design(request).finding.value().box.exact);
}

struct FirstReturnRow {
  double zeta, r, b;
};
/// Roots of the return with no speed left, in 50 digits; with zeta = 0 they are 1/sqrt(8) and
/// 1/sqrt(2).
constexpr std::array first_returns{FirstReturnRow{0, .35355339059327376, .70710678118654752},
                                   FirstReturnRow{.01, .34578624459869488, .70260868471098997},
                                   FirstReturnRow{.05, .31559999698522502, .68495266613546249},
                                   FirstReturnRow{.2, .21491715844561354, .62302340935741052},
                                   FirstReturnRow{.5, .072182882760396119, .5149315653513191}};

std::optional<FeasibleRegion> region_under(const Interval& zeta, double beta) {
  RecordDesignRequest request = exactly(under_hit(zeta, beta));
  request.maps = true;
  return design::design(request).region;
}

/// f2 to f3 and Delta1(f) to V0^2/2 without damping, and with it r as the largest f.
BOOST_AUTO_TEST_CASE(the_region_has_the_edges_of_the_closed_forms) {
  for (const auto& [zeta, r, b] : first_returns) {
    const Problem problem{.beta = 0.9, .criterion = Criterion::exact};
    const auto region = region_under({zeta, zeta}, problem.beta);
    BOOST_TEST_REQUIRE((region && region->f.size() == 1 && region->deltas.size() == 61));
    BOOST_TEST(std::abs(region->f.front().high - r) <= beside * r);
    if (zeta > 0) {
      continue;
    }
    const double f2 = admissible_region(problem).f2;
    BOOST_TEST(std::abs(region->f.front().low - f2) <= beside * f2);
    for (const auto& [f, delta] : region->deltas) {
      BOOST_TEST(std::abs(delta.low - delta1_exact(problem, f).value_or(0)) <= beside);
      BOOST_TEST(std::abs(delta.high - 0.5) <= beside);
    }
  }
  const auto empty = region_under({0.05, 0.05}, 0.68);
  BOOST_TEST_REQUIRE(empty.has_value());
  BOOST_TEST((empty->f.empty() && empty->deltas.empty()));
}

BOOST_AUTO_TEST_CASE(a_first_return_ends_where_the_closed_forms_say) {
  constexpr double delta = 0.01;  // more than what is left there
  for (const auto& [zeta, r, b] : first_returns) {
    const auto holds = [&, zeta = zeta](double f, double beta) {
      return is_admissible(under_hit({zeta, zeta}, beta), f, delta);
    };
    BOOST_TEST_CONTEXT("zeta = " << zeta) {
      BOOST_TEST(holds(r * (1 - beside), 1));
      BOOST_TEST(!holds(r * (1 + beside), 1));
      BOOST_TEST(holds(r * (1 - beside), b * (1 + 2 * beside)));
      BOOST_TEST(!holds(r * (1 - beside), b * (1 - 2 * beside)));
    }
  }
}

// Of f and Delta at once, from the edges of the region, which are roots.
BOOST_AUTO_TEST_CASE(the_best_tolerance_is_that_of_the_edges) {
  constexpr double beta = 1;  // beyond any motion
  for (const auto& [zeta, f_max, best] : {std::tuple(0.05, 1.0, 0.442), {0.1, 1e-3, 0.3068}}) {
    RecordDesignRequest request = under_hit({zeta, zeta}, beta);
    request.f_max = f_max;
    request.delta_max = 0.5;
    const RecordDesign found = design::design(request);
    BOOST_TEST_CONTEXT("zeta = " << zeta << ", f <= " << f_max) {
      BOOST_REQUIRE(found.finding.has_value());
      BOOST_TEST(found.finding->cross_check.passed);
      BOOST_TEST(found.largest_tolerance.value() >= best - of_edge);
      BOOST_TEST(*found.largest_tolerance <= best + of_edge);
      // More can be asked for, unless it is required.
      request.tolerance = {{best + 0.2, best + 0.2}, {best + 0.2, best + 0.2}, {}, {}};
      BOOST_TEST(design::design(request).finding.has_value());
      request.requires_tolerance = true;
      const RecordDesign refused = design::design(request);
      BOOST_TEST(!refused.finding.has_value());
      BOOST_TEST(std::abs(refused.largest_tolerance.value() - best) <= of_searched_tolerance);
    }
  }
}

// Reach is worst with the most damping, stop and peak with the least.
BOOST_AUTO_TEST_CASE(a_range_of_damping_has_the_lesser_tolerance_of_its_ends) {
  RandomSource random(4201);
  int met = 0;
  for (int i = 0; i < 40; ++i) {
    const Interval zeta{i % 3 == 0 ? 0 : random.uniform(0, 0.1), random.uniform(0.1, 0.3)};
    const double beta = random.uniform(0.7, 1);
    const double f = random.uniform(0.05, 0.3);
    const double delta = random.uniform(0.05, 0.45);
    const auto with = [&](const Interval& range) {
      return tolerance_of(under_hit(range, beta), f, delta);
    };
    const auto least = with({zeta.low, zeta.low});
    const auto most = with({zeta.high, zeta.high});
    const auto both = with(zeta);
    BOOST_TEST_CONTEXT("f = " << f << ", delta = " << delta << ", beta = " << beta << ", zeta from "
                              << zeta.low << " to " << zeta.high) {
      BOOST_TEST(both.has_value() == (least && most));
      if (both && least && most) {
        BOOST_TEST(std::abs(*both - std::min(*least, *most)) <= of_tolerance);
        ++met;
      }
    }
  }
  BOOST_TEST(met > 10);
}

/// What an integrator with fixed steps says of one motion.
bool keeps(const SimulationRequest& motion, const SuiteLimits& limits) {
  return excess(
             integrate_to_rest(motion.oscillator, motion.surface, motion.excitation, motion.start),
             limits) == 0;
}

/// Whether an integrator of that accuracy could see a figure beyond its limit, or another end.
bool is_close(const SuiteFigures& figures, const SuiteLimits& limits) {
  constexpr double errors = 1e-5;
  return figures.margin < errors || std::ranges::any_of(suite_figure_kinds, [&](const auto& kind) {
           const std::optional<double>& limit = limits.*kind.limit;
           return limit && *limit > 0 && std::abs(figures.*kind.value / *limit - 1) < errors;
         });
}

LoadCase random_case(RandomSource& random, int i) {
  LoadCase load{.name = "case", .combine = Combine::max};
  if (i % 3 == 0) {
    load.v0 = random.uniform(0.5, 1.5);
  } else if (i % 3 == 1) {
    load.pulse = i % 2 == 0 ? Pulse(HalfSine{random.uniform(0.3, 1), random.uniform(0.5, 3)})
                            : Pulse(Rectangle{random.uniform(0.3, 1), random.uniform(0.5, 3)});
  } else {
    load.records = {short_records().cases.front().records.at(static_cast<std::size_t>(i) % 2)};
  }
  load.limits = {.peak = random.uniform(0.3, 1.5),
                 .acceleration = random.uniform(0.3, 1.5),
                 .residual = load.of_records() || i % 2 == 0 ? random.uniform(0.01, 0.2) : 0};
  if (!load.of_records()) {
    load.limits.passages = random.pick(3);
  }
  return load;
}

BOOST_AUTO_TEST_CASE(a_damper_is_admissible_if_and_only_if_an_integrator_says_so) {
  RandomSource random(4202);
  int admitted = 0;
  int decided = 0;
  for (int i = 0; i < 120; ++i) {
    const double p = random.uniform(0.7, 1.4);
    const double zeta = i % 5 == 0 ? 0 : random.uniform(0.005, 0.4);
    RecordDesignRequest request{.cases = {random_case(random, i)},
                                .p = {p, p},
                                .zeta = {zeta, zeta},
                                .breakaway = i % 4 == 0 ? 1 : random.uniform(1, 2.5)};
    const SuiteLimits& limits = request.cases.front().limits;
    const double f = random.log_uniform(0.005, 0.4);
    const double delta = i % 4 == 1 ? 0 : random.log_uniform(0.005, 0.4);
    if (*limits.residual > 0 && i % 7 < 3) {
      request.width = Interval{0.05, 0.05};
    } else if (i % 7 == 3) {
      request.hold = random.uniform(0, 0.2);
    }
    const RecordDesign judged = design::design(exactly(judge(request, f, delta)));
    const SuiteFigures& own = judged.nearest.figures.front();
    if (own.settled && is_close(own, limits)) {
      continue;
    }
    const SuiteDamper damper{p, f, delta, delta > 0 && request.width ? 0.05 : 0};
    const auto motions = motions_of(request.cases.front());
    const bool starts = !request.cases.front().v0 || damper.width > 0 ||
                        delta < std::pow(*request.cases.front().v0, 2) / 2;
    const bool pushed = !request.cases.front().pulse || *limits.residual > 0 ||
                        request.breakaway * f < peak_load(*request.cases.front().pulse);
    const bool kept =
        starts && pushed && std::ranges::all_of(motions, [&](const CaseMotion& motion) {
          return keeps(motion_of(judged.request, damper, motion), limits);
        });
    BOOST_TEST_CONTEXT("task " << i << ": f = " << f << ", delta = " << delta << ", zeta = " << zeta
                               << ", breakaway = " << request.breakaway) {
      BOOST_TEST((judged.finding && judged.finding->admissible) == kept);
      BOOST_TEST((judged.finding && judged.finding->works_for) == kept);
      BOOST_TEST((!judged.finding || judged.finding->cross_check.passed));
    }
    ++decided;
    admitted += kept;
  }
  BOOST_TEST(decided > 105);
  BOOST_TEST(admitted > 15);
  BOOST_TEST(admitted < decided - 15);
}

BOOST_AUTO_TEST_CASE(a_box_that_is_promised_holds_for_every_damping_of_the_range) {
  RecordDesignRequest request = short_records();
  request.width = Interval{0.05, 0.05};
  request.zeta = {0.02, 0.08};
  request.breakaway = 1.3;
  const RecordDesign found = design::design(request);
  BOOST_REQUIRE(found.finding.has_value());
  BOOST_TEST(found.finding->cross_check.passed);
  const LoadCase& load = found.request.cases.front();
  const SuiteBox& box = found.finding->box;
  RandomSource random(4203);
  for (int i = 0; i < 400; ++i) {
    const SuiteDamper damper{1,
                             random.uniform(box.f.low, box.f.high),
                             random.uniform(box.delta.low, box.delta.high),
                             random.uniform(box.width.low, box.width.high),
                             1,
                             random.uniform(0, 1)};
    const Oscillator oscillator = oscillator_of(found.request, damper);
    BOOST_TEST((oscillator.zeta >= 0.02 && oscillator.zeta <= 0.08));
    for (const CaseMotion& motion : motions_of(load)) {
      const ForcedResponse one =
          forced_response(oscillator, {}, motion.load, {}, Surface{damper.notch_width(), {}});
      BOOST_TEST(one.peak_amplitude <= *load.limits.peak);
      BOOST_TEST(std::abs(one.stop_position.value()) <= *load.limits.residual);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_map_shows_the_worst_of_the_range) {
  RecordDesignRequest request = under_hit({0.05, 0.3}, 0.9);
  constexpr int side = 6;
  const SuiteMap map = suite_map(request, {}, false, side);
  request.cases.front().combine = Combine::max;
  int differ = 0;
  for (std::size_t i = 0; i < map.figures.size(); ++i) {
    SuiteDamper damper{1, map.f[i / side], map.delta[i % side]};
    const TaskFigures least = figures_of(request, damper);
    damper.damping = 1;
    const TaskFigures most = figures_of(request, damper);
    const SuiteFigures expected = largest(worse(least, most));
    BOOST_TEST(map.figures[i].front().peak == expected.peak);
    BOOST_TEST(map.figures[i].front().residual == expected.residual);
    differ += largest(least).residual != largest(most).residual;
  }
  BOOST_TEST(differ > 3);
}

// Its friction is some part of the little speed that it leaves, and the check takes steps within
// it.
BOOST_AUTO_TEST_CASE(a_pulse_may_be_far_shorter_than_the_period) {
  RecordDesignRequest request = under_hit({0.05, 0.05}, 3);
  request.cases.front().v0.reset();
  for (const double lambda : {20.0, 1000.0}) {
    for (const Pulse& pulse : {Pulse(HalfSine{1, lambda}), Pulse(FullSine{1, lambda})}) {
      request.cases.front().pulse = pulse;
      const RecordDesign found = design::design(request);
      BOOST_TEST_REQUIRE(found.finding.has_value());
      BOOST_TEST(*found.largest_tolerance > 0.4);  // of a hit with the same damping
      BOOST_TEST(found.finding->cross_check.passed);
    }
  }
}

// More friction would hold the mass anywhere within its stroke: a brake.
BOOST_AUTO_TEST_CASE(a_residual_asks_for_no_brake) {
  RecordDesignRequest request = under_hit({1e-9, 1e-9}, 0.9);
  request.cases.front().limits.residual = 0.05;
  request.cases.front().limits.passages = std::nullopt;
  const RecordDesign found = design::design(request);
  BOOST_REQUIRE(found.finding.has_value());
  const DesignResult closed = design::design(
      {.problem = {.v0 = 1, .p = 1, .beta = 0.9, .criterion = Criterion::exact, .residual = 0.05}});
  BOOST_TEST(std::abs(*found.largest_tolerance - closed.finding->point.tolerance) <=
             of_searched_tolerance);
  BOOST_TEST(found.finding->box.f.high < 0.9);
  const RecordDesign brake = design::design(exactly(judge(request, 20, 0.001)));
  BOOST_TEST(!brake.finding->admissible);
  const auto held =
      std::ranges::find(brake.constraints, std::string_view("dead_zone"), &Constraint::name);
  BOOST_REQUIRE((held != brake.constraints.end()));
  BOOST_TEST(!held->satisfied);
}

/// However small it is, and so the friction whose dead zone it allows.
BOOST_AUTO_TEST_CASE(a_residual_only_loosens) {
  RecordDesignRequest request = under_hit({0.01, 0.01}, 1.2);
  const auto strict = design::design(request).largest_tolerance;
  BOOST_TEST_REQUIRE(strict.has_value());
  for (const double residual : {1e-4, 0.02}) {
    request.cases.front().limits.residual = residual;
    const auto loose = design::design(request).largest_tolerance;
    BOOST_TEST_CONTEXT("residual " << residual) {
      BOOST_TEST_REQUIRE(loose.has_value());
      BOOST_TEST(*loose >= *strict - of_searched_tolerance);
    }
  }
}

/// Nor does what would do depend on how far a limit is from it.
BOOST_AUTO_TEST_CASE(the_least_stroke_of_a_range_is_found_from_any_limit) {
  constexpr double of_limit = 1e-2;
  const auto least_beta = [](double beta) {
    RecordDesignRequest request = under_hit({0.05, 0.05}, beta);
    request.cases.front().weakest = 0.8;
    request.cases.front().combine = Combine::max;
    request.objective = SuiteObjective::amplitude;
    const RecordDesign result = design::design(request);
    const auto mend = std::ranges::find(result.mends, "beta", &Mend::field);
    return mend == result.mends.end() ? 0 : mend->value;
  };
  const double near = least_beta(0.72);
  BOOST_TEST(near > 0.72);
  for (const double beta : {0.2, 0.385}) {
    BOOST_TEST(std::abs(least_beta(beta) / near - 1) <= of_limit);
  }
}

BOOST_AUTO_TEST_SUITE_END()
