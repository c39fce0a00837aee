// SPDX-License-Identifier: MIT
#pragma once

#include "testing/contains.hpp"
#include "testing/folder.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <functional>
#include <map>
#include <utility>

namespace stillpoint::cli_test {

using test::check_contains;
using test::contains;
using test::one_line;
using test::text_of;

/// The words behind the name of the program.
struct Arguments : std::vector<std::string> {
  using std::vector<std::string>::vector;

  /// As a shell reads a line: words between blanks; single quotes hold one with blanks, or none.
  Arguments(const char* line);  // NOLINT(google-explicit-constructor): stands for its words
};

/// The results of a run.
struct ProgramRun {
  int exit_code{-1};  ///< -1: it crashed, or was ended by a signal or after its time
  std::string out;
  std::string err;

  /// The standard output as JSON; throws where it is none.
  [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(out); }
  /// The lines of standard error.
  [[nodiscard]] std::vector<std::string> err_lines() const;
};

/// The file of the program that is tested.
[[nodiscard]] std::string built_program();

struct Surroundings {
  std::string input{};    ///< on standard input
  std::string program{};  ///< a copy of built_program(); empty: that itself
  /// Beside what the tests themselves run in, less NO_COLOR, and with TERM=xterm.
  std::vector<std::pair<std::string, std::string>> environment{};
  bool output_is_terminal{false};
  bool error_is_terminal{false};
  bool interrupt{false};       ///< sends SIGINT as soon as the program handles it
  std::string interrupt_at{};  ///< sends SIGINT once this has come on standard error
  /// Sends `signal` once this holds; it is asked every millisecond.
  std::function<bool()> signal_when{};
  int signal{SIGINT};
  std::chrono::seconds patience{300};
};

/// A directory that lives as long as the test and in which the program runs. A fixture.
class Sandbox : public test::Folder {
 public:
  /// Runs the program with this directory as its own.
  [[nodiscard]] ProgramRun run(const Arguments& arguments,
                               const Surroundings& surroundings = {}) const;
  /// The same of a run that must end with this code. Some tests look only at the files that it
  /// writes.
  // NOLINTNEXTLINE(modernize-use-nodiscard)
  ProgramRun ending(int exit_code, const Arguments& arguments,
                    const Surroundings& surroundings = {}) const;
  /// The same with 0.
  // NOLINTNEXTLINE(modernize-use-nodiscard)
  ProgramRun succeed(const Arguments& arguments, const Surroundings& surroundings = {}) const;
  /// The report of such a run with --json, whose numbers are finite. Standard error may say that
  /// the damper locks, and nothing else.
  [[nodiscard]] nlohmann::json reported(const Arguments& arguments,
                                        const Surroundings& surroundings = {}) const;

  /// Every entry by name: the text of a file, the target of a link, "/" for a directory. Of files
  /// over a mebibyte the size alone.
  [[nodiscard]] std::map<std::string, std::string> contents() const;
};

/// A precondition of tests: a pseudo-terminal can be had. A bare root without /dev/pts has none.
[[nodiscard]] boost::test_tools::assertion_result if_terminals(boost::unit_test::test_unit_id unit);

/// `head` with `tail` behind it.
[[nodiscard]] Arguments operator+(Arguments head, const Arguments& tail);

/// A double as the program reads it back to the last bit.
[[nodiscard]] std::string in_full(double value);

/// Without their ends.
[[nodiscard]] std::vector<std::string> lines_of(const std::string& text);

}  // namespace stillpoint::cli_test
