// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

// A long sweep says how far it is, and stops when interrupted.
BOOST_FIXTURE_TEST_SUITE(sweep_interrupt_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;

BOOST_AUTO_TEST_CASE(interrupted_standard_output_ends_with_a_whole_row) {
  const ProgramRun stopped = ending(
      130, "sweep --v0 1 --p 1 --f 1e-4:1:1000000 --delta 1e-4:1:1000000", {.interrupt = true});
  BOOST_TEST((stopped.out.empty() || stopped.out.ends_with('\n')));
  BOOST_TEST(stopped.err.starts_with("stillpoint: interrupted: "), stopped.err);
}

/// Hours of work are announced once, in the log.
BOOST_AUTO_TEST_CASE(long_sweep_says_how_long_it_will_take_without_a_terminal) {
  const ProgramRun stopped =
      ending(130, "sweep --v0 1 --p 1 --f 1e-4:1:1000000 --delta 1e-4:1:1000000 --output /dev/null",
             {.interrupt_once_heard = true});
  const auto lines = stopped.err_lines();
  BOOST_TEST_REQUIRE(lines.size() == 2U, stopped.err);
  BOOST_TEST(lines[0].starts_with("stillpoint: "), lines[0]);
  check_contains(lines[0], {" of 1e+12 rows, 0 %, ", " rows/s: about "});
  BOOST_TEST(lines[0].ends_with(" minutes to go"), lines[0]);
  BOOST_TEST(lines[1].starts_with("stillpoint: interrupted: "), lines[1]);
}

/// A list that comes slowly, and is never finished.
BOOST_AUTO_TEST_CASE(interrupt_ends_the_wait_for_a_list) {
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

BOOST_AUTO_TEST_CASE(progress_is_shown_on_a_terminal,
                     *boost::unit_test::precondition(if_terminals)) {
  const ProgramRun stopped =
      ending(130, "sweep --v0 1 --p 1 --f 1e-4:1:1000000 --delta 1e-4:1:1000000 --output /dev/null",
             {.error_is_terminal = true, .interrupt = true});
  check_contains(stopped.err, {" of 1e+12 rows, 0 %, ", " rows/s, ", " left\x1b[K"});
}

BOOST_AUTO_TEST_SUITE_END()
