// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "options/command_line.hpp"
#include "options/options.hpp"
#include "wrong_arguments.hpp"

BOOST_AUTO_TEST_SUITE(wrong_input_test)

namespace {

using namespace stillpoint::cli_test;
using namespace stillpoint::cli_test::right;
namespace cli = stillpoint::cli;

Arguments physical(const Arguments& more = {}) {
  return "design --velocity 0.4 --max-displacement 0.16" + more;
}

}  // namespace

// ---- values

namespace {

const std::vector<Wrong> values{
    {with(design(), "--v0", "0"), {"v0 = 0", "from 1e-150"}},
    {with(design(), "--p", "0"), {"p = 0", "from 1e-150"}},
    {with(design(), "--beta", "0"), {"beta = 0", "from 1e-300"}},
    {with(design(), "--beta", "1e-120"), {"beta = 1e-120", "1e-100"}},
    {with(design(), "--v0", "2:1"), {"v0 = 2:1", "LOW <= HIGH"}},
    {with(region(), "--v0", "-1:1"), {"v0 = -1:1", "0 <= LOW"}},
    {with(simulate(), "--v0", "1:2"), {"v0 = \"1:2\"", "one number, not a range"}},
    {with(design(), "--beta", "0.8:0.9"), {"beta = \"0.8:0.9\"", "one number, not a range"}},
    {"design --velocity 1 --period 0:3 --max-displacement 1", {"period = 0", "from 1e-30"}},
    {design("--residual -1"), {"residual = -1", "from 0"}},
    {design("--arrivals 1e9"), {"arrivals = 1000000000: must be a whole number from 1 to 1000"}},
    {design("--trade-off 2.5"), {"trade-off = 2.5: must be a whole number from 2 to 1000"}},
    {design("--tolerance-f 1.2:1.3"), {"tolerance-f", "LOW <= 1"}},
    {design("--tolerance-delta 1"), {"tolerance-delta", "less than 1"}},
    {design("--tolerance-f 0"), {"tolerance-f = 0", "above 0"}},
    {simulate("--x0 1e301"), {"x0 = 1e+301", "1e+300"}},
    {with(simulate(), "--f", "-0.1"), {"f = -0.1", "from 0"}},
    {simulate("--hold -0.1"), {"hold = -0.1", "from 0"}},
    {simulate("--notch-width 0"), {"notch-width = 0", "from 1e-150"}},
    {simulate("--hold 0.1 --notch-width 0.1"), {"hold", "notch-width", "cannot be combined"}},
    {simulate("--friction-zones 0.2:0.1,0.1:0.3"),
     {"friction-zones 2: to = 0.1", "greater", "0.2"}},
    {simulate("--friction-zones 0.2:0.1,0.3"), {"friction-zones 2 = 0.3", "X:F"}},
    {simulate("--friction-zones 0.2:-0.1"), {"friction-zones 1: f = -0.1", "from 0"}},
    {"simulate --velocity 1 --period 1 --f 0 --delta-m 0 --friction-zones 20ms:0.1",
     {"friction-zones 1: to = \"20ms\"", "m, cm or mm"}},
    {"simulate --velocity 1 --period 1 --f 0 --delta-m 0 --friction-zones 20mm:0.1,1cm:0.2",
     {"friction-zones 2: to = 1cm: must be greater than the previous edge, 20mm"}},
    {simulate("--friction-zones 20mm:0.1"), {"friction-zones 1: to = \"20mm\"", "without a unit"}},
    {"sweep --v0 1 --p 1 --beta 0.8 --notch-width 0.1",
     {"beta and notch-width cannot be combined"}},
    {"design --velocity 1 --period 3 --max-displacement 1 --delta-max-m -1",
     {"delta-max-m = -1", "from 0"}},
    {design("--acceleration-max 0"), {"acceleration-max = 0", "from 1e-300"}},
    {design("--tolerance 1"), {"tolerance = 1", "less than 1 (0.1 is 10 %)"}},
    {design("--tolerance 10%"), {"tolerance = \"10%\": must be a number; 10 % is 0.1"}},
    {design("--acceleration-max 1m/s2"),
     {"acceleration-max = \"1m/s2\": must be a number in g, with or without the unit g"}},
    {"design --pulse half-sine --k 0.5 --pulse-duration 700 --period 2.8 --max-displacement 1",
     {"pulse-duration = 700 s: must be at most 140 s: a longer pulse cannot be computed"}},
    {"design --pulse full-sine --k 0.5 --excitation-frequency 0.001 --period 2.5"
     " --max-displacement 1",
     {"excitation-frequency = 0.001 Hz: must be at least 0.004 Hz: a longer pulse"}},
    {"simulate --period 2.8 --f 0 --delta-m 0 --excitation harmonic --k 1 --end-time 1"
     " --excitation-frequency 1e20",
     {"excitation-frequency = 1e+20 Hz: makes lambda = 2.8e+20: lambda / p must be"}},
    {with(physical("--period 3"), "--velocity", "-0.4"),
     {"velocity = -0.4 m/s: must be from 1e-30 to 1e+30 m/s"}},
    {with(physical("--period 3"), "--max-displacement", "0"), {"max-displacement = 0"}},
    {physical("--period 0"), {"period = 0", "from 1e-30"}},
    {physical("--period 3 --gravity 0"), {"gravity = 0", "from 1e-30"}},
    {"simulate --velocity 1 --period 3 --f 0.1 --delta-m -1", {"delta-m = -1", "from 0"}},
    {simulate("--trajectory t.csv --samples 1"), {"samples = 1", "from 2 to 1000000"}},
    {simulate("--half-cycle-limit 0"), {"half-cycle-limit = 0", "from 1"}},
    {design("--objective best"), {"objective = best", "robust, amplitude, time or acceleration"}},
    {design({"--objective", ""}), {"objective = \"\"", "time or acceleration\n"}},
    {design("--objective amplitud"), {"or acceleration; did you mean amplitude?\n"}},
    {design("--objective acc"), {"or acceleration; did you mean acceleration?\n"}},
    {design("--objective a"), {"or acceleration\n"}},  // two begin so
    {region("--criterion Exact"), {"criterion = Exact", "published or exact; did you mean exact?"}},
    {design({"--algorithm", ""}), {"algorithm = \"\"", "LD_SLSQP"}},
    {"simulate --v0 1 --p 1 --f 1e-200 --delta 1e-200",
     {"f and delta", "half-cycles", "at most 1e+08"}},
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
  const Texts texts{"",    "abc", "nan", "NAN", "inf",  "-inf", "infinity", "1,5",
                    "1 2", "0x3", "1e",  " 1",  "1.5m", "∞",    "1e400",    "-1e400"};
  for (const std::string& text : texts) {
    check_no_number(*this, "design", "v0", text);
    check_no_number(*this, "simulate", "samples", text);
  }
  for (const char* text : {"1.5", "1e-3", "99999999999999999999"}) {
    check_no_number(*this, "simulate", "samples", text);
  }
  BOOST_TEST(contents().empty());
}

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

// ---- missing and contradictory

namespace {

const std::vector<Wrong> combinations{
    {"design --p 1 --beta 1", {"v0 is missing", "--velocity"}},
    {"design --v0 1 --beta 1", {"p is missing", "--period"}},
    {"design --v0 1 --p 1", {"beta is missing", "--max-displacement"}},
    {"simulate --v0 1 --p 1 --delta 1", {"f is missing"}},
    {"simulate --velocity 1 --period 1 --f 1", {"delta-m is missing: give --delta-m,"}},
    {region("--delta 0.4"), {"f is missing", "give f as well"}},
    {"design --period 3 --max-displacement 1", {"velocity is missing", "m/s"}},
    {physical(), {"period is missing", "stiffness"}},
    {physical("--stiffness 1e6"), {"mass is missing"}},
    {"design --v0", {"--v0 needs a value: --v0 V"}},
    {design("--velocity 2"), {"v0 and velocity", "cannot be combined"}},
    {design("--period 2"), {"p and period", "cannot be combined"}},
    {physical("--period 3 --stiffness 1 --mass 1"), {"period and stiffness", "cannot be combined"}},
    {"simulate --velocity 1 --period 3 --f 0 --delta 1 --delta-m 1",
     {"delta and delta-m", "cannot be combined"}},
    {physical("--period 3 --delta-max 1 --delta-max-m 1"),
     {"delta-max and delta-max-m", "cannot be combined"}},
    {"simulate --velocity 1 --period 3 --f 0 --delta 0 --x0 1 --x0-m 1",
     {"x0 and x0-m", "cannot be combined"}},
    {design("--delta-max-m 1"), {"v0 and delta-max-m"}},
    {"design --velocity 1 --period 3 --beta 1", {"beta and velocity", "cannot be combined"}},
    {"simulate --velocity 1 --period 3 --f 0 --delta 0 --x0 1",
     {"x0 and velocity", "cannot be combined"}},
    {simulate("--samples 10"), {"samples", "--trajectory"}},
};

}  // namespace

BOOST_DATA_TEST_CASE_F(Sandbox, combination, data::make(combinations), wrong) {
  check_refused(*this, wrong);
}

BOOST_AUTO_TEST_SUITE_END()
