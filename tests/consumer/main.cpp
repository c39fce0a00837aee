// SPDX-License-Identifier: MIT
// Uses both installed libraries; exits 0 when their answers are right.

#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/design/region.hpp>

#include <cmath>
#include <cstdlib>
#include <iostream>

int main() {
  // Without friction the peak is v0 / p.
  const stillpoint::Response response =
      stillpoint::free_response({.p = 2.0, .f = 0.0, .delta = 0.0}, {.x0 = 0.0, .v0 = 3.0});

  // f3 = v0 p / sqrt(8).
  const stillpoint::design::Region region =
      stillpoint::design::admissible_region({.v0 = 1.0, .p = 1.0, .beta = 1.0});

  std::cout << "peak_amplitude " << response.peak_amplitude << ", f3 " << region.f3 << '\n';
  const bool right = std::abs(response.peak_amplitude - 1.5) < 1e-14 &&
                     std::abs(region.f3 - 1 / std::sqrt(8.0)) < 1e-14;
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
