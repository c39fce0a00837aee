// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_FIXTURE_TEST_SUITE(sweep_command_test, stillpoint::cli_test::Sandbox)

namespace {

using namespace stillpoint::cli_test;

Arguments sweep(const Arguments& more = {}) {
  return "sweep --v0 1 --p 1" + more;
}

SweepTable table_of(const ProgramRun& run) {
  BOOST_TEST_REQUIRE(run.exit_code == 0, run.err);
  BOOST_TEST(run.err.empty(), run.err);
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

/// Asserts that a row has what `design` reports with these options; true if that is a damper.
bool check_design(const SweepTable& table, std::size_t row, const json& report) {
  const bool found = report.at("design").is_object();
  BOOST_TEST((table.at(row, "feasible") == "true") == found);
  if (found) {
    check_row(table, row, report.at("design"), "f delta tolerance arrival");
    check_row(table, row, report.at("response"),
              "peak_amplitude stop_position stop_time peak_absolute_acceleration");
  } else {
    BOOST_TEST((table.at(row, "f").empty() && table.at(row, "arrival").empty()));
  }
  return found;
}

/// The same of each row and the command alone(row); how many of them are dampers.
template <class Alone>
int check_designs(const Sandbox& sandbox, const SweepTable& table, const Alone& alone) {
  int designs = 0;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const ProgramRun found = sandbox.run(alone(row) + "--json");
    designs += check_design(table, row, found.json()) ? 1 : 0;
  }
  return designs;
}

const std::string design_columns =
    "feasible,f,delta,tolerance,arrival,peak_amplitude,stop_position,stop_time,"
    "peak_absolute_acceleration";

const Arguments free_columns("peak_amplitude half_cycles outcome stop_position stop_time");

}  // namespace

BOOST_AUTO_TEST_CASE(matches_simulate_and_varies_its_last_axis_first) {
  const Arguments fs("0 0.02 0.4");
  const Arguments deltas("0 0.03 0.7");
  const SweepTable table = table_of(run(sweep("--f 0,0.02,0.4 --delta 0,0.03,0.7 --times")));
  BOOST_TEST((table.columns == "f delta" + free_columns));
  BOOST_TEST_REQUIRE(table.rows.size() == fs.size() * deltas.size());
  std::size_t row = 0;
  for (const std::string& f : fs) {
    for (const std::string& delta : deltas) {
      BOOST_TEST(table.at(row, "f") == f);
      BOOST_TEST(table.at(row, "delta") == delta);
      const json report =
          run({"simulate", "--v0", "1", "--p", "1", "--f", f, "--delta", delta, "--json"}).json();
      check_row(table, row, report.at("response"), free_columns);
      ++row;
    }
  }
  BOOST_TEST(table.at(0, "outcome") == "never_stops");
  BOOST_TEST(table.at(2, "outcome") == "caught_at_start");
  BOOST_TEST(table.at(3, "outcome") == "stopped_in_dead_zone");
}

BOOST_AUTO_TEST_CASE(has_the_transmitted_acceleration_if_asked_for) {
  const Arguments column("peak_absolute_acceleration");
  for (const char* x0 : {"0", "0.5"}) {  // in lanes, and one by one
    const SweepTable table =
        table_of(run(sweep({"--f", "0,0.02,0.4", "--delta", "0.03,0.7", "--x0", x0, "--columns",
                            "f,delta,peak-absolute-acceleration"})));
    BOOST_TEST_REQUIRE(table.rows.size() == 6U);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      const json report = run({"simulate", "--v0", "1", "--p", "1", "--x0", x0, "--f",
                               table.at(row, "f"), "--delta", table.at(row, "delta"), "--json"})
                              .json();
      check_row(table, row, report.at("response"), column);
    }
  }
}

BOOST_AUTO_TEST_CASE(may_have_axes_of_the_start_and_the_spring) {
  const SweepTable table =
      table_of(run("sweep --delta 0.01,0.02 --f 0.05 --x0 -1:1:3 --p 1,2 --v0 0.5,1 --times"));
  BOOST_TEST((table.columns == "v0 p x0 delta" + free_columns));
  BOOST_TEST_REQUIRE(table.rows.size() == 24U);
  for (const std::size_t row : {std::size_t{0}, std::size_t{7}, std::size_t{16}}) {
    const json report =
        run({"simulate", "--v0", table.at(row, "v0"), "--p", table.at(row, "p"), "--x0",
             table.at(row, "x0"), "--f", "0.05", "--delta", table.at(row, "delta"), "--json"})
            .json();
    check_row(table, row, report.at("response"), free_columns);
  }
  BOOST_TEST((table.rows.back().front() == "1" && table.at(23, "p") == "2"));
}

BOOST_AUTO_TEST_CASE(of_forced_motions_has_the_metrics_of_simulate) {
  const Arguments forced("--excitation harmonic --k 0.2 --lambda 0.35");
  const Arguments columns = free_columns +
                            "end_time final_position final_velocity sticks stick_time "
                            "peak_absolute_acceleration locked_from largest_load_while_locked";
  std::size_t locked = 0;
  for (const Arguments& more : {forced + "--t-end 100", forced + "--duration 20"}) {
    const SweepTable table =
        table_of(run("sweep --p 1 --f 0.05,0.18,0.3 --delta 0,0.01 --times" + more));
    BOOST_TEST_REQUIRE(table.rows.size() == 6U);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      const json report = run(Arguments{"simulate", "--p", "1", "--f", table.at(row, "f"),
                                        "--delta", table.at(row, "delta"), "--json"} +
                              more)
                              .json();
      check_row(table, row, report.at("response"), columns);
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
    const SweepTable table = table_of(run("sweep --beta 0.6,0.85,0.95,1.3" + task +
                                          Arguments{"--columns", "beta," + design_columns}));
    BOOST_TEST_REQUIRE(table.rows.size() == 4U);
    const int designs = check_designs(*this, table, [&](std::size_t row) {
      return Arguments{"design", "--beta", table.at(row, "beta")} + task;
    });
    BOOST_TEST((designs > 0 && designs < 4));
  }
}

BOOST_AUTO_TEST_CASE(ranges_residuals_and_arrivals_are_axes) {
  const SweepTable table =
      table_of(run("sweep --v0 1,0.9:1.1,0:1 --p 1:1,0.9:1.1 --beta 1 --residual 0:0.1:2 "
                   "--arrivals 1,3 --criterion exact --times"));
  BOOST_TEST_REQUIRE(table.rows.size() == 24U);
  const Arguments inputs("v0 v0_low p p_high residual arrivals");
  BOOST_TEST((Arguments(table.columns.begin(), table.columns.begin() + 6) == inputs));
  check_designs(*this, table, [&](std::size_t row) {
    const auto range = [&](const char* low, const char* high) {
      return table.at(row, low) + ":" + table.at(row, high);
    };
    return "design --beta 1 --criterion exact" + Arguments{"--v0",       range("v0_low", "v0"),
                                                           "--p",        range("p", "p_high"),
                                                           "--residual", table.at(row, "residual"),
                                                           "--arrivals", table.at(row, "arrivals")};
  });
  BOOST_TEST((table.at(23, "v0") == "1" && table.at(23, "v0_low") == "0"));
}

BOOST_AUTO_TEST_CASE(columns_of_a_list_are_the_ends_of_ranges) {
  write("hits.csv", "v0_low,v0,p_high,residual,arrivals\n0.9,1.1,1.05,0.05,1\n0,1,1,0,2\n");
  write("hits.jsonl",
        R"({"v0_low": 0.9, "v0": 1.1, "p_high": 1.05, "residual": 0.05, "arrivals": 1}
{"v0_low": 0, "v0": 1, "p_high": 1, "residual": 0, "arrivals": 2})");
  const Arguments fixed("--p 1 --beta 2 --criterion exact");
  for (const char* const list : {"hits.csv", "hits.jsonl"}) {
    const SweepTable table =
        table_of(run(Arguments{"sweep", "--list", list, "--columns", design_columns} + fixed));
    BOOST_TEST_REQUIRE(table.rows.size() == 2U);
    const Arguments first("--v0 0.9:1.1 --p 1:1.05 --residual 0.05");
    const Arguments second("--v0 0:1 --p 1 --residual 0 --arrivals 2");
    const Arguments rest("--beta 2 --criterion exact --json");
    BOOST_TEST(check_design(table, 0, run("design" + first + rest).json()));
    BOOST_TEST(check_design(table, 1, run("design" + second + rest).json()));
  }
}

BOOST_AUTO_TEST_CASE(of_problems_takes_a_pulse_instead_of_the_velocity) {
  const Arguments task("--pulse half-sine --p 1 --beta 0.6 --tolerance 0.1");
  const SweepTable table =
      table_of(run("sweep --k 0.2,0.4:0.5,1.5 --lambda 2,1.8:2.2" + task +
                   Arguments{"--columns", "k,k_low,lambda,lambda_high," + design_columns}));
  BOOST_TEST_REQUIRE(table.rows.size() == 6U);
  const int designs = check_designs(*this, table, [&](std::size_t row) {
    const Arguments pulse{"design", "--k", table.at(row, "k_low") + ":" + table.at(row, "k"),
                          "--lambda", table.at(row, "lambda") + ":" + table.at(row, "lambda_high")};
    return pulse + task;
  });
  BOOST_TEST((designs > 0 && designs < 6));
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

BOOST_AUTO_TEST_CASE(ranges_are_columns_of_npy) {
  const Arguments task("sweep --v0 0.9:1.1,0:1 --p 1 --beta 2 --residual 0.05");
  const SweepTable csv = table_of(run(task));
  succeed(task + "--output d.npy");
  const NpyFile npy = read_npy(read("d.npy"));
  BOOST_TEST_REQUIRE(npy.count == 2);
  BOOST_TEST_REQUIRE(npy.fields.size() == csv.columns.size());
  for (std::int64_t row = 0; row < 2; ++row) {
    for (const std::string& column : csv.columns) {
      if (column != "feasible") {
        BOOST_TEST(npy.number(row, column) == csv.number(static_cast<std::size_t>(row), column));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(of_problems_in_metres_takes_parts_in_metres) {
  write("parts.csv", "name,f,delta_m\na,0.02,6mm\nb,0.025,5mm\nc,0.03,4mm\n");
  const SweepTable table = table_of(
      run("sweep --velocity 0.3:0.4:3 --period 2.8 --max-displacement 0.15 --catalogue parts.csv"));
  BOOST_TEST_REQUIRE(table.rows.size() == 3U);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const json report = run({"design", "--velocity", table.at(row, "velocity"), "--period", "2.8",
                             "--max-displacement", "0.15", "--catalogue", "parts.csv", "--json"})
                            .json();
    BOOST_TEST((table.at(row, "feasible") == "true") == report.at("design").is_object());
    if (report.at("design").is_object()) {
      check_row(table, row, report.at("design"), "f");
    }
  }
  write("plain.csv", "name,f,delta\na,0.02,0.03\n");
  check_refusal(
      run("sweep --velocity 0.3:0.4:3 --period 2.8 --max-displacement 0.15 --catalogue plain.csv"),
      {"plain.csv, line 1: the column delta is dimensionless"});
}

BOOST_AUTO_TEST_CASE(axis_of_one_value_has_no_column) {
  BOOST_TEST(table_of(run(sweep("--f 0.1:0.1:1 --delta 0"))).columns.front() == "peak_amplitude");
}

BOOST_AUTO_TEST_CASE(may_come_from_a_scene) {
  const std::string scene =
      R"({"v0": 1, "p": [1, 2], "f": "0.1:0.3:3", "delta": 0.02, "times": true, "threads": 1})";
  const ProgramRun by_scene = run("sweep -", {.input = scene});
  const ProgramRun by_flags = run("sweep --v0 1 --p 1,2 --f 0.1:0.3:3 --delta 0.02 --times");
  BOOST_TEST(table_of(by_scene).rows.size() == 6U);
  BOOST_TEST(by_scene.out == by_flags.out);
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

BOOST_AUTO_TEST_CASE(writes_the_columns_that_are_asked_for) {
  const Arguments entries("--f 0.1,0.2 --delta 0.3");
  const SweepTable table = table_of(run(sweep(entries + "--columns stop-time,delta,outcome,v0")));
  BOOST_TEST((table.columns == Arguments("stop_time delta outcome v0")));
  const SweepTable all = table_of(run(sweep(entries + "--times")));
  BOOST_TEST(table.at(1, "stop_time") == all.at(1, "stop_time"));
  BOOST_TEST(table.at(1, "v0") == "1");
}

BOOST_AUTO_TEST_SUITE_END()
