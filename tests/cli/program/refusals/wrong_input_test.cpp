// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "options/command_line.hpp"

#include <unistd.h>

BOOST_AUTO_TEST_SUITE(wrong_input_test)

using namespace stillpoint::cli_test;
namespace cli = stillpoint::cli;

/// For every option of every command, too many to start a process for each.
BOOST_AUTO_TEST_CASE(no_option_takes_a_text_for_a_number) {
  for (const cli::Option& option : cli::options()) {
    if (option.kind != cli::OptionKind::number && option.kind != cli::OptionKind::integer) {
      continue;
    }
    for (const cli::Command command : {cli::Command::design, cli::Command::region,
                                       cli::Command::simulate, cli::Command::sweep}) {
      if (option.serves(command)) {
        for (const std::string text : {"nan", "1e400"}) {
          const std::array words{std::string("stillpoint"), std::string(cli::name(command)),
                                 "--" + std::string(option.name), text};
          const std::array pointers{words[0].c_str(), words[1].c_str(), words[2].c_str(),
                                    words[3].c_str()};
          BOOST_CHECK_EXCEPTION(static_cast<void>(cli::parse_command_line(
                                    static_cast<int>(pointers.size()), pointers.data())),
                                stillpoint::InputError, [&](const stillpoint::InputError& error) {
                                  return error.field() == option.name &&
                                         contains(std::string_view(error.what()), text);
                                });
        }
      }
    }
  }
}

// Files that only some users may read or write; the others are in commands/sessions/files.txt.

BOOST_FIXTURE_TEST_CASE(a_scene_that_cannot_be_opened_is_refused, Sandbox) {
  write("secret.json", R"({"v0": 1, "p": 1, "beta": 0.9})");
  fs::permissions(path("secret.json"), fs::perms::none);
  if (::access(path("secret.json").c_str(), R_OK) == 0) {
    BOOST_TEST_MESSAGE("skipped: this user may read every file");
    return;
  }
  check_refused(*this, {"design secret.json", {"secret.json", "Permission denied"}});
}

BOOST_FIXTURE_TEST_CASE(a_directory_that_takes_no_file_is_refused, Sandbox) {
  fs::create_directory(path("sealed"));
  fs::permissions(path("sealed"), fs::perms::owner_read | fs::perms::owner_exec);
  if (::access(path("sealed").c_str(), W_OK) == 0) {
    BOOST_TEST_MESSAGE("skipped: this user may write everywhere");
    return;
  }
  check_refused(*this, {"design --v0 1 --p 1 --beta 0.9 --output sealed/new.json",
                        {"output", "sealed/new.json"}});
}

BOOST_AUTO_TEST_SUITE_END()
