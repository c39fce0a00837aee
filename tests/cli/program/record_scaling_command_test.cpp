// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_AUTO_TEST_SUITE(record_scaling_command_test)

// Records that are scaled to a peak or to a value of their spectrum, and folders of records. The
// spectrum itself is in record_scaling_test.

using namespace stillpoint::cli_test;

/// 0.25 g for 5 s.
constexpr const char* long_load = "0 0.25\n1 0.25\n2 0.25\n3 0.25\n4 0.25\n5 0.25\n";

const Arguments moved("simulate --f 0.05 --delta-m 1mm --period 2.8s");
/// A damper that does not move.
const Arguments held("design --period 2.8s --search-f 100:100 --search-delta-m 0:0");

BOOST_FIXTURE_TEST_CASE(a_motion_that_is_refused_says_what_is_doubtful_of_its_record, Recorded) {
  const ProgramRun refused = ending(2, moved + "--record a.txt --record-scale 1e13");
  BOOST_TEST(contains(refused.err, "warning: record a.txt: is multiplied by 1e+13, to a peak of "),
             refused.err);
  BOOST_TEST(contains(refused.err, "half-cycle-limit"), refused.err);
}

BOOST_FIXTURE_TEST_CASE(a_folder_leaves_out_notes_and_says_so, Sandbox) {
  fs::create_directory(path("suite"));
  write("suite/a.csv", long_load);
  write("suite/notes.txt", "where the record is from\nand who took it\n");
  write("list.csv", "file,scale\nsuite,2\n");
  for (const Arguments& given :
       std::vector<Arguments>{{"--record", "suite"}, {"--records-list", "list.csv"}}) {
    const ProgramRun done = succeed(held + given);
    BOOST_TEST(contains(done.err, "warning: record suite/notes.txt: is left out"), done.err);
    BOOST_TEST(run(held + given + "--quiet").err == "");
  }
}

BOOST_AUTO_TEST_SUITE_END()
