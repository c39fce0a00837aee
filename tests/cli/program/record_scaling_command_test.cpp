// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_AUTO_TEST_SUITE(record_scaling_command_test)

// Records that are scaled to a peak or to a value of their spectrum, and folders of records. The
// spectrum itself is in record_scaling_test.

namespace {

using namespace stillpoint::cli_test;

/// Of a figure worked out by hand, after its way through seconds.
constexpr double hand_tolerance = 1e-12;

/// 0.25 g for 5 s.
constexpr const char* long_load = "0 0.25\n1 0.25\n2 0.25\n3 0.25\n4 0.25\n5 0.25\n";

/// The overshoot of the displacement under a constant load.
const double overshoot = 1 + std::exp(-std::numbers::pi * 0.05 / std::sqrt(1 - 0.05 * 0.05));

const Arguments moved("simulate --f 0.05 --delta-m 1mm --period 2.8s");
/// A damper that does not move.
const Arguments held("design --period 2.8s --search-f 100:100 --search-delta-m 0:0");

}  // namespace

BOOST_FIXTURE_TEST_CASE(motion_under_a_record_of_that_peak, Recorded) {
  const Arguments record = moved + "--record a.txt";
  const json twice = reported(record + "--record-scale -2");
  const json peak = reported(record + "--record-peak 0.8g");
  const json excitation = peak["input"]["excitation"];
  check_values(excitation, {{"record_scale", nullptr},
                            {"record_peak", 0.8},
                            {"record_units", nullptr},
                            {"record_units_read", "g"},
                            {"record_units_assumed", true},
                            {"record_factor", 2},
                            {"pga", 0.8}});
  BOOST_TEST(twice["input"]["excitation"]["record_factor"] == -2);
  BOOST_TEST(twice["input"]["excitation"]["pga"] == 0.8);
  // The other way round, the motion is the same.
  BOOST_TEST(peak["response"]["peak_amplitude"] == twice["response"]["peak_amplitude"]);
}

BOOST_FIXTURE_TEST_CASE(motion_under_a_record_of_that_spectrum, Sandbox) {
  write("a.txt", long_load);
  const auto factor = [&](const Arguments& arguments) {
    return reported(arguments)["input"]["excitation"]["record_factor"].get<double>();
  };
  const Arguments record = moved + "--record a.txt --record-spectrum 1g";
  BOOST_TEST(near(factor(record), 1 / (0.25 * overshoot), hand_tolerance));
  BOOST_TEST(
      near(factor(record + "--record-spectrum-period 7s"), 1 / (0.25 * overshoot), hand_tolerance));
  // In tau: half a period of 3 pi is over after 4.7, that of p = 1/2 after 6.3, beyond the load.
  const Arguments plain("simulate --f 0.05 --delta 0 --record a.txt --record-spectrum 0.5 --p 0.5");
  BOOST_TEST(near(factor(plain + "--record-spectrum-period 9.4"), 0.5 / (0.25 * overshoot),
                  hand_tolerance));
  BOOST_TEST(factor(plain) > 1.0001 * 0.5 / (0.25 * overshoot));
}

BOOST_FIXTURE_TEST_CASE(a_motion_that_is_refused_says_what_is_doubtful_of_its_record, Recorded) {
  const ProgramRun refused = ending(2, moved + "--record a.txt --record-scale 1e13");
  BOOST_TEST(contains(refused.err, "warning: record a.txt: is multiplied by 1e+13, to a peak of "),
             refused.err);
  BOOST_TEST(contains(refused.err, "half-cycle-limit"), refused.err);
}

BOOST_FIXTURE_TEST_CASE(a_suite_has_a_factor_for_each_record, Recorded) {
  write("b.txt", long_load);
  write("list.csv", "file,scale\na.txt,2\nb.txt,-1\n");
  write("peaks.csv", "file,peak\r\na.txt,0.2g\r\nb.txt,0.5\r\n");
  write("spectra.csv", "file,spectrum\nb.txt,1\n");
  const auto check = [&](const Arguments& arguments, const std::vector<double>& scales,
                         const std::vector<double>& peaks) {
    const json list = reported(held + arguments)["cases"][0]["motions"];
    BOOST_TEST_REQUIRE(list.size() == scales.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
      BOOST_TEST(near(list[i]["scale"], scales[i], hand_tolerance), list[i].dump());
      BOOST_TEST(near(list[i]["pga"], peaks[i], hand_tolerance), list[i].dump());
      BOOST_TEST(near(list[i]["response"]["peak_absolute_acceleration"], peaks[i], hand_tolerance));
    }
  };
  check("--records-list list.csv", {2, -1}, {0.8, 0.25});
  check("--records-list list.csv --record-scale 1.5", {3, -1.5}, {1.2, 0.375});
  // The factor of the list comes on top of the target.
  check("--records-list list.csv --record-peak 0.6g", {3, -2.4}, {1.2, 0.6});
  check("--records-list peaks.csv --record-scale 2", {1, 4}, {0.4, 1});
  const double spectrum = 1 / (0.25 * overshoot);
  check("--records-list spectra.csv", {spectrum}, {0.25 * spectrum});
  check("--record b.txt --record-spectrum 1g", {spectrum}, {0.25 * spectrum});
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

BOOST_FIXTURE_TEST_CASE(units_that_are_doubtful_are_said, Sandbox) {
  write("a.txt", "0 0\n0.5 250\n1 0\n");
  const std::string doubt = "warning: record a.txt: the largest value is 250 g";
  for (const char* const command : {"simulate", "sweep"}) {
    const Arguments asked = Arguments{command} + "--period 2 --f 0.1 --delta-m 0 --record a.txt";
    BOOST_TEST(contains(succeed(asked).err, doubt));
    BOOST_TEST(succeed(asked + "--record-units cm/s2").err == "");
    BOOST_TEST(succeed(asked + "--record-peak 0.3g").err == "");
  }
}

BOOST_AUTO_TEST_SUITE_END()
