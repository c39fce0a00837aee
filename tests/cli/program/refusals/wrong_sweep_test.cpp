// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "wrong_arguments.hpp"

BOOST_FIXTURE_TEST_SUITE(wrong_sweep_test, stillpoint::cli_test::Sandbox)

namespace {

using namespace stillpoint::cli_test;
using namespace stillpoint::cli_test::right;

Arguments sweep_designs(const char* hits) {
  return {"sweep", "--v0", hits, "--p", "1", "--beta", "2"};
}

Wrong axis(const char* text, const Texts& says) {
  return {sweep({"--delta", "0", "--f", text}), says};
}

Wrong forced(const Arguments& more, const Texts& says) {
  return {sweep("--f 0.1 --delta 0,1") + more, says};
}

const std::vector<Wrong> sweeps{
    axis("0:1", {"f = 0:1", "first:last:count"}),
    axis("a:1:2", {"f = \"a\": must be a number"}),
    axis("0.1,,0.2", {"f = \"\": must be a number"}),
    axis("0:1:2.5", {"f = 0:1:2.5: must have a whole count from 1"}),
    axis("0:1:3:log", {"f = 0:1:3:log", "above 0"}),
    axis("-1e308:1e308:3", {"f = -1e308", "length"}),
    axis("0.1:-0.1:3", {"stillpoint: f = -0.1: must be a number from 0"}),
    {"sweep --v0 0.9:1.1 --p 1 --f 0.1 --delta 0.1",
     {"v0 = 0.9:1.1", "first:last:count", "only designs take a range"}},
    {sweep_designs("2:1"), {"v0 = 2:1", "0 <= LOW <= HIGH"}},
    {sweep_designs("1,1e-200:1"), {"v0_low = 1e-200", "from 1e-150"}},
    {sweep("--beta 1 --arrivals 1:4:3"), {"arrivals = 2.5", "whole number from 1 to 1000"}},
    {sweep("--beta 1 --residual 0,-1"), {"residual = -1", "from 0"}},
    {sweep("--f 1 --delta 1 --residual 1"), {"residual needs a design"}},
    {"sweep --p 1 --beta 1 --list -",
     {"line 2", "v0_low = 2: must be at most v0 = 1"},
     "v0,v0_low\n1,2\n"},
    {"sweep --velocity 1 --max-displacement 1 --list -",
     {"line 2", "period_low = 3: must be at most period = 2"},
     "period,period_low\n2,3\n"},
    {"sweep --v0 0.9:1 --p 1 --beta 1 --list -",
     {"v0 = 0.9:1", "is also a column of the list"},
     "v0_low\n1\n"},
    {sweep("--beta 1 --k 1"), {"k needs a pulse", "--pulse"}},
    {"sweep --p 1 --beta 1 --pulse half-sine --k 1", {"lambda is missing"}},
    {"sweep --p 1 --f 1 --delta 1 --pulse half-sine --k 1", {"pulse needs a design"}},
    forced("--excitation half-sine --k 1,2 --lambda 1",
           {"k = 1,2", "one number in a sweep of motions"}),
    forced("--excitation half-sine --k 1 --lambda 1:2",
           {"lambda = 1:2", "one number in a sweep of motions"}),
    {sweep("--beta 1 --list -"),
     {"lambda-high = an input: must be left out without a pulse"},
     "lambda_high\n1\n"},
    {"sweep --p 1 --beta 1 --pulse half-sine --k 1 --lambda 1 --list -",
     {"v0-low = an input: must be left out: the pulse is the hit"},
     "v0_low\n1\n"},
    {sweep("--beta 1 --list -"), {"k = an input: must be left out without a pulse"}, "k\n1\n"},
    {"sweep --v0 1 --p 1 --delta 1 --list -",
     {"v0_low", "not an input of a free sweep"},
     "v0_low,f\n1,1\n"},
    {sweep("--beta 0.9 --tolerance-f 1.1:1.2"), {"tolerance-f = 1.1:1.2", "LOW <= 1"}},
    {sweep("--f 0:1:1000000000 --delta 0:1:10000000"), {"grid", "more than 1000000000000000"}},
    {sweep("--delta 0"), {"f is missing", "first:last:count"}},
    {sweep("--f 1 --delta 1 --reduce --histogram peak_amplitude"),
     {"histogram = \"peak_amplitude\"", "COLUMN:LOW:HIGH:BINS"}},
    {sweep("--f 1 --delta 1 --reduce --best peak_amplitude:2.5"),
     {"best = \"peak_amplitude:2.5\"", "COLUMN:ROWS"}},
    {sweep("--f 1 --delta 1 --reduce --best stop_time:5"),
     {"best = \"stop_time:5\"", "peak_amplitude", "--times and --columns add others"}},
    {sweep("--f 1 --beta 1"), {"beta and f cannot be combined"}},
    {sweep("--beta 1 --excitation harmonic"), {"beta and excitation cannot be combined"}},
    {sweep("--beta 0.9,-1"), {"beta = -1", "from 1e-300"}},
    forced("--tolerance 0.1", {"tolerance needs a design"}),
    forced("--t-end 9", {"t-end needs an excitation"}),
    forced("--k 9", {"k needs an excitation"}),
    forced("--excitation harmonic --k 1 --lambda 1", {"t-end is missing", "never ends"}),
    forced("--excitation full-sine --k 1 --lambda 0", {"lambda = 0"}),
    forced("--format xls", {"format = xls", "csv or npy"}),
    forced("--columns f,fast", {"columns", "\"fast\"", "peak_amplitude"}),
    forced("--columns sticks", {"columns = \"sticks\"", "must be among"}),
    forced({"--columns", ""}, {"columns", "\"\""}),
    forced("--columns f --times", {"columns and times cannot be combined"}),
    forced("--threads 1025", {"threads = 1025", "from 0 to 1024"}),
    forced("--list none.csv", {"none.csv", "No such file"}),
    {"sweep --v0 1 --p 1,2 --list -",
     {"p = 1,2", "one number if there is a list"},
     "f,delta\n1,1\n"},
    {sweep("--f 1 --list -"), {"beta and f cannot be combined"}, "beta\n1\n"},
    {"sweep - --list -", {"scene and the list", "standard input"}, "f,delta\n1,1\n"},
    {"sweep -", {"scene and the list", "standard input"}, R"({"list": "-"})"},
    {sweep("--beta 1 --list - --catalogue -"),
     {"the catalogue and the list", "standard input"},
     ""},
    {with(simulate(), "--f", "0:1:2"), {"f = \"0:1:2\"", "one number, not a range"}},
    {"sweep --v0 1 --p 1 --list -",
     {"line 2: delta = \"?0\": must be a number"},
     {"f,delta\n0.1,\0"
      "0\n",
      15}},
    forced("--reduce --html page.html", {"reduce and html cannot be combined: a map shows"}),
    forced("--part 1/2 --output rows.csv --svg figures",
           {"part and svg cannot be combined: a map"}),
    {"sweep -",
     {"f = [\"1\"]", "an array of numbers"},
     R"({"v0": 1, "p": 1, "delta": 0, "f": ["1"]})"},
};

}  // namespace

BOOST_DATA_TEST_CASE_F(Sandbox, sweep_input, data::make(sweeps), wrong) {
  check_refused(*this, wrong);
}

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
