// SPDX-License-Identifier: MIT
#include "motion.hpp"

// What the paper says about resonance, lambda = p = 1, over grids: where it holds and where it
// fails. docs/resonance.md states the results, each with its test.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(forced_resonance_test)

struct Resonance {
  double f;
  double delta;
  double v0;
  double k;
  double phase;
};

ForcedResponse run(const Resonance& scene, double half_cycles) {
  return forced_response({1, scene.f, scene.delta}, {0, scene.v0},
                         Harmonic{scene.k, 1, scene.phase}, {.t_end = half_cycles * pi});
}

bool caught(const Resonance& scene) {
  return run(scene, 400).outcome == Outcome::stopped_at_zero;
}

double size(const ForcedResponse& response) {
  return std::hypot(*response.final_position, *response.final_velocity);
}

/// The f up to which 20 half-cycles at the best phase end larger than they began.
double growth_threshold(double delta, double v0, double k) {
  double low = 0;
  double high = k;
  while (high - low > 1e-9) {
    const double f = low + (high - low) / 2;
    const ForcedResponse response = run({f, delta, v0, k, -pi / 2}, 20.5);
    const bool grows = response.outcome == Outcome::running && size(response) > v0;
    (grows ? low : high) = f;
  }
  return low;
}

BOOST_AUTO_TEST_CASE(point_friction_alone_does_restrain_resonance_for_many_starts) {
  int starts = 0;
  int stopped = 0;
  for (const double k : {0.05, 0.1, 0.2}) {
    for (int eighth = 0; eighth < 8; ++eighth) {
      for (const double v0 : {0.3, 1.0, 3.0}) {
        for (const double part : {0.1, 0.3, 0.5, 0.7, 0.9, 0.99}) {
          // Delta lets the motion start: 2 delta = part * v0^2
          ++starts;
          stopped += caught({0, part * v0 * v0 / 2, v0, k, eighth * pi / 4}) ? 1 : 0;
        }
      }
    }
  }
  BOOST_TEST(starts == 432);
  BOOST_TEST(stopped > 300);
  BOOST_TEST(stopped < 340);
}

BOOST_AUTO_TEST_CASE(at_the_best_phase_growth_parts_where_the_recursion_says) {
  // u grows where u > 2 delta / (pi k) - pi k / 4.
  const double k = 0.1;
  for (const double u : {0.5, 1.0, 2.0}) {
    const double delta = (u + pi * k / 4) * pi * k / 2;
    BOOST_TEST(!caught({0, delta * (1 - 1e-6), u, k, -pi / 2}));
    BOOST_TEST(caught({0, delta * (1 + 1e-6), u, k, -pi / 2}));
  }
}

BOOST_AUTO_TEST_CASE(what_survives_point_friction_grows_at_half_k) {
  for (const double delta : {0.02, 0.05, 0.09}) {
    const double early = run({0, delta, 1, 0.1, 0}, 2000).peak_amplitude;
    const double late = run({0, delta, 1, 0.1, 0}, 4000).peak_amplitude;
    BOOST_TEST((late - early) / (2000 * pi) == 0.05, tt::tolerance(2e-3));
  }
}

BOOST_AUTO_TEST_CASE(constant_friction_alone_has_the_threshold_pi_k_over_4) {
  for (const double k : {0.1, 0.5}) {
    for (const double phase : {0.0, 1.0, -2.0}) {
      const auto growth = [&](double ratio) {
        const Resonance scene{ratio * k, 0, 1, k, phase};
        return size(run(scene, 4000)) - size(run(scene, 2000));
      };
      BOOST_TEST(growth(pi / 4 * (1 - 1e-3)) > 0);
      BOOST_TEST(growth(pi / 4 * (1 + 1e-3)) <= 1e-9);
    }
  }
}

BOOST_AUTO_TEST_CASE(above_the_threshold_the_motion_has_stops) {
  for (const double ratio : {0.79, 0.85, 0.95}) {
    const ForcedResponse early = run({ratio * 0.2, 0, 1, 0.2, 0}, 2000);
    const ForcedResponse late = run({ratio * 0.2, 0, 1, 0.2, 0}, 2200);
    BOOST_TEST(late.sticks - early.sticks == 200);
  }
}

BOOST_AUTO_TEST_CASE(friction_of_k_and_more_ends_at_rest_or_creeps_towards_it) {
  // |x| <= f - k is never left. From outside, each period's slips carry the mass a little closer,
  // by less the closer it is: it gets there only in the limit, unless a swing ends inside.
  int inside = 0;
  for (const double ratio : {1.0, 1.05, 1.2, 1.5, 2.0}) {
    for (const double v0 : {0.5, 1.0, 1.5}) {
      const double zone = (ratio - 1) * 0.2;
      const ForcedResponse early = run({ratio * 0.2, 0, v0, 0.2, 0}, 400);
      const ForcedResponse late = run({ratio * 0.2, 0, v0, 0.2, 0}, 4000);
      const double before = std::abs(*early.final_position) - zone;
      const double after = std::abs(*late.final_position) - zone;
      if (late.outcome == Outcome::stopped_in_dead_zone) {
        BOOST_TEST(after <= 1e-16);
        ++inside;
      } else {
        BOOST_TEST(after > 0);
        BOOST_TEST(after < before / 4);
        BOOST_TEST(after < 1e-3);
      }
    }
  }
  BOOST_TEST(inside > 0);
  BOOST_TEST(inside < 15);
}

BOOST_AUTO_TEST_CASE(point_friction_lowers_the_threshold_of_f_only_for_the_amplitude_at_hand) {
  // pi k / 4 - delta / (2 a): the larger the amplitude, the less
  const double k = 0.2;
  for (const double delta : {0.0, 0.02, 0.1}) {
    for (const double a : {5.0, 20.0}) {
      const double expected = pi * k / 4 - delta / (2 * a);
      BOOST_TEST(growth_threshold(delta, a, k) == expected, tt::tolerance(3e-3));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_period_tends_to_that_of_the_forcing_but_does_not_begin_with_it) {
  const ForcedTrajectory path({1, 0, 0}, {0, 1}, Harmonic{0.1, 1}, {2000});
  std::vector<double> passages;
  for (const Event& event : path.events()) {
    if (event.kind == EventKind::passage) {
      passages.push_back(event.state.tau);
    }
  }
  BOOST_REQUIRE(passages.size() > 600U);
  BOOST_TEST(passages[0] / pi == 0.95, tt::tolerance(0.01));
  const double last = passages.back() - passages[passages.size() - 2];
  BOOST_TEST(last / pi == 1, tt::tolerance(1e-5));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
