// SPDX-License-Identifier: MIT
#include "motion.hpp"

BOOST_AUTO_TEST_SUITE(forced_start_test)

// Rests at the start of a run, and their outcome at the end of the excitation.

namespace {

using namespace stillpoint;
using test::until;

constexpr double time_tolerance = 1e-13;

}  // namespace

BOOST_AUTO_TEST_CASE(a_mass_on_the_edge_of_sticking_at_the_crest_of_the_load_waits) {
  // |W + x| = k - |x0| = f to the last bit at tau = 0, where W is largest: it is released by the
  // next trough, not at once and again and again.
  const ForcedResponse held = until(10, {1, 0.045, 0}, {-0.0099999999999999985, 0},
                                    Harmonic{0.055, 1, std::numbers::pi / 2});
  BOOST_TEST(held.end_time.value() == 10);
  BOOST_TEST(held.sticks >= 1);
}

BOOST_AUTO_TEST_CASE(without_excitation_a_run_from_rest_counts_as_the_free_one) {
  const Oscillator oscillator{1, 0.00977, 0.0422};
  const Start start{-0.0297, 0};
  const Response free = free_response(oscillator, start);
  const ForcedResponse forced = forced_response(oscillator, start, NoExcitation{});
  BOOST_TEST(forced.half_cycles.value() == free.half_cycles.value());
  BOOST_TEST(forced.stop_time.value() == free.stop_time.value(), tt::tolerance(time_tolerance));
}

BOOST_AUTO_TEST_CASE(a_stick_that_the_end_of_the_excitation_ends_is_counted) {
  // W = -1 holds x = 1 (no load at all) for pi; then it swings back freely, f = 0.21: peaks 0.58,
  // 0.16 of 1, and rests there.
  const Excitation excitation = Rectangle{-1, 1};
  const ForcedResponse to_the_end = forced_response({1, 0.21, 0}, {1, 0}, excitation);
  const ForcedResponse in_time = until(50, {1, 0.21, 0}, {1, 0}, excitation);
  BOOST_TEST(to_the_end.sticks == 1);
  BOOST_TEST(to_the_end.stick_time == std::numbers::pi, tt::tolerance(time_tolerance));
  BOOST_TEST(to_the_end.half_cycles.value() == 3);
  BOOST_TEST(in_time.sticks == to_the_end.sticks);
  BOOST_TEST(in_time.half_cycles.value() == to_the_end.half_cycles.value());
}

BOOST_AUTO_TEST_CASE(before_a_record_of_one_sample_the_motion_is_free) {
  Record record;
  record.values = {-0.2};
  record.times = {0.36};
  const ForcedResponse before = until(0.1, {1, 0.1, 0}, {0, 1}, record);
  const ForcedResponse free = until(0.1, {1, 0.1, 0}, {0, 1}, NoExcitation{});
  BOOST_TEST(before.end_time.value() == 0.1);
  BOOST_TEST(before.final_position.value() == free.final_position.value());
}

BOOST_AUTO_TEST_SUITE_END()
