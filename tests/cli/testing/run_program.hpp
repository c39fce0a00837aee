// SPDX-License-Identifier: MIT
#pragma once

#include "testing/folder.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::cli_test {

using Arguments = std::vector<std::string>;

/// What a run left behind.
struct ProgramRun {
  int exit_code{-1};  ///< -1: it crashed, or was ended by a signal or after its time
  std::string out;
  std::string err;

  /// The standard output as JSON; throws where it is none.
  [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(out); }
  /// The lines of standard error.
  [[nodiscard]] std::vector<std::string> err_lines() const;
};

enum class StandardOutput { pipe, terminal, file };

struct Surroundings {
  std::string input{};  ///< on standard input
  /// Beside what the tests themselves run in, less NO_COLOR, and with TERM=xterm.
  std::vector<std::pair<std::string, std::string>> environment{};
  StandardOutput output{StandardOutput::pipe};
  std::string output_file{};  ///< appended to, with StandardOutput::file
  bool error_is_terminal{false};
  /// Sends SIGINT as soon as the program handles it; with error_is_terminal once it has said
  /// something there.
  bool interrupt{false};
  bool interrupt_once_heard{false};  ///< the same where standard error is no terminal
  /// Sends `signal` once this holds; it is asked every millisecond.
  std::function<bool()> signal_when{};
  int signal{SIGINT};
  std::chrono::seconds patience{120};
};

/// A directory that lives as long as the test and in which the program runs. A fixture.
class Sandbox {
 public:
  /// Runs the program with this directory as its own.
  [[nodiscard]] ProgramRun run(const Arguments& arguments,
                               const Surroundings& surroundings = {}) const;

  [[nodiscard]] std::filesystem::path path(std::string_view name) const { return path_ / name; }
  void write(std::string_view name, std::string_view text) const;
  [[nodiscard]] std::string read(std::string_view name) const;

  /// Every entry by name: the text of a file, the target of a link, "/" for a directory. Of files
  /// over a mebibyte the size alone.
  [[nodiscard]] std::map<std::string, std::string> contents() const;

 private:
  test::Folder folder_;
  std::filesystem::path path_{std::filesystem::canonical(folder_.path(""))};
};

/// A precondition of tests: a pseudo-terminal can be had. A bare root without /dev/pts has none.
[[nodiscard]] boost::test_tools::assertion_result if_terminals(boost::unit_test::test_unit_id unit);

/// `head` with `tail` behind it.
[[nodiscard]] Arguments joined(Arguments head, const Arguments& tail);

/// A double as the program reads it back to the last bit.
[[nodiscard]] std::string in_full(double value);

/// Without their ends.
[[nodiscard]] std::vector<std::string> lines_of(const std::string& text);

}  // namespace stillpoint::cli_test
