// SPDX-License-Identifier: MIT
#include "forced_arguments.hpp"
#include "refusal.hpp"
#include "report_fields.hpp"
#include "run_program.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(forced_lists_test)

// Half-cycles and trajectories of forced motions.

namespace {

using namespace stillpoint::cli_test;
using nlohmann::json;
using std::numbers::pi;

}  // namespace

BOOST_FIXTURE_TEST_CASE(half_cycles_are_those_that_are_counted, Sandbox) {
  for (const Arguments& arguments : {s3, s4, harmonic, pulse("half-sine"), pulse("full-sine")}) {
    const json report = reported(arguments);
    const json& response = report["response"];
    const json& list = report["half_cycles"];
    BOOST_TEST(list.size() == response["half_cycles"]);
    BOOST_TEST(report["half_cycles_listed"] == response["half_cycles"]);
    double time = 0;
    double largest = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
      BOOST_TEST(list[i]["index"] == i + 1);
      BOOST_TEST(list[i]["start_time"] == time);
      time = list[i]["end_time"];
      largest = std::max(largest, list[i]["peak"].get<double>());
    }
    BOOST_TEST(near(time, response["end_time"], 1e-13));
    BOOST_TEST(near(largest, response["peak_amplitude"], 1e-14));
  }
}

BOOST_FIXTURE_TEST_CASE(half_cycles_are_capped_as_asked, Sandbox) {
  const json all = reported(s3);
  for (const std::size_t most : {0U, 1U, 30U, 65U, 66U}) {
    const json report = reported(joined(s3, {"--max-half-cycles", std::to_string(most)}));
    const std::size_t listed = std::min<std::size_t>(most, 65);
    BOOST_TEST(report["half_cycles"].size() == listed);
    BOOST_TEST(report["half_cycles_listed"] == listed);
    BOOST_TEST(report["response"] == all["response"]);
    for (std::size_t i = 0; i < listed; ++i) {
      BOOST_TEST(report["half_cycles"][i] == all["half_cycles"][i]);
    }
  }
  // Also of a motion without an end.
  const Arguments endless = free_at_rest("--excitation half-sine --k 1 --lambda 2");
  BOOST_TEST(reported(joined(endless, "--max-half-cycles 3"))["half_cycles"].size() == 3U);
}

namespace {

std::vector<Row> trajectory_of(const Sandbox& sandbox, const std::string& header) {
  const std::string text = sandbox.read("motion.csv");
  check_only_finite(text);
  BOOST_TEST(text.ends_with('\n'));
  std::istringstream stream(text);
  std::string line;
  std::getline(stream, line);
  BOOST_TEST(line == header);
  std::vector<Row> rows;
  while (std::getline(stream, line)) {
    std::istringstream cells(line);
    Row row;
    for (std::string cell; std::getline(cells, cell, ',');) {
      row.push_back(std::stod(cell));
    }
    rows.push_back(row);
  }
  BOOST_TEST(std::ranges::is_sorted(rows, {}, [](const Row& row) { return row[0]; }));
  return rows;
}

}  // namespace

BOOST_FIXTURE_TEST_CASE(trajectory_has_every_event_and_ends_with_the_response, Sandbox) {
  for (const Arguments& arguments : {s3, s4, harmonic}) {
    const json report = reported(joined(arguments, "--trajectory motion.csv --samples 100"));
    const auto rows = trajectory_of(*this, "tau,x,v");
    const json& response = report["response"];
    BOOST_TEST((rows.front() == Row{0, 0, report["input"]["v0"]}));
    BOOST_TEST(rows.back()[0] == response["end_time"].get<double>());
    BOOST_TEST(near(rows.back()[1], response["final_position"], 1e-13));
    BOOST_TEST(near(rows.back()[2], response["final_velocity"], 1e-13));
    const auto at = [&](double tau) {
      std::vector<Row> found;
      std::ranges::copy_if(rows, std::back_inserter(found),
                           [tau](const Row& row) { return row[0] == tau; });
      return found;
    };
    for (const json& now : report["half_cycles"]) {
      if (now["arrival_speed"].is_null()) {
        continue;  // under way at the end
      }
      const auto peak = at(now["peak_time"]);
      BOOST_TEST_REQUIRE(!peak.empty());
      BOOST_TEST(near(peak[0][1], now["side"].get<double>() * now["peak"].get<double>(), 1e-14));
      BOOST_TEST(peak[0][2] == 0);
      const auto passage = at(now["end_time"]);
      BOOST_TEST_REQUIRE(passage.size() == 2U);
      BOOST_TEST(passage[0][1] == 0);
      BOOST_TEST(near(std::abs(passage[0][2]), now["arrival_speed"], 1e-14));
      const std::size_t next = now["index"];
      BOOST_TEST(
          near(std::abs(passage[1][2]), report["half_cycles"][next]["departure_speed"], 1e-14));
    }
    for (int i = 0; i < 100; ++i) {
      const double tau = report["input"]["t_end"].get<double>() * i / 99;
      BOOST_TEST(
          std::ranges::any_of(rows, [tau](const Row& row) { return near(row[0], tau, 1e-14); }),
          "no sample at " << tau);
    }
  }
}

BOOST_FIXTURE_TEST_CASE(rest_under_a_load_ends_its_half_cycle_and_its_trajectory_when_it_begins,
                        Sandbox) {
  const Arguments scene(
      "simulate --v0 1 --p 1 --f 0.8 --delta 0 --excitation rectangle --k 0.5 --lambda 0.1 "
      "--trajectory motion.csv");
  constexpr double stop = 3.797288279831329;
  for (const Arguments& more : {Arguments{}, Arguments("--t-end 50")}) {
    const json report = reported(joined(scene, more));
    BOOST_TEST(near(report["response"]["stop_time"], stop, 1e-15));
    BOOST_TEST(report["half_cycles"].back()["end_time"] == report["response"]["stop_time"]);
    const auto rows = trajectory_of(*this, "tau,x,v");
    BOOST_TEST(rows.back()[0] ==
               (more.empty() ? report["response"]["stop_time"].get<double>() : 50));
  }
}

BOOST_FIXTURE_TEST_CASE(limit_of_half_cycles_refuses_a_longer_motion, Sandbox) {
  const Arguments scene = at_rest("--excitation harmonic --k 0.2 --lambda 1 --t-end 200");
  check_refused(*this, {joined(scene, "--half-cycle-limit 5"),
                        {"half-cycle-limit", "more half-cycles than are allowed", "5 by tau"}});
  BOOST_TEST(
      reported(joined(scene, "--half-cycle-limit 100"))["response"]["half_cycles"].get<double>() >
      5);
}

BOOST_FIXTURE_TEST_CASE(trajectory_of_a_pulse_ends_with_the_motion, Sandbox) {
  const json report = reported(pulse("half-sine", "--trajectory motion.csv"));
  const auto rows = trajectory_of(*this, "tau,x,v");
  BOOST_TEST(near(rows.back()[0], report["response"]["stop_time"], 1e-11));
  BOOST_TEST(near(rows.back()[1], report["response"]["stop_position"], 1e-13));
  BOOST_TEST(rows.back()[2] == 0);
  // It is followed at rest up to an end that is given.
  const json longer = reported(pulse("half-sine", "--trajectory motion.csv --t-end 50"));
  BOOST_TEST(trajectory_of(*this, "tau,x,v").back() ==
             (Row{50, longer["response"]["stop_position"], 0}));
  BOOST_TEST(longer["response"]["end_time"] == longer["response"]["stop_time"]);
  // Ten periods more where there is no end.
  const json endless =
      reported(free_at_rest("--excitation half-sine --k 1 --lambda 2 --trajectory motion.csv"));
  BOOST_TEST(endless["response"]["outcome"] == "never_stops");
  BOOST_TEST(near(trajectory_of(*this, "tau,x,v").back()[0], pi / 2 + 20 * pi, 1e-13));
}

BOOST_FIXTURE_TEST_CASE(trajectory_of_nothing_that_moves_stays_at_its_place_to_the_end, Sandbox) {
  const json report =
      reported(at_rest("--excitation harmonic --k 0.1 --lambda 1 --t-end 9 "
                       "--trajectory motion.csv --samples 5"));
  const auto rows = trajectory_of(*this, "tau,x,v");
  BOOST_TEST(report["response"]["stop_time"] == 0);
  BOOST_TEST(rows.back()[0] == 9);
  BOOST_TEST(std::ranges::all_of(rows, [](const Row& row) { return row[1] == 0 && row[2] == 0; }));
}

BOOST_FIXTURE_TEST_CASE(trajectory_of_physical_input_has_metres_and_seconds, Sandbox) {
  write("s5.txt", column_file(record_s5()));
  const json report = reported(
      "simulate --period 2 --f 0.05 --delta-m 0 --record s5.txt "
      "--record-step 0.02 --trajectory motion.csv --samples 50");
  const auto rows = trajectory_of(*this, "tau,x,v,t_s,x_m,v_m_per_s");
  const json& quantities = report["physical"];
  double peak = 0;
  for (const Row& row : rows) {
    BOOST_TEST(near(row[3], row[0] * quantities["time_unit_s"].get<double>(), 1e-15));
    peak = std::max(peak, std::abs(row[4]));
  }
  BOOST_TEST(near(peak, quantities["peak_m"], 1e-14));
  BOOST_TEST(near(rows.back()[3], quantities["stop_time_s"], 1e-11));
}

BOOST_AUTO_TEST_SUITE_END()
