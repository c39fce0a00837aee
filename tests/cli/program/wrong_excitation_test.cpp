// SPDX-License-Identifier: MIT
#include "forced_arguments.hpp"
#include "refusal.hpp"
#include "run_program.hpp"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(wrong_excitation_test)

namespace {

using namespace stillpoint::cli_test;
namespace data = boost::unit_test::data;

Wrong scene(const char* name, const std::string& excitation, const Texts& says) {
  return {name,
          {"simulate", "-"},
          says,
          R"({"v0": 1, "p": 1, "f": 0.1, "delta": 0.01, "excitation": )" + excitation + "}"};
}

const Arguments step_record{"--record", "values.txt", "--record-step", "1"};

/// At a period of 2 s.
Arguments in_seconds(const char* record) {
  return {"simulate", "--period", "2", "--f", "0.1", "--delta-m", "0", "--record", record};
}

const std::vector<Wrong> wrong_inputs{
    {"type_unknown", pulse("sine"), {"excitation = sine", "harmonic, half-sine"}},
    {"type_empty", pulse(""), {"excitation = ", "must be harmonic"}},
    {"type_in_capitals", pulse("Harmonic"), {"excitation = Harmonic", "must be"}},
    {"k_missing", at_rest({"--excitation", "half-sine", "--lambda", "1"}), {"k is missing", "--k"}},
    {"lambda_missing",
     at_rest({"--excitation", "half-sine", "--k", "1"}),
     {"lambda is missing", "--lambda"}},
    {"lambda_zero",
     at_rest({"--excitation", "rectangle", "--k", "1", "--lambda", "0"}),
     {"lambda = 0", "from 1e-150"}},
    {"lambda_negative",
     at_rest({"--excitation", "half-sine", "--k", "1", "--lambda", "-2"}),
     {"lambda = -2", "from 1e-150"}},
    {"lambda_far_from_p",
     at_rest({"--excitation", "half-sine", "--k", "1", "--lambda", "1e13"}),
     {"lambda = 1", "lambda / p must be from 1e-12"}},
    {"k_too_large",
     at_rest({"--excitation", "half-sine", "--k", "1e151", "--lambda", "1"}),
     {"k = 1e+151", "1e+150"}},
    {"k_no_number",
     at_rest({"--excitation", "half-sine", "--k", "nan", "--lambda", "1"}),
     {"k = ", "nan", "must be"}},
    {"duration_negative",
     pulse("harmonic", {"--duration", "-1"}),
     {"duration = -1", "must be 0 or a number from 1e-150 to 1e+150"}},
    {"duration_too_short",
     pulse("harmonic", {"--duration", "1e-151"}),
     {"duration = 1e-151", "must be 0 or a number from 1e-150"}},
    {"phase_of_a_half_sine", pulse("half-sine", {"--phase", "1"}), {"phase", "half-sine"}},
    {"phase_of_a_full_sine", pulse("full-sine", {"--phase", "1"}), {"phase", "full-sine"}},
    {"duration_of_a_rectangle", pulse("rectangle", {"--duration", "1"}), {"duration", "rectangle"}},
    {"k_without_excitation", at_rest({"--v0", "1", "--k", "1"}), {"k ", "--excitation"}},
    {"k_without_excitation_or_start", at_rest({"--k", "1"}), {"k ", "--excitation"}},
    {"phase_without_excitation", at_rest({"--v0", "1", "--phase", "1"}), {"phase", "--excitation"}},
    {"record_step_without_record",
     at_rest({"--v0", "1", "--record-step", "1"}),
     {"record-step", "--excitation"}},
    {"k_of_a_record", at_rest(joined(step_record, {"--k", "1"})), {"k and excitation record"}},
    {"phase_of_a_record",
     at_rest(joined(step_record, {"--phase", "1", "--excitation", "record"})),
     {"phase and excitation record"}},
    {"record_of_a_harmonic",
     joined(harmonic, {"--record", "values.txt"}),
     {"record and excitation harmonic"}},
    {"record_units_of_a_harmonic",
     joined(harmonic, {"--record-units", "g"}),
     {"record-units and excitation harmonic"}},
    {"record_scale_of_a_pulse",
     pulse("half-sine", {"--record-scale", "2"}),
     {"record-scale and excitation half-sine"}},
    {"end_of_a_harmonic_missing", pulse("harmonic"), {"t-end is missing", "--t-end"}},
    {"end_zero", pulse("half-sine", {"--t-end", "0"}), {"t-end = 0", "from 1e-150 to 1e+150"}},
    {"end_negative", pulse("harmonic", {"--t-end", "-1"}), {"t-end = -1"}},
    {"end_without_excitation", at_rest({"--v0", "1", "--t-end", "1"}), {"t-end", "--excitation"}},
    {"start_missing_without_excitation", at_rest({}), {"v0 is missing"}},
    {"record_missing", at_rest({"--excitation", "record"}), {"record is missing", "--record"}},
    {"record_that_does_not_exist",
     at_rest({"--record", "none.txt"}),
     {"record none.txt", "No such file"}},
    {"record_that_is_empty", at_rest({"--record", "empty.txt"}), {"record empty.txt"}},
    {"record_with_a_text_for_a_number",
     at_rest({"--record", "text.txt"}),
     {"record text.txt, line 4", "much"}},
    {"record_whose_time_does_not_grow",
     at_rest({"--record", "times.txt"}),
     {"record times.txt, line 3", "time 1"}},
    {"record_that_begins_before_0",
     at_rest({"--record", "before.txt"}),
     {"record before.txt, line 2: time -1 tau", "at least 0"}},
    {"record_that_begins_before_0_in_seconds",
     in_seconds("before.txt"),
     {"record before.txt, line 2: time -1 s", "at least 0"}},
    {"record_that_goes_on_too_long",
     in_seconds("long.txt"),
     {"record long.txt, line 2: time 1e+300 s", "at most"}},
    {"record_whose_times_are_too_near",
     in_seconds("near.txt"),
     {"record near.txt, line 2: time 2e-300 s", "too close to 1e-300"}},
    {"record_of_subnormal_values",
     in_seconds("tiny.txt"),
     {"record tiny.txt, line 1, column 3: \"1e-320\" is out of range"}},
    {"record_step_too_small",
     at_rest({"--record", "values.txt", "--record-step", "1e-200"}),
     {"record-step = 1e-200", "1e-150", "tau"}},
    {"record_dt_too_small",
     in_seconds("dense.at2"),
     {"record dense.at2, line 4: DT = 1e-200", " s"}},
    {"pulse_whose_motion_goes_on_too_long",
     {"simulate", "--p", "1", "--f", "0.01", "--delta", "0", "--excitation", "rectangle", "--k",
      "1e100", "--lambda", "1e12"},
     {"t_end is missing", "tau = 4.9348e+90", "give an end before that"}},
    {"record_that_holds_less_than_it_says",
     at_rest({"--record", "short.at2"}),
     {"record short.at2, line ", "4"}},
    {"record_step_missing", at_rest({"--record", "values.txt"}), {"record-step is missing"}},
    {"record_step_zero",
     at_rest({"--record", "values.txt", "--record-step", "0"}),
     {"record-step = 0"}},
    {"record_units_unknown",
     at_rest(joined(step_record, {"--record-units", "km"})),
     {"record-units", "km", "cm/s2"}},
    {"record_scale_zero",
     at_rest(joined(step_record, {"--record-scale", "0"})),
     {"record-scale = 0"}},
    {"gravity_of_a_record_zero", at_rest(joined(step_record, {"--gravity", "0"})), {"gravity = 0"}},
    {"gravity_without_a_record", joined(harmonic, {"--gravity", "9"}), {"gravity", "exclude"}},
    {"excitation_of_design",
     {"design", "--v0", "1", "--p", "1", "--beta", "0.9", "--excitation", "harmonic"},
     {"--excitation", "not an option of design"}},
    {"record_of_region",
     {"region", "--v0", "1", "--p", "1", "--beta", "0.9", "--record", "values.txt"},
     {"--record", "not an option of region"}},
    scene("scene_unknown_key", R"({"type": "half-sine", "k": 1, "lambda": 1, "colour": "red"})",
          {"excitation.colour = \"red\"", "not a key"}),
    scene("scene_key_of_the_motion", R"({"type": "half-sine", "k": 1, "lambda": 1, "x0": 1})",
          {"excitation.x0 = 1", "not a key"}),
    scene("scene_repeated_key", R"({"type": "half-sine", "k": 1, "k": 1, "lambda": 1})",
          {"k is set twice"}),
    scene("scene_key_inside_and_outside", R"({"type": "half-sine", "k": 1, "lambda": 1}, "k": 1)",
          {"k is set twice"}),
    scene("scene_empty", "{}", {"excitation = {}", "must have a type"}),
    scene("scene_without_a_type", R"({"k": 1, "lambda": 1})", {"k ", "--excitation"}),
    scene("scene_type_no_text", R"({"type": 1, "k": 1, "lambda": 1})", {"excitation = 1"}),
    scene("scene_text_for_a_number", R"({"type": "half-sine", "k": "1", "lambda": 1})",
          {"k = \"1\"", "must be a number"}),
    scene("scene_number", "1", {"excitation = 1"}),
    scene("scene_null", "null", {"excitation = null"}),
    scene("scene_k_missing", R"({"type": "half-sine", "lambda": 1})", {"k is missing"}),
    scene("scene_lambda_zero", R"({"type": "half-sine", "k": 1, "lambda": 0})", {"lambda = 0"}),
    scene("scene_within_itself", R"({"type": "half-sine", "excitation": {"k": 1}})",
          {"excitation.excitation", "not a key"}),
};

}  // namespace

BOOST_DATA_TEST_CASE_F(Sandbox, wrong_excitation, data::make(wrong_inputs), wrong) {
  write("values.txt", "0.1\n0.2\n");
  write("empty.txt", "");
  write("text.txt", "# comment\n0 0.1\n1 0.2\n2 much\n");
  write("times.txt", "0 0.1\n1 0.2\n1 0.3\n");
  write("before.txt", "# comment\n-1 0.1\n1 0.2\n");
  write("long.txt", "1e-300 1\n1e300 1\n");
  write("near.txt", "1e-300 1\n2e-300 1\n");
  write("tiny.txt", "0 1e-320\n1 1\n");
  write("dense.at2",
        "A\nB\nACCELERATION TIME HISTORY IN UNITS OF G\nNPTS= 3, DT= 1e-200 SEC\n.1 .2 .3\n");
  write("short.at2",
        "A\nB\nACCELERATION TIME HISTORY IN UNITS OF G\nNPTS= 4, DT= .01 SEC\n.1 .2 .3\n");
  check_refused(*this, wrong);
}

BOOST_FIXTURE_TEST_CASE(wrong_excitation_leaves_the_trajectory_alone, Sandbox) {
  write("motion.csv", "old\n");
  check_refused(*this, {"", pulse("harmonic", {"--trajectory", "motion.csv"}), {"t-end"}});
  BOOST_TEST(read("motion.csv") == "old\n");
}

BOOST_AUTO_TEST_SUITE_END()
