// SPDX-License-Identifier: MIT
// Sweeps over the dampers along the front of each design problem.
#include "cli_test.hpp"

BOOST_AUTO_TEST_SUITE(sweep_front_test)

using namespace stillpoint::cli_test;

constexpr std::size_t dampers = 4;
const Arguments front("--trade-off 4 --times");

/// Asserts that the row has the numbers of a damper of a report's front.
void check_damper(const SweepTable& table, std::size_t row, const json& damper) {
  BOOST_TEST(table.at(row, "feasible") == "true");
  for (const char* const column :
       {"f", "delta", "tolerance", "peak_amplitude", "stop_time", "peak_absolute_acceleration"}) {
    BOOST_TEST(table.number(row, column) == damper.at(column).get<double>(), column);
  }
}

BOOST_FIXTURE_TEST_CASE(has_the_dampers_that_design_reports, Sandbox) {
  for (const Arguments& task :
       std::vector<Arguments>{"--v0 1 --p 1", "--v0 1 --p 1 --arrivals 3 --tolerance 0.25",
                              "--v0 0.9:1.1 --p 1 --criterion exact",
                              "--v0 1 --p 1 --residual 0.05 --arrivals 2 --f-max 0.2",
                              "--v0 1 --p 1 --tolerance-f 0.9:1.2 --tolerance-delta 0.05"}) {
    const ProgramRun swept = succeed("sweep --beta 0.6,0.9,1.2" + task + front);
    const SweepTable table = read_csv(swept.out);
    BOOST_TEST_REQUIRE(table.rows.size() == 3 * dampers);
    int fronts = 0;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      BOOST_TEST(table.number(row, "trade_off") == static_cast<double>(row % dampers + 1));
    }
    for (std::size_t first = 0; first < table.rows.size(); first += dampers) {
      const json report =
          run(Arguments{"design", "--json", "--trade-off", "4", "--beta", table.at(first, "beta")} +
              task + Arguments{})
              .json();
      const json& reported = report.at("trade_off");
      if (reported.empty()) {
        BOOST_TEST(table.at(first, "feasible") == "false");
        BOOST_TEST(table.at(first + 1, "f").empty());
        continue;
      }
      BOOST_TEST_REQUIRE(reported.size() == dampers);
      ++fronts;
      for (std::size_t i = 0; i < dampers; ++i) {
        check_damper(table, first + i, reported[i]);
      }
    }
    BOOST_TEST((fronts == 1 || fronts == 2));
  }
}

const Arguments task("sweep --v0 1 --p 1 --tolerance 0.05 --trade-off 4");
const std::string betas = "beta\n0.8\n0.5\n0.9\n0.95\n1.2\n";

struct Listed : Sandbox {
  Listed() { write("list.csv", betas); }

  [[nodiscard]] std::string rows_of(const Arguments& more) const {
    succeed(task + "--output whole.csv" + more);
    return read("whole.csv");
  }
};

BOOST_FIXTURE_TEST_CASE(of_a_list_has_the_rows_of_the_grid, Listed) {
  const std::string expected = rows_of("--beta 0.8,0.5,0.9,0.95,1.2");
  BOOST_TEST(rows_of("--list list.csv") == expected);
  BOOST_TEST(rows_of("--list list.csv --threads 1") == expected);
}

BOOST_FIXTURE_TEST_CASE(of_a_list_is_resumed_where_a_line_was_wrong, Listed) {
  const std::string whole = rows_of("--list list.csv");
  const Arguments again = task + "--list broken.csv --output rows.csv";
  write("broken.csv", "beta\n0.8\n0.5\n-1\n");
  const ProgramRun broken = ending(2, again);
  check_contains(broken.err, {"broken.csv, line 4", "beta = -1", "--resume"});
  write("broken.csv", betas);
  const ProgramRun answer = succeed(again + "--resume --json");
  BOOST_TEST(answer.json()["resumed_at"] == 2 * dampers);
  BOOST_TEST(read("rows.csv") == whole);
}

BOOST_AUTO_TEST_SUITE_END()
