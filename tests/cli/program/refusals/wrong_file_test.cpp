// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "wrong_arguments.hpp"

#include <unistd.h>

BOOST_AUTO_TEST_SUITE(wrong_file_test)

// Scenes that cannot be read and output that cannot be written.

using namespace stillpoint::cli_test;
using namespace stillpoint::cli_test::right;

BOOST_FIXTURE_TEST_SUITE(scene_file, Sandbox)

BOOST_AUTO_TEST_CASE(that_is_too_large) {
  write("huge.json", "");
  fs::resize_file(path("huge.json"), 100'000'000);
  check_refused(*this, {"design huge.json", {"huge.json", "too large", "1048576 bytes"}});
}

BOOST_AUTO_TEST_CASE(that_cannot_be_opened) {
  write("secret.json", "{" + good + "}");
  fs::permissions(path("secret.json"), fs::perms::none);
  if (::access(path("secret.json").c_str(), R_OK) == 0) {
    BOOST_TEST_MESSAGE("skipped: this user may read every file");
    return;
  }
  check_refused(*this, {"design secret.json", {"secret.json", "Permission denied"}});
}

BOOST_AUTO_TEST_CASE(whose_reading_fails) {
  const char* unreadable = "/proc/self/mem";  // opens, but nothing lies at its beginning
  if (!fs::exists(unreadable)) {
    BOOST_TEST_MESSAGE("skipped: no " << unreadable);
    return;
  }
  check_refused(*this, {{"design", unreadable}, {unreadable, "cannot be read"}});
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(output, Sandbox)

BOOST_AUTO_TEST_CASE(standard_output_that_is_full) {
  const std::vector<Arguments> all{design(), design("--json"), region(), simulate()};
  for (const Arguments& arguments : all) {
    check_refused(*this, {arguments, {"standard output", "No space left"}}, to_a_full_device);
  }
  check_refusal(run(sweep("--f 0.1 --delta 0,1"), to_a_full_device),
                {"standard output", "No space left"});
  check_refusal(run("--help", to_a_full_device), {"standard output"});
  check_refusal(run("--version", to_a_full_device), {"standard output"});
}

/// Nothing can be said, so only the exit code tells it.
BOOST_AUTO_TEST_CASE(standard_error_that_is_full_or_closed) {
  const Surroundings shell{.program = "/bin/sh"};
  for (const std::string end : {" 2> /dev/full", " 2>&-"}) {
    const ProgramRun wrong = run({"-c", built_program() + " design --v0 x" + end}, shell);
    BOOST_TEST(wrong.exit_code == 2, end);
    BOOST_TEST(wrong.out.empty());
  }
}

BOOST_AUTO_TEST_CASE(standard_output_that_is_full_leaves_the_trajectory_alone) {
  write("t.csv", "old");
  check_refused(*this, {simulate("--trajectory t.csv"), {"standard output"}}, to_a_full_device);
}

BOOST_AUTO_TEST_CASE(file_in_a_directory_that_takes_none) {
  // Not even root can create files there.
  if (fs::exists("/proc/self")) {
    check_refused(*this, {design("--output /proc/report.json"), {"/proc/report.json"}});
  }
  fs::create_directory(path("sealed"));
  fs::permissions(path("sealed"), fs::perms::owner_read | fs::perms::owner_exec);
  if (::access(path("sealed").c_str(), W_OK) == 0) {
    BOOST_TEST_MESSAGE("skipped: this user may write everywhere");
    return;
  }
  check_refused(*this, {design("--output sealed/new.json"), {"output", "sealed/new.json"}});
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
