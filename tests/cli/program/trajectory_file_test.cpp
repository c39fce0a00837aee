// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "forced_arguments.hpp"

BOOST_FIXTURE_TEST_SUITE(trajectory_file_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;

struct Simulation {
  json report;
  SweepTable table;

  /// Of the last row.
  [[nodiscard]] double end(std::string_view column) const {
    return table.number(table.rows.size() - 1, column);
  }
};

Simulation simulation(const Sandbox& sandbox, const Arguments& arguments) {
  const ProgramRun run = sandbox.succeed(arguments + "--json --trajectory motion.csv");
  check_only_finite(sandbox.read("motion.csv"));
  return {run.json(), read_csv(sandbox.read("motion.csv"))};
}

const Arguments eleven("simulate --v0 1 --p 1 --f 0.02 --delta 0.02");

BOOST_AUTO_TEST_CASE(ends_where_asked) {
  const auto shorter = simulation(*this, eleven + "--samples 10 --t-end 5");
  BOOST_TEST(shorter.end("tau") == 5);
  // The report is that of the whole motion.
  BOOST_TEST(shorter.report["response"]["half_cycles"] == 11);
  const auto longer = simulation(*this, eleven + "--samples 10 --t-end 50");
  BOOST_TEST(longer.end("tau") == 50);
  BOOST_TEST(longer.end("x") == 0);
  BOOST_TEST(longer.end("v") == 0);
}

BOOST_AUTO_TEST_CASE(has_columns_in_metres_and_seconds_for_physical_input) {
  const Simulation motion =
      simulation(*this, "simulate --velocity 0.4 --period 3 --f 0.02 --delta-m 0.001 --samples 20");
  const json& quantities = motion.report["physical"];
  const double length_unit = quantities["length_unit_m"];
  const double velocity_unit = std::sqrt(9.80665 * length_unit);
  for (std::size_t row = 0; row < motion.table.rows.size(); ++row) {
    const auto number = [&](const char* column) { return motion.table.number(row, column); };
    BOOST_TEST(near(number("t_s"), number("tau") * quantities["time_unit_s"].get<double>(), 1e-15));
    BOOST_TEST(near(number("x_m"), number("x") * length_unit, 1e-15));
    BOOST_TEST(near(number("v_m_per_s"), number("v") * velocity_unit, 1e-15));
  }
  BOOST_TEST(near(motion.table.number(0, "v_m_per_s"), 0.4, 1e-15));
  BOOST_TEST(near(motion.end("t_s"), quantities["stop_time_s"], 1e-15));
}

BOOST_AUTO_TEST_CASE(is_written_beside_the_report) {
  succeed(eleven + "--trajectory motion.csv --output report.json");
  BOOST_TEST(contents().size() == 2U);
  BOOST_TEST(json::parse(read("report.json"))["response"]["half_cycles"] == 11);
  // 1000 samples where none are asked for.
  BOOST_TEST(read_csv(read("motion.csv")).rows.size() >= 1000U);
}

BOOST_AUTO_TEST_SUITE_END()
