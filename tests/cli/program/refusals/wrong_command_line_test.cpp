// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "wrong_arguments.hpp"

BOOST_AUTO_TEST_SUITE(wrong_command_line_test)

namespace {

using namespace stillpoint::cli_test;
using namespace stillpoint::cli_test::right;

const std::vector<Wrong> command_lines{
    {{"dezign"},
     {"command dezign", "design, region, simulate, spectrum, sweep, accuracy, init or explore",
      "mean design?"}},
    {design("--quiet --verbose"), {"quiet and verbose"}},
    {simulate("--trajectory - --json"), {"json and the trajectory", "standard output"}},
    {design("region"), {"region"}},
    {design("--betta 2"), {"--betta", "unknown option", "mean --beta?"}},
    {design("--frobnicate"), {"--frobnicate", "unknown"}},
    {design("--vv0=2"), {"--vv0=2", "mean --v0?"}},
    {design("-x"), {"-x", "unknown option"}},
    {{"--frobnicate"}, {"--frobnicate: an option comes after its command: design, region"}},
    {design("--tol 0.1"), {"--tol", "unknown option"}},
    {design("--v0 2"), {"--v0", "2 times", "only once"}},
    {design("--json --json"), {"--json", "2 times"}},
    {design("--json=maybe"), {"--json = maybe", "takes no value"}},
    {design("-v0 2"), {"-v0: an option begins with two dashes: --v0"}},
    {design("--stroke 2"), {"--stroke: unknown option; did you mean --max-displacement?"}},
    {design("--f 0.2"), {"--f: is not an option of design", "region judges a given damper"}},
    {simulate("--pulse half-sine"), {"--pulse", "simulate", "a motion takes --excitation"}},
    {"design --velocity 400 mm/s", {"mm/s: a unit must follow its number without a space: 1mm/s"}},
    {"region scene.json --f 0.02 --delta-m 6 mm", {"mm: a unit must follow its number without"}},
    {"design old.json old.json", {"old.json", "only one scene"}},
};

}  // namespace

BOOST_DATA_TEST_CASE_F(Sandbox, command_line, data::make(command_lines), wrong) {
  check_refused(*this, wrong);
}

BOOST_FIXTURE_TEST_CASE(commands_that_take_no_options_say_what_they_take, Sandbox) {
  check_refusal(run("help swep"), {"command swep", "mean sweep?"});
  check_refusal(
      run("region --friction-zones 0.1:0.1"),
      {"--friction-zones: is not an option of region, only of simulate, sweep, accuracy"});
  check_refusal(run("helpp"), {"command helpp", "mean help?"});
  check_refusal(run("help hlep"), {"command hlep", "mean help?"});
  check_refusal(run("help sweep design"), {"help sweep", "one command"});
  check_refusal(run("init bulding"),
                {"init = bulding", "building, machine or equipment", "mean building?"});
  check_refusal(run("init building machine"), {"machine: unexpected, only one word"});
  check_refusal(run("scene.json"), {"command scene.json", "did you mean design scene.json?"});
  for (const char* const merge : {"sweep merge", "sweep merge out.csv"}) {
    check_refusal(run(merge), {"merge needs the file to write and the file of each part"});
  }
  check_refusal(run("design --part 1/2"), {"--part: is not an option of design, only of sweep"});
  check_refusal(run("init --json"), {"--json", "not an option of init"});
}

BOOST_AUTO_TEST_SUITE_END()
