// SPDX-License-Identifier: MIT
#include "options/command_line.hpp"
#include "options/options.hpp"
#include "refusal.hpp"
#include "run_program.hpp"
#include "wrong_arguments.hpp"

#include <stillpoint/core/input_error.hpp>

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(wrong_input_test)

namespace {

using namespace stillpoint::cli_test;
using namespace stillpoint::cli_test::right;
namespace cli = stillpoint::cli;
namespace data = boost::unit_test::data;

Arguments physical(const Arguments& more = {}) {
  return joined("design --velocity 0.4 --max-displacement 0.16", more);
}

/// `arguments` with the value of `option` replaced.
Arguments with(Arguments arguments, const char* option, const char* value) {
  const auto found = std::ranges::find(arguments, option);
  *(found + 1) = value;
  return arguments;
}

}  // namespace

// ---- values

namespace {

const std::vector<Wrong> values{
    {with(design(), "--v0", "0"), {"v0 = 0", "from 1e-150"}},
    {with(design(), "--v0", "-1"), {"v0 = -1", "from 1e-150"}},
    {with(design(), "--v0", "1e151"), {"v0 = 1e+151", "to 1e+150"}},
    {with(design(), "--p", "0"), {"p = 0", "from 1e-150"}},
    {with(region(), "--p", "-2"), {"p = -2", "from 1e-150"}},
    {with(simulate(), "--p", "0"), {"p = 0", "from 1e-150"}},
    {with(design(), "--beta", "0"), {"beta = 0", "from 1e-300"}},
    {with(region(), "--beta", "-0.9"), {"beta = -0.9", "from 1e-300"}},
    {with(design(), "--beta", "1e-120"), {"beta = 1e-120", "1e-100"}},
    {with(simulate(), "--v0", "1e-200"), {"v0 = 1e-200", "1e-150"}},
    {with(design(), "--v0", "2:1"), {"v0 = 2:1", "LOW <= HIGH"}},
    {with(design(), "--v0", "1:2:3"), {"v0 = 1:2:3", "LOW:HIGH"}},
    {with(design(), "--v0", "1:"), {"v0 = 1:", "LOW:HIGH"}},
    {with(region(), "--p", ":1"), {"p = :1", "LOW:HIGH"}},
    {with(design(), "--v0", "nan:1"), {"v0 = \"nan\"", "finite"}},
    {with(region(), "--p", "0:1"), {"p = 0", "from 1e-150"}},
    {with(region(), "--v0", "-1:1"), {"v0 = -1:1", "0 <= LOW"}},
    {with(simulate(), "--v0", "1:2"), {"v0 = \"1:2\"", "one number, not a range"}},
    {with(design(), "--beta", "0.8:0.9"), {"beta = \"0.8:0.9\"", "one number, not a range"}},
    {design("--residual 0:1"), {"residual = \"0:1\"", "one number, not a range"}},
    {"design --velocity 1 --period 0:3 --max-displacement 1", {"period = 0", "from 1e-30"}},
    {design("--residual -1"), {"residual = -1", "from 0"}},
    {"design --pulse half-sine --k 0.5 --lambda 20 --p 1 --beta 0.05 --residual 0.01",
     {"pulse", "residual"}},
    {design("--arrivals 0"), {"arrivals = 0", "from 1 to 1000"}},
    {design("--arrivals 1000000000"), {"arrivals = 1000000000", "whole number from 1 to 1000"}},
    {design("--arrivals 1e9"), {"arrivals = 1000000000: must be a whole number from 1 to 1000"}},
    {design("--arrivals -1"), {"arrivals = -1", "from 1 to 1000"}},
    {design("--arrivals 1.5"), {"arrivals = 1.5: must be a whole number"}},
    {design("--arrivals 1e20"), {"arrivals = 1e20", "at most 18 digits"}},
    {design("--arrivals 3:4"), {"arrivals = \"3:4\": must be a whole number"}},
    {design("--tolerance-f 1.2:1.3"), {"tolerance-f", "LOW <= 1"}},
    {design("--tolerance-delta 1"), {"tolerance-delta", "less than 1"}},
    {design("--tolerance-f 0"), {"tolerance-f = 0", "above 0"}},
    {simulate("--x0 1e301"), {"x0 = 1e+301", "1e+300"}},
    {with(simulate(), "--f", "-0.1"), {"f = -0.1", "from 0"}},
    {with(simulate(), "--delta", "-0.1"), {"delta = -0.1", "from 0"}},
    {simulate("--hold -0.1"), {"hold = -0.1", "from 0"}},
    {simulate("--hold nan"), {"hold = \"nan\"", "finite"}},
    {simulate("--notch-width 0"), {"notch-width = 0", "from 1e-150"}},
    {design("--notch-width -1"), {"notch-width = -1", "1e-150"}},
    {simulate("--hold 0.1 --notch-width 0.1"), {"hold", "notch-width", "exclude each other"}},
    {simulate("--friction-zones 0.2:0.1,0.1:0.3"),
     {"friction-zones 2: to = 0.1", "greater", "0.2"}},
    {simulate("--friction-zones 0.2:0.1,0.3"), {"friction-zones 2 = 0.3", "X:F"}},
    {simulate("--friction-zones 0.2:-0.1"), {"friction-zones 1: f = -0.1", "from 0"}},
    {"simulate --velocity 1 --period 1 --f 0 --delta-m 0 --friction-zones 20ms:0.1",
     {"friction-zones 1: to = \"20ms\"", "m, cm or mm"}},
    {simulate("--friction-zones 20mm:0.1"), {"friction-zones 1: to = \"20mm\"", "without a unit"}},
    {"sweep --v0 1 --p 1 --beta 0.8 --notch-width 0.1",
     {"beta and notch-width exclude each other"}},
    {"sweep --v0 1 --p 1 --beta 0.8 --friction-zones 0.1:0.1",
     {"beta and friction-zones exclude each other"}},
    {region("--f -1"), {"f = -1", "from 0"}},
    {region("--f 0.3 --delta -1"), {"delta = -1", "from 0"}},
    {design("--f-max 0"), {"f_max = 0", "from 1e-300"}},
    {design("--f-max -1"), {"f_max = -1", "from 1e-300"}},
    {"design --velocity 1 --period 3 --max-displacement 1 --delta-max-m 0",
     {"delta-max-m = 0", "from"}},
    {design("--acceleration-max 0"), {"acceleration_max = 0", "from 1e-300"}},
    {design("--delta-max 0"), {"delta_max = 0", "from 1e-300"}},
    {design("--tolerance 1"), {"tolerance = 1", "less than 1"}},
    {design("--tolerance -0.1"), {"tolerance = -0.1", "at least 0"}},
    {region("--tolerance 2"), {"tolerance = 2", "less than 1"}},
    {with(physical("--period 3"), "--velocity", "0"), {"velocity = 0", "from 1e-30"}},
    {with(physical("--period 3"), "--velocity", "-0.4"), {"velocity = -0.4", "from 1e-30"}},
    {with(physical("--period 3"), "--max-displacement", "0"), {"max-displacement = 0"}},
    {with(physical("--period 3"), "--max-displacement", "-0.1"), {"max-displacement = -0.1"}},
    {physical("--period 0"), {"period = 0", "from 1e-30"}},
    {physical("--period -3"), {"period = -3", "from 1e-30"}},
    {physical("--stiffness -1 --mass 1"), {"stiffness = -1", "from 1e-30"}},
    {physical("--period 3 --mass 0"), {"mass = 0", "from 1e-30"}},
    {physical("--period 3 --gravity 0"), {"gravity = 0", "from 1e-30"}},
    {physical("--period 3 --gravity -9.8"), {"gravity = -9.8"}},
    {"simulate --velocity 1 --period 3 --f 0.1 --delta-m -1", {"delta-m = -1", "from 0"}},
    {simulate("--trajectory t.csv --samples 1"), {"samples = 1", "from 2 to 1000000"}},
    {simulate("--trajectory t.csv --samples 10000001"),
     {"samples = 10000001", "from 2 to 1000000"}},
    {simulate("--trajectory t.csv --samples 3.5"), {"samples = 3.5", "whole number"}},
    {simulate("--max-half-cycles -1"), {"max-half-cycles = -1", "from 0"}},
    {simulate("--half-cycle-limit 0"), {"half-cycle-limit = 0", "from 1"}},
    {simulate("--trajectory t.csv --t-end 0"), {"t-end = 0"}},
    {simulate("--trajectory t.csv --t-end -1"), {"t-end = -1"}},
    {design("--objective best"), {"objective = best", "robust, amplitude, time or acceleration"}},
    {design({"--objective", ""}), {"objective = ", "robust"}},
    {region("--criterion Exact"), {"criterion = Exact", "published or exact"}},
    {design("--algorithm LD_BEST"), {"algorithm = LD_BEST", "LD_SLSQP"}},
    {design("--algorithm AUGLAG"), {"algorithm = AUGLAG", "LN_COBYLA"}},
    {design({"--algorithm", ""}), {"algorithm", "NLopt"}},
    {"simulate --v0 1 --p 1 --f 1e-200 --delta 1e-200",
     {"f and delta", "half-cycles", "at most 1e+08"}},
    {simulate("--half-cycle-limit 5"), {"f and delta", "half-cycles", "at most 5"}},
    {"simulate --v0 1 --p 1 --f 0 --delta 1e-13 --trajectory t.csv", {"half-cycles", "1e+06"}},
};

}  // namespace

BOOST_DATA_TEST_CASE_F(Sandbox, value, data::make(values), wrong) {
  check_refused(*this, wrong);
}

namespace {

void check_no_number(const Sandbox& sandbox, std::string_view command, std::string_view option,
                     const std::string& text) {
  BOOST_TEST_CONTEXT(command << " --" << option << " " << text) {
    const std::string name(option);
    check_refusal(sandbox.run({std::string(command), "--" + name, text}),
                  {name + " = ", text, "must "});
  }
}

}  // namespace

BOOST_FIXTURE_TEST_CASE(no_text_is_taken_for_a_number, Sandbox) {
  const Texts texts{"",    "abc", "nan", "NAN", "inf",  "-inf", "infinity", "1,5",   "1 2",
                    "0x3", "1e",  "--",  " 1",  "1.5m", "∞",    "1e400",    "-1e400"};
  for (const std::string& text : texts) {
    check_no_number(*this, "design", "v0", text);
    check_no_number(*this, "simulate", "samples", text);
  }
  for (const char* text : {"1.5", "1e-3", "99999999999999999999"}) {
    check_no_number(*this, "simulate", "samples", text);
  }
  BOOST_TEST(contents().empty());
}

/// Of every option of every command, so many that no process is started for each.
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

// ---- missing and contradictory

namespace {

const std::vector<Wrong> combinations{
    {"design --p 1 --beta 1", {"v0 is missing", "--velocity"}},
    {"design --v0 1 --beta 1", {"p is missing", "--period"}},
    {"design --v0 1 --p 1", {"beta is missing", "--max-displacement"}},
    {"region --v0 1 --p 1", {"beta is missing"}},
    {{"design"}, {"v0 is missing"}},
    {"simulate --v0 1 --p 1 --delta 1", {"f is missing"}},
    {"simulate --v0 1 --p 1 --f 1", {"delta is missing"}},
    {region("--delta 0.4"), {"f is missing", "--f"}},
    {"design --period 3 --max-displacement 1", {"velocity is missing", "m/s"}},
    {"design --period 3 --velocity 1", {"max-displacement is missing"}},
    {physical(), {"period is missing", "stiffness"}},
    {physical("--stiffness 1e6"), {"mass is missing"}},
    {"design --v0", {"v0", "missing"}},
    {"design --v0 --p 1", {"v0"}},
    {"design --v0=", {"v0"}},
    {design("--velocity 2"), {"v0 and velocity", "exclude each other"}},
    {design("--period 2"), {"p and period", "exclude each other"}},
    {design("--stiffness 2"), {"p and stiffness", "exclude each other"}},
    {region("--max-displacement 2"), {"beta and max-displacement", "exclude each other"}},
    {physical("--period 3 --stiffness 1 --mass 1"), {"period and stiffness", "exclude each other"}},
    {"simulate --velocity 1 --period 3 --f 0 --delta 1 --delta-m 1",
     {"delta and delta-m", "exclude each other"}},
    {physical("--period 3 --delta-max 1 --delta-max-m 1"),
     {"delta-max and delta-max-m", "exclude each other"}},
    {"simulate --velocity 1 --period 3 --f 0 --delta 0 --x0 1 --x0-m 1",
     {"x0 and x0-m", "exclude each other"}},
    {design("--mass 3"), {"v0 and mass", "exclude each other"}},
    {design("--gravity 3"), {"v0 and gravity", "exclude"}},
    {design("--delta-max-m 1"), {"v0 and delta-max-m"}},
    {"design --velocity 1 --period 3 --beta 1", {"beta and velocity", "exclude each other"}},
    {"simulate --velocity 1 --period 3 --f 0 --delta 0 --x0 1",
     {"x0 and velocity", "exclude each other"}},
    {simulate("--samples 10"), {"samples", "--trajectory"}},
    {simulate("--t-end 10"), {"t-end", "--trajectory"}},
};

}  // namespace

BOOST_DATA_TEST_CASE_F(Sandbox, combination, data::make(combinations), wrong) {
  check_refused(*this, wrong);
}

// ---- the command line itself

namespace {

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
    {design("--x0 1"), {"--x0", "not an option of design"}},
    {simulate("--beta 1"), {"--beta", "simulate"}},
    {region("--objective time"), {"--objective", "region"}},
    {design("--v0 2"), {"--v0", "2 times", "only once"}},
    {design("--objective time --objective time"), {"--objective", "2 times"}},
    {design("--output a --output b"), {"--output", "2 times"}},
    {design("--json --json"), {"--json", "2 times"}},
    {design("--json=maybe"), {"--json", "maybe"}},
    {"design old.json old.json", {"old.json", "only one scene"}},
    {design({"--objective", "a\nb"}), {"objective", "robust"}},
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
  check_refusal(run("init building machine"), {"machine", "unexpected"});
  check_refusal(run("init --json"), {"--json", "not an option of init"});
}

// ---- sweeps

namespace {

Arguments sweep(const Arguments& more) {
  return joined("sweep --v0 1 --p 1", more);
}

Arguments sweep_designs(const char* hits) {
  return {"sweep", "--v0", hits, "--p", "1", "--beta", "2"};
}

Wrong axis(const char* text, const Texts& says) {
  return {sweep({"--delta", "0", "--f", text}), says};
}

Wrong forced(const Arguments& more, const Texts& says) {
  return {joined(sweep("--f 0.1 --delta 0,1"), more), says};
}

const std::vector<Wrong> sweeps{
    axis("0:1", {"f = 0:1", "first:last:count"}),
    axis("0:1:2:3", {"f = 0:1:2:3", "first:last:count:log"}),
    axis("a:1:2", {"f = \"a\"", "finite number"}),
    axis("0.1,,0.2", {"f = \"\"", "finite number"}),
    axis("0:1:2.5", {"f = 2.5", "whole number"}),
    axis("0:1:0", {"f = 0:1:0", "count from 1"}),
    axis("0:1:3:log", {"f = 0:1:3:log", "above 0"}),
    axis("-1e308:1e308:3", {"f = -1e308", "length"}),
    axis("0.1:-0.1:3", {"stillpoint: f = -0.1: must be a number from 0"}),
    axis("-1", {"stillpoint: f = -1: must be a number from 0"}),
    {"sweep --v0 0.9:1.1 --p 1 --f 0.1 --delta 0.1",
     {"v0 = 0.9:1.1", "first:last:count", "for designs"}},
    {sweep_designs("2:1"), {"v0 = 2:1", "0 <= LOW <= HIGH"}},
    {sweep_designs("1,3:2"), {"v0 = 3:2", "0 <= LOW <= HIGH"}},
    {sweep_designs("nan:1"), {"v0 = \"nan\"", "finite number"}},
    {sweep_designs("1,1e-200:1"), {"v0_low = 1e-200", "from 1e-150"}},
    {sweep("--beta 1 --arrivals 1:4:3"), {"arrivals = 2.5", "whole number from 1 to 1000"}},
    {sweep("--beta 1 --arrivals 1e9"), {"arrivals = 1000000000", "whole number from 1 to 1000"}},
    {sweep("--beta 1 --residual 0,-1"), {"residual = -1", "from 0"}},
    {sweep("--f 1 --delta 1 --residual 1"), {"residual is for designs"}},
    {"sweep --p 1 --beta 1 --list -",
     {"line 2", "v0_low = 2: must be at most v0 = 1"},
     "v0,v0_low\n1,2\n"},
    {"sweep --velocity 1 --max-displacement 1 --list -",
     {"line 2", "period_low = 3: must be at most period = 2"},
     "period,period_low\n2,3\n"},
    {"sweep --v0 0.9:1 --p 1 --beta 1 --list -",
     {"v0 = 0.9:1", "is a column of the list as well"},
     "v0_low\n1\n"},
    {sweep("--beta 1 --pulse half-sine --k 1 --lambda 1"), {"v0 and pulse exclude each other"}},
    {sweep("--beta 1 --k 1"), {"k is for a pulse", "--pulse"}},
    {"sweep --p 1 --beta 1 --pulse half-sine --k 1", {"lambda is missing"}},
    {"sweep --p 1 --beta 1 --pulse half-sine --k 1 --lambda 1 --residual 0.1",
     {"pulse = half-sine", "residual"}},
    {"sweep --p 1 --f 1 --delta 1 --pulse half-sine --k 1", {"pulse is for designs"}},
    forced("--excitation half-sine --k 1,2 --lambda 1", {"k = 1,2", "one number for motions"}),
    forced("--excitation half-sine --k 1 --lambda 1:2", {"lambda = 1:2", "one number for motions"}),
    {sweep("--beta 1 --list -"),
     {"lambda-high = an input: must be left out without a pulse"},
     "lambda_high\n1\n"},
    {"sweep --p 1 --beta 1 --pulse half-sine --k 1 --lambda 1 --list -",
     {"v0-low = an input: must be left out with a pulse"},
     "v0_low\n1\n"},
    {sweep("--beta 1 --list -"), {"k = an input: must be left out without a pulse"}, "k\n1\n"},
    {"sweep --v0 1 --p 1 --delta 1 --list -",
     {"v0_low", "not an input of a free sweep"},
     "v0_low,f\n1,1\n"},
    {sweep("--beta 0.9 --tolerance-f 1.1:1.2"), {"tolerance-f = 1.1:1.2", "LOW <= 1"}},
    {sweep("--f 0:1:1000000000 --delta 0:1:10000000"), {"grid", "more than 1000000000000000"}},
    {sweep("--delta 0"), {"f is missing", "first:last:count"}},
    {"sweep --p 1 --f 1 --delta 1", {"v0 is missing"}},
    {sweep("--f 1 --beta 1"), {"beta and f exclude each other"}},
    {sweep("--beta 1 --excitation harmonic"), {"beta and excitation exclude"}},
    {sweep("--beta 0.9,-1"), {"beta = -1", "from 1e-300"}},
    {sweep("--beta 0.9 --tolerance 2"), {"tolerance = 2"}},
    forced("--tolerance 0.1", {"tolerance is for designs"}),
    forced("--objective time", {"objective is for designs"}),
    forced("--t-end 9", {"t-end is for an excitation"}),
    forced("--k 9", {"k is for an excitation"}),
    forced("--excitation harmonic --k 1 --lambda 1", {"t-end is missing", "never ends"}),
    forced("--excitation full-sine --k 1 --lambda 0", {"lambda = 0"}),
    forced("--record none.txt", {"none.txt", "No such file"}),
    forced("--format xls", {"format = xls", "csv or npy"}),
    forced("--columns f,fast", {"columns", "\"fast\"", "peak_amplitude"}),
    forced("--columns sticks", {"columns = \"sticks\"", "must be among"}),
    forced({"--columns", ""}, {"columns", "\"\""}),
    forced("--columns f,f", {"columns = f", "twice"}),
    forced("--columns f --times", {"columns and times exclude"}),
    forced("--threads 0", {"threads = 0", "from 1 to 1024"}),
    forced("--list-format csv", {"give --list FILE"}),
    forced("--list none.csv", {"none.csv", "No such file"}),
    {"sweep --list - --list-format xml", {"list-format = xml", "csv or jsonl"}, "f,delta\n"},
    {"sweep --v0 1 --p 1,2 --list -", {"p = 1,2", "one number beside a list"}, "f,delta\n1,1\n"},
    {sweep("--f 1 --list -"), {"beta and f exclude each other"}, "beta\n1\n"},
    {"sweep - --list -", {"scene and the list", "standard input"}, "f,delta\n1,1\n"},
    {sweep("--period 1"), {"p and period", "exclude each other"}},
    {with(simulate(), "--f", "0:1:2"), {"f = \"0:1:2\"", "one number, not a range"}},
    {"sweep -",
     {"f = [\"1\"]", "an array of numbers"},
     R"({"v0": 1, "p": 1, "delta": 0, "f": ["1"]})"},
    {"sweep -", {"f = []", "an array of numbers"}, R"({"v0": 1, "p": 1, "delta": 0, "f": []})"},
};

}  // namespace

BOOST_DATA_TEST_CASE_F(Sandbox, sweep_input, data::make(sweeps), wrong) {
  check_refused(*this, wrong);
}

BOOST_FIXTURE_TEST_SUITE(sweep_output, Sandbox)

BOOST_AUTO_TEST_CASE(that_cannot_be) {
  const auto entries = [](const Arguments& more) {
    return joined(sweep("--f 0.1 --delta 0,1"), more);
  };
  for (const auto& [more, says] : std::vector<std::pair<Arguments, Texts>>{
           {{"--json"}, {"json and the rows", "give --output FILE"}},
           {{"--resume"}, {"resume = true", "an output file"}},
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

BOOST_AUTO_TEST_SUITE_END()
