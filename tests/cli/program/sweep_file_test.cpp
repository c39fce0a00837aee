// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_AUTO_TEST_SUITE(sweep_file_test)

using namespace stillpoint::cli_test;

/// The number in the file where the CSV is empty.
double absent(const SweepTable& table, std::size_t row, const std::string& column) {
  const bool endless = std::ranges::count(table.columns, "outcome") > 0 &&
                       table.at(row, "outcome") == "never_stops" && column != "stop_position";
  return endless ? std::numeric_limits<double>::infinity()
                 : std::numeric_limits<double>::quiet_NaN();
}

bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

BOOST_FIXTURE_TEST_CASE(npy_has_the_values_of_the_csv, Sandbox) {
  const Arguments outcomes(
      "stopped_at_zero stopped_in_dead_zone never_stops caught_at_start running "
      "too_many_half_cycles");
  const Arguments forced(
      "--f 0.1,0.4 --delta 0 --excitation harmonic --k 0.2 --lambda 0.35 --t-end 30");
  const Arguments single("sweep --v0 1 --p 1");
  const Arguments designs("sweep --v0 0.9:1.1,0:1 --p 1 --beta 0.5,2 --residual 0.05");
  write("list.csv", "f,delta\n0.1,0.2\n1e-12,1e-30\n0.02,0.03\n");
  for (const Arguments& asked :
       {single + "--f 0,0.02,0.3 --delta 0,0.03,0.7 --times", single + forced,
        single + "--list list.csv --times", designs, single + "--beta 0.9 --trade-off 4"}) {
    const SweepTable table = read_csv(run(asked).out);
    succeed(asked + "--output rows.npy");
    const NpyFile npy = read_npy(read("rows.npy"));
    BOOST_TEST_REQUIRE(npy.fields.size() == table.columns.size());
    BOOST_TEST_REQUIRE(npy.count == static_cast<std::int64_t>(table.rows.size()));
    for (std::size_t i = 0; i < npy.fields.size(); ++i) {
      const auto& [column, type] = npy.fields[i];
      BOOST_TEST(column == table.columns[i]);
      BOOST_TEST(type == (column == "outcome" ? "|u1" : column == "feasible" ? "|b1" : "<f8"));
      for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const std::string& text = table.at(row, column);
        const auto record = static_cast<std::int64_t>(row);
        if (column == "outcome") {
          BOOST_TEST(outcomes.at(static_cast<std::size_t>(npy.byte(record, column))) == text);
        } else if (column == "feasible") {
          BOOST_TEST(npy.byte(record, column) == (text == "true" ? 1 : 0));
        } else {
          const double expected =
              text.empty() ? absent(table, row, column) : table.number(row, column);
          BOOST_TEST(same(npy.number(record, column), expected), column << " in row " << row);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
