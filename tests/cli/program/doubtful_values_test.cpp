// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_AUTO_TEST_SUITE(doubtful_values_test)

namespace {

using namespace stillpoint::cli_test;

Arguments design(const Arguments& more) {
  return "region --velocity" + more;
}

Arguments simulate(const Arguments& more) {
  return "simulate --f 0.02" + more;
}

// Nothing to say: no warning. V0/omega of 0.4 m/s and 2.8 s is 0.178 m.
const std::vector<Wrong> doubts{
    {design("0.4 --period 2.8 --max-displacement 150"),
     {"max-displacement = 150 m", "841 times V0/omega", "mean --max-displacement 150mm?"}},
    {design("0.4 --period 2.8 --max-displacement 15"), {"mean --max-displacement 15cm?"}},
    {design("400 --period 2.8 --max-displacement 0.15"), {"mean --velocity 400mm/s?"}},
    {design("0.4 --period 2800 --max-displacement 0.15"), {"mean --period 2800ms?"}},
    {design("0.4 --natural-frequency 360 --max-displacement 0.15"),
     {"mean --natural-frequency 360mHz?"}},
    {design("0.4 --stiffness 6.04MN/m --mass 1200 --max-displacement 0.15"),
     {"mean --mass 1200t?"}},
    {design("0.4 --stiffness 6.04 --mass 1200t --max-displacement 0.15"),
     {"mean --stiffness 6.04MN/m?"}},
    {design("0.4 --period 2.8 --max-displacement 0.15 --delta-max-m 6"),
     {"delta-max-m = 6 m", "mean --delta-max-m 6mm?"}},
    {simulate("--velocity 0.4 --period 2.8 --delta-m 6"), {"delta-m = 6 m", "mean --delta-m 6mm?"}},
    {simulate("--velocity 400 --period 2.8 --delta 0"),
     {"reaches 178 m", "mean --velocity 400mm/s?"}},
    {simulate("--period 2.8 --delta 0 --excitation half-sine --k 0.5 --pulse-duration 50"),
     {"pulse-duration = 50 s", "mean --pulse-duration 50ms?"}},
    {simulate("--period 2.8 --delta 0 --excitation half-sine --k 9.81 --pulse-duration 50ms"),
     {"k = 9.81 is in g", "mean --k 1?"}},
    // The mass never leaves a notch wider than 2 x 0.178 m.
    {simulate("--velocity 0.4 --period 2.8 --delta-m 0.006 --notch-width-m 0.35"), {}},
    {simulate("--velocity 0.4 --period 2.8 --delta-m 0.006 --notch-width-m 20"),
     {"notch-width-m = 20 m is wider than the motion, which reaches 0.178 m",
      "mean --notch-width-m 20mm?"}},
    {simulate("--velocity 0.4 --period 2.8 --delta-m 0.006 --notch-width-m 360mm"),
     {"notch-width-m = 0.36 m is wider than the motion", "without friction\n"}},
    // Values of no usual size, though they may go together.
    {simulate("--velocity 0.4 --period 1e-5 --delta-m 0"),
     {"period = 1e-05 s", "usual 0.05 to 5 s\n"}},
    {simulate("--velocity 0.4 --period 4.9ms --delta-m 0"),
     {"period = 0.0049 s is far from the usual 0.05 to 5 s\n"}},
    {simulate("--velocity 0.4 --period 60 --delta-m 0"),
     {"period = 60 s is far from the usual 0.05 to 5 s", "mean --period 60ms?"}},
    {simulate("--velocity 0.4 --period 5.1ms --delta-m 0"), {}},
    {simulate("--velocity 0.4 --period 49 --delta-m 0"), {}},
    // A period in the wrong unit is at fault, not the stroke.
    {design("0.4 --period 2.8ms --max-displacement 0.15"),
     {"period = 0.0028 s is far from the usual 0.05 to 5 s\n"}},
    {design("0.4 --period 28ms --max-displacement 0.15"),
     {"max-displacement = 0.15 m is 84.1 times", "without friction\n"}},
    {simulate("--velocity 0.4 --period 2.8 --delta-m 1mm --hold 20"), {}},
    {simulate("--velocity 0.4 --period 2.8 --delta-m 1mm --hold 100"),
     {"hold = 100 g is far above the usual values, which are at most 2 g\n"}},
    // A rectangle of 0.5 natural periods moves the mass 2 k g/omega^2 = 3.895 m k.
    {simulate("--period 2.8 --delta 0 --excitation rectangle --pulse-duration 1.4 --k 1.28"), {}},
    {simulate("--period 2.8 --delta 0 --excitation rectangle --pulse-duration 1.4 --k 1.29"),
     {"k = 1.29 g moves the mass 5.02 m without friction; more than 5 m is doubtful\n"}},
    {"region --pulse rectangle --k 1 --pulse-duration 1.4 --period 2.8 --max-displacement 0.19",
     {"max-displacement = 0.19 m is 0.0488 times 3.89 m, the stroke without friction"}},
    {"region --pulse rectangle --k 1 --pulse-duration 1.4 --period 2.8 --max-displacement 0.2", {}},
    // Slower than the mass it moves it k g/omega^2; faster, k g/lambda^2.
    {simulate("--period 2.8 --delta 0 --excitation harmonic --excitation-frequency 0.1 --end-time "
              "40 --k 50"),
     {"k = 50 g moves the mass 97.4 m"}},
    {simulate("--period 2.8 --delta 0 --excitation harmonic --excitation-frequency 10 --end-time 9 "
              "--k 50"),
     {}},
    // 0.4 g for 1 s, 0.2 g for 1 s: at most 0.6 g s, whose energy per weight is 0.18 g s^2 = 1.765
    // m.
    {"simulate --period 2.8 --f 0 --record load.csv --delta-m 1.7", {}},
    {"simulate --period 2.8 --f 0 --record load.csv --delta-m 1.8",
     {"delta-m = 1.8 m takes more than any passage under this load can have, 1.77 m",
      "mean --delta-m 1.8mm?"}},
    {"simulate --period 2.8 --f 0.1 --record load.csv --delta-m 0 --record-peak 50",
     {"record load.csv: is multiplied by 125, to a peak of 50 g; more than 4 is doubtful"}},
    {simulate("--velocity 101 --natural-frequency 100 --delta-m 0"),
     {"velocity = 101 m/s", "usual 0.01 to 10 m/s", "mean --velocity 101mm/s?"}},
    {simulate("--velocity 99 --natural-frequency 100 --delta-m 0"), {}},
    {simulate("--velocity 0.4 --period 2.8 --delta-m 0 --mass 1g"),
     {"mass = 0.001 kg", "usual 1 to 1e+09 kg\n"}},
    {"simulate --velocity 0.4 --period 2.8 --f 20 --delta-m 0",
     {"f = 20 is far above the usual values, which are at most 0.2", "mean --f 0.2?"}},
    {"simulate --velocity 0.4 --period 2.8 --f 300 --delta-m 0",
     {"f = 300 is far above the usual values, which are at most 0.2\n"}},
    {"simulate --v0 1 --p 1 --f 20 --delta 0", {}},
    {"simulate --v0 1e5 --p 1e-5 --f 2 --delta 20", {}},
    {design("0.4 --period 2.8 --max-displacement 0.15 --residual-m 12"),
     {"residual-m = 12 m", "mean --residual-m 12mm?"}},
    {design("0.4 --period 2.8 --max-displacement 0.15 --residual-m 5"),
     {"residual-m = 5 m allows a rest anywhere within max-displacement = 0.15 m",
      "mean --residual-m 5mm?"}},
    {design("0.4 --period 2.8 --max-displacement 0.15 --residual-m 0.15"),
     {"max-displacement = 0.15 m\n"}},
    {design("0.4 --period 2.8 --max-displacement 0.15 --residual-m 0.14"), {}},
    {design("0.36:0.44 --period 2800:2900 --max-displacement 0.15"), {"mean --period 2900ms?"}},
    // A value given with its unit gets a warning, but no other unit is suggested.
    {design("0.4m/s --period 2.8s --max-displacement 150m"),
     {"max-displacement = 150 m", "without friction\n"}},
    // 20 times either way is the edge of what is absurd: V0/omega is 1 m.
    {design("1 --stiffness 1 --mass 1 --max-displacement 19.9"), {}},
    {design("1 --stiffness 1 --mass 1 --max-displacement 20.1"), {"20.1 times"}},
    {design("0.4 --period 2.8 --max-displacement 0.15"), {}},
    {simulate("--natural-frequency 5 --delta-m 0.001 --excitation half-sine --k 50 "
              "--pulse-duration 0.011"),
     {}},
    {"region --v0 1 --p 1 --beta 500", {}},
};

}  // namespace

BOOST_DATA_TEST_CASE_F(Sandbox, doubtful, data::make(doubts), doubt) {
  write("load.csv", "0 0.4\n1 0.4\n1.00001 0.2\n2 0.2\n");
  const ProgramRun answer = run(doubt.arguments);
  BOOST_TEST((answer.exit_code == 0 || answer.exit_code == 3), answer.err);
  BOOST_TEST(!answer.out.empty());
  std::vector<std::string> doubts_of_it = answer.err_lines();
  std::erase_if(doubts_of_it, [](const std::string& line) {
    return line.starts_with("stillpoint: The notch locks ");
  });
  BOOST_TEST(doubts_of_it.size() == (doubt.says.empty() ? 0U : 1U), answer.err);
  check_contains(answer.err, doubt.says);
  for (const std::string& line : doubts_of_it) {
    BOOST_TEST(line.starts_with("stillpoint: warning: "));
  }
  const ProgramRun quiet = run(doubt.arguments + "--quiet");
  BOOST_TEST(quiet.err.empty(), quiet.err);
  BOOST_TEST(quiet.out == answer.out);
}

BOOST_AUTO_TEST_SUITE_END()
