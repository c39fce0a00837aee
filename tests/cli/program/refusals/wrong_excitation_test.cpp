// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "forced_arguments.hpp"

BOOST_AUTO_TEST_SUITE(wrong_excitation_test)

namespace {

using namespace stillpoint::cli_test;

Wrong scene(const std::string& excitation, const Texts& says) {
  return {"simulate -", says,
          R"({"v0": 1, "p": 1, "f": 0.1, "delta": 0.01, "excitation": )" + excitation + "}"};
}

const Arguments step_record("--record values.txt --record-step 1");

const std::vector<Wrong> wrong_inputs{
    {pulse("sine"), {"excitation = sine", "harmonic, half-sine"}},
    {pulse("half-sin"), {"rectangle or record; did you mean half-sine?"}},
    {pulse("sin"), {"rectangle or record\n"}},
    {at_rest("--excitation half-sine --lambda 1"), {"k is missing", "--k"}},
    {at_rest("--excitation half-sine --k 1"), {"lambda is missing", "--lambda"}},
    {at_rest("--excitation rectangle --k 1 --lambda 0"), {"lambda = 0", "from 1e-150"}},
    {at_rest("--excitation half-sine --k 1 --lambda 1e13"),
     {"lambda = 1", "lambda / p must be from 1e-12"}},
    {at_rest("--excitation half-sine --k 1e151 --lambda 1"), {"k = 1e+151", "1e+150"}},
    {at_rest("--excitation half-sine --k nan --lambda 1"), {"k = ", "nan", "must be"}},
    {pulse("harmonic", "--duration -1"),
     {"duration = -1", "must be 0 or a number from 1e-150 to 1e+150"}},
    {pulse("harmonic", "--duration 1e-151"),
     {"duration = 1e-151", "must be 0 or a number from 1e-150"}},
    {pulse("half-sine", "--phase 1"), {"phase and excitation half-sine", "only a harmonic"}},
    {pulse("rectangle", "--duration 1"), {"duration and excitation rectangle", "--lambda gives"}},
    {at_rest("--k 1"), {"k ", "--excitation"}},
    {at_rest("--v0 1 --record-step 1"), {"record-step needs a record: give --record"}},
    {at_rest("--record times.txt --record-spectrum-period 1"),
     {"record-spectrum-period needs a spectral value: give --record-spectrum"}},
    {at_rest(step_record + "--k 1"), {"k and excitation record"}},
    {at_rest(step_record + "--phase 1 --excitation record"), {"phase and excitation record"}},
    {harmonic + "--record values.txt", {"record and excitation harmonic"}},
    {harmonic + "--record-units g", {"record-units and excitation harmonic"}},
    {pulse("harmonic"), {"t-end is missing", "--t-end"}},
    {pulse("half-sine", "--t-end 0"), {"t-end = 0", "from 1e-150 to 1e+150"}},
    {at_rest("--v0 1 --t-end 1"), {"t-end", "--excitation"}},
    {at_rest({}), {"v0 is missing"}},
    {at_rest("--excitation record"), {"record is missing", "--record"}},
    {at_rest("--record none.txt"), {"record none.txt", "No such file"}},
    {at_rest("--record text.txt"), {"record text.txt, line 4", "much"}},
    {at_rest("--record values.txt --record-step 1e-200"),
     {"record-step = 1e-200", "1e-150", "tau"}},
    {"simulate --p 1 --f 0.01 --delta 0 --excitation rectangle --k 1e100 --lambda 1e12",
     {"t_end is missing", "tau = 4.9348e+90", "give an earlier end"}},
    {at_rest("--record values.txt"), {"record-step is missing"}},
    {at_rest("--record values.txt --record-step 0"), {"record-step = 0"}},
    {at_rest(step_record + "--record-units km"), {"record-units", "km", "cm/s2"}},
    {at_rest(step_record + "--record-scale 0"), {"record-scale = 0"}},
    {at_rest(step_record + "--gravity 0"), {"gravity = 0"}},
    {harmonic + "--gravity 9", {"gravity", "cannot be combined"}},
    {"design --v0 1 --p 1 --beta 0.9 --excitation harmonic",
     {"--excitation", "not an option of design", "a design takes --pulse"}},
    scene(R"({"type": "half-sine", "k": 1, "lambda": 1, "colour": "red"})",
          {"excitation.colour = \"red\"", "not a key"}),
    scene(R"({"type": "half-sine", "k": 1, "lambda": 1, "x0": 1})",
          {"excitation.x0 = 1", "not a key"}),
    scene(R"({"type": "half-sine", "k": 1, "k": 1, "lambda": 1})", {"k is set twice"}),
    scene(R"({"type": "half-sine", "k": 1, "lambda": 1}, "k": 1)", {"k is set twice"}),
    scene(R"({"k": 1, "lambda": 1})", {"k ", "--excitation"}),
    scene(R"({"type": 1, "k": 1, "lambda": 1})", {"excitation = 1"}),
    scene(R"({"type": "half-sine", "k": "1", "lambda": 1})", {"k = \"1\"", "must be a number"}),
    scene("1", {"excitation = 1"}),
    scene(R"({"type": "half-sine", "excitation": {"k": 1}})",
          {"excitation.excitation", "not a key"}),
};

}  // namespace

BOOST_DATA_TEST_CASE_F(Sandbox, wrong_excitation, data::make(wrong_inputs), wrong) {
  write("values.txt", "0.1\n0.2\n");
  write("text.txt", "# comment\n0 0.1\n1 0.2\n2 much\n");
  write("times.txt", "0 0.1\n1 0.2\n1 0.3\n");
  check_refused(*this, wrong);
}

BOOST_FIXTURE_TEST_CASE(wrong_excitation_leaves_the_trajectory_alone, Sandbox) {
  write("motion.csv", "old\n");
  check_refused(*this, {pulse("harmonic", "--trajectory motion.csv"), {"t-end"}});
  BOOST_TEST(read("motion.csv") == "old\n");
}

BOOST_AUTO_TEST_SUITE_END()
