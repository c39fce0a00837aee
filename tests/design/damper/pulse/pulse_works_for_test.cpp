// SPDX-License-Identifier: MIT
#include "damper.hpp"
#include "pulse_task.hpp"

BOOST_AUTO_TEST_SUITE(pulse_works_for_test)

// The pulses and springs that a damper works for, compared with closed forms and with the motions
// of single pulses.

using namespace stillpoint::design_test;

/// The program keeps this from an edge, several times over.
constexpr double edge_tolerance = 1e-12;
/// A point this far from an edge is on its own side of it in any run.
constexpr double aside = 1e-9;

/// Under a rectangle of half a natural period, p = lambda = 1, the mass reaches 2 (k - f), if it
/// returns with w^2 = 4 (k - f)(k - 2 f), and feels 2 k - f.
PulseRequest half_period(double beta, double k = 0.5) {
  return request_of(Rectangle{k, 1}, beta);
}

PulseProblem with_k(PulseProblem problem, double k) {
  std::visit([k](auto& kind) { kind.k = k; }, problem.pulse);
  return problem;
}

PulseProblem with_p(PulseProblem problem, double p) {
  problem.p = p;
  return problem;
}

/// By the motion of that pulse with that spring.
bool holds(const PulseRequest& request, const PulseProblem& one, double f, double delta) {
  if (f >= peak_load(one.pulse)) {
    return false;
  }
  const Scanned now = scanned(request, one, f);
  return now.holds && now.need <= delta;
}

struct Point {
  PulseRequest request;
  double f;
  double delta;

  [[nodiscard]] std::optional<WorksFor> served() const {
    return works_for(request.problem, request.limits, f, delta);
  }
  [[nodiscard]] bool holds_at(const PulseProblem& one) const {
    return holds(request, one, f, delta);
  }
};

/// Admissible by its own motion, and not on an edge.
std::optional<Point> random_point(RandomSource& random) {
  Point now{random_request(random), 0, 0};
  now.request.limits = {.acceleration_max = now.request.limits.acceleration_max};
  const PulseProblem& problem = now.request.problem;
  const double k = peak_load(problem.pulse);
  const double most = std::min(k, 4 * k * problem.p / angular_frequency(problem.pulse));
  now.f = most * random.log_uniform(1e-3, 0.9);
  const Scanned motion = scanned(now.request, problem.pulse, problem.p, now.f);
  now.delta = motion.need * random.uniform(1, 3);
  for (const double side : {1 - aside, 1 + aside}) {
    if (!motion.holds || !holds(now.request, problem, now.f * side, now.delta)) {
      return std::nullopt;
    }
  }
  return now;
}

std::string context_of(const Point& now) {
  std::ostringstream text;
  text.precision(17);
  text << stillpoint::design_test::context_of(now.request) << ", f " << now.f << ", delta "
       << now.delta;
  return text.str();
}

HitEnd end_at(const std::vector<Hits>& list, double k) {
  return std::ranges::find_if(list, [k](const Hits& now) { return k <= now.to; })->end;
}

/// By the motion to the first return.
HitEnd end_by_motion(const Point& now, const PulseProblem& one) {
  if (now.f >= peak_load(one.pulse)) {
    return HitEnd::held;
  }
  const ForcedResponse motion = simulated(one, now.f, 1e200);
  const double w = motion.arrival_speed.value_or(0);
  return motion.peak_amplitude > one.beta                       ? HitEnd::too_far
         : !(motion.stops_at_zero && motion.half_cycles == 1.0) ? HitEnd::off_centre
         : w * w / 2 <= now.delta                               ? HitEnd::centred
                                                                : HitEnd::passes;
}

BOOST_AUTO_TEST_CASE(of_a_rectangle_of_half_a_natural_period_the_ends_are_known) {
  const auto close = tt::tolerance(edge_tolerance);
  const auto served_k = [](const PulseRequest& request, double f, double delta) {
    return works_for(request.problem, request.limits, f, delta).value().hit;
  };
  // With hardly any friction, and without: w = 2 k.
  BOOST_TEST(*served_k(half_period(1.1), 1e-15, 1).high == 1.1 / 2, close);
  BOOST_TEST(served_k(half_period(1.1), 0, 1).low == 0);
  BOOST_TEST(*served_k(half_period(1.1), 0, 1).high == 1.1 / 2, close);
  BOOST_TEST(*served_k(half_period(1.1), 0, 0.51).high == std::sqrt(0.51 / 2), close);
  PulseRequest felt = half_period(1.1);
  felt.limits.acceleration_max = 1.05;
  BOOST_TEST(*served_k(felt, 0, 1).high == 1.05 / 2, close);
  // The pulse itself is on the edge.
  BOOST_TEST(*served_k(half_period(1), 0, 1).high == 0.5);
  BOOST_TEST(*served_k(half_period(0.8, 0.55), 0.15, 1).high == 0.55);
}

/// Held at 4 f from its second turn on where 3 f <= k <= 5 f, so that w^2 = 8 f^2 for all of them;
/// below, it is held at its first turn, as after half a natural period.
BOOST_AUTO_TEST_CASE(a_need_that_is_the_same_for_many_pulses_serves_them_all) {
  for (const double f : {0.1, 0.07, 0.093, 0.111}) {
    const PulseRequest request = request_of(Rectangle{4.4 * f, 0.4}, 10);
    const auto served = works_for(request.problem, {}, f, 4 * f * f);
    BOOST_TEST_REQUIRE(served.has_value());
    BOOST_TEST(served->hit.low == 2 * f, tt::tolerance(edge_tolerance));
    BOOST_TEST(*served->hit.high == 5 * f, tt::tolerance(edge_tolerance));
    for (const double unlike : {1 - aside, 1 + aside}) {
      BOOST_TEST(works_for(request.problem, {}, f, 4 * f * f * unlike).has_value() == (unlike > 1));
    }
  }
}

/// Of f = 0.1, k = 0.626 needs more than those on either side of it.
BOOST_AUTO_TEST_CASE(a_pulse_that_needs_more_than_its_neighbours_is_not_among_those_served) {
  const double f = 0.1;
  constexpr double worst = 0.626;
  const PulseRequest request = request_of(HalfSine{worst, 0.2}, 100);
  const auto need_of = [&](double k) { return scanned(request, HalfSine{k, 0.2}, 1, f).need; };
  const double most = need_of(worst);
  BOOST_TEST(most > need_of(0.625));
  BOOST_TEST(most > need_of(0.627));
  const auto served = [&](double k, double delta) {
    return works_for(with_k(request.problem, k), {}, f, delta).value().hit;
  };
  const double almost = most * (1 - 1e-5);
  BOOST_TEST(*served(0.61, almost).high < worst);
  BOOST_TEST(served(0.645, almost).low > worst);
  PulseProblem both = with_k(request.problem, 0.645);
  both.ranges.k_low = 0.61;
  BOOST_TEST(!works_for(both, {}, f, almost).has_value());
  BOOST_TEST(works_for(both, {}, f, most * (1 + 1e-5)).has_value());
  // A pulse that needs just that Delta is served itself.
  const ServedInterval weaker = served(0.61, need_of(0.61));
  BOOST_TEST(*weaker.high >= 0.61);
  BOOST_TEST(*weaker.high == 0.61, tt::tolerance(aside));
  const ServedInterval stronger = served(0.645, need_of(0.645));
  BOOST_TEST(stronger.low <= 0.645);
  BOOST_TEST(stronger.low == 0.645, tt::tolerance(aside));
}

/// The need is largest at p = 0.615, a little above that of the damper.
BOOST_AUTO_TEST_CASE(springs_that_fail_right_beside_the_own_one_are_seen) {
  const double f = 0.0085;
  const auto served_beside = [&](double p) {
    const PulseRequest request = request_of(FullSine{1, 1}, 100);
    const double need = scanned(request, request.problem.pulse, p, f).need;
    const auto holds_at = [&](double other) {
      return holds(request, with_p(request.problem, other), f, need * (1 + edge_tolerance));
    };
    BOOST_TEST(holds_at(0.5));
    BOOST_TEST(!holds_at(0.615));
    BOOST_TEST(holds_at(0.7));
    return works_for(with_p(request.problem, p), {}, f, need).value().p;
  };
  BOOST_TEST(served_beside(0.63).low == 0.63, tt::tolerance(aside));
  BOOST_TEST(*served_beside(0.6).high == 0.6, tt::tolerance(aside));
}

BOOST_AUTO_TEST_CASE(a_window_of_stiff_springs_that_do_not_return_is_seen) {
  const double f = 0.0957;
  const PulseRequest request = request_of(HalfSine{1, 1}, 100);
  const auto holds_at = [&](double p) {
    return holds(request, with_p(request.problem, p), f, 100);
  };
  BOOST_TEST(!holds_at(6.635));
  BOOST_TEST(holds_at(10));
  const double high = *works_for(with_p(request.problem, 0.823), {}, f, 100).value().p.high;
  BOOST_TEST(high < 6.635);
  BOOST_TEST(holds_at(high * (1 - aside)));
  BOOST_TEST(!holds_at(high * (1 + aside)));
}

/// With ranges or without: corners and points between of everything that works_for says and of the
/// ranges.
BOOST_AUTO_TEST_CASE(every_pulse_and_spring_within_the_ends_is_served_and_none_just_beyond) {
  RandomSource random(9301);
  std::array<int, 2> met{};
  for (int i = 0; i < 700; ++i) {
    auto now = random_point(random);
    if (!now) {
      continue;
    }
    const bool in_ranges = i % 5 == 0;
    if (in_ranges) {
      now->request = ranged(now->request, random, 0.1);
    }
    const PulseProblem& problem = now->request.problem;
    const double k = peak_load(problem.pulse);
    BOOST_TEST_CONTEXT(context_of(*now)) {
      const auto served = now->served();
      BOOST_TEST((served || in_ranges));
      if (!served) {
        continue;
      }
      ++met[in_ranges ? 1 : 0];
      BOOST_TEST(served->hit.low <= problem.ranges.k_low.value_or(k));
      BOOST_TEST(*served->hit.high >= k);
      BOOST_TEST(served->p.low <= problem.p);
      BOOST_TEST(*served->p.high >= problem.p_high.value_or(problem.p));
      const auto part = [&] {
        return aside +
               (1 - 2 * aside) * (random.pick(2) == 0 ? random.pick(2) : random.uniform(0, 1));
      };
      const auto within = [&](const ServedInterval& of) {
        return of.low * std::pow(*of.high / of.low, part());
      };
      for (int point = 0; point < 40; ++point) {
        const double at_k = part();
        const double at_lambda = part();
        const PulseProblem one = at_parts(problem, at_k, at_lambda, part());
        const PulseProblem other =
            point % 2 == 0 ? with_k(one, within(served->hit)) : with_p(one, within(served->p));
        BOOST_TEST(now->holds_at(other), "k " << peak_load(other.pulse) << ", lambda "
                                              << angular_frequency(other.pulse) << ", p "
                                              << other.p);
      }
      if (in_ranges) {
        continue;
      }
      // A full sine is not examined where f is within 1e-4 of k.
      const bool examined = served->hit.low > now->f * (1 + 2e-4);
      BOOST_TEST((!examined || !now->holds_at(with_k(problem, served->hit.low * (1 - aside)))));
      BOOST_TEST(!now->holds_at(with_k(problem, *served->hit.high * (1 + aside))));
      const auto [least, most] = searched_p(problem);
      BOOST_TEST(
          (served->p.low == least || !now->holds_at(with_p(problem, served->p.low * (1 - aside)))));
      BOOST_TEST((*served->p.high == most ||
                  !now->holds_at(with_p(problem, *served->p.high * (1 + aside)))));
    }
  }
  BOOST_TEST(met[0] > 100);
  BOOST_TEST(met[1] > 20);
}

BOOST_AUTO_TEST_CASE(ranges_of_one_value_change_nothing) {
  PulseRequest request = half_period(0.8);
  const WorksFor plain = works_for(request.problem, {}, 0.15, 1).value();
  request.problem.ranges = {0.5, 1};
  request.problem.p_high = 1;
  const WorksFor same = works_for(request.problem, {}, 0.15, 1).value();
  BOOST_TEST(same.hit.low == plain.hit.low);
  BOOST_TEST(*same.hit.high == *plain.hit.high);
  BOOST_TEST(same.p.low == plain.p.low);
  BOOST_TEST(*same.p.high == *plain.p.high);
}

BOOST_AUTO_TEST_CASE(the_strengths_of_a_pulse_end_as_their_motions_do) {
  RandomSource random(9303);
  constexpr double beside = 1e-6;  // of an edge
  std::map<HitEnd, int> met;
  for (int i = 0; i < 300; ++i) {
    Point now{random_request(random), 0, 0};
    const PulseProblem& problem = now.request.problem;
    const double k = peak_load(problem.pulse);
    now.f = random.pick(10) == 0 ? 0 : k * random.log_uniform(1e-3, 3);
    now.delta = scanned(now.request, problem.pulse, problem.p, std::min(now.f, k / 3)).need *
                random.uniform(0.3, 2);
    BOOST_TEST_CONTEXT(context_of(now)) {
      const auto list = shown_strengths(problem, now.f, now.delta);
      double reached = 0;
      for (const Hits& segment : list) {
        BOOST_TEST(segment.from == reached);
        reached = segment.to;
      }
      BOOST_TEST(reached == 2 * k);
      for (int point = 0; point < 20; ++point) {
        const double strength = random.uniform(0, 2 * k);
        const HitEnd end = end_at(list, strength);
        if (end_at(list, strength * (1 - beside)) != end ||
            end_at(list, std::min(2 * k, strength * (1 + beside))) != end) {
          continue;
        }
        ++met[end];
        BOOST_TEST(name(end) == name(end_by_motion(now, with_k(problem, strength))),
                   "k " << strength);
      }
    }
  }
  for (const HitEnd end :
       {HitEnd::held, HitEnd::off_centre, HitEnd::centred, HitEnd::passes, HitEnd::too_far}) {
    BOOST_TEST(met[end] > 100, name(end) << " " << met[end]);
  }
}

BOOST_AUTO_TEST_SUITE_END()
