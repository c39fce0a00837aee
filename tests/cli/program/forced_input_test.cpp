// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "forced_arguments.hpp"

BOOST_FIXTURE_TEST_SUITE(forced_input_test, stillpoint::cli_test::Sandbox)

// simulate with an excitation: the ways to say what shakes the base, and what is said of it.

namespace {

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

/// An excitation by flags and as a part of a scene.
struct Kind {
  const char* name;
  Arguments flags;
  const char* scene;
};

std::ostream& operator<<(std::ostream& stream, const Kind& kind) {
  return stream << kind.name;
}

const std::vector<Kind> kinds{
    {"harmonic",
     {"--excitation", "harmonic", "--k", "0.5", "--lambda", "2", "--t-end", "20"},
     R"("excitation": {"type": "harmonic", "k": 0.5, "lambda": 2}, "t_end": 20)"},
    {"harmonic_of_a_phase_and_a_duration",
     {"--excitation", "harmonic", "--k", "0.5", "--lambda", "2", "--phase", "1", "--duration", "9"},
     R"("excitation": {"type": "harmonic", "k": 0.5, "lambda": 2, "phase": 1, "duration": 9})"},
    {"half_sine",
     {"--excitation", "half-sine", "--k", "0.5", "--lambda", "2"},
     R"("excitation": {"type": "half-sine", "k": 0.5, "lambda": 2})"},
    {"full_sine",
     {"--excitation", "full-sine", "--k", "0.5", "--lambda", "2"},
     R"("excitation": {"type": "full-sine", "k": 0.5, "lambda": 2})"},
    {"rectangle",
     {"--excitation", "rectangle", "--k", "0.5", "--lambda", "2"},
     R"("excitation": {"type": "rectangle", "k": 0.5, "lambda": 2})"},
    {"record",
     {"--record", "w.txt", "--record-step", "0.5", "--record-units", "m/s2", "--record-scale", "2"},
     R"("excitation": {"type": "record", "record": "w.txt", "record_step": 0.5,
                       "record-units": "m/s2", "record_scale": 2})"},
    {"record_by_its_type",
     {"--excitation", "record", "--record", "w.txt", "--record-step", "0.5"},
     R"("excitation": "record", "record": "w.txt", "record-step": 0.5)"},
    {"keys_outside_of_the_object",
     {"--excitation", "full-sine", "--k", "0.5", "--lambda", "2"},
     R"("excitation": "full-sine", "k": 0.5, "lambda": 2)"},
};

}  // namespace

BOOST_DATA_TEST_CASE_F(Sandbox, scene_is_as_good_as_flags, data::make(kinds), kind) {
  write("w.txt", "1.9\n1.8\n-1.9\n-1.9\n0\n");
  const json by_flags = reported(at_rest(kind.flags));
  const Surroundings piped{.input = std::string(R"({"p": 1, "f": 0.1, "delta": 0.01, )") +
                                    kind.scene + "}"};
  const json by_scene = reported("simulate -", piped);
  BOOST_TEST(by_scene == by_flags);
  BOOST_TEST(by_flags["response"]["peak_amplitude"].get<double>() > 0.01);
  BOOST_TEST(by_flags["input"]["v0"] == 0);
}

BOOST_AUTO_TEST_CASE(flag_overrides_the_scene) {
  write("scene.json", R"({"p": 1, "f": 0.1, "delta": 0.01, "t_end": 20,
                          "excitation": {"type": "harmonic", "k": 9, "lambda": 2}})");
  const json expected = reported(harmonic);
  BOOST_TEST(reported("simulate scene.json --k 0.5") == expected);
  const json longer = reported("simulate scene.json --t-end 30 --v0 0.1");
  BOOST_TEST(longer["input"]["t_end"] == 30);
  BOOST_TEST(longer["input"]["v0"] == 0.1);
  const json other = reported("simulate --excitation full-sine scene.json --lambda 3");
  BOOST_TEST(other["input"]["excitation"]["type"] == "full-sine");
  BOOST_TEST(other["input"]["excitation"]["k"] == 9);
  BOOST_TEST(near(other["input"]["excitation"]["duration"], 2 * pi / 3, 1e-15));
}

BOOST_AUTO_TEST_CASE(flag_replaces_the_wave_of_a_scene_with_a_record_and_back) {
  write("w.txt", "0.3\n-0.2\n");
  write("wave.json", R"({"p": 1, "f": 0.1, "delta": 0.01,
                         "excitation": {"type": "half-sine", "k": 9, "lambda": 2}})");
  write("record.json", R"({"p": 1, "f": 0.1, "delta": 0.01,
                           "excitation": {"type": "record", "record": "w.txt", "record_step": 1}})");
  const Arguments record("--record w.txt --record-step 1");
  const Arguments wave("--excitation half-sine --k 9 --lambda 2");
  BOOST_TEST(reported("simulate wave.json" + record) == reported("simulate record.json"));
  BOOST_TEST(reported("simulate record.json" + wave) == reported("simulate wave.json"));
}

BOOST_AUTO_TEST_CASE(scene_with_an_excitation_serves_other_commands_with_a_note) {
  const Surroundings surroundings{.input = R"({"v0": 1, "p": 1, "beta": 0.9,
                           "excitation": {"type": "half-sine", "k": 1, "lambda": 2}})"};
  const ProgramRun design = succeed("design - --json", surroundings);
  BOOST_TEST(contains(design.err, "excitation in the scene is not used by design"));
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

BOOST_AUTO_TEST_CASE(waves_may_be_in_tau_with_physical_input) {
  const json report = reported(
      "simulate --velocity 0.4 --period 3 --f 0.02 --delta-m 0.001 "
      "--excitation harmonic --k 0.1 --lambda 0.7 --t-end 30");
  const json& input = report["input"];
  const json same =
      reported({"simulate", "--v0", in_full(input["v0"]), "--p", in_full(input["p"]), "--f", "0.02",
                "--delta", in_full(input["delta"]), "--excitation", "harmonic", "--k", "0.1",
                "--lambda", "0.7", "--t-end", "30"})["response"];
  BOOST_TEST(report["response"] == same);
  BOOST_TEST(same["end_time"] == 30);
}

/// A later load might move the mass again, so that the motion is running, but it does not move.
BOOST_AUTO_TEST_CASE(a_run_that_ends_at_rest_does_not_say_that_it_moves) {
  const Arguments built(
      "simulate --period 2.8 --f 0.024 --delta-m 6mm --notch-width-m 20mm --end-time 12 --json "
      "--record " STILLPOINT_DATA_DIR "/records/strong_motion.AT2");
  const json response = json::parse(run(built).out)["response"];
  check_values(response,
               {{"outcome", "running"}, {"final_velocity", 0}, {"stop_position", nullptr}});
}

BOOST_AUTO_TEST_SUITE_END()
