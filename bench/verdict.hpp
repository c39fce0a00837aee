// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/peers/reference.hpp>

#include <string>

namespace stillpoint::bench {

/// The errors of a result. They are absolute, in the dimensionless units of the
/// scene.
struct Verdict {
  double peak{0};
  double end{0};  ///< of the stop time of a free motion; of x and v at the end of a forced one
  bool counts_right{
      false};          ///< passages, turns, sticks; for a free motion also that it stops at zero
  std::string counts;  ///< "64, 64, 0"

  [[nodiscard]] double largest() const { return peak > end ? peak : end; }
  /// Right counts and no error above `bound`.
  [[nodiscard]] bool reaches(double bound) const { return counts_right && largest() <= bound; }
};

[[nodiscard]] Verdict judge(const peers::ReferenceScene& scene, const peers::Result& result);

/// "passages, turns, sticks"
[[nodiscard]] std::string counts_of(const peers::Result& result);

}  // namespace stillpoint::bench
