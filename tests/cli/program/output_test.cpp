// SPDX-License-Identifier: MIT
// The colours of a report; where it is written is in commands/sessions/files.txt.
#include "cli_test.hpp"

BOOST_FIXTURE_TEST_SUITE(output_test, stillpoint::cli_test::Sandbox,
                         *boost::unit_test::precondition(stillpoint::cli_test::if_terminals))

using namespace stillpoint::cli_test;

const Arguments hit("design --v0 1 --p 1 --beta 0.9");

bool has_escapes(const std::string& text) {
  return text.find('\x1b') != std::string::npos;
}

const Surroundings on_terminal{.output_is_terminal = true};

const std::vector<Arguments> reports{hit, "design --v0 1 --p 1 --beta 0.6",
                                     "region --v0 1 --p 1 --beta 0.8 --f 0.3 --delta 0.01",
                                     "simulate --v0 1 --p 1 --f 0.02 --delta 0.02"};

BOOST_AUTO_TEST_CASE(only_on_a_terminal) {
  for (const Arguments& arguments : reports) {
    BOOST_TEST(!has_escapes(run(arguments).out));
    BOOST_TEST(has_escapes(run(arguments, on_terminal).out));
  }
}

BOOST_AUTO_TEST_CASE(as_the_environment_says) {
  const auto coloured = [&](const Arguments& arguments, const char* name, const char* value) {
    const std::string text =
        run(arguments, {.environment = {{name, value}}, .output_is_terminal = true}).out;
    BOOST_TEST(!text.empty());
    return has_escapes(text);
  };
  for (const Arguments& arguments : reports) {
    BOOST_TEST(!coloured(arguments, "NO_COLOR", "1"));
  }
  BOOST_TEST(coloured(hit, "NO_COLOR", ""));
  BOOST_TEST(!coloured(hit, "TERM", "dumb"));
}

BOOST_AUTO_TEST_CASE(not_in_json) {
  const ProgramRun answer = run(hit + "--json", on_terminal);
  BOOST_TEST(!has_escapes(answer.out));
  BOOST_TEST(answer.json()["schema"] == "stillpoint/design-report/2");
}

BOOST_AUTO_TEST_CASE(not_in_the_file_beside_a_coloured_report) {
  BOOST_TEST(has_escapes(run(hit + "--output report.json", on_terminal).out));
  BOOST_TEST(!has_escapes(read("report.json")));
}

BOOST_AUTO_TEST_SUITE_END()
