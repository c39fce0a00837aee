// SPDX-License-Identifier: MIT
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(physical_test)

using namespace stillpoint::design_test;

/// Relative, of scales and of what is computed from them: a few roundings.
constexpr double scale_tolerance = 2e-15;

void check_close(double value, double expected, double tolerance = scale_tolerance) {
  BOOST_TEST(std::abs(value - expected) <= tolerance * std::abs(expected),
             value << " instead of " << expected);
}

PhysicalIsolator with_period(double period) {
  PhysicalIsolator isolator;
  isolator.period_s = period;
  return isolator;
}

PhysicalIsolator with_stiffness(double stiffness, double mass) {
  PhysicalIsolator isolator;
  isolator.stiffness_n_per_m = stiffness;
  isolator.mass_kg = mass;
  return isolator;
}

void check_refused(const char* field, const PhysicalIsolator& isolator, double velocity) {
  test::check_refused(field, [&] { return physical_scales(isolator, velocity); });
}

BOOST_AUTO_TEST_CASE(forces_and_energies_need_a_mass) {
  const Scales scales = physical_scales(with_period(3), 0.4);
  BOOST_TEST(!scales.mass_kg);
  BOOST_TEST(!scales.stiffness_n_per_m());
  BOOST_TEST(!scales.friction_force_n(0.1));
  BOOST_TEST(!scales.energy_per_passage_j(0.1));
  BOOST_TEST(scales.delta_m(0.1) > 0);
}

BOOST_AUTO_TEST_CASE(the_scales_satisfy_their_definitions) {
  RandomSource random(1201);
  for (int i = 0; i < 1000; ++i) {
    const double period = random.log_uniform(1e-3, 1e3);
    PhysicalIsolator isolator = with_period(period);
    isolator.gravity_m_per_s2 = random.log_uniform(1, 30);
    isolator.mass_kg = random.log_uniform(1e-3, 1e6);
    const double velocity = random.log_uniform(1e-3, 10);
    const Scales scales = physical_scales(isolator, velocity);
    PhysicalIsolator of_spring =
        with_stiffness(scales.stiffness_n_per_m().value(), *isolator.mass_kg);
    of_spring.gravity_m_per_s2 = isolator.gravity_m_per_s2;
    check_close(physical_scales(of_spring, velocity).omega_rad_per_s, scales.omega_rad_per_s);
    check_close(physical_scales(of_spring, velocity).p, scales.p);
    const double g = isolator.gravity_m_per_s2;
    BOOST_TEST(scales.gravity_m_per_s2 == g);
    check_close(scales.omega_rad_per_s * period, 2 * std::numbers::pi);
    check_close(scales.omega_rad_per_s * scales.omega_rad_per_s,
                g * scales.p * scales.p / scales.length_m);
    check_close(scales.length_m / scales.time_s, scales.velocity_m_per_s);
    check_close(scales.length_m / scales.time_s / scales.time_s, g);
    // H = V/omega makes V0 and p one number.
    check_close(velocity / scales.velocity_m_per_s, scales.p);
    check_close(scales.delta_m(0.3), 0.3 * scales.length_m);
    // The energy of a passage is that of the speed sqrt(2 g delta_m), the force that of m f g.
    check_close(*scales.energy_per_passage_j(0.3), *isolator.mass_kg * g * scales.delta_m(0.3));
    check_close(*scales.friction_force_n(0.3), *isolator.mass_kg * 0.3 * g);
  }
}

/// What is served in metres and seconds is served when it is converted back, and what mends mends.
BOOST_AUTO_TEST_CASE(served_intervals_are_rounded_inwards_and_mends_outwards) {
  RandomSource random(1204);
  for (int i = 0; i < 1000; ++i) {
    const Scales scales =
        physical_scales(with_period(random.log_uniform(0.1, 10)), random.log_uniform(0.1, 1));
    const double v0 = random.log_uniform(0.1, 10);
    const double p = random.log_uniform(0.1, 10);
    const WorksFor served{{v0, v0 * 1.5}, {p, p * 1.5}};
    const auto [velocity, period] = physical_works_for(scales, served);
    BOOST_TEST(velocity.low / scales.velocity_m_per_s >= served.hit.low);
    BOOST_TEST(*velocity.high / scales.velocity_m_per_s <= *served.hit.high);
    const double turn = 2 * std::numbers::pi * scales.time_s;
    BOOST_TEST(turn / *period.high >= served.p.low);
    BOOST_TEST(turn / period.low <= *served.p.high);
    check_close(turn / *period.high, served.p.low, 1e-13);
    check_close(turn / period.low, *served.p.high, 1e-13);
    for (const bool up : {true, false}) {
      const auto mend = physical_mend({.scales = scales}, {"v0", v0, up}, std::nullopt).value();
      const double back = mend.value / scales.velocity_m_per_s;
      BOOST_TEST((up ? back >= v0 : back <= v0));
      check_close(back, v0, 1e-13);
    }
  }
}

BOOST_AUTO_TEST_CASE(wrong_physical_input_is_refused_with_the_name_of_its_field) {
  for (const double wrong : {0.0, -1.0, 1e-31, 1e31, std::nan(""), double(HUGE_VAL)}) {
    check_refused("period", with_period(wrong), 0.4);
    check_refused("stiffness", with_stiffness(wrong, 1), 0.4);
    check_refused("mass", with_stiffness(1, wrong), 0.4);
    check_refused("velocity", with_period(3), wrong);
    PhysicalIsolator floating = with_period(3);
    floating.gravity_m_per_s2 = wrong;
    check_refused("gravity", floating, 0.4);
    PhysicalIsolator weightless = with_period(3);
    weightless.mass_kg = wrong;
    check_refused("mass", weightless, 0.4);
  }
  check_refused("period", PhysicalIsolator{}, 0.4);
  PhysicalIsolator both = with_stiffness(1, 1);
  both.period_s = 3;
  check_refused("stiffness", both, 0.4);
  PhysicalIsolator also_in_hertz = with_period(3);
  also_in_hertz.natural_frequency_hz = 1.0 / 3;
  check_refused("natural-frequency", also_in_hertz, 0.4);
  PhysicalIsolator massless;
  massless.stiffness_n_per_m = 1;
  check_refused("mass", massless, 0.4);
}

BOOST_AUTO_TEST_SUITE_END()
