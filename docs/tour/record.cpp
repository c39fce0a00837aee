// SPDX-License-Identifier: MIT
// A forced run: an isolator under a recorded acceleration. The argument is the record's file.

#include <stillpoint/core.hpp>
#include <stillpoint/design.hpp>

#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

namespace {

/// Two columns, time in s and acceleration in g, in the units of time that the motion has.
stillpoint::Record read_record(std::istream& file, double time_s) {
  stillpoint::Record record;
  for (std::string line; std::getline(file, line);) {
    double time = 0;
    double acceleration = 0;
    if (std::istringstream(line) >> time >> acceleration) {  // a comment is no number
      record.times.push_back(time / time_s);
      record.values.push_back(acceleration);
    }
  }
  return record;
}

}  // namespace

int main(int argc, char** argv) {
  std::ifstream file(argc == 2 ? argv[1] : "near_fault_pulse.txt");
  stillpoint::design::PhysicalIsolator isolator;
  isolator.period_s = 2.8;
  const stillpoint::design::Scales scales = physical_scales(isolator, 0.4);

  const stillpoint::ForcedResponse motion = stillpoint::forced_response(
      {.p = scales.p, .f = 0.02, .delta = 0.01}, {}, read_record(file, scales.time_s));

  std::cout << "outcome     " << name(motion.outcome) << '\n'
            << "peak        " << 1000 * motion.peak_amplitude * scales.length_m << " mm\n"
            << "turns       " << motion.turning_points.value() << '\n'
            << "sticks      " << motion.sticks << ", " << motion.stick_time * scales.time_s
            << " s\n"
            << "at rest     " << motion.stop_time.value() * scales.time_s << " s, at "
            << 1000 * motion.stop_position.value() * scales.length_m << " mm\n";
}
