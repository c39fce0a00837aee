// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_FIXTURE_TEST_SUITE(written_files_test, stillpoint::cli_test::Sandbox)

// What is refused is in commands/refused/written.txt.

using namespace stillpoint::cli_test;

BOOST_AUTO_TEST_CASE(under_any_name_are_never_files_that_are_read) {
  const Arguments shaken("simulate --v0 1 --p 1 --f 0.1 --delta 0.1 --record r.txt");
  write("r.txt", small_record);
  check_refusal(run(shaken + Arguments{"--output", path("r.txt").string()}),
                {"output /", "record r.txt"});
  // Nor those that a scene names.
  const std::string text = R"({"v0": 1, "p": 1, "beta": 0.9, "output": "s.json"})";
  write("s.json", text);
  check_refusal(run("design s.json"), {"output s.json", "scene s.json"});
  BOOST_TEST(read("s.json") == text);
  succeed("design s.json --output other.json");
}

// An old report may be replaced, also one of the same name elsewhere; a device takes everything.
BOOST_AUTO_TEST_CASE(are_written_where_nothing_is_lost) {
  const Arguments simulate("simulate --v0 1 --p 1 --f 0.1 --delta 0.1");
  write("r.txt", small_record);
  fs::create_directory(path("d"));
  for (const char* const files :
       {"--record r.txt --output d/r.txt", "--record r.txt --output d/r.txt",
        "--svg d --output d/map.svg", "--trajectory /dev/null --output /dev/null",
        "--trajectory /dev/stdout --output /dev/stdout"}) {
    succeed(simulate + files);
  }
  BOOST_TEST(read("r.txt") == small_record);
}

BOOST_AUTO_TEST_CASE(figures_of_each_case_have_names) {
  const Arguments damper("region --period 2.8 --f 0.02 --delta-m 2mm --svg d --cases");
  (void)succeed(damper + Arguments{R"([{"name": "a", "velocity": 0.2, "max_displacement": 0.3},
                                       {"name": "b", "velocity": 0.3, "max_displacement": 0.3}])"});
  BOOST_TEST(fs::exists(path("d/case-2-record-1.svg")));
}

BOOST_AUTO_TEST_SUITE_END()
