// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

#include <fmt/format.h>

BOOST_AUTO_TEST_SUITE(physical_sweep_test)

namespace {

using namespace stillpoint::cli_test;

/// A sweep has a different unit of length from a single motion, so the two round differently; a
/// motion amplifies that a few hundred times.
constexpr double row_tolerance = 1e-12;

SweepTable rows(const Sandbox& sandbox, const Arguments& arguments) {
  const ProgramRun answer = sandbox.succeed("sweep" + arguments);
  BOOST_TEST(answer.err.empty(), answer.err);
  return read_csv(answer.out);
}

/// A row's results against the report of its motion alone: metres and seconds, and the outcome.
void check_row(const SweepTable& table, std::size_t row, const json& report,
               const std::vector<std::string>& columns) {
  for (const std::string& column : columns) {
    const json& expected = report["physical"][column];
    const std::string& found = table.at(row, column);
    if (expected.is_null()) {
      BOOST_TEST(found.empty(), column << " = " << found);
    } else {
      const double scale = std::abs(report["physical"]["peak_m"].get<double>());
      BOOST_TEST(std::abs(table.number(row, column) - expected.get<double>()) <=
                     row_tolerance * std::max(std::abs(expected.get<double>()), scale),
                 column << " = " << found << ", " << expected);
    }
  }
  BOOST_TEST(table.at(row, "outcome") == report["response"]["outcome"].get<std::string>());
  BOOST_TEST(table.number(row, "half_cycles") == report["response"]["half_cycles"].get<double>());
}

/// The same of a damper.
void check_damper(const SweepTable& table, std::size_t row, const json& report) {
  constexpr double search_tolerance = 1e-6;  // of one optimum
  BOOST_TEST(near(table.number(row, "tolerance"), report["design"]["tolerance"], search_tolerance));
  BOOST_TEST(near(table.number(row, "f"), report["design"]["f"], search_tolerance));
  BOOST_TEST(near(table.number(row, "delta_m"), report["physical"]["delta_m"], search_tolerance));
  BOOST_TEST(near(table.number(row, "peak_m"), report["physical"]["peak_m"], search_tolerance));
}

}  // namespace

BOOST_FIXTURE_TEST_CASE(rows_are_the_motions_one_by_one, Sandbox) {
  const SweepTable table = rows(
      *this, "--velocity 200mm/s,0.4 --period 2s:3s:3 --f 0.011 --delta-m 0.7mm:2.3mm:3 --times");
  BOOST_TEST(table.columns ==
                 (std::vector<std::string>{"velocity", "period", "delta_m", "peak_m", "half_cycles",
                                           "outcome", "stop_position_m", "stop_time_s"}),
             tt::per_element());
  BOOST_TEST_REQUIRE(table.rows.size() == 18U);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    check_row(table, i,
              reported({"simulate", "--f", "0.011", "--velocity", table.at(i, "velocity"),
                        "--period", table.at(i, "period"), "--delta-m", table.at(i, "delta_m")}),
              {"peak_m", "stop_position_m", "stop_time_s"});
  }
}

BOOST_FIXTURE_TEST_CASE(of_frequencies_and_stiffnesses_match_those_of_periods, Sandbox) {
  const Arguments rest("--velocity 0.4 --f 0.02 --delta-m 1mm");
  const auto peaks = [&](const Arguments& isolator) {
    const SweepTable table = rows(*this, isolator + rest);
    return std::pair{table.number(0, "peak_m"), table.number(1, "peak_m")};
  };
  const auto by_period = peaks("--period 4s,2s");
  const auto by_frequency = peaks("--natural-frequency 250mHz,0.5");
  BOOST_TEST(by_frequency.first == by_period.first);
  BOOST_TEST(by_frequency.second == by_period.second);
  // k = m omega^2
  const double omega = 2 * std::acos(-1.0) / 4;
  const std::string stiffness = in_full(omega * omega) + "kN/m";
  const auto by_stiffness =
      peaks({"--stiffness", stiffness + "," + in_full(4 * omega * omega) + "kN/m", "--mass", "1t"});
  BOOST_TEST(near(by_stiffness.first, by_period.first, row_tolerance));
  BOOST_TEST(near(by_stiffness.second, by_period.second, row_tolerance));
}

BOOST_FIXTURE_TEST_CASE(designs_match_design, Sandbox) {
  const SweepTable table = rows(
      *this,
      "--velocity 0.4 --period 2.8s --max-displacement 120mm:150mm:3 --delta-max-m 5.5mm --times");
  BOOST_TEST_REQUIRE(table.rows.size() == 3U);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const ProgramRun design =
        run({"design", "--velocity", "0.4", "--period", "2.8", "--delta-max-m", "5.5mm", "--json",
             "--max-displacement", table.at(i, "max_displacement")});
    const bool feasible = table.at(i, "feasible") == "true";
    BOOST_TEST(feasible == (design.exit_code == 0));
    if (feasible) {
      check_damper(table, i, design.json());
    }
  }
  BOOST_TEST(table.at(0, "feasible") == "false");
  BOOST_TEST(table.at(2, "feasible") == "true");
}

BOOST_FIXTURE_TEST_CASE(ranges_of_hits_and_springs_match_design, Sandbox) {
  using Spring = std::pair<Arguments, std::string>;
  for (const auto& [spring, column] :
       {Spring{{"--period", "2660ms:2.94s"}, "period"},
        Spring{{"--natural-frequency", "340mHz:0.37"}, "natural_frequency"},
        Spring{{"--stiffness", "5.5MN/m:6.5MN/m", "--mass", "1200t"}, "stiffness"}}) {
    const Arguments task = spring + "--max-displacement 170mm --arrivals 2";
    const SweepTable table = rows(*this, task + "--velocity 0.4,360mm/s:0.44 --residual-m 0,5mm");
    BOOST_TEST_REQUIRE(table.rows.size() == 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      const json report = reported(
          "design" + task +
          Arguments{"--velocity", table.at(i, "velocity_low") + ":" + table.at(i, "velocity"),
                    "--residual-m", table.at(i, "residual_m")});
      check_damper(table, i, report);
    }
    const std::string other = column == "period" ? "period_low" : column + "_high";
    const std::string both = fmt::format("{},{}", column, other);
    const SweepTable ends = rows(*this, task + Arguments{"--velocity", "0.4", "--columns", both});
    BOOST_TEST((column == "period" ? ends.number(0, other) < ends.number(0, column)
                                   : ends.number(0, other) > ends.number(0, column)));
  }
}

BOOST_FIXTURE_TEST_CASE(pulses_of_designs_are_in_hertz_and_seconds, Sandbox) {
  using Clock = std::pair<Arguments, std::string>;
  for (const auto& [clock, column] :
       {Clock{{"--pulse", "full-sine", "--pulse-duration", "0.9s,600ms"}, "pulse_duration"},
        Clock{{"--pulse", "half-sine", "--excitation-frequency", "0.5Hz,1.25"},
              "excitation_frequency"}}) {
    const Arguments task("--k 0.2 --period 2.8s --max-displacement 0.4");
    const SweepTable table = rows(*this, clock + task);
    BOOST_TEST_REQUIRE(table.rows.size() == 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      const std::string option =
          column == "pulse_duration" ? "--pulse-duration" : "--excitation-frequency";
      const json report =
          reported(Arguments{"design", "--pulse", clock[1], option, table.at(i, column)} + task);
      BOOST_TEST_REQUIRE(table.at(i, "feasible") == "true");
      check_damper(table, i, report);
    }
  }
}

BOOST_FIXTURE_TEST_CASE(loads_are_in_hertz_and_seconds, Sandbox) {
  write("record.csv", "0 0\n0.3 0.2\n0.9 -0.15\n1.4 0\n");
  const std::vector<std::string> columns{"peak_m",           "stop_position_m", "end_time_s",
                                         "final_position_m", "stick_time_s",    "locked_from_s"};
  for (const Arguments& load : std::vector<Arguments>{
           {"--excitation", "half-sine", "--k", "0.2g", "--pulse-duration", "300ms"},
           {"--excitation", "harmonic", "--k", "0.2g", "--excitation-frequency", "0.5Hz",
            "--excitation-duration", "3s", "--end-time", "8s"},
           {"--record", "record.csv"}}) {
    const SweepTable table = rows(*this, "--period 2.8s --f 0.031 --delta-m 1mm,3mm" + load);
    BOOST_TEST_REQUIRE(table.rows.size() == 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      check_row(table, i,
                reported(Arguments{"simulate", "--period", "2.8", "--f", "0.031", "--delta-m",
                                   table.at(i, "delta_m")} +
                         load),
                columns);
    }
  }
}

BOOST_FIXTURE_TEST_CASE(lists_are_in_metres_and_seconds, Sandbox) {
  const Arguments motion("--velocity 0.4 --period 2.8s");
  write("dampers.csv", "f,delta-m\n0.02,0.001\n0.03,0.004\n");
  write("dampers.jsonl", R"({"f": 0.02, "delta_m": 0.001}
{"f": 0.03, "delta_m": 0.004})");
  const SweepTable grid = rows(*this, motion + "--f 0.02,0.03 --delta-m 1mm,4mm --times");
  for (const char* const list : {"dampers.csv", "dampers.jsonl"}) {
    const SweepTable table = rows(*this, motion + Arguments{"--list", list, "--times"});
    BOOST_TEST(table.columns == grid.columns, tt::per_element());
    BOOST_TEST_REQUIRE(table.rows.size() == 2U);
    BOOST_TEST(table.rows[0] == grid.rows[0], tt::per_element());
    BOOST_TEST(table.rows[1] == grid.rows[3], tt::per_element());
  }
  write("plain.csv", "f,delta\n0.02,0.001\n");
  check_refusal(run("sweep --list plain.csv" + motion),
                {"\"delta\" is not a column of a list; its columns may be velocity, "
                 "velocity_low, period"});
}

BOOST_FIXTURE_TEST_CASE(real_notches_are_in_metres, Sandbox) {
  const Arguments motion("--velocity 0.4 --period 2.8 --f 0.02");
  const SweepTable table = rows(
      *this,
      motion + "--delta-m 2mm,6mm --notch-width-m 5mm:20mm:2 --friction-zones 30mm:0.03 --times");
  BOOST_TEST_REQUIRE(table.rows.size() == 4U);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    check_row(table, i,
              reported("simulate" + motion +
                       Arguments{"--delta-m", table.at(i, "delta_m"), "--notch-width-m",
                                 table.at(i, "notch_width_m"), "--friction-zones", "0.03:0.03"}),
              {"peak_m", "stop_position_m", "stop_time_s"});
    BOOST_TEST(table.at(i, "outcome") == "stopped_in_notch");
  }
}

BOOST_FIXTURE_TEST_CASE(scenes_columns_and_files_work_too, Sandbox) {
  write("scene.json", R"({"velocity": "0.4m/s", "period": ["2s", 3], "f": 0.02,
      "delta_m": "1mm:3mm:3", "mass": "1200t"})");
  const ProgramRun by_scene = succeed("sweep scene.json --columns period,delta-m,peak_m");
  BOOST_TEST(by_scene.err.empty(), by_scene.err);
  BOOST_TEST(by_scene.out == run("sweep --velocity 0.4 --period 2,3 --f 0.02 --delta-m "
                                 "0.001:0.003:3 --columns period,delta_m,peak_m")
                                 .out);
  const ProgramRun drawn = succeed(
      "sweep --velocity 0.4 --period 2.8 --f 0.001:0.1:20 --delta-m 0:8mm:20 --output rows.npy "
      "--html map.html --json");
  BOOST_TEST(drawn.json()["output"]["columns"][1] == "delta_m");
  BOOST_TEST(contains(read("map.html"), "point friction Δ, mm"));
  BOOST_TEST(contains(read("rows.npy"), "'peak_m'"));
}

namespace {

Arguments sweep(const Arguments& more) {
  return "sweep --velocity 1 --f 0.1" + more;
}

const std::vector<Wrong> wrongs{
    {sweep("--p 1 --delta-m 0"), {"p and velocity", "cannot be combined"}},
    {sweep("--period 1 --delta 0"), {"delta is dimensionless", "--delta-m"}},
    {"sweep --velocity 1 --period 1 --max-displacement 1 --delta-max 1",
     {"delta-max is dimensionless", "--delta-max-m"}},
    {sweep("--period 1 --delta-m 0 --excitation half-sine --k 1 --lambda 1"),
     {"lambda is dimensionless", "--excitation-frequency"}},
    {sweep("--period 0:1:3 --delta-m 0"), {"period = 0 s", "from 1e-30 to 1e+30 s"}},
    {sweep("--period 1 --delta-m 1mm,-1mm"), {"delta-m = -0.001 m", "from 0 to 1e+30 m"}},
    {"sweep --velocity 1e200 --period 1 --f 0 --delta-m 0", {"velocity = 1e+200 m/s", "m/s"}},
    {sweep("--period 1 --delta-m 0 --notch-width-m 0"), {"notch-width-m = 0 m", "from 1e-30"}},
    {"sweep --velocity 1 --period 1 --max-displacement 1 --delta-max-m -1", {"delta-max-m = -1 m"}},
    {sweep("--period 1 --delta-m 0 --excitation harmonic --k 1 --excitation-frequency 1e29Hz "
           "--end-time 1"),
     {"excitation-frequency = 1e+29 Hz", "lambda"}},
    {sweep("--period 1 --delta-m 0 --excitation harmonic --k 1 --excitation-frequency 1 --end-time "
           "1e29s"),
     {"end-time = 1e+29 s"}},
    {sweep("--period 1"), {"delta-m is missing"}},
    {"sweep --velocity 1 --period 1 --f 0:1:3 --delta-m 0,1mm --html map.html --output rows.csv",
     {"delta-m = 0,0.001"}},
    {sweep("--stiffness 1 --delta-m 0"), {"mass is missing"}},
    {sweep("--delta-m 0"), {"period is missing"}},
    {sweep("--period 1 --delta-m 0 --columns stop_time"),
     {"columns = \"stop_time\"", "stop_time_s"}},
    {sweep("--period 1 --max-displacement 1"), {"max-displacement and f cannot be combined"}},
};

}  // namespace

BOOST_DATA_TEST_CASE_F(Sandbox, wrong_input, data::make(wrongs), wrong) {
  check_refused(*this, wrong);
}

namespace {

struct WrongEntry {
  const char* list;
  const char* message;
};

std::ostream& operator<<(std::ostream& out, const WrongEntry& wrong) {
  return out << wrong.message;
}

const std::vector<WrongEntry> wrong_entries{
    {"velocity,f,delta_m\n0.4,0.1,0\n-1e31,0.1,0\n",
     "line 3: velocity = -1e+31 m/s: must be from -1e+30 to 1e+30 m/s"},
    {"velocity,max_displacement\n0.4,0.15\n-1,0.1\n",
     "line 3: velocity = -1 m/s: must be from 1e-30 to 1e+30 m/s"},
    {"velocity,f,delta_m\n0.4,0.1,0\n0.4,0.1,-1\n",
     "line 3: delta-m = -1 m: must be from 0 to 1e+30 m"},
    {"velocity,f,delta_m,x0_m\n0.4,0.1,0,0\n0.4,0.1,0,1e200\n",
     "line 3: x0-m = 1e+200 m: must be from -1e+30 to 1e+30 m"},
    {"velocity,f,delta_m,notch_width_m\n0.4,0.1,0,1\n0.4,0.1,0,0\n",
     "line 3: notch-width-m = 0 m: must be from 1e-30 to 1e+30 m"},
    {"velocity,f,delta_m\n0.4,0.1,0\n0.4,0.1,2mm\n",
     "line 3: delta_m = \"2mm\": must be a number in SI units"},
};

}  // namespace

/// As it was given: the kernel would name a v0 that the user did not write.
BOOST_DATA_TEST_CASE_F(Sandbox, a_wrong_entry_of_a_list_has_its_unit, data::make(wrong_entries),
                       wrong) {
  write("list.csv", wrong.list);
  const ProgramRun refused = ending(2, "sweep --list list.csv --period 2.8");
  BOOST_TEST(contains(refused.err, wrong.message), refused.err);
}

BOOST_AUTO_TEST_SUITE_END()
