// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "json_schema.hpp"

BOOST_AUTO_TEST_SUITE(sessions_test)

// Sessions at a shell, as someone would see them. A file of commands/sessions has
//   task NAME COMMAND  what NAME stands for, which further words may follow
//   session NAME       begins in an empty folder
//   $ COMMAND          that sh runs; $DATA is the folder data
//     LINE             what it prints, standard error last; ... stands for anything
//   exit N             its exit code, where it is not 0
// After a refusal, exit 2, all files are as before, unless it says that rows are kept.

using namespace stillpoint::cli_test;

struct Step {
  std::string command;
  std::string shown{};
  int exit_code{0};
};

struct Sessions {
  std::string setup{"stillpoint() { \"$STILLPOINT\" \"$@\"; }\n"};
  std::vector<std::pair<std::string, std::vector<Step>>> all{};  ///< by their names
};

Sessions sessions_in(const fs::path& file) {
  Sessions found;
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    const auto rest = [&line](std::size_t from) { return line.substr(from); };
    if (line.starts_with("task ")) {
      const std::size_t name = line.find(' ', 5);
      found.setup += line.substr(5, name - 5) + "() { " + rest(name + 1) + " \"$@\"; }\n";
    } else if (line.starts_with("session ")) {
      found.all.push_back({rest(8), {}});
    } else if (line.starts_with("$ ")) {
      found.all.at(found.all.size() - 1).second.push_back({rest(2)});
    } else if (line.starts_with("  ")) {
      found.all.back().second.back().shown += rest(2) + "\n";
    } else if (line.starts_with("exit ")) {
      found.all.back().second.back().exit_code = std::stoi(rest(5));
    } else {
      BOOST_TEST_REQUIRE((line.empty() || line.starts_with('#')), line);
    }
  }
  return found;
}

/// Of a line that is "..." alone the end is anything too.
bool is_shown(std::string_view text, std::string shown) {
  const std::string gap = "...";
  shown = std::regex_replace(shown, std::regex("(^|\n)\\.\\.\\.\n"), "$1...");
  std::size_t from = shown.find(gap);
  if (from == std::string::npos || !text.starts_with(shown.substr(0, from))) {
    return text == shown;
  }
  text.remove_prefix(from);
  for (std::size_t to = 0; (to = shown.find(gap, from += gap.size())) != std::string::npos;
       from = to) {
    const std::string part = shown.substr(from, to - from);
    const std::size_t at = text.find(part);
    if (at == std::string_view::npos) {
      return false;
    }
    text.remove_prefix(at + part.size());
  }
  return text.ends_with(shown.substr(from));
}

void check(const Sandbox& sandbox, const std::string& setup, const Step& step) {
  const auto before = sandbox.contents();
  const ProgramRun run = sandbox.run(
      {"-c", setup + step.command},
      {.program = "/bin/sh",
       .environment = {{"STILLPOINT", built_program()}, {"DATA", STILLPOINT_DATA_DIR}}});
  BOOST_TEST(run.exit_code == step.exit_code);
  BOOST_TEST(is_shown(run.out + run.err, step.shown), run.out + run.err);
  BOOST_TEST(
      (step.exit_code != 2 || contains(run.err, " kept in ") || sandbox.contents() == before));
}

BOOST_AUTO_TEST_CASE(each_command_prints_what_is_shown) {
  for (const auto& entry : fs::directory_iterator(STILLPOINT_COMMANDS "/sessions")) {
    const Sessions sessions = sessions_in(entry.path());
    BOOST_TEST(!sessions.all.empty());
    for (const auto& [name, steps] : sessions.all) {
      const Sandbox sandbox;
      for (const Step& step : steps) {
        BOOST_TEST_CONTEXT(entry.path().filename()
                           << ", session " << name << ": " << step.command) {
          check(sandbox, sessions.setup, step);
        }
      }
      for (const auto& [file, text] : sandbox.contents()) {
        if (file.ends_with(".json") && contains(text, "-report/")) {
          check_report_schema(text);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
