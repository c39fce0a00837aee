// SPDX-License-Identifier: MIT
// Sweeps without rows say of the rows what the rows themselves would.
#include "cli_test.hpp"

BOOST_AUTO_TEST_SUITE(sweep_reduce_test)

using namespace stillpoint::cli_test;

/// Motions without friction that never stop, with little of it, and caught at the start.
const Arguments motions("sweep --v0 1 --p 1 --f 0:0.35:15 --delta 0:0.6:13 --times");
const Arguments designs("sweep --v0 0.5:1:4 --p 1 --beta 0.4:0.9:23");
const Arguments asked(
    "--reduce --histogram peak_amplitude:0.7:0.95:6 --histogram stop_time:1:40:5:log");

/// The numbers of a column, where there are any, with their places from 1.
std::vector<std::pair<double, std::int64_t>> numbers(const SweepTable& table,
                                                     const std::string& column) {
  std::vector<std::pair<double, std::int64_t>> found;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    if (!table.at(i, column).empty()) {
      found.emplace_back(table.number(i, column), static_cast<std::int64_t>(i) + 1);
    }
  }
  return found;
}

/// Asserts that the row of a report is that row of the table.
void check_row(const json& row, const SweepTable& table) {
  const std::size_t place = row.at("entry").get<std::size_t>() - 1;
  BOOST_TEST(row.size() == table.columns.size() + 1);
  for (const std::string& column : table.columns) {
    const std::string& text = table.at(place, column);
    const json& value = row.at(column);
    if (value.is_number()) {
      BOOST_TEST(value.get<double>() == std::stod(text));
    } else {
      BOOST_TEST((value.is_null()     ? ""
                  : value.is_string() ? value.get<std::string>()
                                      : value.dump()) == text);
    }
  }
}

/// Asserts what a report says of a column, from its rows.
void check_column(const json& report, const SweepTable& table) {
  const std::string column = report.at("column");
  BOOST_TEST_CONTEXT(column) {
    auto values = numbers(table, column);
    const auto count = std::ssize(values);
    BOOST_TEST(report.at("count") == count);
    BOOST_TEST(report.at("absent").get<std::int64_t>() +
                   report.at("infinite").get<std::int64_t>() ==
               std::ssize(table.rows) - count);
    std::ranges::sort(values);  // of equal values the first entry
    if (values.empty()) {
      BOOST_TEST(report.at("least").is_null());
      return;
    }
    BOOST_TEST(report.at("least").at("entry") == values.front().second);
    const double largest = values.back().first;
    const auto first_largest =
        std::ranges::find(values, largest, [](const auto& one) { return one.first; });
    BOOST_TEST(report.at("largest").at("entry") == first_largest->second);
    check_row(report.at("least"), table);
    check_row(report.at("largest"), table);
  }
}

void check_histogram(const json& histogram, const SweepTable& table) {
  const auto values = numbers(table, histogram.at("column"));
  const std::vector<double> edges = histogram.at("edges");
  const auto within = [&](double low, double high, bool with_high) {
    return std::ranges::count_if(values, [&](const auto& one) {
      return low <= one.first && (with_high ? one.first <= high : one.first < high);
    });
  };
  BOOST_TEST_REQUIRE(histogram.at("counts").size() + 1 == edges.size());
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    BOOST_TEST(histogram.at("counts").at(i) ==
               within(edges[i], edges[i + 1], i + 2 == edges.size()));
  }
  BOOST_TEST(histogram.at("below") == within(-INFINITY, edges.front(), false));
  BOOST_TEST(histogram.at("below").get<std::int64_t>() + histogram.at("above").get<std::int64_t>() +
                 within(edges.front(), edges.back(), true) ==
             std::ssize(values));
}

struct Reduced : Sandbox {
  /// Asserts that what it says about its rows is true.
  void check_true(const Arguments& sweep, const Arguments& more) const {
    const SweepTable table = read_csv(run(sweep).out);
    const json found = reported(sweep + more);
    BOOST_TEST(found.at("rows") == table.rows.size());
    if (found.at("outcomes").is_object()) {
      for (const auto& [outcome, count] : found.at("outcomes").items()) {
        std::int64_t there = 0;
        for (std::size_t i = 0; i < table.rows.size(); ++i) {
          there += table.at(i, "outcome") == outcome ? 1 : 0;
        }
        BOOST_TEST(count == there, outcome);
      }
    } else {
      BOOST_TEST(found.at("feasible") == numbers(table, "f").size());
    }
    if (found.at("kind") == "forced") {
      BOOST_TEST(found.at("locked") == numbers(table, "locked_from").size());
    }
    for (const json& column : found.at("columns")) {
      check_column(column, table);
    }
    for (const json& histogram : found.at("histograms")) {
      check_histogram(histogram, table);
    }
  }
};

BOOST_FIXTURE_TEST_SUITE(reductions, Reduced)

BOOST_AUTO_TEST_CASE(match_the_rows) {
  check_true(motions, asked);
  check_true(designs, "--reduce --histogram delta:0,0.05,0.1,0.4 --histogram delta:0:0.4:1");
  check_true(
      "sweep --p 1 --f 0.05:0.2:9 --delta 0 --excitation harmonic --k 0.2 --lambda 0.35 --t-end 20",
      "--reduce");
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
