// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_AUTO_TEST_SUITE(physical_sweep_test)

using namespace stillpoint::cli_test;

/// A sweep has a different unit of length from a single motion, so the two round differently; a
/// motion amplifies that a few hundred times.
constexpr double row_tolerance = 1e-12;

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

void check_damper(const SweepTable& table, std::size_t row, const json& report) {
  constexpr double search_tolerance = 1e-6;  // of one optimum
  const bool found = report["design"].is_object();
  BOOST_TEST((table.at(row, "feasible") == "true") == found);
  if (found) {
    for (const auto& [column, part] : {std::pair{"tolerance", "design"},
                                       {"f", "design"},
                                       {"delta_m", "physical"},
                                       {"peak_m", "physical"}}) {
      BOOST_TEST(near(table.number(row, column), report[part][column], search_tolerance), column);
    }
  }
}

SweepTable rows(const Sandbox& sandbox, const Arguments& arguments) {
  return read_csv(sandbox.succeed("sweep" + arguments).out);
}

/// The options that all rows share, and those that vary.
struct Asked {
  Arguments fixed;
  Arguments axes;
};

BOOST_FIXTURE_TEST_CASE(motions_are_those_of_simulate, Sandbox) {
  write("record.csv", "0 0\n0.3 0.2\n0.9 -0.15\n1.4 0\n");
  const std::vector<std::string> free{"peak_m", "stop_position_m", "stop_time_s"};
  const std::vector<std::string> forced{"peak_m",           "stop_position_m", "end_time_s",
                                        "final_position_m", "stick_time_s",    "locked_from_s"};
  const Arguments shaken("--period 2.8s --f 0.031");
  const Arguments deltas("--delta-m 1mm,3mm");
  for (const auto& [asked, columns] : std::vector<std::pair<Asked, std::vector<std::string>>>{
           {{"--f 0.011",
             "--velocity 200mm/s,0.4 --period 2s:3s:3 --delta-m 0.7mm:2.3mm:3 --times"},
            free},
           {{"--velocity 0.4 --period 2.8 --f 0.02 --friction-zones 30mm:0.03",
             "--delta-m 2mm,6mm --notch-width-m 5mm:20mm:2 --times"},
            free},
           {{"--velocity 0.4 --f 0.02 --delta-m 1mm", "--natural-frequency 250mHz,0.5 --times"},
            free},
           {{"--velocity 0.4 --f 0.02 --delta-m 1mm --mass 1t",
             "--stiffness 2.5kN/m,10kN/m --times"},
            free},
           {{shaken + "--excitation half-sine --k 0.2g --pulse-duration 300ms", deltas}, forced},
           {{shaken + "--excitation harmonic --k 0.2g --excitation-frequency 0.5Hz "
                      "--excitation-duration 3s --end-time 8s",
             deltas},
            forced},
           {{shaken + "--record record.csv --record-scale -1.5", deltas}, forced}}) {
    check_rows(
        *this, "simulate", asked.fixed, asked.axes,
        [&, &compared = columns](const SweepTable& table, std::size_t row, const json& report) {
          check_row(table, row, report, compared);
        });
  }
}

BOOST_FIXTURE_TEST_CASE(dampers_are_those_of_design, Sandbox) {
  write("parts.csv", "name,f,delta_m\na,0.02,6mm\nb,0.025,5mm\nc,0.03,4mm\n");
  const Arguments ranged("--max-displacement 170mm --arrivals 2");
  const Arguments hits("--velocity 0.4,360mm/s:0.44 --residual-m 0,5mm");
  const Arguments pulse("--k 0.2 --period 2.8s --max-displacement 0.4");
  for (const auto& [fixed, axes] :
       std::vector<Asked>{{"--velocity 0.4 --period 2.8s --delta-max-m 5.5mm",
                           "--max-displacement 120mm:150mm:3 --times"},
                          {ranged + "--period 2660ms:2.94s", hits},
                          {ranged + "--natural-frequency 340mHz:0.37", hits},
                          {ranged + "--stiffness 5.5MN/m:6.5MN/m --mass 1200t", hits},
                          {pulse + "--pulse full-sine", "--pulse-duration 0.9s,600ms"},
                          {pulse + "--pulse half-sine", "--excitation-frequency 0.5Hz,1.25"},
                          {"--period 2.8 --max-displacement 0.15 --catalogue parts.csv",
                           "--velocity 0.3:0.4:3"}}) {
    const SweepTable table = check_rows(*this, "design", fixed, axes, check_damper);
    BOOST_TEST(table.at(table.rows.size() - 1, "feasible") == "true");
  }
  write("plain.csv", "name,f,delta\na,0.02,0.03\n");
  check_refusal(
      run("sweep --velocity 0.3:0.4:3 --period 2.8 --max-displacement 0.15 --catalogue plain.csv"),
      {"plain.csv, line 1: the column delta is dimensionless"});
}

// A longer period is a softer spring.
BOOST_FIXTURE_TEST_CASE(the_ends_of_a_range_of_springs_are_columns, Sandbox) {
  for (const auto& [spring, columns] :
       {std::pair{"--period 2660ms:2.94s", "period_low,period"},
        {"--natural-frequency 340mHz:0.37", "natural_frequency,natural_frequency_high"},
        {"--stiffness 5.5MN/m:6.5MN/m --mass 1200t", "stiffness,stiffness_high"}}) {
    const SweepTable ends = rows(*this, "--velocity 0.4 --max-displacement 170mm" +
                                            Arguments(spring) + Arguments{"--columns", columns});
    BOOST_TEST(ends.number(0, ends.columns[0]) < ends.number(0, ends.columns[1]));
  }
}

BOOST_FIXTURE_TEST_CASE(lists_are_in_metres_and_seconds, Sandbox) {
  const Arguments motion("--velocity 0.4 --period 2.8s");
  write("dampers.csv", "f,delta-m\n0.02,0.001\n0.03,0.004\n");
  write("reversed.csv", "delta_m,f\n0.001,0.02\n0.004,0.03\n");
  const SweepTable grid = rows(*this, motion + "--f 0.02,0.03 --delta-m 1mm,4mm --times");
  for (const char* const list : {"dampers.csv", "reversed.csv"}) {
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

BOOST_AUTO_TEST_SUITE_END()
