// SPDX-License-Identifier: MIT
#pragma once

// The motions of a damper for records by another integrator: docs/records-design.md section 3.

#include <vector>

namespace stillpoint::design {

/// One record by another integrator, and its distance from the kernel.
struct SuiteCheckRow {
  double peak{0};
  double acceleration{0};
  double residual{0};
  double relative_error{0};  ///< of peak and acceleration; of residual over the peak
};

/// Runge-Kutta with a fixed step, events bisected; it shares only the rules with the kernel.
struct SuiteCheck {
  bool passed{false};
  double tolerance{1e-6};  ///< for relative_error
  double relative_error{0};
  double wall_time_s{0};
  std::vector<SuiteCheckRow> records;
};

}  // namespace stillpoint::design
