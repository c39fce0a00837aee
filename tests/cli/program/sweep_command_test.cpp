// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "wrong_arguments.hpp"

BOOST_FIXTURE_TEST_SUITE(sweep_command_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;
using right::sweep;

SweepTable table_of(const ProgramRun& run) {
  BOOST_TEST_REQUIRE(run.exit_code == 0, run.err);
  return read_csv(run.out);
}

/// A text of a report, or a number to the last bit, as a sweep writes it; "" for null.
bool is_same(const json& reported, const std::string& written) {
  if (reported.is_null()) {
    return written.empty();
  }
  if (reported.is_string()) {
    return written == reported.get_ref<const std::string&>();
  }
  if (reported.is_boolean()) {
    return written == (reported.get<bool>() ? "true" : "false");
  }
  return !written.empty() && std::stod(written) == reported.get<double>();
}

/// Asserts that the columns of a row are those of a report's object.
void check_row(const SweepTable& table, std::size_t row, const json& reported,
               const Arguments& columns) {
  for (const std::string& column : columns) {
    BOOST_TEST(is_same(reported.at(column), table.at(row, column)),
               column << ": " << table.at(row, column) << " in the sweep, " << reported.at(column)
                      << " in the report");
  }
}

/// A sweep of motions, whose rows must have these columns of what `simulate` reports.
SweepTable check_motions(const Sandbox& sandbox, const Arguments& fixed, const Arguments& axes,
                         const Arguments& columns) {
  return check_rows(sandbox, "simulate", fixed, axes,
                    [&](const SweepTable& table, std::size_t row, const json& report) {
                      check_row(table, row, report.at("response"), columns);
                    });
}

/// A sweep of problems, of which some have the damper that `design` reports and some have none.
SweepTable check_designs(const Sandbox& sandbox, const Arguments& fixed, const Arguments& axes) {
  std::size_t designs = 0;
  SweepTable all =
      check_rows(sandbox, "design", fixed, axes,
                 [&](const SweepTable& table, std::size_t row, const json& report) {
                   const bool found = report.at("design").is_object();
                   designs += found ? 1U : 0U;
                   BOOST_TEST((table.at(row, "feasible") == "true") == found);
                   if (found) {
                     check_row(table, row, report.at("design"), "f delta tolerance arrival");
                     check_row(table, row, motion_of(report).at("response"),
                               "peak_amplitude stop_position stop_time peak_absolute_acceleration");
                   } else {
                     BOOST_TEST((table.at(row, "f").empty() && table.at(row, "arrival").empty()));
                   }
                 });
  BOOST_TEST((designs > 0 && designs < all.rows.size()));
  return all;
}

const std::string design_columns =
    "feasible,f,delta,tolerance,arrival,peak_amplitude,stop_position,stop_time,"
    "peak_absolute_acceleration";

const Arguments free_columns("peak_amplitude half_cycles outcome stop_position stop_time");

BOOST_AUTO_TEST_CASE(matches_simulate_and_varies_its_last_axis_first) {
  const Arguments fs("0 0.02 0.4");
  const Arguments deltas("0 0.03 0.7");
  const SweepTable table = check_motions(*this, "--v0 1 --p 1",
                                         "--f 0,0.02,0.4 --delta 0,0.03,0.7 --times", free_columns);
  BOOST_TEST((table.columns == "f delta" + free_columns));
  BOOST_TEST_REQUIRE(table.rows.size() == 9U);
  for (std::size_t row = 0; row < 9; ++row) {
    BOOST_TEST(table.at(row, "f") == fs[row / 3]);
    BOOST_TEST(table.at(row, "delta") == deltas[row % 3]);
  }
  BOOST_TEST(table.at(0, "outcome") == "never_stops");
  BOOST_TEST(table.at(2, "outcome") == "caught_at_start");
  BOOST_TEST(table.at(3, "outcome") == "stopped_in_dead_zone");
}

BOOST_AUTO_TEST_CASE(has_the_transmitted_acceleration_if_asked_for) {
  for (const char* x0 : {"0", "0.5"}) {  // in lanes, and one by one
    check_motions(*this, {"--v0", "1", "--p", "1", "--x0", x0},
                  "--f 0,0.02,0.4 --delta 0.03,0.7 --columns f,delta,peak-absolute-acceleration",
                  "peak_absolute_acceleration");
  }
}

BOOST_AUTO_TEST_CASE(may_have_axes_of_the_start_and_the_spring) {
  const SweepTable table = check_motions(
      *this, "--f 0.05", "--delta 0.01,0.02 --x0 -1:1:3 --p 1,2 --v0 0.5,1 --times", free_columns);
  BOOST_TEST((table.columns == "v0 p x0 delta" + free_columns));
  BOOST_TEST(table.rows.size() == 24U);
}

BOOST_AUTO_TEST_CASE(may_have_axes_of_the_damping_and_the_breakaway_friction) {
  const Arguments axes("--delta 0,0.02 --damping 0,5%,0.3 --breakaway 1,1.5");
  const Arguments columns = free_columns + "peak_absolute_acceleration";
  const SweepTable table = check_motions(*this, "--v0 1 --p 1 --f 0.05", axes + "--times", columns);
  BOOST_TEST((table.columns == "delta damping breakaway" + columns));
  BOOST_TEST_REQUIRE(table.rows.size() == 12U);
  BOOST_TEST(table.at(2, "damping") == "0.05");
  BOOST_TEST(table.at(0, "peak_amplitude") != table.at(2, "peak_amplitude"));
  check_motions(*this, "--p 1 --f 0.05 --excitation half-sine --k 0.3 --lambda 0.8", axes,
                "peak_amplitude half_cycles outcome final_position");
}

BOOST_AUTO_TEST_CASE(of_forced_motions_has_the_metrics_of_simulate) {
  const Arguments forced("--p 1 --excitation harmonic --k 0.2 --lambda 0.35");
  const Arguments columns = free_columns +
                            "end_time final_position final_velocity sticks stick_time "
                            "peak_absolute_acceleration locked_from largest_load_while_locked";
  std::size_t locked = 0;
  for (const char* until : {"--t-end 100", "--duration 20"}) {
    const SweepTable table =
        check_motions(*this, forced + until, "--f 0.05,0.18,0.3 --delta 0,0.01 --times", columns);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      locked += table.at(row, "locked_from").empty() ? 0U : 1U;
    }
  }
  BOOST_TEST((locked > 0 && locked < 12));
}

BOOST_AUTO_TEST_CASE(of_problems_has_the_designs_of_design) {
  write("parts.csv", "name,f,delta\na,0.26,0.37\nb,0.1,0.4\nc,0.05,0.2\nd,0.25,0.33\n");
  const Arguments hit("--v0 1 --p 1");
  const Arguments hits("--v0 0.9:1.1 --p 0.95:1.05 --criterion exact");
  for (const Arguments& task :
       std::vector<Arguments>{hit + "--tolerance 0.05 --objective time --criterion exact",
                              hit + "--arrivals 3 --f-max 0.1",
                              hit + "--catalogue parts.csv",
                              hit + "--catalogue parts.csv --arrivals 2 --f-max 0.2",
                              hits,
                              hits + "--arrivals 2 --residual 0.05",
                              {"--v0", "0:1", "--p", "1", "--criterion", "exact"},
                              hits + "--catalogue parts.csv --residual 0.05",
                              hit + "--residual 0.1 --arrivals 4 --objective time",
                              hit + "--tolerance-f 0.8:1.3 --tolerance-delta 0.05",
                              hit + "--tolerance 0.1 --tolerance-delta 0.95:1"}) {
    check_designs(*this, task,
                  {"--beta", "0.6,0.85,0.95,1.3", "--columns", "beta," + design_columns});
  }
}

/// Of a tolerance only what was searched is known, and 0 is for closed forms.
BOOST_AUTO_TEST_CASE(of_problems_has_the_designs_for_a_damped_mass) {
  write("parts.csv", "name,f,delta\na,0.26,0.37\nb,0.1,0.4\n");
  const auto check = [&](const Arguments& fixed, const Arguments& axes) {
    check_designs(*this, fixed,
                  axes + Arguments{"--columns", "beta,damping,breakaway," + design_columns});
  };
  check("--v0 1 --p 1 --criterion exact", "--beta 0.5,0.9 --damping 0,5% --breakaway 1");
  check("--v0 0.9:1 --p 0.95:1 --objective amplitude --tolerance 0.05",
        "--beta 0.5,1 --damping 5% --breakaway 1.5");
  check("--v0 1 --p 1 --catalogue parts.csv", "--beta 0.5,0.9 --damping 5% --breakaway 1");
  check("--pulse half-sine --k 0.5 --lambda 2 --p 1 --tolerance-f 0.8:1.1",
        "--beta 0.1,0.6 --damping 5% --breakaway 1");
}

BOOST_AUTO_TEST_CASE(ranges_residuals_and_arrivals_are_axes) {
  const SweepTable table =
      check_designs(*this, "--beta 0.75 --criterion exact",
                    "--v0 1,0.9:1.1,0:1 --p 1:1,0.9:1.1 --residual 0:0.1:2 --arrivals 1,3 --times");
  BOOST_TEST_REQUIRE(table.rows.size() == 24U);
  const Arguments inputs("v0 v0_low p p_high residual arrivals");
  BOOST_TEST((Arguments(table.columns.begin(), table.columns.begin() + 6) == inputs));
  BOOST_TEST((table.at(23, "v0") == "1" && table.at(23, "v0_low") == "0"));
}

BOOST_AUTO_TEST_CASE(columns_of_a_list_are_the_ends_of_ranges) {
  write("hits.csv", "v0_low,v0,p_high,residual,arrivals\n0.9,1.1,1.05,0.05,1\n0,1,1,0,2\n");
  const Arguments asked = Arguments("--beta 2 --criterion exact --columns") +
                          Arguments{"feasible,f,delta,tolerance,arrival"};
  const Arguments first("--v0 0.9:1.1 --p 1:1.05 --residual 0.05");
  const Arguments second("--v0 0:1 --p 1 --residual 0 --arrivals 2");
  const std::vector<std::vector<std::string>> expected{
      table_of(run("sweep" + first + asked)).rows.at(0),
      table_of(run("sweep" + second + asked)).rows.at(0)};
  BOOST_TEST((table_of(run("sweep --p 1 --list hits.csv" + asked)).rows == expected));
}

BOOST_AUTO_TEST_CASE(of_problems_takes_a_pulse_instead_of_the_velocity) {
  const Arguments task("--pulse half-sine --p 1 --beta 0.6 --tolerance 0.1");
  const SweepTable table =
      check_designs(*this, task,
                    {"--k", "0.2,0.4:0.5,1.5", "--lambda", "2,1.8:2.2", "--columns",
                     "k,k_low,lambda,lambda_high," + design_columns});
  BOOST_TEST_REQUIRE(table.rows.size() == 6U);
  write("pulses.csv", "k,lambda,lambda_high\n0.2,1.8,2.2\n");
  const SweepTable listed =
      table_of(run("sweep --list pulses.csv --columns f,delta,tolerance" + task));
  for (const std::string& column : listed.columns) {
    BOOST_TEST(listed.at(0, column) == table.at(1, column));
  }
}

BOOST_AUTO_TEST_CASE(scenes_have_axes_of_ranges) {
  write("scene.json", R"({"v0": [1, [0.9, 1.1], "0:1"], "p": "0.95:1.05", "beta": 2,
                          "tolerance_f": [0.8, 1.2], "residual": [0, 0.1]})");
  const ProgramRun flags = succeed(
      "sweep --v0 1,0.9:1.1,0:1 --p 0.95:1.05 --beta 2 --tolerance-f 0.8:1.2 --residual 0,0.1");
  BOOST_TEST(run("sweep scene.json").out == flags.out);
}

BOOST_AUTO_TEST_CASE(does_not_depend_on_the_threads) {
  for (const Arguments& more :
       {Arguments("--f 0:0.3:60 --delta 0:0.5:70 --times"),
        Arguments("--f 0:0.3:20 --delta 0:0.1:15 --x0 0.5"),
        Arguments("--f 0:0.3:20 --delta 0:0.1:15 --excitation full-sine --k 0.3 --lambda 0.7")}) {
    const ProgramRun one = succeed(sweep(more + "--threads 1"));
    BOOST_TEST(one.out.size() > 10'000U);
    for (const char* threads : {"2", "7"}) {
      BOOST_TEST((run(sweep(more + Arguments{"--threads", threads})).out == one.out));
    }
  }
  const Arguments designs("--beta 0.6:1.2:40");
  BOOST_TEST((run(sweep(designs + "--threads 1")).out == run(sweep(designs + "--threads 3")).out));
}

BOOST_AUTO_TEST_SUITE_END()
