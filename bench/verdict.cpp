// SPDX-License-Identifier: MIT
#include "verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stillpoint::bench {

std::string counts_of(const peers::Result& result) {
  return fmt::format("{}, {}, {}", result.passages, result.turns, result.sticks);
}

Verdict judge(const peers::ReferenceScene& scene, const peers::Result& result) {
  const peers::Result& truth = scene.truth;
  Verdict verdict;
  verdict.peak = std::abs(result.peak - truth.peak);
  verdict.end = scene.free ? std::abs(result.end_time - truth.end_time)
                           : std::max(std::abs(result.x - truth.x), std::abs(result.v - truth.v));
  verdict.counts = counts_of(result);
  verdict.counts_right = result.finished && verdict.counts == counts_of(truth) &&
                         (!scene.free || result.outcome == truth.outcome);
  return verdict;
}

}  // namespace stillpoint::bench
