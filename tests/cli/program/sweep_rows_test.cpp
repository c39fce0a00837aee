// SPDX-License-Identifier: MIT
// Each row of a sweep is what its command alone reports: the sweeps of commands/swept.txt, with how
// many rows they have, and of how many a column is not empty.
#include "cli_test.hpp"

BOOST_AUTO_TEST_SUITE(sweep_rows_test)

using namespace stillpoint::cli_test;

/// The command of a row, without what is only for sweeps.
Arguments alone(const Arguments& sweep, const Arguments& inputs) {
  static const std::set<std::string> of_sweeps{"sweep", "--times", "--columns", "--list"};
  Arguments words;
  bool kept = false;
  for (const std::string& word : sweep) {
    if (word.starts_with("--") || word == "sweep") {
      kept = !of_sweeps.contains(word) && std::ranges::find(inputs, word) == inputs.end();
    }
    if (kept) {
      words.push_back(word);
    }
  }
  return words + inputs;
}

/// What a cell may be off by: nothing, or where units of length differ some roundings, which a
/// motion amplifies a few hundred times, and what the search of one optimum leaves.
double allowed(const json& report, double value) {
  constexpr double of_motions = 1e-12;
  constexpr double of_searches = 1e-6;
  if (!report["physical"].is_object()) {
    return 0;
  }
  return report.contains("design")
             ? of_searches * std::abs(value)
             : of_motions *
                   std::max(std::abs(value), std::abs(report["physical"]["peak_m"].get<double>()));
}

bool is_same(const json& report, const json& value, const std::string& cell) {
  if (value.is_number()) {
    const auto number = value.get<double>();
    return !cell.empty() && std::abs(std::stod(cell) - number) <= allowed(report, number);
  }
  return cell == (value.is_null()     ? ""
                  : value.is_string() ? value.get<std::string>()
                                      : value.dump());
}

/// The objects that have the figures of a row.
std::vector<json> places(const json& report, const std::string& damper) {
  if (!damper.empty()) {  // of a front
    const json& front = report["trade_off"];
    return front.empty() ? std::vector<json>() : std::vector{front.at(std::stoul(damper) - 1)};
  }
  if (!report.contains("design")) {
    return {report["physical"], report["response"]};
  }
  return report["design"].is_null()
             ? std::vector<json>()
             : std::vector{report["design"], report["physical"], motion_of(report)["response"]};
}

void check_row(const SweepTable& table, std::size_t row, const json& report) {
  const bool front = std::ranges::count(table.columns, "trade_off") > 0;
  const std::vector<json> all = places(report, front ? table.at(row, "trade_off") : "");
  std::size_t compared = 0;
  for (const std::string& column : table.columns) {
    const std::string& cell = table.at(row, column);
    const auto place = std::ranges::find_if(
        all, [&](const json& now) { return now.is_object() && now.contains(column); });
    if (column == "feasible") {
      BOOST_TEST(cell == (all.empty() ? "false" : "true"));
    } else if (place != all.end()) {
      ++compared;
      BOOST_TEST(is_same(report, (*place)[column], cell),
                 column << ": " << cell << ", alone " << (*place)[column]);
    } else if (all.empty() && (column == "f" || column == "arrival" || column == "tolerance")) {
      BOOST_TEST(cell.empty(), column << ": " << cell);
    }
  }
  BOOST_TEST((all.empty() || compared >= 1));
}

BOOST_AUTO_TEST_CASE(each_row_is_what_its_command_alone_reports) {
  for (const Wrong& sweep : commands_in("swept.txt")) {
    BOOST_TEST_CONTEXT(sweep) {
      const Sandbox sandbox;
      write_files(sandbox, sweep);
      const ProgramRun swept = sandbox.succeed(sweep.arguments);
      BOOST_TEST(swept.err.empty(), swept.err);
      const SweepTable table = read_csv(swept.out);
      std::string told = std::to_string(table.rows.size()) + " rows";
      const std::string column = sweep.says.at(0).substr(sweep.says.at(0).rfind(' ') + 1);
      const bool design = std::ranges::count(table.columns, "feasible") > 0;
      std::map<Arguments, json> reports;  // all dampers of a front are in one
      std::size_t filled = 0;
      for (std::size_t row = 0; row < table.rows.size(); ++row) {
        BOOST_TEST_CONTEXT("row " << row) {
          const Arguments command = Arguments{design ? "design" : "simulate", "--json"} +
                                    alone(sweep.arguments, inputs_of(table, row));
          json& report = reports[command];
          report = report.is_null() ? sandbox.run(command).json() : report;
          check_row(table, row, report);
          filled += column == "rows" || table.at(row, column).empty() ? 0U : 1U;
        }
      }
      if (column != "rows") {
        told += ", " + std::to_string(filled) + " with " + column;
      }
      BOOST_TEST(told == sweep.says.at(0));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
