// SPDX-License-Identifier: MIT
#include "damper.hpp"
#include "pulse/pulse_task.hpp"

BOOST_AUTO_TEST_SUITE(catalogue_test)

// The truth about a part is its own simulation, and the order of the values that the parts have.

using namespace stillpoint::design_test;

/// Relative; nearer to an edge than that, the rounding of the simulation decides.
constexpr double undecided_within = 1e-9;

struct Shop {
  DesignRequest request;
  std::vector<Part> parts;
};

/// What the motion after the hit or under the pulse has.
template <class Use>
auto moved(const DesignRequest& request, double f, double delta, const Use& use) {
  const Oscillator damper{request.problem.p, f, delta};
  return request.pulse ? use(forced_response(damper, {}, excitation(*request.pulse)))
                       : use(free_response(damper, {0, request.problem.v0}));
}

/// Of the exact criterion, which the simulation knows.
Shop random_shop(RandomSource& random, int size, bool pulsed) {
  Shop shop;
  Problem& problem = shop.request.problem;
  Limits& limits = shop.request.limits;
  double f_unit = 0;
  double delta_unit = 0;
  double felt = 0;
  if (pulsed) {
    problem.p = random.log_uniform(0.1, 10);
    const double k = random.log_uniform(0.1, 10);
    shop.request.pulse = random_pulse(random, k, problem.p / random.log_uniform(0.05, 3));
    moved(shop.request, 1e-3 * k, 1e200, [&](const auto& free) {
      const double w = free.arrival_speed.value_or(0);
      felt = free.peak_absolute_acceleration;
      f_unit = std::min(k, felt);
      delta_unit = 2 * w * w;
      problem.beta = random.uniform(0.5, 1.2) * free.peak_amplitude;
    });
  } else {
    problem = random_problem(random, 0.75, 1.5);
    problem.arrivals = 1 + random.pick(3);
    felt = f_unit = problem.p * problem.v0;
    delta_unit = problem.v0 * problem.v0;
  }
  problem.criterion = Criterion::exact;
  limits.tolerance = random.pick(2) == 0 ? 0 : random.uniform(0, 0.3);
  random.one_in(3, limits.f_max, [&] { return random.uniform(0.1, 0.4) * f_unit; });
  random.one_in(3, limits.delta_max, [&] { return random.uniform(0.2, 0.6) * delta_unit; });
  random.one_in(3, limits.acceleration_max, [&] { return random.uniform(0.95, 1.1) * felt; });
  shop.request.search.objective = random_objective(random);
  for (int i = 0; i < size; ++i) {
    shop.parts.push_back({"part " + std::to_string(i), i == 0 ? 0 : random.uniform(0, 0.5) * f_unit,
                          random.uniform(0, 0.6) * delta_unit});
  }
  return shop;
}

/// By simulation: it stops at x = 0 in time, within beta and the limits, all changed by this
/// factor.
bool works(const DesignRequest& request, double f, double delta, double factor = 1) {
  const Problem& problem = request.problem;
  const Limits& limits = request.limits;
  const auto within = [factor](double value, const std::optional<double>& limit) {
    return value <= limit.value_or(HUGE_VAL) * factor;
  };
  return (request.pulse || 2 * delta <= problem.v0 * problem.v0 * factor) &&
         within(f, limits.f_max) && within(delta, limits.delta_max) &&
         moved(request, f, delta * factor, [&](const auto& motion) {
           return motion.stops_at_zero &&
                  motion.half_cycles <= static_cast<double>(problem.arrivals) &&
                  within(motion.peak_amplitude, problem.beta) &&
                  within(motion.peak_absolute_acceleration, limits.acceleration_max);
         });
}

bool box_works(const DesignRequest& request, const Part& part, double r, double factor = 1,
               int steps = 20) {
  for (int i = -steps; i <= steps; ++i) {
    const double f = part.f * (1 + r * i / steps);
    if (!works(request, f, part.delta * (1 - r), factor) ||
        !works(request, f, part.delta * (1 + r), factor)) {
      return false;
    }
  }
  return true;
}

/// What the objective minimises.
double part_value(const DesignRequest& request, const RatedPart& rated) {
  const Objective objective = request.search.objective;
  return objective == Objective::robust
             ? -rated.tolerance.value()
             : moved(request, rated.part.f, rated.part.delta,
                     [&](const auto& motion) { return value_of(objective, motion); });
}

/// Nearer to the edge than the first mend is, less than which does not suffice.
double less_than(const Mend& mend, bool pulsed) {
  return mend.field == "arrivals" ? mend.value - 1
         : pulsed                 ? mend.value * (mend.upwards ? 1 - 1e-9 : 1 + 1e-9)
                                  : std::nextafter(mend.value, mend.upwards ? 0 : 1);
}

struct Counts {
  int fit{0};
  int fail{0};
  int mended{0};
  int more_arrivals{0};
};

void check_part(const DesignRequest& request, const RatedPart& now) {
  const double asked = request.limits.tolerance;
  BOOST_TEST(now.tolerance.has_value() == now.violated.empty());
  BOOST_TEST(now.admissible == (now.tolerance && *now.tolerance >= asked));
  BOOST_TEST((!now.tolerance || works(request, now.part.f, now.part.delta, 1 + undecided_within)));
  BOOST_TEST((now.tolerance || !works(request, now.part.f, now.part.delta, 1 - undecided_within)));
  for (const Constraint& constraint : now.violated) {
    BOOST_TEST(!constraint.satisfied);
  }
  if (!now.tolerance) {
    return;
  }
  constexpr double beside = 1e-6;
  BOOST_TEST(box_works(request, now.part, *now.tolerance * (1 - beside)));
  // Between the strips of two arrivals lie gaps that no grid sees. Even a fine one misses a kink of
  // what Delta must take; the search ends at 0.995.
  constexpr double missed = 1e-3;
  if (request.problem.arrivals == 1 && *now.tolerance < 0.995) {
    BOOST_TEST(!box_works(request, now.part, *now.tolerance + missed, 1, 200));
  }
}

void check_mends(const Shop& shop, const std::vector<Mend>& mends, Counts& counts) {
  const bool pulsed = shop.request.pulse.has_value();
  const auto any_fits = [&shop](const Mend& mend, double value) {
    const Task changed = Task{shop.request.problem, shop.request.limits}.with(mend.field, value);
    DesignRequest request = shop.request;
    std::tie(request.problem, request.limits) = std::tie(changed.problem, changed.limits);
    return choose(request, shop.parts).parts.front().admissible;
  };
  for (const Mend& mend : mends) {
    BOOST_TEST_CONTEXT(mend.field << " = " << mend.value) {
      BOOST_TEST(mend.upwards == (mend.field != "tolerance"));
      BOOST_TEST(any_fits(mend, mend.value));
      BOOST_TEST(!any_fits(mend, less_than(mend, pulsed)));
      ++(mend.field == "arrivals" ? counts.more_arrivals : counts.mended);
    }
  }
}

/// Those that fit come first, as the objective has them, then the nearest misses.
void check_order(const DesignRequest& request, const std::vector<RatedPart>& parts) {
  for (std::size_t k = 1; k < parts.size(); ++k) {
    const RatedPart& before = parts[k - 1];
    const RatedPart& now = parts[k];
    BOOST_TEST((before.admissible || !now.admissible));
    BOOST_TEST((before.tolerance || !now.tolerance));
    if (now.admissible) {
      BOOST_TEST(part_value(request, before) <= part_value(request, now) + undecided_within);
    } else if (now.tolerance && !before.admissible) {
      BOOST_TEST(*before.tolerance >= *now.tolerance);
    }
  }
}

BOOST_AUTO_TEST_CASE(every_part_is_judged_as_it_moves) {
  for (const bool pulsed : {false, true}) {
    RandomSource random(20261122);
    Counts counts;
    for (int i = 0; i < (pulsed ? 30 : 150); ++i) {
      const Shop shop = random_shop(random, i % 2 == 0 ? 4 : 20, pulsed);
      const DesignRequest& request = shop.request;
      const auto& [result, parts] = choose(request, shop.parts);
      BOOST_TEST_CONTEXT("shop " << i << (pulsed ? ", pulsed" : "")) {
        BOOST_TEST(parts.size() == shop.parts.size());
        for (const RatedPart& now : parts) {
          BOOST_TEST_CONTEXT(now.part.name << ", f = " << now.part.f
                                           << ", delta = " << now.part.delta) {
            check_part(request, now);
            ++(now.admissible ? counts.fit : counts.fail);
          }
        }
        check_order(request, parts);
        const RatedPart& best = parts.front();
        BOOST_TEST(result.finding.has_value() == best.admissible);
        BOOST_TEST(result.reason.has_value() != best.admissible);
        BOOST_TEST((result.mends.empty() || !best.admissible));
        check_mends(shop, result.mends, counts);
        if (best.admissible) {
          const Found& finding = *result.finding;
          BOOST_TEST(finding.point.f == best.part.f);
          BOOST_TEST(finding.point.delta == best.part.delta);
          BOOST_TEST(finding.point.tolerance == *best.tolerance);
          BOOST_TEST(finding.cross_check.passed);
          BOOST_TEST((!finding.search && finding.works_for));
          // No part is better than the best damper of any size.
          DesignRequest any = request;
          any.search.objective = Objective::robust;
          const DesignResult robust = design::design(any);
          BOOST_TEST(robust.finding.value().point.tolerance >= *best.tolerance - 1e-8);
        }
      }
    }
    BOOST_TEST(counts.fit >= 40);
    BOOST_TEST(counts.fail >= 100);
    BOOST_TEST(counts.mended >= (pulsed ? 4 : 50));
    BOOST_TEST((pulsed || counts.more_arrivals > 5));
  }
}

BOOST_AUTO_TEST_CASE(equals_keep_their_order_and_the_nearest_miss_is_first_of_those_that_fail) {
  // At beta = 0.9, f2 = 0.10556; f3 = 0.35355, Delta2 = 0.5.
  const std::vector<Part> parts{{"far in f", 0.02, 0.501}, {"far", 0.01, 0.45},
                                {"near", 0.1, 0.45},       {"twin 1", 0.2, 0.45},
                                {"twin 2", 0.2, 0.45},     {"too strong", 0.36, 1e-9}};
  const auto all = ranked({1, 1, 0.9}, {}, Objective::acceleration, parts);
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const RatedPart& rated : all) {
    names.push_back(rated.part.name);
  }
  // f2/f - 1: 10.6, 4.28 and 0.056, which is worse than delta/Delta2 - 1 = 0.002; f/f3 - 1: 0.018.
  const std::vector<std::string> expected{"twin 1", "twin 2",   "too strong",
                                          "near",   "far in f", "far"};
  BOOST_TEST(names == expected, tt::per_element());
  // What does not come back is not judged by Delta1: above f3 the published one means nothing.
  BOOST_TEST_REQUIRE(all[2].violated.size() == 1U);
  BOOST_TEST(all[2].violated[0].name == "return");
  BOOST_TEST(all[3].violated[0].name == "amplitude");
}

// Known by hand, docs/theory.md section 8: a rectangle of k = 1/2 and lambda = p = 1 returns for
// f <= 1/4 with the peak 2 (k - f) and half the square of the speed 2 (k - f) (k - 2 f).
BOOST_AUTO_TEST_CASE(a_part_under_a_pulse_may_fail_by_the_criterion_alone) {
  const DesignRequest request{.problem = {.beta = 0.8}, .pulse = Rectangle{0.5, 1}};
  BOOST_CHECK_THROW((void)choose(request, {}), InputError);
  // f = 0.175 needs 0.65 * 0.3 / 2 = 0.0975, by the published criterion f^2/2 = 0.0153 more.
  const std::vector<Part> between{{"between", 0.175, 0.1}};
  const Choice refused = choose(request, between);
  BOOST_TEST(!refused.parts.front().admissible);
  BOOST_TEST(refused.parts.front().violated.at(0).by_criterion_alone);
  BOOST_TEST((refused.result.criterion_mend == Criterion::exact));
}

// One that returns under every pulse of the range; the weakest is k = 0.35.
BOOST_AUTO_TEST_CASE(parts_hold_for_a_range_of_pulses) {
  const DesignRequest request{.problem = {.beta = 0.8, .criterion = Criterion::exact},
                              .pulse = Rectangle{0.5, 1},
                              .pulse_ranges = {.k_low = 0.35}};
  const std::vector<Part> parts{{"too strong", 0.2, 0.3}, {"fits", 0.17, 0.3}};
  const Choice choice = choose(request, parts);
  BOOST_TEST(choice.parts.at(0).part.name == "fits");
  BOOST_TEST(choice.parts.at(0).admissible);
  BOOST_TEST(!choice.parts.at(1).admissible);
  BOOST_TEST(choice.parts.at(1).violated.at(0).limit == 0.175, tt::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(the_largest_values_are_judged_and_mended_in_doubles) {
  const std::vector<Part> parts{{"strong", 1e150, 0.45}, {"held", 0.2, 1e299}};
  const Limits limits{.f_max = 0.3, .delta_max = 0.4, .tolerance = 0.1, .acceleration_max = 1.05};
  const Choice none = choose({{1, 1, 0.9}, limits}, parts);
  for (const RatedPart& rated : none.parts) {
    BOOST_TEST(!rated.violated.empty());
    for (const Constraint& now : rated.violated) {
      BOOST_TEST(std::isfinite(now.limit));
      BOOST_TEST(std::isfinite(now.slack));
    }
  }
  BOOST_TEST(none.result.mends.empty());
}

BOOST_AUTO_TEST_CASE(if_no_part_fits_the_reason_says_so) {
  const std::vector<Part> weak{{"weak", 0.1, 0.45}};
  const Choice none = choose({{1, 1, 0.9}}, weak);
  BOOST_TEST(none.result.region.feasible);
  BOOST_TEST(none.result.reason.value() == "the only part of the catalogue is not admissible");
  // The stroke of f = 0.1 is sqrt(1 + f^2) - f.
  BOOST_TEST_REQUIRE(none.result.mends.size() == 1U);
  BOOST_TEST(none.result.mends[0].field == "beta");
  BOOST_TEST(std::abs(none.result.mends[0].value - (std::sqrt(1.01) - 0.1)) < 1e-15);
}

BOOST_AUTO_TEST_CASE(refuses_what_it_cannot_judge) {
  BOOST_CHECK_THROW((void)choose({{1, 1, 0.9}}, {}), InputError);
  for (const Part& wrong :
       {Part{"negative", -0.2, 0.45}, Part{"strong", 1e200, 0.45}, Part{"huge", 0.2, HUGE_VAL}}) {
    BOOST_CHECK_THROW((void)choose({{1, 1, 0.9}}, std::vector{wrong}), InputError);
  }
}

BOOST_AUTO_TEST_SUITE_END()
