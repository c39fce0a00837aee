// SPDX-License-Identifier: MIT
#include "motion.hpp"

#include <thread>

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(cancellation_test)

/// Some seconds: 1e9 half-cycles.
Response long_motion() {
  FreeOptions options;
  options.half_cycle_limit = 1e10;
  return free_response({.p = 1, .f = 5e-10, .delta = 1e-13}, {.x0 = 0, .v0 = 1}, options);
}

BOOST_AUTO_TEST_CASE(a_long_free_motion_ends_when_it_is_no_longer_wanted) {
  int asked = 0;
  const Cancellable cancellable([&] { return ++asked < 3; });
  BOOST_CHECK_THROW(long_motion(), Cancelled);
  BOOST_TEST(asked == 3);
}

BOOST_AUTO_TEST_CASE(a_motion_that_is_still_wanted_is_the_same) {
  const Oscillator oscillator{.p = 1, .f = 1e-7, .delta = 1e-11};  // 4e6 half-cycles
  const Start start{.x0 = 0, .v0 = 1};
  const Response alone = free_response(oscillator, start);
  int asked = 0;
  const Cancellable cancellable([&] {
    ++asked;
    return true;
  });
  const Response watched = free_response(oscillator, start);
  BOOST_TEST(asked > 0);
  BOOST_TEST(*watched.half_cycles == *alone.half_cycles);
  BOOST_TEST(*watched.stop_time == *alone.stop_time);
  BOOST_TEST(*watched.decision_margin == *alone.decision_margin);
}

BOOST_AUTO_TEST_CASE(the_inner_one_and_the_outer_one_are_asked_while_they_live) {
  bool wanted = true;
  const Cancellable outer([&] { return wanted; });
  {
    const Cancellable inner([] { return false; });
    BOOST_CHECK_THROW(cancellation_point(), Cancelled);
  }
  BOOST_CHECK_NO_THROW(cancellation_point());
  wanted = false;
  const Cancellable inner([] { return true; });
  BOOST_CHECK_THROW(cancellation_point(), Cancelled);
}

BOOST_AUTO_TEST_CASE(only_its_own_thread_is_cancelled) {
  BOOST_CHECK_NO_THROW(cancellation_point());
  const Cancellable cancellable([] { return false; });
  bool reached = false;
  std::jthread([&] {
    cancellation_point();
    reached = true;
  }).join();
  BOOST_TEST(reached);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
