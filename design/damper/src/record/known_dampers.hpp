// SPDX-License-Identifier: MIT
#pragma once

// Dampers whose figures are known: a limit that one of them breaks is broken by every box that
// holds it, so that such a box need not be sampled.

#include "record/suite_space.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace stillpoint::design {

/// Those that one search sampled.
class KnownDampers {
 public:
  explicit KnownDampers(const SuiteSpace& space) : space_(space) {}

  void add(std::span<const SuiteDamper> dampers, std::span<const SuiteFigures> figures);
  /// Of those in the box of a damper; no figure at all if none is known there.
  [[nodiscard]] SuiteFigures worst(const SuiteDamper& nominal) const;

 private:
  const SuiteSpace& space_;
  std::vector<SuitePlace> values_;
  std::vector<SuiteFigures> figures_;
};

}  // namespace stillpoint::design
