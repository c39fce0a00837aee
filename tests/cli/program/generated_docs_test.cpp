// SPDX-License-Identifier: MIT
#include "generated_docs.hpp"
#include "cli_test.hpp"
#include "options/command_line.hpp"

BOOST_AUTO_TEST_SUITE(generated_docs_test)

using namespace stillpoint::cli_test;
namespace cli = stillpoint::cli;

std::set<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

std::set<std::string> flags_of(cli::Command command) {
  std::set<std::string> flags{"--help", "--version"};
  for (const cli::Option& option : cli::options()) {
    if (option.serves(command)) {
      flags.insert("--" + std::string(option.name));
    }
  }
  return flags;
}

struct Bash : Sandbox {
  Bash() { write("stillpoint.bash", cli::bash_completion()); }

  /// What is offered for the last word of a command line.
  [[nodiscard]] std::set<std::string> offered(const std::string& line) const {
    const std::string script = "source ./stillpoint.bash; COMP_WORDS=(" + line +
                               "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _stillpoint; "
                               "printf '%s\\n' \"${COMPREPLY[@]}\"";
    return words(run({"bash", "-c", script}, {.program = "/usr/bin/env"}).out);
  }
};

BOOST_FIXTURE_TEST_SUITE(bash, Bash)

BOOST_AUTO_TEST_CASE(offers_only_the_options_of_each_command) {
  for (const cli::CommandHelp& help : cli::all_commands()) {
    const std::string command(cli::name(help.command));
    BOOST_TEST(offered("stillpoint " + command + " --") == flags_of(help.command), command);
    BOOST_TEST(offered("stillpoint " + command.substr(0, 2)).contains(command));
  }
}

BOOST_AUTO_TEST_CASE(offers_files_for_file_options_and_nothing_for_numbers) {
  write("scene.json", "{}");
  const std::set<std::string> scene{"scene.json"};
  BOOST_TEST(offered("stillpoint design sce") == scene);
  BOOST_TEST(offered("stillpoint design --output sce") == scene);
  BOOST_TEST(offered("stillpoint design --output = sce") == scene);
  BOOST_TEST(offered("stillpoint design --v0 sce").empty());
}

BOOST_AUTO_TEST_CASE(offers_the_values_of_an_option) {
  const std::set<std::string> pulses{"half-sine", "full-sine", "rectangle",
                                     "sawtooth",  "trapezoid", "haversine"};
  BOOST_TEST(offered("stillpoint design --pulse \"\"") == pulses);
  BOOST_TEST(offered("stillpoint design --objective=a") == std::set<std::string>());
  const std::set<std::string> with_a{"amplitude", "acceleration"};
  BOOST_TEST(offered("stillpoint design --objective = a") == with_a);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(texts)

/// Every text has the name of each option, with its help.
BOOST_AUTO_TEST_CASE(name_every_option) {
  const std::string man = cli::man_page();
  const std::string zsh = cli::zsh_completion();
  const std::string fish = cli::fish_completion();
  for (const cli::Option& option : cli::options()) {
    const std::string name(option.name);
    std::string in_roff = "\\fB--" + name + "\\fR";
    for (std::size_t at = 3; (at = in_roff.find('-', at)) != std::string::npos; at += 2) {
      in_roff.insert(at, "\\");
    }
    const bool is_flag = option.kind == cli::OptionKind::flag;
    BOOST_TEST(contains(man, in_roff), in_roff);
    BOOST_TEST(contains(zsh, "'--" + name + (is_flag ? "[" : "=[")), name);
    BOOST_TEST(contains(fish, " -l " + name + " "), name);
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE(rows)

/// The options that a row needs or excludes exist, in the same commands.
BOOST_AUTO_TEST_CASE(name_options_of_the_same_command) {
  const auto check = [](const cli::Option& option, cli::CommandSet commands,
                        std::string_view other) {
    const cli::Option* const named = cli::find_option(other);
    BOOST_TEST_REQUIRE(named != nullptr, option.name << " names " << other);
    for (const cli::Command command :
         {cli::Command::design, cli::Command::simulate, cli::Command::sweep}) {
      BOOST_TEST((!commands.has(command) || (option.serves(command) && named->serves(command))),
                 option.name << " and " << other << " in " << name(command));
    }
  };
  for (const cli::Option& option : cli::options()) {
    // What is needed may be one of several; the first, which a message names, is in each command.
    if (const cli::Needs& needs = option.traits.needs; !needs.options.empty()) {
      check(option, needs.commands, needs.names().front());
    }
    for (const cli::Excludes& excludes : option.traits.excludes) {
      for (const std::string_view other : excludes.names()) {
        if (!other.empty()) {
          check(option, excludes.commands, other);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_CASE(the_columns_of_a_sweep_have_the_names_of_the_docs) {
  const std::string page = text_of(fs::path(STILLPOINT_DATA_DIR).parent_path() / "docs/sweep.md");
  const std::string row = cli::sweep_columns_row();
  BOOST_TEST((page.find("\n" + row) != std::string::npos), "made now:\n" << row);
}

/// Tables between empty lines.
BOOST_AUTO_TEST_CASE(the_tables_of_the_docs_match_the_library) {
  const std::string page = text_of(fs::path(STILLPOINT_DATA_DIR).parent_path() / "docs/reports.md");
  const std::string tables = cli::motion_tables();
  const std::string gap = "\n\n";
  BOOST_TEST_REQUIRE(tables.find(gap) != std::string::npos);
  for (std::size_t from = 0; from < tables.size();) {
    const std::size_t to = std::min(tables.find(gap, from), tables.size() - 1);
    const std::string table = tables.substr(from, to + 1 - from);
    BOOST_TEST((page.find("\n" + table + "\n") != std::string::npos), "made now:\n" << table);
    from = to + gap.size();
  }
}

BOOST_AUTO_TEST_SUITE_END()
