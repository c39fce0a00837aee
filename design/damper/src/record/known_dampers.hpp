// SPDX-License-Identifier: MIT
#pragma once

// Dampers whose figures are known: a limit that one of them breaks is broken by every box that
// holds it, so that such a box need not be sampled.

#include "record/suite_space.hpp"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace stillpoint::design {

/// Those that one search sampled.
class KnownDampers {
 public:
  explicit KnownDampers(const SuiteSpace& space) : axes_(space.axes()) {}

  void add(std::span<const SuiteDamper> dampers, std::span<const TaskFigures> figures);
  /// Those of another search for dampers with the same variables.
  void add(const KnownDampers& others);
  /// Of those in the box of a damper; no figure at all if none is known there.
  [[nodiscard]] TaskFigures worst(const SuiteDamper& nominal) const;
  /// Those that break a limit.
  [[nodiscard]] KnownDampers breaking(const std::vector<SuiteLimits>& limits) const;

 private:
  explicit KnownDampers(std::vector<SuiteAxis> axes) : axes_(std::move(axes)) {}

  std::vector<SuiteAxis> axes_;
  std::vector<SuitePlace> values_;
  std::vector<TaskFigures> figures_;
};

}  // namespace stillpoint::design
