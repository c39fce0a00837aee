// SPDX-License-Identifier: MIT
// Uses the installed libraries; exits 0 when their answers are right. That the headers compile
// shows that none needs one that is not installed.

#include <stillpoint/design.hpp>
#include <stillpoint/records/record_file.hpp>
#include <stillpoint/sweep/axis.hpp>

#include <cmath>
#include <cstdlib>
#include <iostream>

int main() {
  // Without friction the peak is v0 / p.
  const stillpoint::Response motion =
      stillpoint::free_response({.p = 2, .f = 0, .delta = 0}, {.x0 = 0, .v0 = 3});

  // Where amplitude does not bind, the best tolerance by the published criterion is 0.36336.
  const stillpoint::design::DesignResult result =
      stillpoint::design::design({.problem = {.v0 = 1, .p = 1, .beta = 0.9}});

  const stillpoint::records::RecordFile file =
      stillpoint::records::parse_record("0.1\n0.2\n", "text", {.step = 0.02});
  const stillpoint::sweep::Axis axis = stillpoint::sweep::parse_axis("f", "0:1:5");

  const double tolerance = result.finding ? result.finding->point.tolerance : 0;
  std::cout << "peak_amplitude " << motion.peak_amplitude << ", tolerance " << tolerance << '\n';
  const bool right = std::abs(motion.peak_amplitude - 1.5) < 1e-14 &&
                     std::abs(tolerance - 0.36336281) < 1e-8 && file.record.values.size() == 2 &&
                     axis[1] == 0.25;
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
