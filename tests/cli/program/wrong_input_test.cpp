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
  return joined({"design", "--velocity", "0.4", "--max-displacement", "0.16"}, more);
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
    {"v0_zero", with(design(), "--v0", "0"), {"v0 = 0", "from 1e-150"}},
    {"v0_negative", with(design(), "--v0", "-1"), {"v0 = -1", "from 1e-150"}},
    {"v0_too_large", with(design(), "--v0", "1e151"), {"v0 = 1e+151", "to 1e+150"}},
    {"p_zero", with(design(), "--p", "0"), {"p = 0", "from 1e-150"}},
    {"p_negative", with(region(), "--p", "-2"), {"p = -2", "from 1e-150"}},
    {"p_of_simulate_zero", with(simulate(), "--p", "0"), {"p = 0", "from 1e-150"}},
    {"beta_zero", with(design(), "--beta", "0"), {"beta = 0", "from 1e-300"}},
    {"beta_negative", with(region(), "--beta", "-0.9"), {"beta = -0.9", "from 1e-300"}},
    {"beta_far_from_v0", with(design(), "--beta", "1e-120"), {"beta = 1e-120", "1e-100"}},
    {"v0_of_simulate_too_small", with(simulate(), "--v0", "1e-200"), {"v0 = 1e-200", "1e-150"}},
    {"range_of_v0_reversed", with(design(), "--v0", "2:1"), {"v0 = 2:1", "LOW <= HIGH"}},
    {"range_of_three", with(design(), "--v0", "1:2:3"), {"v0 = 1:2:3", "LOW:HIGH"}},
    {"range_with_nan", with(design(), "--v0", "nan:1"), {"v0 = \"nan\"", "finite"}},
    {"range_of_p_from_0", with(region(), "--p", "0:1"), {"p = 0", "from 1e-150"}},
    {"range_below_0", with(region(), "--v0", "-1:1"), {"v0 = -1:1", "0 <= LOW"}},
    {"range_of_simulate", with(simulate(), "--v0", "1:2"), {"v0 = \"1:2\"", "number"}},
    {"range_of_periods_from_0",
     {"design", "--velocity", "1", "--period", "0:3", "--max-displacement", "1"},
     {"period = 0", "from 1e-30"}},
    {"residual_negative", design({"--residual", "-1"}), {"residual = -1", "from 0"}},
    {"residual_with_a_pulse",
     {"design", "--pulse", "half-sine", "--k", "0.5", "--lambda", "20", "--p", "1", "--beta",
      "0.05", "--residual", "0.01"},
     {"pulse", "residual"}},
    {"no_arrivals", design({"--arrivals", "0"}), {"arrivals = 0", "from 1 to 1000"}},
    {"far_too_many_arrivals", design({"--arrivals", "1000000000"}), {"arrivals", "from 1 to 1000"}},
    {"tolerance_f_beside_1", design({"--tolerance-f", "1.2:1.3"}), {"tolerance-f", "LOW <= 1"}},
    {"tolerance_delta_of_1",
     design({"--tolerance-delta", "1"}),
     {"tolerance-delta", "less than 1"}},
    {"no_tolerance_at_all", design({"--tolerance-f", "0"}), {"tolerance-f = 0", "above 0"}},
    {"x0_too_large", simulate({"--x0", "1e301"}), {"x0 = 1e+301", "1e+300"}},
    {"f_negative", with(simulate(), "--f", "-0.1"), {"f = -0.1", "from 0"}},
    {"delta_negative", with(simulate(), "--delta", "-0.1"), {"delta = -0.1", "from 0"}},
    {"hold_negative", simulate({"--hold", "-0.1"}), {"hold = -0.1", "from 0"}},
    {"hold_not_a_number", simulate({"--hold", "nan"}), {"hold = \"nan\"", "finite"}},
    {"notch_width_zero", simulate({"--notch-width", "0"}), {"notch-width = 0", "from 1e-150"}},
    {"notch_width_of_design", design({"--notch-width", "-1"}), {"notch-width = -1", "1e-150"}},
    {"hold_and_width",
     simulate({"--hold", "0.1", "--notch-width", "0.1"}),
     {"hold", "notch-width", "exclude each other"}},
    {"zones_fall",
     simulate({"--friction-zones", "0.2:0.1,0.1:0.3"}),
     {"friction-zones 2: to = 0.1", "greater", "0.2"}},
    {"zone_without_friction",
     simulate({"--friction-zones", "0.2:0.1,0.3"}),
     {"friction-zones 2 = 0.3", "X:F"}},
    {"zone_of_negative_friction",
     simulate({"--friction-zones", "0.2:-0.1"}),
     {"friction-zones 1: f = -0.1", "from 0"}},
    {"zones_in_no_length",
     {"simulate", "--velocity", "1", "--period", "1", "--f", "0", "--delta-m", "0",
      "--friction-zones", "20ms:0.1"},
     {"friction-zones 1: to = \"20ms\"", "m, cm or mm"}},
    {"zones_with_a_unit_of_a_dimensionless_motion",
     simulate({"--friction-zones", "20mm:0.1"}),
     {"friction-zones 1: to = \"20mm\"", "without a unit"}},
    {"notch_of_a_sweep_of_designs",
     {"sweep", "--v0", "1", "--p", "1", "--beta", "0.8", "--notch-width", "0.1"},
     {"beta and notch-width exclude each other"}},
    {"zones_of_a_sweep_of_designs",
     {"sweep", "--v0", "1", "--p", "1", "--beta", "0.8", "--friction-zones", "0.1:0.1"},
     {"beta and friction-zones exclude each other"}},
    {"f_of_region_negative", region({"--f", "-1"}), {"f = -1", "from 0"}},
    {"delta_of_region_negative", region({"--f", "0.3", "--delta", "-1"}), {"delta = -1", "from 0"}},
    {"f_max_zero", design({"--f-max", "0"}), {"f_max = 0", "from 1e-300"}},
    {"f_max_negative", design({"--f-max", "-1"}), {"f_max = -1", "from 1e-300"}},
    {"delta_max_m_zero",
     {"design", "--velocity", "1", "--period", "3", "--max-displacement", "1", "--delta-max-m",
      "0"},
     {"delta-max-m = 0", "from"}},
    {"acceleration_max_zero",
     design({"--acceleration-max", "0"}),
     {"acceleration_max = 0", "from 1e-300"}},
    {"delta_max_zero", design({"--delta-max", "0"}), {"delta_max = 0", "from 1e-300"}},
    {"tolerance_one", design({"--tolerance", "1"}), {"tolerance = 1", "less than 1"}},
    {"tolerance_negative", design({"--tolerance", "-0.1"}), {"tolerance = -0.1", "at least 0"}},
    {"tolerance_of_region", region({"--tolerance", "2"}), {"tolerance = 2", "less than 1"}},
    {"velocity_zero",
     with(physical({"--period", "3"}), "--velocity", "0"),
     {"velocity = 0", "from 1e-30"}},
    {"velocity_negative",
     with(physical({"--period", "3"}), "--velocity", "-0.4"),
     {"velocity = -0.4", "from 1e-30"}},
    {"max_displacement_zero",
     with(physical({"--period", "3"}), "--max-displacement", "0"),
     {"max-displacement = 0"}},
    {"max_displacement_negative",
     with(physical({"--period", "3"}), "--max-displacement", "-0.1"),
     {"max-displacement = -0.1"}},
    {"period_zero", physical({"--period", "0"}), {"period = 0", "from 1e-30"}},
    {"period_negative", physical({"--period", "-3"}), {"period = -3", "from 1e-30"}},
    {"stiffness_negative",
     physical({"--stiffness", "-1", "--mass", "1"}),
     {"stiffness = -1", "from 1e-30"}},
    {"mass_zero", physical({"--period", "3", "--mass", "0"}), {"mass = 0", "from 1e-30"}},
    {"gravity_zero", physical({"--period", "3", "--gravity", "0"}), {"gravity = 0", "from 1e-30"}},
    {"gravity_negative", physical({"--period", "3", "--gravity", "-9.8"}), {"gravity = -9.8"}},
    {"delta_m_negative",
     {"simulate", "--velocity", "1", "--period", "3", "--f", "0.1", "--delta-m", "-1"},
     {"delta-m = -1", "from 0"}},
    {"samples_one",
     simulate({"--trajectory", "t.csv", "--samples", "1"}),
     {"samples = 1", "from 2 to 1000000"}},
    {"samples_too_many",
     simulate({"--trajectory", "t.csv", "--samples", "10000001"}),
     {"samples = 10000001", "from 2 to 1000000"}},
    {"samples_not_whole",
     simulate({"--trajectory", "t.csv", "--samples", "3.5"}),
     {"samples = \"3.5\"", "whole number"}},
    {"max_half_cycles_negative",
     simulate({"--max-half-cycles", "-1"}),
     {"max-half-cycles = -1", "from 0"}},
    {"half_cycle_limit_zero",
     simulate({"--half-cycle-limit", "0"}),
     {"half-cycle-limit = 0", "from 1"}},
    {"t_end_zero", simulate({"--trajectory", "t.csv", "--t-end", "0"}), {"t-end = 0"}},
    {"t_end_negative", simulate({"--trajectory", "t.csv", "--t-end", "-1"}), {"t-end = -1"}},
    {"objective_unknown",
     design({"--objective", "best"}),
     {"objective = best", "robust, amplitude, time or acceleration"}},
    {"objective_empty", design({"--objective", ""}), {"objective = ", "robust"}},
    {"criterion_unknown",
     region({"--criterion", "Exact"}),
     {"criterion = Exact", "published or exact"}},
    {"algorithm_unknown", design({"--algorithm", "LD_BEST"}), {"algorithm = LD_BEST", "LD_SLSQP"}},
    {"algorithm_of_another_kind",
     design({"--algorithm", "AUGLAG"}),
     {"algorithm = AUGLAG", "LN_COBYLA"}},
    {"algorithm_empty", design({"--algorithm", ""}), {"algorithm", "NLopt"}},
    {"too_many_half_cycles",
     {"simulate", "--v0", "1", "--p", "1", "--f", "1e-200", "--delta", "1e-200"},
     {"f and delta", "half-cycles", "at most 1e+08"}},
    {"too_many_half_cycles_for_its_own_limit",
     simulate({"--half-cycle-limit", "5"}),
     {"f and delta", "half-cycles", "at most 5"}},
    {"too_many_half_cycles_for_a_trajectory",
     {"simulate", "--v0", "1", "--p", "1", "--f", "0", "--delta", "1e-13", "--trajectory", "t.csv"},
     {"half-cycles", "1e+06"}},
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
  for (const char* text : {"1.0", "1e3", "99999999999999999999"}) {
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
                                         std::string_view(error.what()).find(text) !=
                                             std::string_view::npos;
                                });
        }
      }
    }
  }
}

// ---- missing and contradictory

namespace {

const std::vector<Wrong> combinations{
    {"v0_missing", {"design", "--p", "1", "--beta", "1"}, {"v0 is missing", "--velocity"}},
    {"p_missing", {"design", "--v0", "1", "--beta", "1"}, {"p is missing", "--period"}},
    {"beta_missing",
     {"design", "--v0", "1", "--p", "1"},
     {"beta is missing", "--max-displacement"}},
    {"beta_of_region_missing", {"region", "--v0", "1", "--p", "1"}, {"beta is missing"}},
    {"everything_missing", {"design"}, {"v0 is missing"}},
    {"f_missing", {"simulate", "--v0", "1", "--p", "1", "--delta", "1"}, {"f is missing"}},
    {"delta_missing", {"simulate", "--v0", "1", "--p", "1", "--f", "1"}, {"delta is missing"}},
    {"f_of_a_point_missing", region({"--delta", "0.4"}), {"f is missing", "--f"}},
    {"velocity_missing",
     {"design", "--period", "3", "--max-displacement", "1"},
     {"velocity is missing", "m/s"}},
    {"max_displacement_missing",
     {"design", "--period", "3", "--velocity", "1"},
     {"max-displacement is missing"}},
    {"period_missing", physical(), {"period is missing", "stiffness"}},
    {"mass_for_stiffness_missing", physical({"--stiffness", "1e6"}), {"mass is missing"}},
    {"value_missing_at_the_end", {"design", "--v0"}, {"v0", "missing"}},
    {"value_missing_before_a_flag", {"design", "--v0", "--p", "1"}, {"v0"}},
    {"value_missing_behind_an_equals_sign", {"design", "--v0="}, {"v0"}},
    {"v0_and_velocity", design({"--velocity", "2"}), {"v0 and velocity", "exclude each other"}},
    {"p_and_period", design({"--period", "2"}), {"p and period", "exclude each other"}},
    {"p_and_stiffness", design({"--stiffness", "2"}), {"p and stiffness", "exclude each other"}},
    {"beta_and_max_displacement",
     region({"--max-displacement", "2"}),
     {"beta and max-displacement", "exclude each other"}},
    {"period_and_stiffness",
     physical({"--period", "3", "--stiffness", "1", "--mass", "1"}),
     {"period and stiffness", "exclude each other"}},
    {"delta_and_delta_m",
     {"simulate", "--velocity", "1", "--period", "3", "--f", "0", "--delta", "1", "--delta-m", "1"},
     {"delta and delta-m", "exclude each other"}},
    {"delta_max_and_delta_max_m",
     physical({"--period", "3", "--delta-max", "1", "--delta-max-m", "1"}),
     {"delta-max and delta-max-m", "exclude each other"}},
    {"x0_and_x0_m",
     {"simulate", "--velocity", "1", "--period", "3", "--f", "0", "--delta", "0", "--x0", "1",
      "--x0-m", "1"},
     {"x0 and x0-m", "exclude each other"}},
    {"dimensionless_and_mass", design({"--mass", "3"}), {"v0 and mass", "exclude each other"}},
    {"dimensionless_and_gravity", design({"--gravity", "3"}), {"v0 and gravity", "exclude"}},
    {"dimensionless_and_delta_max_m", design({"--delta-max-m", "1"}), {"v0 and delta-max-m"}},
    {"physical_and_beta",
     {"design", "--velocity", "1", "--period", "3", "--beta", "1"},
     {"beta and velocity", "exclude each other"}},
    {"physical_and_x0",
     {"simulate", "--velocity", "1", "--period", "3", "--f", "0", "--delta", "0", "--x0", "1"},
     {"x0 and velocity", "exclude each other"}},
    {"samples_without_trajectory", simulate({"--samples", "10"}), {"samples", "--trajectory"}},
    {"t_end_without_trajectory", simulate({"--t-end", "10"}), {"t-end", "--trajectory"}},
};

}  // namespace

BOOST_DATA_TEST_CASE_F(Sandbox, combination, data::make(combinations), wrong) {
  check_refused(*this, wrong);
}

// ---- the command line itself

namespace {

const std::vector<Wrong> command_lines{
    {"unknown_command",
     {"dezign"},
     {"command dezign", "design, region, simulate, spectrum, sweep, accuracy or init",
      "mean design?"}},
    {"quiet_and_verbose", design({"--quiet", "--verbose"}), {"quiet and verbose"}},
    {"json_and_trajectory_on_standard_output",
     simulate({"--trajectory", "-", "--json"}),
     {"json and the trajectory", "standard output"}},
    {"command_behind_another", design({"region"}), {"region"}},
    {"unknown_option", design({"--betta", "2"}), {"--betta", "unknown option", "mean --beta?"}},
    {"unknown_option_without_a_neighbour", design({"--frobnicate"}), {"--frobnicate", "unknown"}},
    {"unknown_option_with_a_value", design({"--vv0=2"}), {"--vv0=2", "mean --v0?"}},
    {"unknown_short_option", design({"-x"}), {"-x", "unknown option"}},
    {"unknown_option_of_the_program",
     {"--frobnicate"},
     {"--frobnicate: an option comes after its command: design, region"}},
    {"abbreviated_option", design({"--tol", "0.1"}), {"--tol", "unknown option"}},
    {"option_of_another_command", design({"--x0", "1"}), {"--x0", "not an option of design"}},
    {"option_of_design_for_simulate", simulate({"--beta", "1"}), {"--beta", "simulate"}},
    {"option_of_design_for_region", region({"--objective", "time"}), {"--objective", "region"}},
    {"option_twice", design({"--v0", "2"}), {"--v0", "2 times", "only once"}},
    {"text_option_twice",
     design({"--objective", "time", "--objective", "time"}),
     {"--objective", "2 times"}},
    {"output_twice", design({"--output", "a", "--output", "b"}), {"--output", "2 times"}},
    {"flag_twice", design({"--json", "--json"}), {"--json", "2 times"}},
    {"flag_with_a_value", design({"--json=maybe"}), {"--json", "maybe"}},
    {"two_scenes", {"design", "old.json", "old.json"}, {"old.json", "only one scene"}},
    {"value_with_a_line_break", design({"--objective", "a\nb"}), {"objective", "robust"}},
};

}  // namespace

BOOST_DATA_TEST_CASE_F(Sandbox, command_line, data::make(command_lines), wrong) {
  check_refused(*this, wrong);
}

BOOST_FIXTURE_TEST_CASE(commands_that_take_no_options_say_what_they_take, Sandbox) {
  check_refusal(run({"help", "swep"}), {"command swep", "mean sweep?"});
  check_refusal(run({"help", "sweep", "design"}), {"help sweep", "one command"});
  check_refusal(run({"init", "bulding"}),
                {"init = bulding", "building, machine or equipment", "mean building?"});
  check_refusal(run({"init", "building", "machine"}), {"machine", "unexpected"});
  check_refusal(run({"init", "--json"}), {"--json", "not an option of init"});
}

// ---- sweeps

namespace {

Arguments sweep(const Arguments& more) {
  return joined({"sweep", "--v0", "1", "--p", "1"}, more);
}

Arguments sweep_designs(const char* hits) {
  return {"sweep", "--v0", hits, "--p", "1", "--beta", "2"};
}

Wrong axis(const char* name, const char* text, const Texts& says) {
  return {name, sweep({"--delta", "0", "--f", text}), says};
}

Wrong forced(const char* name, const Arguments& more, const Texts& says) {
  return {name, joined(sweep({"--f", "0.1", "--delta", "0,1"}), more), says};
}

const std::vector<Wrong> sweeps{
    axis("axis_without_a_count", "0:1", {"f = 0:1", "first:last:count"}),
    axis("axis_with_too_many_parts", "0:1:2:3", {"f = 0:1:2:3", "first:last:count:log"}),
    axis("axis_of_no_number", "a:1:2", {"f = \"a\"", "finite number"}),
    axis("axis_with_a_gap", "0.1,,0.2", {"f = \"\"", "finite number"}),
    axis("axis_with_a_fraction_of_a_value", "0:1:2.5", {"f = \"2.5\"", "whole number"}),
    axis("axis_of_nothing", "0:1:0", {"f = 0:1:0", "count from 1"}),
    axis("axis_logarithmic_from_zero", "0:1:3:log", {"f = 0:1:3:log", "above 0"}),
    axis("axis_longer_than_a_double", "-1e308:1e308:3", {"f = -1e308", "length"}),
    axis("axis_with_a_negative_end", "0.1:-0.1:3",
         {"stillpoint: f = -0.1: must be a number from 0"}),
    axis("one_negative_value", "-1", {"stillpoint: f = -1: must be a number from 0"}),
    {"range_of_hits_of_motions",
     {"sweep", "--v0", "0.9:1.1", "--p", "1", "--f", "0.1", "--delta", "0.1"},
     {"v0 = 0.9:1.1", "first:last:count", "for designs"}},
    {"range_the_wrong_way_round", sweep_designs("2:1"), {"v0 = 2:1", "0 <= LOW <= HIGH"}},
    {"range_in_a_list_of_ranges", sweep_designs("1,3:2"), {"v0 = 3:2", "0 <= LOW <= HIGH"}},
    {"range_of_no_number", sweep_designs("nan:1"), {"v0 = \"nan\"", "finite number"}},
    {"range_beyond_a_speed", sweep_designs("1,1e-200:1"), {"v0_low = 1e-200", "from 1e-150"}},
    {"arrivals_that_are_no_count",
     sweep({"--beta", "1", "--arrivals", "1:4:3"}),
     {"arrivals = 2.5", "whole number from 1 to 1000"}},
    {"arrivals_beyond_counting",
     sweep({"--beta", "1", "--arrivals", "1e9"}),
     {"arrivals = 1000000000", "whole number from 1 to 1000"}},
    {"sweep_of_a_negative_residual",
     sweep({"--beta", "1", "--residual", "0,-1"}),
     {"residual = -1", "from 0"}},
    {"residual_of_motions",
     sweep({"--f", "1", "--delta", "1", "--residual", "1"}),
     {"residual is for designs"}},
    {"range_in_a_list_the_wrong_way_round",
     {"sweep", "--p", "1", "--beta", "1", "--list", "-"},
     {"line 2", "v0_low = 2: must be at most v0 = 1"},
     "v0,v0_low\n1,2\n"},
    {"range_of_periods_in_a_list_the_wrong_way_round",
     {"sweep", "--velocity", "1", "--max-displacement", "1", "--list", "-"},
     {"line 2", "period_low = 3: must be at most period = 2"},
     "period,period_low\n2,3\n"},
    {"range_in_a_list_and_as_an_option",
     {"sweep", "--v0", "0.9:1", "--p", "1", "--beta", "1", "--list", "-"},
     {"v0 = 0.9:1", "is a column of the list as well"},
     "v0_low\n1\n"},
    {"velocity_and_pulse_of_a_sweep",
     sweep({"--beta", "1", "--pulse", "half-sine", "--k", "1", "--lambda", "1"}),
     {"v0 and pulse exclude each other"}},
    {"k_of_a_sweep_without_a_pulse",
     sweep({"--beta", "1", "--k", "1"}),
     {"k is for a pulse", "--pulse"}},
    {"pulse_of_a_sweep_without_lambda",
     {"sweep", "--p", "1", "--beta", "1", "--pulse", "half-sine", "--k", "1"},
     {"lambda is missing"}},
    {"pulse_of_a_sweep_with_a_residual",
     {"sweep", "--p", "1", "--beta", "1", "--pulse", "half-sine", "--k", "1", "--lambda", "1",
      "--residual", "0.1"},
     {"pulse = half-sine", "residual"}},
    {"pulse_of_motions",
     {"sweep", "--p", "1", "--f", "1", "--delta", "1", "--pulse", "half-sine", "--k", "1"},
     {"pulse is for designs"}},
    forced("k_of_an_excitation_as_an_axis",
           {"--excitation", "half-sine", "--k", "1,2", "--lambda", "1"},
           {"k = 1,2", "one number for motions"}),
    forced("lambda_of_an_excitation_as_a_range",
           {"--excitation", "half-sine", "--k", "1", "--lambda", "1:2"},
           {"lambda = 1:2", "one number for motions"}),
    {"lambda_in_a_list_without_a_pulse",
     sweep({"--beta", "1", "--list", "-"}),
     {"lambda-high = an input: must be left out without a pulse"},
     "lambda_high\n1\n"},
    {"hits_in_a_list_with_a_pulse",
     {"sweep", "--p", "1", "--beta", "1", "--pulse", "half-sine", "--k", "1", "--lambda", "1",
      "--list", "-"},
     {"v0-low = an input: must be left out with a pulse"},
     "v0_low\n1\n"},
    {"k_in_a_list_without_a_pulse",
     sweep({"--beta", "1", "--list", "-"}),
     {"k = an input: must be left out without a pulse"},
     "k\n1\n"},
    {"range_in_a_list_of_motions",
     {"sweep", "--v0", "1", "--p", "1", "--delta", "1", "--list", "-"},
     {"v0_low", "not an input of a free sweep"},
     "v0_low,f\n1,1\n"},
    {"wrong_tolerance_of_one_side",
     sweep({"--beta", "0.9", "--tolerance-f", "1.1:1.2"}),
     {"tolerance-f = 1.1:1.2", "LOW <= 1"}},
    {"trade_off_of_a_sweep",
     sweep({"--beta", "0.9", "--trade-off", "5"}),
     {"--trade-off: is not an option of sweep"}},
    {"grid_beyond_counting",
     sweep({"--f", "0:1:1000000000", "--delta", "0:1:10000000"}),
     {"grid", "more than 1000000000000000"}},
    {"f_missing", sweep({"--delta", "0"}), {"f is missing", "first:last:count"}},
    {"v0_missing", {"sweep", "--p", "1", "--f", "1", "--delta", "1"}, {"v0 is missing"}},
    {"beta_and_f", sweep({"--f", "1", "--beta", "1"}), {"beta and f exclude each other"}},
    {"beta_and_excitation",
     sweep({"--beta", "1", "--excitation", "harmonic"}),
     {"beta and excitation exclude"}},
    {"wrong_beta", sweep({"--beta", "0.9,-1"}), {"beta = -1", "from 1e-300"}},
    {"wrong_tolerance", sweep({"--beta", "0.9", "--tolerance", "2"}), {"tolerance = 2"}},
    forced("tolerance_without_beta", {"--tolerance", "0.1"}, {"tolerance is for designs"}),
    forced("objective_without_beta", {"--objective", "time"}, {"objective is for designs"}),
    forced("t_end_without_an_excitation", {"--t-end", "9"}, {"t-end is for an excitation"}),
    forced("k_without_an_excitation", {"--k", "9"}, {"k is for an excitation"}),
    forced("harmonic_for_ever", {"--excitation", "harmonic", "--k", "1", "--lambda", "1"},
           {"t-end is missing", "never ends"}),
    forced("wrong_lambda", {"--excitation", "full-sine", "--k", "1", "--lambda", "0"},
           {"lambda = 0"}),
    forced("record_that_does_not_exist", {"--record", "none.txt"}, {"none.txt", "No such file"}),
    forced("wrong_format", {"--format", "xls"}, {"format = xls", "csv or npy"}),
    forced("unknown_column", {"--columns", "f,fast"}, {"columns", "\"fast\"", "peak_amplitude"}),
    forced("column_of_another_kind", {"--columns", "sticks"},
           {"columns = \"sticks\"", "must be among"}),
    forced("no_columns", {"--columns", ""}, {"columns", "\"\""}),
    forced("column_twice", {"--columns", "f,f"}, {"columns = f", "twice"}),
    forced("columns_and_times", {"--columns", "f", "--times"}, {"columns and times exclude"}),
    forced("no_threads", {"--threads", "0"}, {"threads = 0", "from 1 to 1024"}),
    forced("list_format_without_a_list", {"--list-format", "csv"}, {"give --list FILE"}),
    forced("list_that_does_not_exist", {"--list", "none.csv"}, {"none.csv", "No such file"}),
    {"wrong_list_format",
     {"sweep", "--list", "-", "--list-format", "xml"},
     {"list-format = xml", "csv or jsonl"},
     "f,delta\n"},
    {"range_beside_a_list",
     {"sweep", "--v0", "1", "--p", "1,2", "--list", "-"},
     {"p = 1,2", "one number beside a list"},
     "f,delta\n1,1\n"},
    {"beta_column_and_f",
     sweep({"--f", "1", "--list", "-"}),
     {"beta and f exclude each other"},
     "beta\n1\n"},
    {"list_and_scene_on_standard_input",
     {"sweep", "-", "--list", "-"},
     {"scene and the list", "standard input"},
     "f,delta\n1,1\n"},
    {"physical_option", sweep({"--period", "1"}), {"p and period", "exclude each other"}},
    {"axis_for_simulate", with(simulate(), "--f", "0:1:2"), {"f = \"0:1:2\"", "finite number"}},
    {"scene_with_an_axis_of_texts",
     {"sweep", "-"},
     {"f = [\"1\"]", "an array of numbers"},
     R"({"v0": 1, "p": 1, "delta": 0, "f": ["1"]})"},
    {"scene_with_an_empty_axis",
     {"sweep", "-"},
     {"f = []", "an array of numbers"},
     R"({"v0": 1, "p": 1, "delta": 0, "f": []})"},
};

}  // namespace

BOOST_DATA_TEST_CASE_F(Sandbox, sweep_input, data::make(sweeps), wrong) {
  check_refused(*this, wrong);
}

BOOST_FIXTURE_TEST_SUITE(sweep_output, Sandbox)

BOOST_AUTO_TEST_CASE(that_cannot_be) {
  const auto entries = [](const Arguments& more) {
    return joined(sweep({"--f", "0.1", "--delta", "0,1"}), more);
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
  Surroundings list;
  list.input = "f,delta\n1,1\n";
  check_refusal(run(sweep({"--list", "-", "--format", "npy"}), list),
                {"format = npy", "an output file for a list"});
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
