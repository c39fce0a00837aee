// SPDX-License-Identifier: MIT
// A design: from an isolator in metres and seconds to a checked damper.

#include <stillpoint/design.hpp>

#include <iostream>

int main() {
  // A period of 2.8 s, a hit of 0.4 m/s, room for 150 mm; f and delta may be off by 5 %.
  const double velocity = 0.4;
  stillpoint::design::PhysicalIsolator isolator;
  isolator.period_s = 2.8;
  isolator.mass_kg = 1.2e6;
  const stillpoint::design::Scales scales = physical_scales(isolator, velocity);

  stillpoint::design::DesignRequest request;
  request.problem = {
      .v0 = velocity / scales.velocity_m_per_s, .p = scales.p, .beta = 0.15 / scales.length_m};
  request.limits.tolerance = 0.05;
  request.search.objective = stillpoint::design::Objective::acceleration;

  const stillpoint::design::DesignResult result = stillpoint::design::design(request);
  if (!result.finding) {
    std::cout << "no damper works: " << *result.reason << '\n';
    return 1;
  }
  const stillpoint::design::Found& found = *result.finding;
  std::cout << "f             " << found.point.f << '\n'
            << "delta         " << 1000 * scales.delta_m(found.point.delta) << " mm\n"
            << "friction      " << *scales.friction_force_n(found.point.f) / 1000 << " kN\n"
            << "peak          " << 1000 * found.response.peak_amplitude * scales.length_m << " mm\n"
            << "stop time     " << found.response.stop_time.value() * scales.time_s << " s\n"
            << "may be off    " << 100 * found.point.tolerance << " %\n"
            << "cross-check   " << (found.cross_check.passed ? "agrees" : "DISAGREES") << '\n';
}
