// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

#include <fmt/format.h>

#include <algorithm>

BOOST_AUTO_TEST_SUITE(spectrum_command_test)

// stillpoint spectrum, from the flags to the report. The figures are in spectrum_test.

namespace {

using namespace stillpoint::cli_test;

/// Metres and seconds on the way there and back.
constexpr double units_tolerance = 1e-12;

const Arguments asked(
    "spectrum --record a.txt --period 1s:3s:5 --f 0.02 --delta-m 20mm --hold 0.1");

Arguments but(const std::string& option, const std::string& value) {
  Arguments changed = asked;
  for (std::size_t i = 0; i < changed.size(); ++i) {
    if (changed[i] == option) {
      changed[i + 1] = value;
    }
  }
  return changed;
}

}  // namespace

BOOST_FIXTURE_TEST_CASE(each_point_matches_simulate, Recorded) {
  const json report = reported(asked);
  for (const json& point : report["records"][0]["points"]) {
    const json motion = reported(
        Arguments{"simulate", "--record", "a.txt", "--period", in_full(point["period_s"])} +
        "--f 0.02 --delta-m 20mm --hold 0.1")["physical"];
    check_near(point,
               {{"peak_m", motion["peak_m"]},
                {"jump_m_per_s", motion["jump_m_per_s"]},
                {"residual_m", std::abs(motion["stop_position_m"].get<double>())}},
               units_tolerance);
  }
}

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
    const json& point = report["records"][record]["points"][i % 5];
    BOOST_TEST(csv.number(i, "record") == static_cast<double>(record + 1));
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

/// A notch that holds every load: the structure feels all of it, from the beginning.
BOOST_FIXTURE_TEST_CASE(a_damper_that_locks_is_reported, Recorded) {
  const Arguments locked = but("--hold", "10");
  const json points = reported(locked)["combined"];
  for (const json& point : points) {
    BOOST_TEST(point["locked_from_s"] == 0);
    BOOST_TEST(point["largest_load_while_locked"] == point["peak_absolute_acceleration"]);
  }
  BOOST_TEST(run(locked + "--json --quiet").err.empty());
}

/// A notch that lets go is there to hold the mass at the end; one that holds any load is a trap.
BOOST_FIXTURE_TEST_CASE(a_notch_that_holds_the_mass_at_the_end_is_no_fault, Sandbox) {
  const Arguments damper =
      Arguments("spectrum --period 2s:3s:3 --f 0.03 --delta-m 70mm") +
      Arguments{"--record", STILLPOINT_DATA_DIR "/records/near_fault_pulse.txt"};
  const auto severity = [&](const Arguments& more) {
    const json findings = reported(damper + more)["findings"];
    const auto lock =
        std::ranges::find_if(findings, [](const json& now) { return now["kind"] == "locks"; });
    return lock == findings.end() ? "none" : (*lock)["severity"].get<std::string>();
  };
  BOOST_TEST(severity("--hold 0.1") == "info");
  BOOST_TEST(severity({}) == "caution");
}

BOOST_FIXTURE_TEST_CASE(says_what_the_records_are, Sandbox) {
  write("a.txt", "0 0\n1 200\n2 0\n");
  write("b.AT2", "ACCELERATION IN UNITS OF G\nNPTS= 3, DT= 1 SEC\n0 0.1 0\n");
  write("list.csv", "file,peak\na.txt,0.3g\nb.AT2,0.2g\n");
  const Arguments asked("spectrum --records-list list.csv --period 1s:3s:3 --f 0.05 --delta-m 0");
  const json records = reported(asked)["records"];
  check_values(records[0], {{"units", "g"}, {"units_assumed", true}});
  check_values(records[1], {{"units", "g"}, {"units_assumed", false}, {"scale", 2}, {"pga", 0.2}});
}

BOOST_FIXTURE_TEST_CASE(missing_values_are_left_out, Recorded) {
  const Arguments endless("spectrum --record a.txt --period 2s --f 0 --delta-m 0");
  BOOST_TEST(reported(endless)["combined"][0]["residual_m"] == nullptr);
  const ProgramRun table = run(endless + "--table -");
  BOOST_TEST(read_csv(table.out).at(0, "residual_m").empty());
  succeed(endless + "--table t.npy --quiet");
  BOOST_TEST(std::isnan(read_npy(read("t.npy")).number(0, "residual_m")));
}

/// An ideal notch makes the velocity jump; one with a width is felt as an acceleration.
BOOST_FIXTURE_TEST_CASE(the_largest_jump_stands_beside_the_acceleration, Recorded) {
  const Arguments friction("spectrum --record a.txt --f 0.02");
  const Arguments periods("--period 1s:3s:5");
  const auto largest = [&](const char* notch) {
    double most = 0;
    const json points = reported(friction + periods + notch)["combined"];
    for (const json& point : points) {
      most = std::max(most, point["jump_m_per_s"].get<double>());
    }
    return most;
  };
  const json jolts = finding(reported(friction + periods + "--delta-m 1mm"), "jolts");
  BOOST_TEST(near(jolts["jump_m_per_s"], largest("--delta-m 1mm"), units_tolerance));
  BOOST_TEST(largest("--delta-m 1mm --notch-width-m 20mm") == 0);
  BOOST_TEST(largest("--delta-m 0") == 0);
}

BOOST_FIXTURE_TEST_CASE(a_scene_has_the_same_keys, Recorded) {
  write("scene.json", R"({"record": ["a.txt"], "period": "1s:3s:5", "f": 0.02, "delta_m": "20mm",
                          "hold": 0.1})");
  BOOST_TEST(reported("spectrum scene.json") == reported(asked));
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
