// SPDX-License-Identifier: MIT
#include "report_fields.hpp"
#include "run_program.hpp"
#include "testing/printing.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(trajectory_file_test)

namespace {

using namespace stillpoint::cli_test;
using nlohmann::json;

using Row = std::vector<double>;

struct Table {
  std::string header;
  std::vector<Row> rows;
};

Table parse(const std::string& text) {
  BOOST_TEST(text.ends_with('\n'));
  std::istringstream stream(text);
  Table table;
  std::getline(stream, table.header);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream cells(line);
    Row row;
    for (std::string cell; std::getline(cells, cell, ',');) {
      row.push_back(std::stod(cell));
    }
    table.rows.push_back(row);
  }
  return table;
}

struct Simulation {
  json report;
  Table table;
};

Simulation simulation(const Sandbox& sandbox, const Arguments& arguments) {
  const ProgramRun run = sandbox.succeed(joined(arguments, "--json --trajectory motion.csv"));
  check_only_finite(sandbox.read("motion.csv"));
  return {run.json(), parse(sandbox.read("motion.csv"))};
}

const Arguments eleven("simulate --v0 1 --p 1 --f 0.02 --delta 0.02");

/// Rows at exactly this instant.
std::vector<Row> rows_at(const Table& table, double tau) {
  std::vector<Row> found;
  std::ranges::copy_if(table.rows, std::back_inserter(found),
                       [tau](const Row& row) { return row[0] == tau; });
  return found;
}

}  // namespace

BOOST_FIXTURE_TEST_SUITE(trajectory_file, Sandbox)

BOOST_AUTO_TEST_CASE(has_every_sample_and_every_event_in_order) {
  const auto [report, table] = simulation(*this, joined(eleven, "--samples 50"));
  BOOST_TEST(table.header == "tau,x,v");
  const double stop = report["response"]["stop_time"];
  BOOST_TEST_REQUIRE(!table.rows.empty());
  BOOST_TEST(std::ranges::is_sorted(table.rows, {}, [](const Row& row) { return row[0]; }));
  BOOST_TEST((table.rows.front() == Row{0, 0, 1}));
  BOOST_TEST(table.rows.back()[0] == stop);
  BOOST_TEST(table.rows.back()[1] == 0);
  BOOST_TEST(table.rows.back()[2] == 0);

  for (int i = 0; i < 50; ++i) {
    const double tau = stop * i / 49;
    BOOST_TEST(
        std::ranges::any_of(table.rows, [tau](const Row& row) { return near(row[0], tau, 1e-14); }),
        "no sample at " << tau);
  }
  for (const json& now : report["half_cycles"]) {
    const auto peak = rows_at(table, now["peak_time"]);
    BOOST_TEST_REQUIRE(peak.size() == 1U);
    BOOST_TEST(peak[0][1] == now["side"].get<double>() * now["peak"].get<double>());
    BOOST_TEST(peak[0][2] == 0);
    const bool last = now["index"] == 11;
    const auto passage = rows_at(table, now["end_time"]);
    BOOST_TEST_REQUIRE(passage.size() == 2U);
    BOOST_TEST(passage[0][1] == 0);
    BOOST_TEST(passage[1][1] == 0);
    const double side = now["side"];
    BOOST_TEST(near(passage[0][2], -side * now["arrival_speed"].get<double>(), 1e-15));
    const std::size_t next = now["index"].get<std::size_t>();
    const double departure =
        last ? 0 : report["half_cycles"][next]["departure_speed"].get<double>();
    BOOST_TEST(near(passage[1][2], -side * departure, 1e-15));
  }
  // 50 samples, the first and last of which are events; 11 peaks; 2 lines for each of 11 arrivals.
  BOOST_TEST(table.rows.size() == 48U + 1U + 11U + 22U);
}

BOOST_AUTO_TEST_CASE(reaches_the_peak_of_the_response_exactly) {
  const auto [report, table] = simulation(*this, joined(eleven, "--samples 2"));
  double peak = 0;
  for (const Row& row : table.rows) {
    peak = std::max(peak, std::abs(row[1]));
  }
  BOOST_TEST(peak == report["response"]["peak_amplitude"].get<double>());
}

BOOST_AUTO_TEST_CASE(obeys_the_equation_of_motion_between_events) {
  // On the way out x = -f + S sin(tau + atan f), with v0 = p = 1.
  const auto [report, table] = simulation(*this, joined(eleven, "--samples 2000"));
  const double first_peak = report["half_cycles"][0]["peak_time"];
  const double radius = std::hypot(1, 0.02);
  int compared = 0;
  for (const Row& row : table.rows) {
    if (row[0] < first_peak) {
      const double phase = row[0] + std::atan(0.02);
      BOOST_TEST(std::abs(row[1] - (radius * std::sin(phase) - 0.02)) <= 1e-15);
      BOOST_TEST(std::abs(row[2] - radius * std::cos(phase)) <= 1e-15);
      ++compared;
    }
  }
  BOOST_TEST(compared > 80);
}

BOOST_AUTO_TEST_CASE(ends_where_it_is_told_to) {
  const auto shorter = simulation(*this, joined(eleven, "--samples 10 --t-end 5"));
  BOOST_TEST(shorter.table.rows.back()[0] == 5);
  // The report is that of the whole motion.
  BOOST_TEST(shorter.report["response"]["half_cycles"] == 11);
  const auto longer = simulation(*this, joined(eleven, "--samples 10 --t-end 50"));
  BOOST_TEST((longer.table.rows.back() == Row{50, 0, 0}));
}

BOOST_AUTO_TEST_CASE(of_a_motion_without_an_end_has_ten_periods) {
  const auto endless = simulation(*this, "simulate --v0 1 --p 2 --f 0 --delta 0 --samples 9");
  BOOST_TEST(near(endless.table.rows.back()[0], 10 * std::numbers::pi, 1e-14));
}

BOOST_AUTO_TEST_CASE(of_nothing_that_moves_stays_at_its_place) {
  const auto caught = simulation(*this, "simulate --v0 1 --p 1 --f 0.1 --delta 0.6 --samples 5");
  for (const Row& row : caught.table.rows) {
    BOOST_TEST(row[1] == 0);
  }
  BOOST_TEST(caught.table.rows.back()[2] == 0);
}

BOOST_AUTO_TEST_CASE(has_columns_in_metres_and_seconds_for_physical_input) {
  const auto [report, table] =
      simulation(*this, "simulate --velocity 0.4 --period 3 --f 0.02 --delta-m 0.001 --samples 20");
  BOOST_TEST(table.header == "tau,x,v,t_s,x_m,v_m_per_s");
  const json& quantities = report["physical"];
  const double velocity_unit = std::sqrt(9.80665 * quantities["length_unit_m"].get<double>());
  for (const Row& row : table.rows) {
    BOOST_TEST_REQUIRE(row.size() == 6U);
    BOOST_TEST(near(row[3], row[0] * quantities["time_unit_s"].get<double>(), 1e-15));
    BOOST_TEST(near(row[4], row[1] * quantities["length_unit_m"].get<double>(), 1e-15));
    BOOST_TEST(near(row[5], row[2] * velocity_unit, 1e-15));
  }
  BOOST_TEST(near(table.rows.front()[5], 0.4, 1e-15));
  BOOST_TEST(near(table.rows.back()[3], quantities["stop_time_s"], 1e-15));
}

BOOST_AUTO_TEST_CASE(goes_with_the_report_into_two_files) {
  succeed(joined(eleven, "--trajectory motion.csv --output report.json"));
  BOOST_TEST(contents().size() == 2U);
  BOOST_TEST(json::parse(read("report.json"))["response"]["half_cycles"] == 11);
  // 1000 samples where none are asked for.
  BOOST_TEST(parse(read("motion.csv")).rows.size() >= 1000U);
}

BOOST_AUTO_TEST_CASE(and_report_cannot_be_the_same_file) {
  for (const char* same : {"one", "./one"}) {
    const ProgramRun both = run(joined(eleven, {"--trajectory", "one", "--output", same}));
    BOOST_TEST(both.exit_code == 2);
    BOOST_TEST(contents().empty());
  }
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
