// SPDX-License-Identifier: MIT
#include "motion.hpp"
#include "reference_rows.hpp"

// Whole motions against numbers from other programs. The file is written by
// data/reference/make_forced_reference.py; S5 stands in it with its record rounded.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(forced_reference_test)

// A few hundred events, each of which may add the rounding of a time: 1e-15 each.
constexpr double position_tolerance = 1e-12;
constexpr double time_tolerance = 1e-12;

void check(const ReferenceRow& row) {
  BOOST_TEST_CONTEXT(row.cells[0]) {
    const Record record = rounded_record_s5();
    const bool shaken = row.cells[8] == "record";
    const double t_end =
        shaken ? record.step * static_cast<double>(record.values.size() - 1) : row[11];
    const Excitation excitation = shaken        ? Excitation(record)
                                  : row[8] == 0 ? Excitation(NoExcitation{})
                                                : Harmonic{row[8], row[9], row[10]};
    const ForcedResponse response =
        until(t_end, {row[3], row[4], row[5], {}, row[6], row[7]}, {row[1], row[2]}, excitation);
    close(response.peak_amplitude, row[12], position_tolerance);
    close(*response.final_position, row[13], position_tolerance);
    close(*response.final_velocity, row[14], position_tolerance);
    BOOST_TEST(*response.zero_passages == row[15]);
    BOOST_TEST(*response.turning_points == row[16]);
    BOOST_TEST(response.sticks == row[17]);
    close(response.stick_time, row[18], time_tolerance);
    close(response.peak_absolute_acceleration, row[19], position_tolerance);
  }
}

BOOST_AUTO_TEST_CASE(scene_s5_has_its_known_peak_end_and_count) {
  const auto response = until(59.98, {1, 0.05, 0}, {0, 0}, record_s5());
  close(response.peak_amplitude, 0.098335012538125103, position_tolerance);
  close(*response.final_position, -0.0015776946596039220, position_tolerance);
  BOOST_TEST(*response.zero_passages == 18);
}

BOOST_AUTO_TEST_CASE(every_motion_of_the_reference_file_is_reproduced) {
  const std::vector<ReferenceRow> all = reference_rows(
      "forced_motion.csv",
      "name,x0,v0,p,f,delta,zeta,breakaway,k,lambda,phase,t_end,peak_amplitude,final_position,"
      "final_velocity,zero_passages,turning_points,sticks,stick_time,peak_absolute_acceleration");
  BOOST_TEST(all.size() == 24U);
  for (const ReferenceRow& row : all) {
    check(row);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
