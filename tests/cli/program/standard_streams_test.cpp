// SPDX-License-Identifier: MIT
// Standard streams that are closed, that nobody reads, and files that cannot grow.
#include "cli_test.hpp"
#include "limits.hpp"
#include "wrong_arguments.hpp"

BOOST_FIXTURE_TEST_SUITE(standard_streams_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;
using right::design;

/// The locked motion is a remark on standard error, the report goes to standard output.
const Arguments sweep("sweep --v0 1 --p 1 --f 0.1 --delta 0:1:5 --format csv --output");
const Arguments locks(
    "simulate --v0 0.1 --p 1 --f 0.05 --delta 0.3 --excitation harmonic --k 0.2 --lambda 0.35 "
    "--t-end 100 --output");

/// Files get the lowest numbers that are free; what is written to the streams must not end there.
BOOST_AUTO_TEST_CASE(that_are_closed_are_no_files) {
  // Without the times.
  const auto numbers = [](const std::string& text) { return text.substr(0, text.find("search")); };
  for (const Arguments& task : {sweep, locks, design("--output")}) {
    succeed(task + "whole");
    for (const std::vector<int>& closed :
         std::vector<std::vector<int>>{{0}, {1}, {2}, {0, 1}, {0, 2}, {1, 2}, {0, 1, 2}}) {
      succeed(task + "part", {.closed = closed});
      BOOST_TEST(numbers(read("part")) == numbers(read("whole")));
    }
  }
  BOOST_TEST(contents().size() == 2U);
}

/// An answer that is lost is an error, as on a full disk.
BOOST_AUTO_TEST_CASE(that_are_closed_take_and_give_nothing) {
  for (const Arguments& task :
       {design(), Arguments("simulate --v0 1 --p 1 --f 0.1 --delta 0.1"),
        Arguments("sweep --v0 1 --p 1 --f 0.1 --delta 0.1"), Arguments("--version")}) {
    check_refusal(run(task, {.closed = {1}}), {"standard output: cannot be written"});
  }
  check_refusal(run("design -", {.closed = {0}}), {"scene"});
}

/// As on a full disk, whatever the program inherits.
BOOST_AUTO_TEST_CASE(and_files_that_cannot_grow_leave_nothing) {
  for (void (*const at_the_limit)(int) : {SIG_DFL, SIG_IGN}) {
    const WriteLimit limit(1000, at_the_limit);
    for (const char* const files : {"--html page", "--output report", "--svg figures"}) {
      check_refusal(run(design(files)), {"cannot be written: File too large"});
    }
  }
  BOOST_TEST(contents().size() == 1U);  // the directory of the figures
  BOOST_TEST(fs::is_empty(path("figures")));
}

/// The end of a reader ends the program silently, as it ends any other; nothing is left.
BOOST_AUTO_TEST_CASE(that_nobody_reads_leave_nothing) {
  const Surroundings unread{.output = StandardOutput::unread};
  for (const Arguments& task :
       {design("--html page.html --output report.json"), sweep + "/dev/stdout"}) {
    const ProgramRun ended = run(task, unread);
    BOOST_TEST(ended.exit_code == -1);
    BOOST_TEST(ended.err.empty(), ended.err);
  }
  BOOST_TEST(contents().empty());
}

/// No address space has room for such stacks.
BOOST_AUTO_TEST_CASE(and_threads_that_cannot_be_started_are_said) {
  const Limit stacks(RLIMIT_STACK, rlim_t{1} << 56U);
  check_refusal(run(sweep + "rows.csv --threads 1"),
                {"no thread can be started (Resource temporarily unavailable)", "ulimit"});
  BOOST_TEST(contents().empty());
}

BOOST_AUTO_TEST_SUITE_END()
