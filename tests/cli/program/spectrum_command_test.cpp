// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_AUTO_TEST_SUITE(spectrum_command_test)

// stillpoint spectrum, from the flags to the report. The figures are in spectrum_test.

using namespace stillpoint::cli_test;

const Arguments asked(
    "spectrum --record a.txt --period 1s:3s:5 --f 0.02 --delta-m 20mm --hold 0.1");

BOOST_FIXTURE_TEST_CASE(the_table_has_the_numbers_of_the_report, Recorded) {
  write("list.csv", "file,scale\na.txt,-3\n");
  const Arguments two = asked + "--records-list list.csv";
  const json report = reported(two + "--table t.csv --output report.json");
  BOOST_TEST(json::parse(read("report.json")) == report);
  succeed(two + "--table t.npy");
  BOOST_TEST(run(two + "--table -").out == read("t.csv"));
  const SweepTable csv = read_csv(read("t.csv"));
  const NpyFile npy = read_npy(read("t.npy"));
  BOOST_TEST_REQUIRE(csv.rows.size() == 10U);
  BOOST_TEST_REQUIRE(npy.count == 10);
  for (std::size_t i = 0; i < csv.rows.size(); ++i) {
    const std::size_t record = i / 5;
    const json& point = report["motions"][record]["points"][i % 5];
    BOOST_TEST(csv.number(i, "motion") == static_cast<double>(record + 1));
    for (const char* const name :
         {"period_s", "peak_m", "residual_m", "peak_absolute_acceleration", "jump_m_per_s"}) {
      BOOST_TEST(csv.number(i, name) == point[name].get<double>());
    }
    for (const char* const name : {"peak_m", "residual_m", "peak_absolute_acceleration"}) {
      BOOST_TEST(csv.number(i, name + std::string("_without_notch")) ==
                 point["without_notch"][name].get<double>());
    }
    for (const NpyField& field : npy.fields) {
      const double number = npy.number(static_cast<std::int64_t>(i), field.name);
      BOOST_TEST((csv.at(i, field.name).empty() ? std::isnan(number)
                                                : number == csv.number(i, field.name)));
    }
  }
}

BOOST_FIXTURE_TEST_CASE(missing_values_are_left_out, Recorded) {
  const Arguments endless("spectrum --record a.txt --period 2s --f 0 --delta-m 0");
  BOOST_TEST(reported(endless)["combined"][0]["residual_m"] == nullptr);
  const ProgramRun table = run(endless + "--table -");
  BOOST_TEST(read_csv(table.out).at(0, "residual_m").empty());
  succeed(endless + "--table t.npy --quiet");
  BOOST_TEST(std::isnan(read_npy(read("t.npy")).number(0, "residual_m")));
}

BOOST_FIXTURE_TEST_CASE(an_interrupt_writes_nothing, Sandbox) {
  std::string record;
  for (int i = 0; i < 20000; ++i) {
    record += i % 7 < 3 ? "0.3\n" : "-0.2\n";
  }
  write("long.txt", record);
  const Surroundings interrupted{.interrupt = true};
  const ProgramRun stopped = ending(
      130,
      "spectrum --record long.txt --record-step 0.01 --period 0.5:4:10000 --f 0.01 --delta-m "
      "1mm --hold 0.1 --table t.csv",
      interrupted);
  BOOST_TEST(stopped.err == "stillpoint: interrupted: nothing is written\n");
  BOOST_TEST(contents().size() == 1U);
}

BOOST_AUTO_TEST_SUITE_END()
