// SPDX-License-Identifier: MIT
// Sentences that are put together from clauses: each reads as if it were written whole.
#include "cli_test.hpp"

#include <regex>
#include <string>

BOOST_FIXTURE_TEST_SUITE(sentences_test, stillpoint::cli_test::Sandbox)

namespace {

using namespace stillpoint::cli_test;

const Arguments two_records{"--record", STILLPOINT_DATA_DIR "/records/near_fault_pulse.txt",
                            "--record", STILLPOINT_DATA_DIR "/records/strong_motion.AT2"};

/// The title and the verdict.
std::string headline(const ProgramRun& run) {
  return one_line(run.out.substr(0, run.out.find("\n\n")));
}

}  // namespace

// Only a notch wider than the stroke would let the pulse move it, and besides f has no tolerance.
BOOST_AUTO_TEST_CASE(a_damper_for_which_no_notch_works_may_be_too_exact_as_well) {
  const ProgramRun both = run(
      {"design", STILLPOINT_DATA_DIR "/scenes/near_fault_pulse.json", "--objective", "amplitude"});
  check_contains(headline(both), {" The damper found has "});
  check_contains(one_line(both.out), {" fault No notch works: ", " Too exact to be built: "});
}

BOOST_AUTO_TEST_CASE(what_a_pulse_needs_and_what_is_allowed_are_opposed) {
  check_contains(
      headline(run("design --pulse full-sine --k 30 --lambda 2 --p 1 --beta 0.5 --f-max "
                   "0.3")),
      {" a peak within the displacement allowed needs f >= ", ", but f may be at most 0.3. "});
  const json report =
      run("design --pulse rectangle --k 0.5 --lambda 1 --p 1 --beta 0.6 --tolerance 0.5 --json")
          .json();
  check_contains(report["region"]["reason"].get<std::string>(),
                 {", but coming back to x = 0 needs f <= "});
}

BOOST_AUTO_TEST_CASE(what_decides_is_named) {
  check_contains(headline(run("region --v0 1 --p 1 --beta 0.9 --f 0.8 --delta 0.9")),
                 {": it is held by the notch: delta is 80 % too large."});
}

BOOST_AUTO_TEST_CASE(one_of_a_kind_is_singular) {
  check_contains(one_line(run("design --v0 1 --p 0.95:1.05 --beta 1.2 --criterion exact --residual "
                              "0.1 --f-max 0.03 --objective amplitude --verbose")
                              .out),
                 {" after 1 evaluation, "});
}

// 0.3 g of friction hold the mass through the weaker record.
BOOST_AUTO_TEST_CASE(a_notch_that_helps_nowhere_helps_at_no_period) {
  check_contains(
      headline(run("spectrum --period 2.4s:3.2s:3 --f 0.3 --delta-m 20mm" + two_records)),
      {": the notch lowers the residual at no period, "});
}

BOOST_AUTO_TEST_CASE(a_damper_without_friction_or_notch_is_named_by_what_it_has) {
  check_contains(headline(run("design --period 2.8s --mass 1200t --max-displacement 1m --search-f "
                              "0.05:0.05 --search-delta-m 0:0" +
                              two_records)),
                 {" has a friction force of 588.4 kN without a notch, with a period of 2.8 s. "});
}

// 5 % of a period of 0.1 s and all of it are in seconds, as in the tables.
BOOST_AUTO_TEST_CASE(times_of_a_report_have_one_unit) {
  const std::string text =
      run("simulate --velocity 0.4 --natural-frequency 10Hz --f 2 --delta-m 1mm --verbose").out;
  BOOST_TEST(std::regex_search(text, std::regex("stop time +0\\.0[0-9]+ s")), text);
  BOOST_TEST(!contains(text, " ms"), text);
}

BOOST_AUTO_TEST_SUITE_END()
