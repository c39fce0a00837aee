// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "wrong_arguments.hpp"

BOOST_AUTO_TEST_SUITE(sweep_file_test)

using namespace stillpoint::cli_test;
using right::sweep;
using right::with_input;

const Arguments grid("--f 0,0.02,0.3 --delta 0,0.03,0.7 --times");

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

BOOST_FIXTURE_TEST_SUITE(npy, Sandbox)

BOOST_AUTO_TEST_CASE(has_the_values_of_the_csv) {
  const Arguments outcomes(
      "stopped_at_zero stopped_in_dead_zone never_stops caught_at_start running");
  const Arguments forced(
      "--f 0.1,0.4 --delta 0 --excitation harmonic --k 0.2 --lambda 0.35 --t-end 30");
  const Arguments single("sweep --v0 1 --p 1");
  const Arguments designs("sweep --v0 0.9:1.1,0:1 --p 1 --beta 0.5,2 --residual 0.05");
  for (const Arguments& asked :
       {single + grid, single + forced, designs, single + "--beta 0.9 --trade-off 4"}) {
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

BOOST_AUTO_TEST_CASE(of_a_list_gets_its_length_at_the_end) {
  std::string text = "f,delta\n";
  for (int i = 0; i < 1234; ++i) {
    text += "0.1,0.5\n";
  }
  succeed(sweep("--list - --output rows.npy"), with_input(text));
  BOOST_TEST(read_npy(read("rows.npy")).count == 1234);
  succeed(sweep("--list - --output none.npy"), with_input("f,delta\n"));
  BOOST_TEST(read_npy(read("none.npy")).count == 0);
}

BOOST_AUTO_TEST_CASE(of_a_grid_may_go_through_a_pipe) {
  const ProgramRun piped = run(sweep(grid + "--format npy"));
  succeed(sweep(grid + "--output rows.npy"));
  BOOST_TEST(piped.out == read("rows.npy"));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_FIXTURE_TEST_SUITE(file, Sandbox)

BOOST_AUTO_TEST_CASE(is_what_standard_output_would_be) {
  write("rows.csv", "old");
  const ProgramRun answer = succeed(sweep(grid + "--output rows.csv"));
  BOOST_TEST(answer.err.empty(), answer.err);
  BOOST_TEST(answer.out.starts_with("Sweep\n"), answer.out);
  BOOST_TEST(read("rows.csv") == run(sweep(grid)).out);
  BOOST_TEST(contents().size() == 1U);
}

BOOST_AUTO_TEST_CASE(keeps_a_link) {
  fs::create_directory(path("elsewhere"));
  fs::create_symlink("elsewhere/rows.csv", path("link.csv"));
  succeed(sweep(grid + "--output link.csv"));
  BOOST_TEST(fs::is_symlink(path("link.csv")));
  BOOST_TEST(read("elsewhere/rows.csv").starts_with("f,delta,"));
}

BOOST_AUTO_TEST_CASE(may_be_standard_output_or_a_device) {
  BOOST_TEST(run(sweep(grid + "--output /dev/stdout")).out == run(sweep(grid)).out);
  succeed(sweep(grid + "--output /dev/null"));
  BOOST_TEST(contents().empty());
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
