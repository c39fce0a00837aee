// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_AUTO_TEST_SUITE(record_design_command_test)

// design --record, from the flags to the report. The search itself is in record_design_test.

using namespace stillpoint::cli_test;

/// A damper that does not move, so every figure is known: it transmits the load.
const Arguments held("design --record a.txt --period 2.8s --search-f 2:2 --search-delta-m 0:0");

BOOST_FIXTURE_TEST_CASE(the_relaxed_limit_that_is_suggested_suffices, Recorded) {
  const json report = ending(3, held + "--json --acceleration-max 0.1").json();
  succeed(held + Arguments{"--acceleration-max", in_full(report["mends"][0]["value"])});
}

/// 40 s that are shaken up to 29 s, without an offset, under which a search takes seconds.
struct LongRecord : Sandbox {
  LongRecord() {
    std::string record;
    for (int i = 0; i < 4000; ++i) {
      record += i >= 2900 ? "0\n" : i % 7 < 3 ? "0.3\n" : "-0.225\n";
    }
    write("long.txt", record);
  }
};

BOOST_FIXTURE_TEST_CASE(an_interrupt_ends_with_the_best_so_far, LongRecord) {
  const Arguments long_search(
      "design --record long.txt --record-step 0.01 --period 2.8 --hold 0.1 --jump-max 9");
  const Surroundings interrupted{.interrupt = true};
  const ProgramRun stopped = ending(130, long_search + "--json --output r.json", interrupted);
  BOOST_TEST(stopped.err ==
             "stillpoint: caution: The search was interrupted: a complete one may find a better "
             "damper.\n");
  BOOST_TEST(stopped.json()["search"]["interrupted"] == true);
  BOOST_TEST(stopped.json()["search"]["scan"]["points"] < 10'000);
  BOOST_TEST(read("r.json") == stopped.out);
  BOOST_TEST(contains(run(long_search, interrupted).out,
                      "No damper was verified before the search was interrupted."));
}

// Friction alone is verified in a second; the notch of any width, at any period, takes a minute.
BOOST_FIXTURE_TEST_CASE(an_interrupt_gives_the_verified_damper_that_a_terminal_shows, LongRecord,
                        *boost::unit_test::precondition(if_terminals)) {
  const Arguments search(
      "design --record long.txt --record-step 0.01 --search-period 2:4 --residual-m 0.05 "
      "--search-notch-width-m 20mm:300mm --scan-points 1000000");
  const std::string mark = ", best verified ";
  const Surroundings interrupted{.error_is_terminal = true, .interrupt_at = mark};
  const ProgramRun stopped = ending(130, search + "--output r.json", interrupted);
  check_contains(stopped.err, {" of about ", " dampers"});
  const json report = json::parse(read("r.json"));
  BOOST_TEST(report["search"]["interrupted"] == true);
  BOOST_TEST(report["design"]["box"]["samples"] >= 4000);
  BOOST_TEST(report["cases"][0]["worst"]["residual_m"] <= 0.05);
  const std::string best = stopped.err.substr(stopped.err.rfind(mark) + mark.size());
  const std::string transmitted = best.substr(0, best.find(','));  // "0.24 g transmitted"
  BOOST_TEST(contains(one_line(stopped.out), " " + transmitted), stopped.out);
}

BOOST_AUTO_TEST_SUITE_END()
