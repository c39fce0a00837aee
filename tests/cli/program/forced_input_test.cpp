// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "forced_arguments.hpp"

BOOST_FIXTURE_TEST_SUITE(forced_input_test, stillpoint::cli_test::Sandbox)

// simulate with an excitation: the ways to say what shakes the base, and what is said of it.

using namespace stillpoint::cli_test;
using std::numbers::pi;

/// The numbers and texts of two responses agree but for rounding.
void check_same_motion(const json& response, const json& expected, double tolerance = 1e-11) {
  for (const auto& [name, value] : expected.items()) {
    BOOST_TEST_CONTEXT("field " << name) {
      if (value.is_number_float() && name != "decision_margin") {
        BOOST_TEST(std::abs(response[name].get<double>() - value.get<double>()) <=
                   tolerance * std::max(1.0, std::abs(value.get<double>())));
      } else if (!value.is_number_float()) {
        BOOST_TEST(response[name] == value);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(units_and_scale_of_a_record_are_converted) {
  const auto answer = [&](double file_scale, const Arguments& more) {
    write("s5.txt", column_file(record_s5(file_scale)));
    return reported(s5 + "--record-step 0.02" + more)["response"];
  };
  const json expected = answer(1, {});
  constexpr double tolerance = 1e-9;  // the file is rounded differently
  check_same_motion(answer(1, "--record-units g"), expected, 0);
  check_same_motion(answer(9.80665, "--record-units m/s2"), expected, tolerance);
  check_same_motion(answer(980.665, "--record-units cm/s2"), expected, tolerance);
  // A gravity that goes with dimensionless input, since it is only the record's.
  check_same_motion(answer(3.7, "--record-units m/s2 --gravity 3.7"), expected, tolerance);
  check_same_motion(answer(0.25, "--record-scale 4"), expected, 0);
}

BOOST_AUTO_TEST_CASE(record_is_in_seconds_with_physical_input) {
  // From rest H = g / omega^2 makes p = 1; tau = omega t with omega = pi.
  write("s5.txt", column_file(record_s5()));
  const json dimensionless =
      reported(s5 + Arguments{"--record-step", in_full(0.02 * pi)})["response"];
  const json report =
      reported("simulate --period 2 --f 0.05 --delta-m 0 --record s5.txt --record-step 0.02");
  BOOST_TEST(near(report["input"]["p"], 1, 1e-15));
  BOOST_TEST(near(report["input"]["excitation"]["duration"], 59.98 * pi, 1e-14));
  check_same_motion(report["response"], dimensionless, 1e-8);
  BOOST_TEST(near(report["physical"]["peak_m"],
                  dimensionless["peak_amplitude"].get<double>() * 9.80665 / (pi * pi), 1e-9));
  BOOST_TEST(
      near(report["physical"]["stop_time_s"], dimensionless["stop_time"].get<double>() / pi, 1e-8));
  BOOST_TEST(report["physical"]["excitation_rad_per_s"].is_null());
  BOOST_TEST(report["physical"]["excitation_duration_s"].is_null());
}

BOOST_AUTO_TEST_SUITE_END()
