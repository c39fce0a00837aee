// SPDX-License-Identifier: MIT
#include "damper.hpp"
#include "random_pulse.hpp"

BOOST_AUTO_TEST_SUITE(pulse_catalogue_test)

// The truth about a part under a pulse is its own simulation from rest.

namespace {

using namespace stillpoint::design_test;

/// Relative; nearer to an edge than that, the rounding of the simulation decides.
constexpr double undecided_within = 1e-9;
/// Of a mend, which keeps a relative 1e-11 from its edge.
constexpr double close_to_edge = 1e-9;

struct Shop {
  DesignRequest request;
  std::vector<Part> parts;
};

ForcedResponse simulated(const DesignRequest& request, double f, double delta) {
  return forced_response({request.problem.p, f, delta}, {}, excitation(*request.pulse));
}

/// Within beta and the limits, all of them changed by this factor.
bool works(const DesignRequest& request, double f, double delta, double factor) {
  const Limits& limits = request.limits;
  const ForcedResponse motion = simulated(request, f, delta * factor);
  const auto within = [factor](double value, const std::optional<double>& limit) {
    return value <= limit.value_or(HUGE_VAL) * factor;
  };
  return motion.stops_at_zero && motion.half_cycles == 1.0 &&
         within(motion.peak_amplitude, request.problem.beta) && within(f, limits.f_max) &&
         within(delta, limits.delta_max) &&
         within(motion.peak_absolute_acceleration, limits.acceleration_max);
}

bool box_works(const DesignRequest& request, const Part& part, double r, double factor,
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

Shop random_shop(RandomSource& random, int size) {
  Shop shop;
  Problem& problem = shop.request.problem;
  problem.p = random.log_uniform(0.1, 10);
  problem.criterion = Criterion::exact;  // which the simulation knows
  const double k = random.log_uniform(0.1, 10);
  const double lambda = problem.p / random.log_uniform(0.05, 3);
  constexpr std::array kinds{0, 2, 1};
  shop.request.pulse = pulse_of(kinds.at(static_cast<std::size_t>(random.pick(3))), k, lambda);
  const ForcedResponse free = simulated(shop.request, 1e-3 * k, 1e200);
  const double w = free.arrival_speed.value_or(0);
  const double f_unit = std::min(k, free.peak_absolute_acceleration);
  problem.beta = random.uniform(0.5, 1.2) * free.peak_amplitude;
  Limits& limits = shop.request.limits;
  limits.tolerance = random.pick(2) == 0 ? 0 : random.uniform(0, 0.3);
  random.one_in(3, limits.f_max, [&] { return random.uniform(0.1, 0.4) * f_unit; });
  random.one_in(3, limits.delta_max, [&] { return random.uniform(0.4, 1) * w * w; });
  random.one_in(3, limits.acceleration_max,
                [&] { return random.uniform(0.9, 1.2) * free.peak_absolute_acceleration; });
  for (int i = 0; i < size; ++i) {
    shop.parts.push_back({"part " + std::to_string(i), i == 0 ? 0 : random.uniform(0, 0.5) * f_unit,
                          random.uniform(0, 1) * w * w});
  }
  return shop;
}

double part_value(const DesignRequest& request, const RatedPart& rated) {
  const Objective objective = request.search.objective;
  return objective == Objective::robust
             ? -rated.tolerance.value_or(0)
             : value_of(objective, simulated(request, rated.part.f, rated.part.delta));
}

DesignRequest mended(DesignRequest request, std::string_view field, double value) {
  const Task changed = Task{request.problem, request.limits}.with(field, value);
  request.problem = changed.problem;
  request.limits = changed.limits;
  return request;
}

bool any_fits(const DesignRequest& request, const std::vector<Part>& parts) {
  return choose(request, parts).parts.front().admissible;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_part_is_judged_as_its_simulation_judges_it) {
  RandomSource random(20261122);
  int fit = 0;
  int fail = 0;
  int without_any = 0;
  for (int i = 0; i < 30; ++i) {
    Shop shop = random_shop(random, 12);
    shop.request.search.objective =
        std::array{Objective::robust, Objective::amplitude, Objective::time,
                   Objective::acceleration}[static_cast<std::size_t>(random.pick(4))];
    const auto& request = shop.request;
    const Choice choice = choose(request, shop.parts);
    BOOST_TEST_CONTEXT("shop " << i << ", " << name(*request.pulse) << ", p/lambda "
                               << request.problem.p / angular_frequency(*request.pulse)) {
      BOOST_TEST(choice.parts.size() == shop.parts.size());
      for (std::size_t n = 0; n < choice.parts.size(); ++n) {
        const RatedPart& now = choice.parts[n];
        const auto& [name, f, delta] = now.part;
        const double asked = request.limits.tolerance;
        BOOST_TEST_CONTEXT(name << ", f = " << f << ", delta = " << delta) {
          // Strictly inside it is admissible, and strictly outside it is not.
          BOOST_TEST(
              (now.admissible || !box_works(request, now.part, asked, 1 - undecided_within)));
          BOOST_TEST(
              (!now.admissible || box_works(request, now.part, asked, 1 + undecided_within)));
          if (now.tolerance) {
            constexpr double beside = 1e-6;
            // Even a fine scan misses a kink of what Delta must take, by as much.
            constexpr double missed = 1e-3;
            constexpr int fine = 200;
            BOOST_TEST(box_works(request, now.part, *now.tolerance * (1 - beside), 1));
            const bool most = *now.tolerance >= 0.995;  // the search ends there
            BOOST_TEST((most || !box_works(request, now.part, *now.tolerance + missed, 1, fine)));
          } else {
            BOOST_TEST(!now.admissible);
          }
          if (n > 0 && now.admissible) {
            BOOST_TEST(choice.parts[n - 1].admissible);
            BOOST_TEST(part_value(request, choice.parts[n - 1]) <=
                       part_value(request, now) + undecided_within);
          }
        }
        (now.admissible ? fit : fail) += 1;
      }
      BOOST_TEST(choice.result.finding.has_value() == choice.parts.front().admissible);
      if (choice.result.finding) {
        BOOST_TEST(choice.result.finding->cross_check.passed);
        BOOST_TEST(choice.result.finding->point.f == choice.parts.front().part.f);
        continue;
      }
      ++without_any;
      BOOST_TEST(choice.result.reason.has_value());
      for (const Mend& mend : choice.result.mends) {
        BOOST_TEST_CONTEXT(mend.field << " = " << mend.value) {
          BOOST_TEST(any_fits(mended(request, mend.field, mend.value), shop.parts));
          const double less = mend.value * (1 - (mend.upwards ? 1 : -1) * close_to_edge);
          BOOST_TEST(!any_fits(mended(request, mend.field, less), shop.parts));
        }
      }
    }
  }
  BOOST_TEST(fit >= 40);
  BOOST_TEST(fail >= 100);
  BOOST_TEST(without_any >= 4);
}

// Known by hand, docs/theory.md section 8: a rectangle of k = 1/2 and lambda = p = 1 returns for
// f <= 1/4 with the peak 2 (k - f) and half the square of the speed 2 (k - f) (k - 2 f).
BOOST_AUTO_TEST_CASE(parts_under_a_known_pulse_fail_as_they_must) {
  DesignRequest request;
  request.problem.beta = 0.8;
  request.problem.criterion = Criterion::exact;
  request.pulse = Rectangle{0.5, 1};
  const std::vector<Part> parts{{"held", 0.6, 1},
                                {"off centre", 0.3, 1},
                                {"too far", 0.05, 1},
                                {"passes", 0.2, 0.05},
                                {"fits", 0.2, 0.3}};
  const Choice choice = choose(request, parts);
  const auto of = [&](std::string_view name) {
    return *std::ranges::find(choice.parts, name,
                              [](const RatedPart& now) { return now.part.name; });
  };
  const auto violates = [&](std::string_view name) { return of(name).violated.at(0).name; };
  BOOST_TEST(choice.parts.front().part.name == "fits");
  BOOST_TEST(of("fits").tolerance.value() == 0.25, tt::tolerance(1e-9));
  BOOST_TEST(violates("held") == "start");
  BOOST_TEST(violates("off centre") == "return");
  BOOST_TEST(violates("too far") == "amplitude");
  BOOST_TEST(violates("passes") == "stop");
  BOOST_TEST(of("passes").violated.at(0).limit == 2 * 0.3 * 0.1, tt::tolerance(1e-9));
  BOOST_CHECK_THROW((void)choose(request, {}), InputError);
  // f = 0.175 needs 0.65 * 0.3 / 2 = 0.0975, by the published criterion f^2/2 = 0.0153 more.
  request.problem.criterion = Criterion::published;
  const std::vector<Part> between{{"between", 0.175, 0.1}};
  const Choice refused = choose(request, between);
  BOOST_TEST(!refused.parts.front().admissible);
  BOOST_TEST(refused.parts.front().violated.at(0).by_criterion_alone);
  BOOST_TEST((refused.result.criterion_mend == Criterion::exact));
}

// One that returns under every pulse of the range; the weakest is k = 0.35.
BOOST_AUTO_TEST_CASE(parts_hold_for_a_range_of_pulses) {
  DesignRequest request;
  request.problem.beta = 0.8;
  request.problem.criterion = Criterion::exact;
  request.pulse = Rectangle{0.5, 1};
  request.pulse_ranges.k_low = 0.35;
  const std::vector<Part> parts{{"too strong", 0.2, 0.3}, {"fits", 0.17, 0.3}};
  const Choice choice = choose(request, parts);
  BOOST_TEST(choice.parts.at(0).part.name == "fits");
  BOOST_TEST(choice.parts.at(0).admissible);
  BOOST_TEST(!choice.parts.at(1).admissible);
  BOOST_TEST(choice.parts.at(1).violated.at(0).limit == 0.175, tt::tolerance(1e-9));
}

BOOST_AUTO_TEST_SUITE_END()
