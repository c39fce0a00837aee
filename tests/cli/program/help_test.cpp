// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "options/options.hpp"

#include <nlopt.h>

BOOST_FIXTURE_TEST_SUITE(help_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;
using stillpoint::cli::Command;

constexpr std::array commands{Command::design, Command::region, Command::simulate,
                              Command::spectrum, Command::sweep};

Surroundings of_width(const char* columns) {
  Surroundings surroundings;
  surroundings.environment.emplace_back("COLUMNS", columns);
  return surroundings;
}

/// The words of a text, whatever is between them; a line's end in an example does not count.
std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    if (word != "\\") {
      words.push_back(word);
    }
  }
  return words;
}

BOOST_AUTO_TEST_CASE(of_a_command_lists_only_its_options) {
  for (const Command command : commands) {
    const ProgramRun answer = succeed({std::string(name(command)), "--help"}, of_width("1000"));
    BOOST_TEST(answer.err.empty(), answer.err);
    for (const stillpoint::cli::Option& option : stillpoint::cli::options()) {
      const std::string start = "  --" + std::string(option.name) + " ";
      BOOST_TEST(contains(answer.out, start) == option.serves(command), name(command)
                                                                            << ": " << option.name);
      if (option.serves(command)) {
        BOOST_TEST((!option.help.empty() && contains(answer.out, std::string(option.help))),
                   option.name);
      }
    }
    check_contains(answer.out, {"--help", "--version", "Exit codes: 0"});
  }
}

BOOST_AUTO_TEST_CASE(examples_work) {
  // The lines of "Examples:" that need no file; a line that ends in \ goes on.
  int tried = 0;
  for (const Command command : commands) {
    std::string text = run({std::string(name(command)), "--help"}).out;
    for (std::size_t fold = text.find("\\\n"); fold != std::string::npos;
         fold = text.find("\\\n")) {
      text.replace(fold, 2, "");
    }
    std::istringstream lines(text.substr(text.find("Examples:")));
    for (std::string line; std::getline(lines, line);) {
      const std::string program = "  stillpoint ";
      if (!line.starts_with(program) || contains(line, ".json") || contains(line, "--record") ||
          contains(line, "--list")) {
        continue;
      }
      succeed(line.substr(program.size()).c_str());
      ++tried;
    }
  }
  BOOST_TEST(tried >= 10);
}

BOOST_AUTO_TEST_CASE(is_as_wide_as_the_terminal_or_80_columns) {
  for (const Command command : commands) {
    const Arguments help{std::string(name(command)), "--help"};
    const auto whole = words_of(run(help, of_width("1000")).out);
    for (const auto& [columns, width] :
         {std::pair{"60", 60U}, std::pair{"100", 100U}, std::pair{"0", 80U}, std::pair{"x", 80U},
          std::pair{"3", 50U}}) {
      const std::string text = run(help, of_width(columns)).out;
      bool full = false;
      for (const std::string& line : lines_of(text)) {
        // One word alone may be longer than the page is wide.
        BOOST_TEST((line.size() <= width || words_of(line).size() <= 2), columns << ": " << line);
        full = full || line.size() + 12 > width;
      }
      BOOST_TEST(full, "no line of " << columns << " columns is filled");
      BOOST_TEST(words_of(text) == whole, tt::per_element());
    }
  }
}

BOOST_AUTO_TEST_CASE(version_says_with_what_it_was_built_and_runs) {
  // The program's answer against what the test finds out by itself: NLopt is asked in C, the build
  // type and the compiler are those of the test.
  int major = 0;
  int minor = 0;
  int bugfix = 0;
  nlopt_version(&major, &minor, &bugfix);
  std::ostringstream expected;
  expected << "stillpoint " << STILLPOINT_TEST_VERSION << " (NLopt " << major << '.' << minor << '.'
           << bugfix << ", " << STILLPOINT_TEST_BUILD_TYPE << " build, " << STILLPOINT_TEST_COMPILER
           << ")\n";
  for (const char* const asked : {"--version", "design --version", "sweep --version"}) {
    BOOST_TEST(succeed(asked).out == expected.str());
  }
}

BOOST_AUTO_TEST_SUITE_END()
