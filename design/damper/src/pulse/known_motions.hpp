// SPDX-License-Identifier: MIT
#pragma once

#include "pulse/worst_return.hpp"

#include <vector>

namespace stillpoint::design {

/// The motions of one search, which asks for the same f again and again, and for others next to it.
class KnownMotions {
 public:
  explicit KnownMotions(const WorstReturn& profile)
      : profile_(profile), motions_(profile.samples()) {}

  [[nodiscard]] const WorstReturn& profile() const { return profile_; }
  /// Valid until the next one.
  const FirstReturn& at(double f);
  /// The largest need from low to high: of both ends and of the samples between them.
  [[nodiscard]] double need_between(double low, double high, Criterion criterion);
  /// Over f, by the difference to a motion nearby where the worst has no slope of its own.
  [[nodiscard]] double need_slope(double f, Criterion criterion);
  /// All of them from low to high, with both ends.
  [[nodiscard]] std::vector<FirstReturn> between(double low, double high);

 private:
  const WorstReturn& profile_;
  std::vector<FirstReturn> motions_;  ///< by f
};

}  // namespace stillpoint::design
