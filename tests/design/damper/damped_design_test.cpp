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

/// A hit of V0 = 1 that must stop at x = 0 by its first arrival.
RecordDesignRequest under_hit(const Interval& zeta, double beta) {
  RecordDesignRequest request{
      .cases = {{.name = "hit", .v0 = 1, .limits = {.peak = beta, .residual = 0, .passages = 0}}},
      .objective = SuiteObjective::robust,
      .zeta = zeta};
  return request;
}

RecordDesignRequest judge(RecordDesignRequest request, double f, double delta) {
  request.f = Interval{f, f};
  request.delta = Interval{delta, delta};
  request.judges = true;
  request.tolerance = {{}, {}, {}, {}};
  return request;
}

bool is_admissible(const RecordDesignRequest& request, double f, double delta) {
  const RecordDesign judged = design::design(judge(request, f, delta));
  return judged.finding && judged.finding->admissible;
}

std::optional<double> tolerance_of(const RecordDesignRequest& request, double f, double delta) {
  return design::design(judge(request, f, delta)).largest_tolerance;
}

RecordDesignRequest map_of(RecordDesignRequest request) {
  request.maps = true;
  request.tolerance = {{}, {}, {}, {}};
  return request;
}

/// The best there is tolerates 44.2 %.
BOOST_AUTO_TEST_CASE(a_tolerance_that_is_required_is_not_undercut) {
  RecordDesignRequest request = under_hit({0.05, 0.05}, 1);
  request.tolerance = {{0.6, 0.6}, {0.6, 0.6}, {}, {}};
  BOOST_TEST(design::design(request).finding.has_value());
  request.requires_tolerance = true;
  const RecordDesign found = design::design(request);
  BOOST_TEST(!found.finding.has_value());
  BOOST_TEST_REQUIRE(found.largest_tolerance.has_value());
  BOOST_TEST(std::abs(*found.largest_tolerance - 0.442) <= of_searched_tolerance);
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
    const auto damper = [&](const auto& part) {  // each part from -1 to 1
      SuiteDamper now = middle;
      now.f *= 1 + off * part();
      now.delta *= 1 + off * part();
      now.p *= 1 + off / 3 * part();
      now.load = std::lerp(request.cases.front().weakest, 1, (1 + part()) / 2);
      return now;
    };
    TaskFigures worst;
    bool all_move = true;  // as the bounds of a start require
    for (unsigned corner = 0; corner < 16; ++corner) {
      unsigned left = corner;
      const auto end = [&left] {
        const double part = (left & 1U) != 0 ? 1 : -1;
        left >>= 1U;
        return part;
      };
      const TaskFigures now = figures_of(request, damper(end));
      all_move = all_move && now.front().peak > 0;
      worst = worse(worst, now);
    }
    if (!all_move || !settled(worst) || worst.front().passages > 0 || worst.front().residual > 0) {
      continue;
    }
    ++boxes;
    for (int k = 0; k < 40; ++k) {
      const SuiteFigures now =
          figures_of(request, damper([&] { return random.uniform(-1, 1); })).front();
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

/// f2 to f3 and Delta1(f) to V0^2/2 without damping, and with it r as the largest f.
BOOST_AUTO_TEST_CASE(the_region_has_the_edges_of_the_closed_forms) {
  for (const auto& [zeta, r, b] : first_returns) {
    const Problem problem{.beta = 0.9, .criterion = Criterion::exact};
    const auto region = design::design(map_of(under_hit({zeta, zeta}, problem.beta))).region;
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
}

BOOST_AUTO_TEST_CASE(a_region_may_be_empty) {
  const auto region = design::design(map_of(under_hit({0.05, 0.05}, 0.68))).region;
  BOOST_TEST_REQUIRE(region.has_value());
  BOOST_TEST((region->f.empty() && region->deltas.empty()));
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
      BOOST_TEST(found.largest_tolerance.value() >= best - of_searched_tolerance);
      BOOST_TEST(*found.largest_tolerance <= best + of_edge);
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
    load.records = short_records().cases.front().records;
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
    const RecordDesign judged = design::design(judge(request, f, delta));
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

BOOST_AUTO_TEST_CASE(next_to_no_damping_changes_nothing) {
  RandomSource random(4204);
  constexpr double of_figure = 1e-5;  // some motions enlarge what is off ten thousandfold
  for (int i = 0; i < 150; ++i) {
    RecordDesignRequest request{.cases = {random_case(random, i)}};
    const SuiteDamper damper{1, random.log_uniform(0.005, 0.4), random.log_uniform(0.005, 0.4),
                             i % 7 == 0 ? 0.05 : 0};
    const SuiteFigures without = figures_of(request, damper).front();
    request.zeta = {1e-9, 1e-9};
    const SuiteFigures with = figures_of(request, damper).front();
    if (without.margin < of_figure) {
      continue;
    }
    BOOST_TEST_CONTEXT("motion " << i << ": f = " << damper.f << ", delta = " << damper.delta) {
      BOOST_TEST(std::abs(with.peak - without.peak) <= of_figure);
      BOOST_TEST(std::abs(with.acceleration - without.acceleration) <= of_figure);
      BOOST_TEST(std::abs(with.residual - without.residual) <= of_figure);
      BOOST_TEST(with.passages == without.passages);
    }
  }
  const double undamped = design::design(under_hit({0, 0}, 0.9)).largest_tolerance.value();
  const double damped = design::design(under_hit({1e-9, 1e-9}, 0.9)).largest_tolerance.value();
  BOOST_TEST(std::abs(damped - undamped) <= of_tolerance);
}

BOOST_AUTO_TEST_CASE(a_damper_works_for_the_hits_under_which_it_is_admissible) {
  RandomSource random(4205);
  constexpr double of_end = 1e-6;
  int ended = 0;
  for (int i = 0; i < 30; ++i) {
    const double low = random.uniform(0, 0.1);
    RecordDesignRequest request = under_hit({low, i % 2 == 0 ? low : 2 * low}, 0.9);
    request.breakaway = random.uniform(1, 3);
    request.cases.front().combine = Combine::max;
    const double f = random.uniform(0.05, 0.3);
    const double delta = random.uniform(0.1, 0.45);
    const auto served = works_for(request, {1, f, delta, 0});
    BOOST_TEST(served.has_value() == is_admissible(request, f, delta));
    if (!served) {
      continue;
    }
    const auto holds = [&](double v0) {
      RecordDesignRequest other = request;
      other.cases.front().v0 = v0;
      return is_admissible(other, f, delta);
    };
    BOOST_TEST_CONTEXT("damper " << i << ", f = " << f << ", delta = " << delta) {
      BOOST_TEST(holds(served->hit.low * (1 + of_end)));
      BOOST_TEST(holds(*served->hit.high * (1 - of_end)));
      BOOST_TEST(!holds(served->hit.low * (1 - of_end)));
      BOOST_TEST(!holds(*served->hit.high * (1 + of_end)));
      ++ended;
    }
  }
  BOOST_TEST(ended > 8);
}

// The turn is at A = sqrt(f^2 + 1) - f = 0.744, where the spring pulls with as much.
BOOST_AUTO_TEST_CASE(friction_that_holds_at_the_turn_lets_nothing_return) {
  for (const auto& [breakaway, returns] : {std::pair(2.48, true), {2.481, false}}) {
    RecordDesignRequest request = under_hit({0, 0}, 1);
    request.breakaway = breakaway;
    BOOST_TEST(is_admissible(request, 0.3, 0.1) == returns);
  }
}

BOOST_AUTO_TEST_CASE(a_pulse_must_overcome_the_friction_that_holds) {
  RecordDesignRequest request{.cases = {{.name = "pulse",
                                         .pulse = Rectangle{0.5, 1},
                                         .limits = {.peak = 2, .residual = 0, .passages = 0}}},
                              .breakaway = 2};
  const RecordDesign judged = design::design(judge(request, 0.26, 0.3));
  BOOST_TEST(judged.constraints.back().name == "start");
  BOOST_TEST(judged.constraints.back().limit == 0.25, tt::tolerance(1e-8));
  BOOST_TEST(!judged.constraints.back().satisfied);
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
  const RecordDesign brake = design::design(judge(request, 20, 0.001));
  BOOST_TEST(!brake.finding->admissible);
  const auto held =
      std::ranges::find(brake.constraints, std::string_view("dead_zone"), &Constraint::name);
  BOOST_REQUIRE((held != brake.constraints.end()));
  BOOST_TEST(!held->satisfied);
}

BOOST_AUTO_TEST_CASE(what_would_help_needs_no_tolerance) {
  constexpr double least = .68495266613546249;  // first_returns
  const RecordDesign none = design::design(under_hit({0.05, 0.05}, 0.68));
  BOOST_REQUIRE(!none.finding);
  const auto beta = std::ranges::find(none.mends, std::string_view("beta"), &Mend::field);
  BOOST_REQUIRE((beta != none.mends.end()));
  BOOST_TEST(beta->value >= least);
  BOOST_TEST(beta->value <= 1.004 * least);  // 2e-3 above the best that was found
}

// A weaker hit, and a stiffer spring, only change the scale of the motion.
BOOST_AUTO_TEST_CASE(a_weaker_hit_and_a_stiffer_spring_help) {
  const RecordDesignRequest request = under_hit({0.05, 0.05}, 0.5);
  const RecordDesign none = design::design(request);
  const auto mended = [&](std::string_view field) {
    const auto mend = std::ranges::find(none.mends, field, &Mend::field);
    BOOST_REQUIRE((mend != none.mends.end()));
    return mend->value;
  };
  constexpr double of_rounding = 1e-12;
  BOOST_TEST(std::abs(mended("v0") - 0.5 / mended("beta")) <= of_rounding);
  BOOST_TEST(std::abs(mended("p") - mended("beta") / 0.5) <= of_rounding);
  RecordDesignRequest weaker = request;
  weaker.cases.front().v0 = mended("v0");
  BOOST_TEST(design::design(weaker).finding.has_value());
  RecordDesignRequest stiffer = request;
  stiffer.p = {mended("p"), mended("p")};
  BOOST_TEST(design::design(stiffer).finding.has_value());
}

BOOST_AUTO_TEST_CASE(a_weaker_hit_helps_where_no_single_limit_does) {
  RecordDesignRequest request = under_hit({0.05, 0.05}, 0.5);
  request.cases.front().limits.acceleration = 0.6;
  const RecordDesign none = design::design(request);
  BOOST_TEST_REQUIRE(none.mends.size() == 1U);
  BOOST_TEST(none.mends.front().field == "v0");
  BOOST_TEST(!none.mends.front().upwards);
  request.cases.front().v0 = none.mends.front().value;
  BOOST_TEST(design::design(request).finding.has_value());
  request.cases.front().v0 = 1.01 * none.mends.front().value;  // 2e-3 below the best that was found
  BOOST_TEST(!design::design(request).finding.has_value());
}

BOOST_AUTO_TEST_CASE(wrong_damping_is_refused) {
  const auto refused = [](const std::string& field, const auto& spoil) {
    RecordDesignRequest request = under_hit({0, 0}, 1);
    spoil(request);
    check_refused(field, [&] { (void)design::design(request); });
  };
  refused("damping", [](auto& request) { request.zeta = {-0.1, 0.1}; });
  refused("damping", [](auto& request) { request.zeta = {0.1, 0.05}; });
  refused("damping", [](auto& request) { request.zeta = {0.1, 1}; });
  refused("damping", [](auto& request) { request.zeta = {0.1, 0.95}; });  // it would creep
  refused("breakaway", [](auto& request) { request.breakaway = 0.9; });
}

BOOST_AUTO_TEST_SUITE_END()
