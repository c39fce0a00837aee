// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "wrong_arguments.hpp"

#include <unistd.h>

BOOST_AUTO_TEST_SUITE(wrong_file_test)

// Scenes that cannot be read and output that cannot be written.

using namespace stillpoint::cli_test;
using namespace stillpoint::cli_test::right;

BOOST_FIXTURE_TEST_SUITE(scene_file, Sandbox)

BOOST_AUTO_TEST_CASE(that_is_none) {
  fs::create_directory(path("folder"));
  write("empty.json", "");
  write("binary.json", std::string("\x7f\x45\x4c\x46\x00\x01", 6));
  write("huge.json", "");
  fs::resize_file(path("huge.json"), 100'000'000);
  for (const Wrong& wrong : std::vector<Wrong>{
           {"design none.json", {"none.json", "No such file"}},
           {design({""}), {"scene \"\": cannot be read"}},
           {"design folder", {"folder", "directory"}},
           {"design empty.json", {"empty.json", "empty"}},
           {"design binary.json", {"binary.json", "not valid JSON"}},
           {"design huge.json", {"huge.json", "too large", "1048576 bytes"}},
           {"design /dev/zero", {"/dev/zero", "too large", "1048576 bytes"}},
       }) {
    check_refused(*this, wrong);
  }
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

/// Such a value would overflow the stack, and its text would fill the screen.
BOOST_AUTO_TEST_CASE(that_is_nested_too_deeply) {
  for (const int levels : {17, 50'000, 100'000, 500'000}) {
    const auto count = static_cast<std::size_t>(levels);
    const std::string arrays = std::string(count, '[') + "1" + std::string(count, ']');
    check_refused(*this, {"design -", {"nested deeper than 16"}, "{\"v0\": " + arrays + "}"});
    check_refused(*this, {"design -", {"nested deeper than 16"}, arrays});
  }
  std::string objects;
  for (int i = 0; i < 100'000; ++i) {
    objects += "{\"a\":";
  }
  check_refused(*this, {"sweep -", {"nested deeper than 16"}, objects + "1"});
}

/// A message quotes only as much as one can read.
BOOST_AUTO_TEST_CASE(whose_text_is_long_is_quoted_in_part) {
  const std::string text(100'000, 'x');
  const std::string quoted = "\"" + text + "\"";
  std::string numbers = "[\"a\"";
  for (int i = 0; i < 50'000; ++i) {
    numbers += ",1";
  }
  numbers += "]";
  const std::vector<Wrong> long_ones{
      {"design -", {"v0 = ", "must be a number"}, "{\"v0\": " + quoted + "}"},
      {"design -", {"v0 = ", "must be a number"}, "{\"v0\": " + numbers + "}"},
      {"sweep -", {"f = ", "an array of numbers"}, "{\"f\": " + numbers + "}"},
      {"design -", {"xxx", "is not a key"}, "{" + quoted + ": 1}"},
      {"design -", {"xxx", "set twice"}, "{" + quoted + ": 1, " + quoted + ": 1}"},
      {"design -", {"not valid JSON"}, "{" + quoted},
      {"design -",
       {"line 1, column 8: v0 = 1000", "1.8e308"},
       "{\"v0\": 1" + std::string(100'000, '0') + "}"},
      {{"design", text}, {"scene xxx", "cannot be read"}},
      {{"design", "--" + text}, {"xxx", "unknown option"}},
      {{"design", "a", text}, {"xxx", "only one scene"}},
      {{text}, {"command xxx", "must be design"}},
      {{"design", "--v0", text}, {"v0 = ", "must be a number"}},
      {design({"--criterion", text}), {"criterion = xxx", "published or exact"}},
      {design({"--algorithm", text}), {"algorithm = xxx"}},
      {simulate({"--samples", text}), {"samples = ", "whole number"}},
      {simulate({"--record", text}), {"record xxx", "cannot be read"}},
      {simulate({"--trajectory", text}), {"trajectory xxx", "cannot be written"}},
      {{"sweep", "--v0", text + ":1:2"}, {"v0 = ", "must be a number"}},
      {{"sweep", "--v0", "1", "--list", text}, {"list xxx", "cannot be read"}},
  };
  for (const Wrong& wrong : long_ones) {
    const ProgramRun answer = run(wrong.arguments, {.input = wrong.input});
    check_refusal(answer, wrong.says);
    BOOST_TEST(answer.err.size() < 600U, answer.err.substr(0, 1000));
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(output, Sandbox)

BOOST_AUTO_TEST_CASE(standard_output_that_is_full) {
  const std::vector<Arguments> all{design(), design("--json"), region(), simulate()};
  for (const Arguments& arguments : all) {
    check_refused(*this, {arguments, {"standard output", "No space left"}}, to_a_full_device);
  }
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

BOOST_AUTO_TEST_CASE(file_that_cannot_be_written) {
  fs::create_directory(path("folder"));
  write("t.csv", "old");
  for (const Wrong& wrong : std::vector<Wrong>{
           {design("--output /dev/full"), {"output", "/dev/full", "No space left"}},
           {simulate("--trajectory /dev/full"), {"trajectory", "/dev/full", "No space"}},
           {design("--output no/where.json"), {"output", "no/where.json"}},
           {design("--output none/"), {"output", "none/"}},
           {simulate("--trajectory no/where.csv"), {"trajectory", "no/where.csv"}},
           {design({"--output", ""}), {"output"}},
           {simulate({"--trajectory", ""}), {"trajectory"}},
           {design("--output folder"), {"output", "folder", "directory"}},
           {{"", "--v0", "1"}, {"command \"\": must be design"}},
           {simulate("--trajectory t.csv --output no/where.json"), {"output", "no/where.json"}},
           {simulate("--trajectory no/where.csv --output old.json"), {"no/where.csv"}},
       }) {
    check_refused(*this, wrong);
  }
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
