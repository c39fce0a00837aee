// SPDX-License-Identifier: MIT
#include "motion.hpp"

#include <atomic>

#include <sys/resource.h>
#include <unistd.h>

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(batch_test)

template <class Action>
bool too_many_half_cycles(const Action& action) {
  try {
    action();
  } catch (const TooManyHalfCycles&) {
    return true;
  }
  return false;
}

BOOST_AUTO_TEST_CASE(an_error_names_the_first_entry_at_fault) {
  // Whatever the number of threads: blocks of some thousand entries are run at once.
  Eigen::ArrayXd f = Eigen::ArrayXd::Constant(40000, 0.1);
  Eigen::ArrayXd delta = Eigen::ArrayXd::Constant(40000, 0.01);
  f[39999] = -1;
  delta[20011] = std::numeric_limits<double>::quiet_NaN();
  f[20017] = -1;
  for (const int threads : {1, 2, 7}) {
    const auto run = [&] { static_cast<void>(free_batch(1, 1, f, delta, {.threads = threads})); };
    BOOST_TEST(refusal_of<InputError>(run) ==
               "delta[20011] = nan: must be a number from 0 to 1e+300");
  }
}

#ifndef __SANITIZE_ADDRESS__  // which reserves terabytes

/// A precondition: an emulator takes a limit and ignores it.
tt::assertion_result if_memory_can_be_limited(boost::unit_test::test_unit_id /*unit*/) {
  rlimit before{};
  rlimit now{};
  getrlimit(RLIMIT_AS, &before);
  const rlimit wanted{rlim_t{1} << 40U, before.rlim_max};
  setrlimit(RLIMIT_AS, &wanted);
  getrlimit(RLIMIT_AS, &now);
  setrlimit(RLIMIT_AS, &before);
  return now.rlim_cur == wanted.rlim_cur;
}

// Each thread reserves 8 MB for its stack, as `ulimit -v` or a container may not allow.
BOOST_AUTO_TEST_CASE(threads_that_cannot_start_are_an_error_of_their_number,
                     *boost::unit_test::precondition(if_memory_can_be_limited)) {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  rlimit whole{};
  getrlimit(RLIMIT_AS, &whole);
  rlimit little = whole;
  little.rlim_cur = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (rlim_t{16} << 20U);
  setrlimit(RLIMIT_AS, &little);
  const std::string said =
      refusal_of<InputError>([] { for_each_entry(1000, 100, {}, [](std::ptrdiff_t) {}); });
  setrlimit(RLIMIT_AS, &whole);
  BOOST_TEST(said ==
             "threads = 100: cannot be started (Resource temporarily unavailable): give fewer");
}
#endif

BOOST_AUTO_TEST_CASE(a_value_for_all_is_named_without_an_entry) {
  const Eigen::ArrayXd one = Eigen::ArrayXd::Constant(1, 0.1);
  BOOST_TEST(refusal_of<InputError>([&] { static_cast<void>(free_batch(1, -1, one, one)); }) ==
             "p = -1: must be a number from 1e-150 to 1e+150");
  BOOST_TEST(refusal_of<InputError>([&] {
               static_cast<void>(free_batch(one, one - 1.1, one, one));
             }) == "p[0] = -1: must be a number from 1e-150 to 1e+150");
}

BOOST_AUTO_TEST_CASE(too_many_half_cycles_name_their_entry) {
  Eigen::ArrayXd f = Eigen::ArrayXd::Constant(100, 0.1);
  Eigen::ArrayXd delta = Eigen::ArrayXd::Constant(100, 0.01);
  f[77] = 1e-9;
  delta[77] = 1e-9;
  const std::string message = refusal_of<TooManyHalfCycles>(
      [&] { static_cast<void>(free_batch(1, 1, f, delta, {.half_cycle_limit = 1000})); });
  BOOST_TEST(message.starts_with("entry 77: f and delta are so small"), message);
  // By (16) at most 1 / (2 * 0.02) = 25 half-cycles. 64 entries leave no lane empty.
  f = Eigen::ArrayXd::Constant(64, 0.0002);
  delta = Eigen::ArrayXd::Constant(64, 0.02);
  static_cast<void>(free_batch(1, 1, f, delta, {.half_cycle_limit = 25}));
  BOOST_CHECK_THROW(static_cast<void>(free_batch(1, 1, f, delta, {.half_cycle_limit = 24.9})),
                    TooManyHalfCycles);
}

BOOST_AUTO_TEST_CASE(the_limit_of_half_cycles_is_that_of_one_entry_to_the_last_bit) {
  // v0^2 / (2 delta) and the limit differ by rounding at most; f allows far more.
  Dice dice(1);
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    const double limit = dice.uniform(8, 16);
    const double v0 = dice.uniform(1, 2);
    const double delta = v0 * v0 / limit / 2;
    const auto alone = [&] {
      static_cast<void>(free_response({1, 1e-6, delta}, {0, v0}, {.half_cycle_limit = limit}));
    };
    const Eigen::ArrayXd all_f = Eigen::ArrayXd::Constant(64, 1e-6);
    const Eigen::ArrayXd all_delta = Eigen::ArrayXd::Constant(64, delta);
    const auto in_lanes = [&] {
      static_cast<void>(free_batch(v0, 1, all_f, all_delta, {.half_cycle_limit = limit}));
    };
    const bool refuses = too_many_half_cycles(alone);
    refused += refuses ? 1 : 0;
    BOOST_TEST(too_many_half_cycles(in_lanes) == refuses, "v0 = " << v0 << ", limit " << limit);
  }
  BOOST_TEST(refused > 100);
  BOOST_TEST(refused < 1900);
}

// 1e10 half-cycles each, in lanes and, with the largest v0, alone.
BOOST_AUTO_TEST_CASE(slow_motions_end_when_they_are_no_longer_wanted) {
  for (const double v0 : {1.0, 0x1p65}) {
    for (const int threads : {1, 2}) {
      std::atomic<int> asked = 0;
      const BatchOptions options{
          .half_cycle_limit = 1e11, .threads = threads, .go_on = [&asked] { return ++asked < 6; }};
      const Eigen::ArrayXd f = Eigen::ArrayXd::Constant(10'000, 5e-11 * v0);
      const Eigen::ArrayXd delta = Eigen::ArrayXd::Constant(10'000, 1e-13 * v0 * v0);
      BOOST_CHECK_THROW(static_cast<void>(free_batch(v0, 1, f, delta, options)), Cancelled);
      BOOST_TEST(asked >= 6);
    }
  }
}

BOOST_AUTO_TEST_CASE(motions_that_are_still_wanted_are_the_same) {
  std::atomic<int> asked = 0;
  BatchOptions options{.times = true};
  const Eigen::ArrayXd f = Eigen::ArrayXd::LinSpaced(64, 5e-7, 6e-7);
  const Eigen::ArrayXd delta = Eigen::ArrayXd::Constant(64, 1e-9);
  const BatchResult alone = free_batch(1, 1, f, delta, options);
  options.go_on = [&asked] { return ++asked > 0; };
  const BatchResult watched = free_batch(1, 1, f, delta, options);
  BOOST_TEST(asked > 0);
  BOOST_TEST((watched.half_cycles == alone.half_cycles).all());
  BOOST_TEST((watched.stop_time == alone.stop_time).all());
  BOOST_TEST((watched.stop_position == alone.stop_position).all());
}

BOOST_AUTO_TEST_CASE(what_is_asked_for_is_checked) {
  const Eigen::ArrayXd two = Eigen::ArrayXd::Constant(2, 0.1);
  const Eigen::ArrayXd three = Eigen::ArrayXd::Constant(3, 0.1);
  const auto message = [&](const BatchValues& v0, const BatchValues& p, const BatchValues& delta,
                           const BatchOptions& options) {
    return refusal_of<InputError>(
        [&] { static_cast<void>(free_batch(v0, p, two, delta, options)); });
  };
  BOOST_TEST(message(three, two, two, {}) ==
             "v0 = an array of 3: must have as many entries as f, 2");
  BOOST_TEST(message(two, three, two, {}) ==
             "p = an array of 3: must have as many entries as f, 2");
  BOOST_TEST(message(two, two, three, {}) ==
             "delta = an array of 3: must have as many entries as f, 2");
  BOOST_TEST(message(two, two, two, {.threads = -1}) == "threads = -1: must be 1 or more");
  BOOST_TEST(message(two, two, two, {.half_cycle_limit = 0}) ==
             "half_cycle_limit = 0: must be a number from 1 to 1000000000000000");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
