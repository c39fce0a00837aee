// SPDX-License-Identifier: MIT
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(hits_test)

using namespace stillpoint::design_test;

/// Of an edge, relative: this far inside it the motion itself ends as the segment says. A few
/// hundred half-cycles, each accurate to 2e-16.
constexpr double beside = 1e-12;
/// Of a rest, relative to f/p^2: near an edge of the dead zone it moves as the radius does.
constexpr double rest_tolerance = 1e-9;

struct Case {
  Oscillator oscillator;
  double beta;
  double most;
  double residual{0};
};

Case random_case(RandomSource& random) {
  const double p = random.log_uniform(1e-3, 1e3);
  const double v0 = random.log_uniform(1e-3, 1e3);
  Case now{{p, random.log_uniform(3e-3, 2) * v0 * p, random.log_uniform(1e-3, 2) * v0 * v0},
           random.log_uniform(0.2, 3) * v0 / p,
           2 * v0};
  if (const int kind = random.pick(6); kind == 0) {
    now.oscillator.f = 0;
  } else if (kind == 1) {
    now.oscillator.delta = 0;
  }
  if (random.pick(3) == 0) {
    const double dead_zone = now.oscillator.f / p / p;
    now.residual = random.uniform(0, 1.2) * dead_zone;
  }
  return now;
}

void check_motion(const Case& now, const Hits& hit, double v0) {
  const Response motion = free_response(now.oscillator, {0, v0});
  BOOST_TEST_CONTEXT("v0 " << v0 << ", " << name(hit.end) << " from " << hit.from << " to "
                           << hit.to) {
    BOOST_TEST((motion.peak_amplitude > now.beta) == (hit.end == HitEnd::too_far));
    if (hit.end == HitEnd::too_far) {
      return;
    }
    BOOST_TEST((motion.outcome == Outcome::caught_at_start) == (hit.end == HitEnd::held));
    if (hit.end == HitEnd::centred) {
      BOOST_TEST(motion.stops_at_zero);
      BOOST_TEST(*motion.zero_passages + 1 == *hit.arrivals);
    } else if (hit.end == HitEnd::off_centre || hit.end == HitEnd::within_residual) {
      BOOST_TEST(!motion.stops_at_zero);
      BOOST_TEST(*motion.zero_passages == *hit.arrivals);
      BOOST_TEST(std::signbit(*motion.stop_position) == std::signbit(*hit.rest));
      const double dead_zone = now.oscillator.f / now.oscillator.p / now.oscillator.p;
      const double rest = std::abs(*motion.stop_position);
      BOOST_TEST(rest <= std::abs(*hit.rest) + rest_tolerance * dead_zone);
      const bool within = hit.end == HitEnd::within_residual;
      BOOST_TEST((within ? rest - now.residual : now.residual - rest) <=
                 rest_tolerance * dead_zone);
    } else if (hit.end == HitEnd::alternating) {
      BOOST_TEST(*motion.zero_passages >= *hit.arrivals - 1);
    }
  }
}

/// For the same hit with another spring.
int severity(HitEnd end) {
  return end == HitEnd::centred           ? 0
         : end == HitEnd::within_residual ? 1
         : end == HitEnd::alternating     ? 2
         : end == HitEnd::off_centre      ? 3
                                          : 4;
}

BOOST_AUTO_TEST_CASE(every_motion_ends_as_its_segment_says_up_to_both_edges) {
  RandomSource random(2401);
  std::array<int, 8> seen{};
  for (int i = 0; i < 1500; ++i) {
    const Case now = random_case(random);
    const std::vector<Hits> list = hits(now.oscillator, now.beta, now.most, now.residual);
    BOOST_TEST(list.size() <= static_cast<std::size_t>(most_hit_segments) + 5);
    double reached = 0;
    for (const Hits& hit : list) {
      BOOST_TEST(hit.from == reached);
      BOOST_TEST(hit.to > reached);
      reached = hit.to;
      const double inset = beside * hit.to;
      if (hit.to - hit.from < 4 * inset) {
        continue;
      }
      ++seen.at(static_cast<std::size_t>(hit.end));
      check_motion(now, hit, std::max(hit.from + inset, 1e-9 * hit.to));
      check_motion(now, hit, hit.to - inset);
      check_motion(now, hit, random.uniform(hit.from + inset, hit.to - inset));
    }
    BOOST_TEST(reached == now.most);
  }
  for (const HitEnd end : {HitEnd::held, HitEnd::centred, HitEnd::within_residual,
                           HitEnd::off_centre, HitEnd::too_far}) {
    BOOST_TEST(seen.at(static_cast<std::size_t>(end)) > 500, name(end));
  }
  BOOST_TEST(seen.at(static_cast<std::size_t>(HitEnd::alternating)) > 5);
}

BOOST_AUTO_TEST_CASE(the_farthest_rest_is_reached) {
  // f = 0.5, p = 1, Delta = 0.02: no passage up to V0 = sqrt(8)/2, rests at the peak
  // sqrt(V0^2 + 1/4) - 1/2 up to 1/2 at V0 = sqrt(3)/2.
  const Oscillator oscillator{1, 0.5, 0.02};
  const auto rest = [&](double most) {
    const auto list = hits(oscillator, 9, most);
    return list.back().rest.value_or(0);
  };
  BOOST_TEST(std::abs(rest(0.5) - (std::sqrt(0.5) - 0.5)) < 1e-15);
  BOOST_TEST(std::abs(rest(1.2) - 0.5) < 1e-15);
  // A start beyond that: Delta = 0.5 holds up to 1, then it rests at 3 f - sqrt(1 + f^2).
  const auto beyond = hits({1, 0.5, 0.5}, 9, 1.2);
  BOOST_TEST(beyond.size() == 2U);
  BOOST_TEST(std::abs(*beyond.back().rest - (1.5 - std::sqrt(1.25))) < 1e-15);
}

BOOST_AUTO_TEST_CASE(without_friction_it_never_stops) {
  const auto frictionless = hits({2, 0, 0}, 1, 3);
  BOOST_TEST_REQUIRE(frictionless.size() == 2U);
  BOOST_TEST((frictionless[0].end == HitEnd::never_stops));
  BOOST_TEST(frictionless[0].to == 2);
}

BOOST_AUTO_TEST_CASE(many_segments_become_one) {
  const auto list = hits({1, 1e-6, 1e-6}, 1, 2);
  BOOST_TEST_REQUIRE(list.size() == static_cast<std::size_t>(most_hit_segments) + 2);
  const Hits& rest = list[list.size() - 2];
  BOOST_TEST((rest.end == HitEnd::alternating));
  BOOST_TEST((list.back().end == HitEnd::too_far));
  BOOST_TEST(rest.from == list[list.size() - 3].to);
}

BOOST_AUTO_TEST_CASE(the_worst_of_a_range_of_springs_is_that_of_some_spring) {
  const auto end_at = [](const std::vector<Hits>& list, double v0) {
    return *std::ranges::find_if(list, [v0](const Hits& now) { return v0 < now.to; });
  };
  RandomSource random(2404);
  constexpr int springs = 50;
  int mixed = 0;
  int near = 0;
  int missed = 0;
  for (int i = 0; i < 200; ++i) {
    Problem problem = random_feasible_problem(random);
    problem.p_high = problem.p * random.uniform(1.01, 1.3);
    const double f = admissible_region(problem).f3 * random.uniform(0.1, 1);
    if (random.pick(2) == 0) {
      problem.residual = f / problem.p / problem.p * random.uniform(0.1, 1.1);
    }
    const double delta = problem.v0 * problem.v0 / 2 * random.uniform(0, 1);
    for (const Hits& now : shown_hits(problem, f, delta)) {
      const double edge = random.log_uniform(1e-9, 0.5);  // as a part of the segment, of either
      const double v0 = std::lerp(now.from, now.to, random.pick(2) == 0 ? edge : 1 - edge);
      const auto worse = [](HitEnd one, HitEnd other) { return severity(one) > severity(other); };
      int like_it = 0;
      for (int k = 0; k <= springs; ++k) {
        Problem one = problem;
        one.p += (*problem.p_high - problem.p) * k / springs;
        const Hits its = end_at(shown_hits(one, f, delta), v0);
        like_it += its.end == now.end ? 1 : 0;
        BOOST_TEST(!worse(its.end, now.end));
      }
      BOOST_TEST((like_it == springs + 1 || !now.every_spring));
      mixed += now.every_spring ? 0 : 1;
      near += now.end == HitEnd::within_residual ? 1 : 0;
      missed += like_it == 0 ? 1 : 0;  // few springs end so
    }
  }
  BOOST_TEST(mixed > 100);
  BOOST_TEST(near > 100);
  BOOST_TEST(missed < mixed / 20);
}

BOOST_AUTO_TEST_CASE(wrong_input_is_refused) {
  BOOST_CHECK_THROW((void)hits({1, -1, 0}, 1, 1), InputError);
  BOOST_CHECK_THROW((void)hits({1, 1, 1}, 0, 1), InputError);
  BOOST_CHECK_THROW((void)hits({1, 1, 1}, 1, 0), InputError);
  BOOST_CHECK_THROW((void)hits({1, 1, 1}, 1, 1, -1), InputError);
}

BOOST_AUTO_TEST_SUITE_END()
