// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "wrong_arguments.hpp"

BOOST_FIXTURE_TEST_SUITE(wrong_sweep_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;
using namespace stillpoint::cli_test::right;

BOOST_AUTO_TEST_CASE(that_cannot_be) {
  const auto entries = [](const Arguments& more) { return sweep("--f 0.1 --delta 0,1") + more; };
  for (const auto& [more, says] : std::vector<std::pair<Arguments, Texts>>{
           {{"--json"}, {"json and the rows", "give --output FILE"}},
           {{"--resume"}, {"output is missing", "resume continues the file"}},
           {{"--output", ""}, {"output = \"\"", "name of a file"}},
           {{"--output", "-"}, {"output = -"}},
           {{"--output", "."}, {"output .", "directory"}},
           {{"--output", "no/where.csv"}, {"output no/where.csv", "No such file"}},
           {{"--output", "/dev/full"}, {"output /dev/full", "No space left"}}}) {
    check_refusal(run(entries(more)), says);
    BOOST_TEST(contents().empty());
  }
  check_refusal(run(entries({}), to_a_full_device), {"standard output", "No space left"});
  const Surroundings list{.input = "f,delta\n1,1\n"};
  check_refusal(run(sweep("--list - --format npy"), list),
                {"format = npy", "an output file for a list"});
}

BOOST_AUTO_TEST_SUITE_END()
