// SPDX-License-Identifier: MIT
#include "damper.hpp"
#include "pulse_task.hpp"

BOOST_AUTO_TEST_SUITE(pulse_reduction_test)

// The velocity that a short pulse leaves, compared with the motion under the pulse itself.

using namespace stillpoint::design_test;

// As p/lambda -> 0 the peak and the arrival become those of the velocity.
BOOST_AUTO_TEST_CASE(short_pulses_tend_to_the_reduction) {
  for (int kind = 0; kind < 6; ++kind) {
    const Pulse pulse = pulse_of(kind, 1, 1e4);
    if (std::holds_alternative<FullSine>(pulse)) {
      continue;  // leaves no velocity
    }
    const double v0 = equivalent_start(pulse, 0).value().speed;
    PulseRequest request = request_of(pulse, 0.9 * v0);
    const DesignResult result = design::design(request);
    const Region hit = admissible_region({v0, 1, 0.9 * v0, Criterion::exact});
    // f takes a part of the velocity, of the order of f over k.
    BOOST_TEST(result.region.f2 == hit.f2, tt::tolerance(1e-3));
    BOOST_TEST(result.region.f3 == hit.f3, tt::tolerance(1e-3));
    BOOST_TEST(result.region.beta_min == hit.beta_min, tt::tolerance(1e-3));
    const PulseCheck& check = result.finding.value().pulse.value();
    BOOST_TEST(std::abs(check.peak_error.value()) < 1e-6);
    BOOST_TEST(std::abs(check.stop_time_error.value()) < 1e-6);
    BOOST_TEST(check.warnings.empty());
  }
}

// docs/forced.md section 8: from above, by these parts of (p / lambda)^2.
BOOST_AUTO_TEST_CASE(the_reduction_errs_to_the_safe_side_by_less_than_its_bound) {
  struct Bounds {
    int kind;  // as pulse_of
    double least;
    double most;
  };
  constexpr std::array<Bounds, 5> bounds{
      {{0, 0.21, 0.31}, {1, 0.36, 0.55}, {3, 0.15, 0.36}, {4, 0.3, 0.45}, {5, 0.14, 0.22}}};
  for (const double shortness : {1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01}) {
    for (const double part : {0.05, 0.3, 0.5, 0.7, 0.9, 0.97}) {
      for (const auto& [kind, least, most] : bounds) {
        const Pulse pulse = pulse_of(kind, 0.5, 1 / shortness);
        const auto v0_at = [&](double f) { return equivalent_start(pulse, f).value().speed; };
        double f = 0;
        for (int i = 0; i < 200; ++i) {  // f = part of the largest, f3(V(f))
          f += 0.5 * (v0_at(f) / std::sqrt(8.0) - f);
        }
        f *= part;
        const double v0 = v0_at(f);
        const double peak = simulated({pulse, 1, 1, Criterion::exact}, f, 1e200).peak_amplitude;
        const double error = v0 * v0 / (std::hypot(f, v0) + f) / peak - 1;
        // Taken relative to the reduced figure, so that it stays below 1 at p / lambda = 1.
        const double relative = error / (1 + error) / (shortness * shortness);
        BOOST_TEST_CONTEXT(name(pulse) << " p/lambda " << shortness << " part " << part) {
          BOOST_TEST(relative > least);
          BOOST_TEST(relative < most);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(what_makes_the_reduction_poor_is_named) {
  const auto warnings = [](const Pulse& pulse, double beta, Objective objective) {
    return design::design(request_of(pulse, beta, objective))
        .finding.value()
        .pulse.value()
        .warnings;
  };
  using enum PulseWarning;
  BOOST_TEST((warnings(HalfSine{0.5, 20}, 0.05, Objective::time).empty()));
  BOOST_TEST((warnings(HalfSine{0.5, 4}, 0.22, Objective::time) ==
              std::vector<PulseWarning>{pulse_not_short}));
  BOOST_TEST((warnings(Rectangle{0.5, 3}, 0.6, Objective::amplitude) ==
              std::vector<PulseWarning>{pulse_not_short, friction_not_small}));
}

BOOST_AUTO_TEST_SUITE_END()
