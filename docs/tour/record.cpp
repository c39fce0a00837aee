// SPDX-License-Identifier: MIT
// A forced run: an isolator under a recorded acceleration. The argument is the record's file.

#include <stillpoint/core.hpp>
#include <stillpoint/design.hpp>
#include <stillpoint/records/record_file.hpp>

#include <iostream>

int main(int argc, char** argv) {
  stillpoint::design::PhysicalIsolator isolator;
  isolator.period_s = 2.8;
  const stillpoint::design::Scales scales = physical_scales(isolator, 0.4);

  const stillpoint::records::RecordFile file = stillpoint::records::read_record(
      argc == 2 ? argv[1] : "near_fault_pulse.txt",
      {.clock = {.unit = "s", .per_tau = scales.time_s, .p = scales.p}});

  const stillpoint::ForcedResponse motion =
      stillpoint::forced_response({.p = scales.p, .f = 0.02, .delta = 0.01}, {}, file.record);

  std::cout << "outcome     " << name(motion.outcome) << '\n'
            << "peak        " << 1000 * motion.peak_amplitude * scales.length_m << " mm\n"
            << "turns       " << motion.turning_points.value() << '\n'
            << "sticks      " << motion.sticks << ", " << motion.stick_time * scales.time_s
            << " s\n"
            << "at rest     " << motion.stop_time.value() * scales.time_s << " s, at "
            << 1000 * motion.stop_position.value() * scales.length_m << " mm\n";
}
