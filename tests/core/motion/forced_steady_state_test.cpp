// SPDX-License-Identifier: MIT
#include "motion.hpp"

// Known settled motions under W = k sin(lambda tau): Den Hartog's without stops, cycles
// with two stops at resonance, growth at resonance.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(forced_steady_state_test)

struct Forcing {
  double p;
  double lambda;
  double k;
  double f;
  double zeta{0};
};

struct Settled {
  std::vector<State> turns;  ///< those of the last two periods
  bool stops;                ///< in the last two periods
};

Settled settled(const Forcing& forcing, double periods) {
  const double period = 2 * pi / forcing.lambda;
  const Oscillator oscillator{.p = forcing.p, .f = forcing.f, .zeta = forcing.zeta};
  const ForcedTrajectory path(oscillator, {0, 0.1}, Harmonic{forcing.k, forcing.lambda},
                              {periods * period});
  Settled result{{}, false};
  for (const Event& event : path.events()) {
    if (event.state.tau > (periods - 2) * period) {
      if (event.kind == EventKind::turn) {
        result.turns.push_back(event.state);
      }
      result.stops = result.stops || event.kind == EventKind::stick;
    }
  }
  return result;
}

/// Den Hartog's V and U.
double gain(const Forcing& forcing) {
  return 1 / (forcing.p * forcing.p - forcing.lambda * forcing.lambda);
}
double damping(const Forcing& forcing) {
  return std::tan(pi * forcing.p / (2 * forcing.lambda)) / (forcing.p * forcing.lambda);
}

/// The largest f / k without stops: |V| / sqrt(U^2 + S^2), S on a fine grid.
double largest_ratio_without_stops(const Forcing& forcing) {
  const auto [p, lambda, k, f, undamped] = forcing;
  const double tangent = std::tan(pi * p / (2 * lambda));
  double most = 0;
  for (int i = 1; i < 20000; ++i) {
    const double s = pi / lambda * i / 20000;
    most = std::max(most, (std::sin(p * s) + tangent * (std::cos(lambda * s) - std::cos(p * s))) /
                              (p * lambda * std::sin(lambda * s)));
  }
  most = std::max(most, 1 / (lambda * lambda));  // the limit s -> 0 or pi / lambda
  const double u = damping(forcing);
  return std::abs(gain(forcing)) / std::sqrt(u * u + most * most);
}

const std::vector<Forcing> grid{{1, 0.7, 0.3, 0.1},  {1, 0.6, 0.2, 0.05}, {1, 1.3, 0.3, 0.1},
                                {1, 1.9, 0.5, 0.1},  {2, 1.6, 0.4, 0.2},  {0.5, 0.8, 1, 0.3},
                                {3, 2.5, 0.1, 0.03}, {1, 0.9, 1, 0.6}};

BOOST_AUTO_TEST_CASE(without_stops_amplitude_and_phase_are_den_hartogs) {
  for (const Forcing& forcing : grid) {
    const auto [p, lambda, k, f, undamped] = forcing;
    BOOST_TEST_CONTEXT("p " << p << " lambda " << lambda << " k " << k << " f " << f) {
      BOOST_REQUIRE(f / k < largest_ratio_without_stops(forcing));
      const Settled motion = settled(forcing, 3000);
      BOOST_TEST(!motion.stops);
      BOOST_REQUIRE(motion.turns.size() >= 3U);
      const double kv = k * gain(forcing);
      const double fu = f * damping(forcing);
      const double amplitude = std::sqrt(kv * kv - fu * fu);
      for (const State& turn : motion.turns) {
        BOOST_TEST(std::abs(std::abs(turn.x) - amplitude) <= 1e-10 * amplitude);
        // At a maximum; half a period later at a minimum.
        const double theta = lambda * turn.tau;
        const double side = turn.x > 0 ? 1 : -1;
        BOOST_TEST(std::abs(std::cos(theta) - side * -fu / kv) <= 1e-10);
        BOOST_TEST(std::abs(std::sin(theta) - side * -amplitude / kv) <= 1e-10);
      }
    }
  }
}

/// With viscous damping, p = k = 1, without stops: docs/damping.md.
double damped_amplitude(const Forcing& forcing) {
  const double r = forcing.lambda;
  const double zeta = forcing.zeta;
  const double s = std::sqrt(1 - zeta * zeta);
  const double angle = pi * s / r;
  const double below = std::cosh(pi * zeta / r) + std::cos(angle);
  const double g = (std::sinh(pi * zeta / r) - zeta / s * std::sin(angle)) / below;
  const double h = std::sin(angle) / (r * s) / below;
  const double square = std::pow(1 - r * r, 2) + std::pow(2 * zeta * r, 2);
  return std::sqrt(1 / square - std::pow(h * forcing.f, 2)) - g * forcing.f;
}

BOOST_AUTO_TEST_CASE(with_damping_the_amplitude_is_den_hartogs_as_well) {
  struct Known {
    Forcing forcing;
    double amplitude{0};  ///< to nine decimals, by integration in small steps
  };
  for (const auto& [forcing, amplitude] :
       {Known{{1, 0.8, 1, 0.3, 0.05}, 2.346871967}, Known{{1, 1, 1, 0.4, 0.1}, 2.450073798},
        Known{{1, 1.5, 1, 0.2, 0.2}, 0.615054904}, Known{{1, 0.6, 1, 0.2, 0.05}, 1.503724845}}) {
    const double exact = damped_amplitude(forcing);
    BOOST_TEST(std::abs(exact - amplitude) <= 6e-10);
    const Settled motion = settled(forcing, 200);
    BOOST_TEST(!motion.stops);
    BOOST_REQUIRE(motion.turns.size() >= 3U);
    for (const State& turn : motion.turns) {
      BOOST_TEST(std::abs(std::abs(turn.x) - exact) <= 1e-12 * exact);
    }
  }
}

BOOST_AUTO_TEST_CASE(den_hartogs_bound_parts_motion_without_and_with_stops) {
  for (Forcing forcing : grid) {
    const double bound = largest_ratio_without_stops(forcing);
    BOOST_TEST_CONTEXT("p " << forcing.p << " lambda " << forcing.lambda << " bound " << bound) {
      forcing.f = forcing.k * bound * (1 - 1e-3);
      BOOST_TEST(!settled(forcing, 3000).stops);
      forcing.f = forcing.k * bound * (1 + 1e-3);
      BOOST_TEST(settled(forcing, 3000).stops);
    }
  }
}

BOOST_AUTO_TEST_CASE(at_resonance_strong_friction_ends_in_a_cycle_with_two_stops) {
  struct Known {
    double ratio;
    double amplitude;
  };
  for (const auto& [ratio, amplitude] :
       {Known{0.79, 0.4355}, Known{0.80, 0.2994}, Known{0.85, 0.0969}, Known{0.90, 0.0324}}) {
    const Settled motion = settled({1, 1, 0.2, 0.2 * ratio}, 2000);
    BOOST_TEST(motion.stops);
    BOOST_REQUIRE(motion.turns.size() == 4U);
    BOOST_TEST(std::abs(std::abs(motion.turns.back().x) / 0.2 - amplitude) <= 5e-5);
  }
}

BOOST_AUTO_TEST_CASE(at_resonance_each_half_cycle_adds_pi_k_over_2_less_2f) {
  const Settled motion = settled({1, 1, 0.2, 0.1}, 3000);
  BOOST_REQUIRE(motion.turns.size() >= 2U);
  const double grown = std::abs(motion.turns[1].x) - std::abs(motion.turns[0].x);
  BOOST_TEST(std::abs(grown - (pi * 0.1 - 0.2)) <= 1e-6);
}

BOOST_AUTO_TEST_CASE(at_the_best_phase_the_speed_follows_its_recursion) {
  // f = 0, phase -pi / 2, from x = 0 at speed u: u'^2 = (u + pi k / 2)^2 - 2 delta.
  const double k = 0.1;
  const double delta = 0.05;
  const ForcedTrajectory path({1, 0, delta}, {0, 1}, Harmonic{k, 1, -pi / 2}, {200});
  double speed = 1;
  int passages = 0;
  for (const Event& event : path.events()) {
    if (event.kind == EventKind::passage) {
      speed = std::sqrt(std::pow(speed + pi * k / 2, 2) - 2 * delta);
      ++passages;
      BOOST_TEST(std::abs(std::abs(event.state.v) - speed) <= 1e-12 * speed);
      BOOST_TEST(std::abs(event.state.tau - pi * passages) <= 1e-12 * event.state.tau);
    }
  }
  BOOST_TEST(passages == 63);
}

BOOST_AUTO_TEST_CASE(point_friction_alone_restrains_resonance_below_an_amplitude) {
  const ForcedOptions options{.t_end = 1000};
  const auto grows = forced_response({1, 0, 0.09}, {0, 1}, Harmonic{0.1, 1}, options);
  BOOST_TEST(grows.outcome == Outcome::running);
  BOOST_TEST(grows.peak_amplitude > 40);
  const auto caught = forced_response({1, 0, 0.1}, {0, 1}, Harmonic{0.1, 1}, options);
  BOOST_TEST(caught.outcome == Outcome::stopped_at_zero);
  BOOST_TEST(std::abs(*caught.stop_time - 83.25) <= 5e-3);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
