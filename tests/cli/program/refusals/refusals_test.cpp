// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

// Wrong input, reported by field, value and bound: the commands of ../commands/refused.

BOOST_AUTO_TEST_SUITE(refusals_test)

using namespace stillpoint::cli_test;

BOOST_AUTO_TEST_CASE(each_wrong_command_is_refused_with_its_words) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(STILLPOINT_COMMANDS "/refused")) {
    for (const Wrong& wrong : commands_in("refused/" + entry.path().filename().string())) {
      BOOST_TEST_CONTEXT(entry.path().filename() << ": " << wrong) {
        check_refused(Sandbox(), wrong);
        ++count;
      }
    }
  }
  BOOST_TEST(count > 400U);
}

BOOST_FIXTURE_TEST_CASE(commands_that_take_no_output_are_refused_alone, Sandbox) {
  for (const Wrong& wrong : commands_in("refused_alone.txt")) {
    BOOST_TEST_CONTEXT(wrong) {
      check_refusal(run(wrong.arguments, {.input = wrong.input}), wrong.says);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
