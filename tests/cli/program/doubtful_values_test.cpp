// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_AUTO_TEST_SUITE(doubtful_values_test)

using namespace stillpoint::cli_test;

BOOST_AUTO_TEST_CASE(each_has_its_warning) {
  for (const Wrong& doubt : commands_in("doubtful.txt")) {
    BOOST_TEST_CONTEXT(doubt) {
      const Sandbox sandbox;
      sandbox.write("load.csv", doubt.files.at("load.csv"));
      const ProgramRun answer = sandbox.run(doubt.arguments);
      BOOST_TEST((answer.exit_code == 0 || answer.exit_code == 3), answer.err);
      BOOST_TEST(!answer.out.empty());
      BOOST_TEST(answer.err_lines().size() == (doubt.says.empty() ? 0U : 1U), answer.err);
      check_contains(answer.err, doubt.says);
      BOOST_TEST((answer.err.empty() || answer.err.starts_with("stillpoint: warning: ")));
      const ProgramRun quiet = sandbox.run(doubt.arguments + "--quiet");
      BOOST_TEST(quiet.err.empty(), quiet.err);
      BOOST_TEST(quiet.out == answer.out);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
