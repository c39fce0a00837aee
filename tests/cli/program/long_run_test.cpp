// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

BOOST_FIXTURE_TEST_SUITE(long_run_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;

/// Some minutes.
Arguments endless(const Arguments& more = {}, const std::string& t_end = "1e9") {
  return Arguments{"simulate", "--v0",     "0.5",  "--p",          "1",        "--f",
                   "0.05",     "--delta",  "0.01", "--excitation", "harmonic", "--k",
                   "0.2",      "--lambda", "1",    "--t-end",      t_end} +
         more;
}

BOOST_AUTO_TEST_CASE(stops_at_an_interrupt_and_writes_nothing) {
  write("old.json", "an old report\n");
  const Surroundings interrupted{.interrupt = true};
  for (const Arguments& more :
       {Arguments{}, Arguments("--json --output old.json"), Arguments("--trajectory motion.csv")}) {
    const ProgramRun stopped = ending(130, endless(more), interrupted);
    BOOST_TEST(stopped.out.empty(), stopped.out);
    BOOST_TEST(stopped.err_lines().size() == 1U, stopped.err);
    BOOST_TEST(stopped.err.starts_with("stillpoint: interrupted "), stopped.err);
    BOOST_TEST(contents().size() == 1U);
    BOOST_TEST(read("old.json") == "an old report\n");
  }
}

BOOST_AUTO_TEST_CASE(shows_progress_on_a_terminal_and_clears_it_at_the_end,
                     *boost::unit_test::precondition(if_terminals)) {
  const Surroundings interrupted{.error_is_terminal = true, .interrupt_at = "tau"};
  const ProgramRun stopped = ending(130, endless(), interrupted);
  BOOST_TEST(stopped.err.starts_with("\rtau "), stopped.err);
  BOOST_TEST(contains(stopped.err, " of 1e+09, "), stopped.err);
  // The line is cleared before the message takes its place.
  BOOST_TEST(contains(stopped.err, "\r\x1b[Kstillpoint: interrupted"), stopped.err);
  BOOST_TEST(std::ranges::count(stopped.err, '\n') == 1);
}

BOOST_AUTO_TEST_CASE(says_how_long_it_will_take_without_a_terminal) {
  const ProgramRun stopped = run(endless({}, "1e12"), {.interrupt_at = "to go"});  // days
  BOOST_TEST(stopped.exit_code == 130);
  const auto lines = stopped.err_lines();
  BOOST_TEST_REQUIRE(lines.size() == 2U, stopped.err);
  BOOST_TEST(lines[0].starts_with("stillpoint: tau "), lines[0]);
  BOOST_TEST(contains(lines[0], " of 1e+12, 0 %: about "), lines[0]);
  BOOST_TEST(lines[0].ends_with(" minutes to go"), lines[0]);
  BOOST_TEST(lines[1].starts_with("stillpoint: interrupted "), lines[1]);
}

// It is held while the load is below f: asin(0.2) of pi.
BOOST_AUTO_TEST_CASE(under_a_load_that_ends_by_itself_says_how_long_it_will_take) {
  const ProgramRun stopped =
      run("simulate --v0 0 --p 1 --f 0.1 --delta 0 --excitation half-sine --k 0.5 --lambda 1e-11",
          {.interrupt_at = "to go"});
  BOOST_TEST(stopped.exit_code == 130);
  const auto lines = stopped.err_lines();
  BOOST_TEST_REQUIRE(lines.size() == 2U, stopped.err);
  BOOST_TEST(contains(lines[0], " of 3.14159e+11, 6 %: about "), lines[0]);
  BOOST_TEST(lines[0].ends_with(" minutes to go"), lines[0]);
}

// At most V0/(2 f) half-cycles: 1e11 of them. A run that the limit refuses is not announced.
BOOST_AUTO_TEST_CASE(of_free_motion_warns_beforehand_that_it_takes_minutes) {
  const Arguments free("simulate --v0 1 --p 1 --f 5e-12 --delta 1e-15 --half-cycle-limit");
  const ProgramRun stopped = run(free + "1e12", {.interrupt_at = "minutes"});
  const auto lines = stopped.err_lines();
  BOOST_TEST_REQUIRE(lines.size() == 1U, stopped.err);
  BOOST_TEST(lines[0] == "stillpoint: up to 1e+11 half-cycles: this may take about 25 minutes");
  const ProgramRun refused = run(free + "1e10");
  check_refusal(refused, {"1e+11 half-cycles; at most 1e+10"});
  BOOST_TEST(refused.err_lines().size() == 1U, refused.err);
}

/// A terminal that would print the escapes shows what a log does.
BOOST_AUTO_TEST_CASE(of_a_dumb_terminal_has_no_escapes,
                     *boost::unit_test::precondition(if_terminals)) {
  const ProgramRun stopped =
      run(endless({}, "1e12"),
          {.environment = {{"TERM", "dumb"}}, .error_is_terminal = true, .interrupt_at = "to go"});
  BOOST_TEST(stopped.exit_code == 130);
  BOOST_TEST(contains(stopped.err, " minutes to go"), stopped.err);
  BOOST_TEST(!contains(stopped.err, "\x1b"), stopped.err);
}

BOOST_AUTO_TEST_CASE(short_run_shows_none, *boost::unit_test::precondition(if_terminals)) {
  const ProgramRun brief =
      succeed("simulate --v0 1 --p 1 --f 0.1 --delta 0.1", {.error_is_terminal = true});
  BOOST_TEST(brief.err.empty(), brief.err);
}

// ---- sweeps

/// Hours.
const Arguments sweep("sweep --v0 1 --p 1 --f 1e-4:1:1000000 --delta 1e-4:1:1000000");

BOOST_AUTO_TEST_CASE(sweep_interrupted_on_standard_output_ends_with_a_whole_row) {
  const ProgramRun stopped = ending(130, sweep, {.interrupt = true});
  BOOST_TEST((stopped.out.empty() || stopped.out.ends_with('\n')));
  BOOST_TEST(stopped.err.starts_with("stillpoint: interrupted: "), stopped.err);
}

/// Hours of work are announced once, in the log.
BOOST_AUTO_TEST_CASE(sweep_says_how_long_it_will_take_without_a_terminal) {
  const ProgramRun stopped = ending(130, sweep + "--output /dev/null", {.interrupt_at = "to go"});
  const auto lines = stopped.err_lines();
  BOOST_TEST_REQUIRE(lines.size() == 2U, stopped.err);
  BOOST_TEST(lines[0].starts_with("stillpoint: "), lines[0]);
  check_contains(lines[0], {" of 1e+12 rows, 0 %, ", " rows/s: about "});
  BOOST_TEST(lines[0].ends_with(" minutes to go"), lines[0]);
  BOOST_TEST(lines[1].starts_with("stillpoint: interrupted: "), lines[1]);
}

/// A list that comes slowly, and is never finished.
BOOST_AUTO_TEST_CASE(sweep_that_waits_for_a_list_is_ended_by_an_interrupt) {
  fs::path list = path("list");
  BOOST_TEST_REQUIRE(::mkfifo(list.c_str(), 0600) == 0);
  const int writer = ::open(list.c_str(), O_RDWR | O_CLOEXEC);
  const std::string begun = "f,delta\n0.1,0.2\n";
  BOOST_TEST(::write(writer, begun.data(), begun.size()) == static_cast<ssize_t>(begun.size()));
  const ProgramRun stopped = run("sweep --v0 1 --p 1 --list list", {.interrupt = true});
  ::close(writer);
  BOOST_TEST(stopped.exit_code == 130);
  BOOST_TEST(stopped.err.starts_with("stillpoint: interrupted: "), stopped.err);
}

BOOST_AUTO_TEST_CASE(sweep_shows_progress_on_a_terminal,
                     *boost::unit_test::precondition(if_terminals)) {
  const ProgramRun stopped = ending(130, sweep + "--output /dev/null",
                                    {.error_is_terminal = true, .interrupt_at = "rows/s"});
  check_contains(stopped.err, {" of 1e+12 rows, 0 %, ", " rows/s, ", " left\x1b[K"});
}

BOOST_AUTO_TEST_SUITE_END()
