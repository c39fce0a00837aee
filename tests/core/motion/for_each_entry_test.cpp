// SPDX-License-Identifier: MIT
#include "motion.hpp"

#include <atomic>
#include <chrono>
#include <thread>

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(for_each_entry_test)

BOOST_AUTO_TEST_CASE(each_entry_is_called_once) {
  for (const Threads& threads : {Threads(), Threads(1), Threads(2), Threads(7)}) {
    std::vector<std::atomic<int>> calls(1000);
    for_each_entry(1000, threads, {},
                   [&](std::ptrdiff_t i) { ++calls[static_cast<std::size_t>(i)]; });
    BOOST_TEST(std::ranges::all_of(calls, [](const auto& count) { return count == 1; }));
  }
}

BOOST_AUTO_TEST_CASE(without_entries_nothing_is_called) {
  for_each_entry(0, 2, {}, [](std::ptrdiff_t /*i*/) { BOOST_ERROR("called"); });
}

BOOST_AUTO_TEST_CASE(the_first_entry_that_throws_is_named_whatever_the_threads) {
  for (const int threads : {1, 2, 7}) {
    const auto run = [&] {
      for_each_entry(1000, threads, {}, [](std::ptrdiff_t i) {
        if (i >= 400) {
          throw std::out_of_range(i == 400 ? "the four hundredth" : "a later one");
        }
      });
    };
    BOOST_CHECK_EXCEPTION(run(), EntryError, [](const EntryError& error) {
      BOOST_CHECK_THROW(std::rethrow_exception(error.cause()), std::out_of_range);
      return error.entry() == 400 && std::string(error.what()) == "the four hundredth";
    });
  }
}

BOOST_AUTO_TEST_CASE(an_entry_that_throws_after_a_later_one_is_named) {
  std::atomic<bool> last_threw = false;
  const auto run = [&] {
    for_each_entry(2, 2, {}, [&](std::ptrdiff_t i) {
      if (i == 0) {
        last_threw.wait(false);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));  // until that one is kept
      } else {
        last_threw = true;
        last_threw.notify_one();
      }
      throw std::out_of_range(i == 0 ? "the first" : "the last");
    });
  };
  BOOST_CHECK_EXCEPTION(run(), EntryError,
                        [](const EntryError& error) { return error.entry() == 0; });
}

BOOST_AUTO_TEST_CASE(a_run_that_is_stopped_skips_the_rest) {
  // One thread asks before each entry: the entries 0 to 9 are done when the tenth is refused.
  int done = 0;
  for_each_entry(
      1000, 1, [&] { return done < 10; }, [&](std::ptrdiff_t /*i*/) { ++done; });
  BOOST_TEST(done == 10);
}

BOOST_AUTO_TEST_CASE(what_go_on_throws_reaches_the_caller_whatever_the_threads) {
  for (const int threads : {1, 2, 7}) {
    std::atomic<int> asked = 0;
    std::atomic<int> done = 0;
    const auto go_on = [&] {
      if (++asked > 100) {
        throw std::out_of_range("not wanted");
      }
      return true;
    };
    BOOST_CHECK_EXCEPTION(
        for_each_entry(1000, threads, go_on, [&](std::ptrdiff_t /*i*/) { ++done; }),
        std::out_of_range,
        [](const std::out_of_range& error) { return std::string(error.what()) == "not wanted"; });
    BOOST_TEST(done <= 100);
  }
}

BOOST_AUTO_TEST_CASE(a_negative_number_of_threads_is_refused) {
  BOOST_TEST(refusal_of<InputError>([] {
               for_each_entry(1, -1, {}, [](std::ptrdiff_t /*i*/) {});
             }) == "threads = -1: must be 1 or more");
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
