// SPDX-License-Identifier: MIT
#pragma once

namespace stillpoint {

/// Of one number: low <= high.
struct Interval {
  double low{0};
  double high{0};

  friend bool operator==(const Interval&, const Interval&) = default;
};

}  // namespace stillpoint
