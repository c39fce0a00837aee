// SPDX-License-Identifier: MIT
#include "motion.hpp"

// The ends of a motion with f and Delta 1 % off, where they are known by hand.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(nearby_ends_test)

NearbyEnds ends_of(const SimulationRequest& request) {
  return nearby_ends(request, simulate(request)).value();
}

/// Each half-cycle takes 2 f from the distance: from x = 1 it rests at 1 - 4 f.
BOOST_AUTO_TEST_CASE(a_rest_moves_with_the_friction_of_its_zone) {
  SimulationRequest request = simulation_of({1, 0.1, 0}, {1, 0});
  request.surface.zones = {{2, 0.3}};
  const NearbyEnds ends = ends_of(request);
  near("low", ends.rests.value().low, 1 - 4 * 0.303, 1e-12);
  near("high", ends.rests.value().high, 1 - 4 * 0.297, 1e-12);
  BOOST_TEST(!ends.rest_differs);
  BOOST_TEST(!ends.lock_differs);
}

/// The load of 0.1005 moves what friction of 0.1 holds, but not what 0.101 does.
BOOST_AUTO_TEST_CASE(a_load_close_to_friction_may_move_the_mass_or_not) {
  const NearbyEnds ends = ends_of(simulation_of({1, 0.1, 0}, {}, Rectangle{0.1005, 1}, 1));
  BOOST_TEST(ends.rest_differs);
  BOOST_TEST(!ends.rests.has_value());
}

/// From x = 1 it comes to x = 0 with the energy 1/2 - f = 0.4, about that of the notch. What
/// passes, with 0.001 or 0.003, rests at up to -0.03 in the dead zone.
BOOST_AUTO_TEST_CASE(a_notch_close_to_the_energy_that_arrives_may_lock_or_not) {
  const NearbyEnds ends = ends_of(simulation_of({1, 0.1, 0.402}, {1, 0}, Harmonic{1e-6, 1}, 10));
  BOOST_TEST(ends.lock_differs);
  BOOST_TEST(!ends.rest_differs);
  BOOST_TEST(ends.rests.value().low < -0.009);
  BOOST_TEST(ends.rests.value().low > -0.031);
  BOOST_TEST(ends.rests.value().high == 0);
}

BOOST_AUTO_TEST_CASE(a_motion_too_long_to_follow_has_none) {
  SimulationRequest request = simulation_of({1, 0.1, 0}, {}, Harmonic{0.5, 1}, 1e9);
  BOOST_TEST(!nearby_ends(request, {}).has_value());
  request.excitation = {};
  request.oscillator.f = 1e-9;
  request.start = {1, 0};
  request.surface.zones = {{0.5, 2e-9}};
  BOOST_TEST(!nearby_ends(request, {}).has_value());
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
