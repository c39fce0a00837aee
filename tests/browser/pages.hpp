// SPDX-License-Identifier: MIT
#pragma once

#include "run_program.hpp"

namespace stillpoint::browser_test {

/// The pages under test, written by the program, by name: design, infeasible, arrivals, free,
/// forced, region, pulse, sweep (with a logarithmic axis), trade_off, varying, records. All are
/// made once for the whole test program.
struct Pages {
  Pages();

  cli_test::Sandbox sandbox;
  std::map<std::string, nlohmann::json> reports;  ///< what --json said beside the page
};
[[nodiscard]] const Pages& pages();

enum class Scheme { light, dark };

/// What probe.js reported: [page][look], where a look is "1280" or "400" (the width of the window
/// in pixels) or "print" (laid out as on paper 700 pixels wide). One run of the browser per colour
/// scheme.
[[nodiscard]] const nlohmann::json& seen(Scheme scheme);

/// Some rows of the sweep that the page "sweep" draws.
struct MapRow {
  double f;
  double delta;
  double half_cycles;
  std::string outcome;
};
[[nodiscard]] std::vector<MapRow> map_rows();

/// Points of curves and maps that the probe hovers over, by figure; from the reports and closed
/// forms only, in the units of the figure.
[[nodiscard]] nlohmann::json points_of_interest(const std::string& page);

/// The factor of figures in millimetres for dimensionless lengths.
[[nodiscard]] double millimetres(const nlohmann::json& report);

}  // namespace stillpoint::browser_test
