// SPDX-License-Identifier: MIT
#pragma once

#include "record/suite.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>

namespace stillpoint::design {

/// Counts what a search evaluates, keeps the best so far for its user, and knows when the user has
/// stopped it.
class SuiteWatch {
 public:
  SuiteWatch(const RecordDesignRequest& request, const RecordWatch& go_on)
      : objective_(request.objective), limits_(request.limits), go_on_(go_on) {}

  /// About this many more dampers will be evaluated than expected so far.
  void expect(std::int64_t more) { progress_.expected += more; }

  /// Adds each damper with its figures, then checks whether to go on. Called by several threads at
  /// once.
  void evaluated(std::span<const SuiteDamper> dampers, std::span<const SuiteFigures> figures) {
    if (!go_on_) {
      return;
    }
    const std::lock_guard lock(one_at_a_time_);
    progress_.evaluations += static_cast<std::int64_t>(dampers.size());
    for (std::size_t i = 0; i < dampers.size(); ++i) {
      const SuiteRank now = rank(figures[i], objective_, limits_);
      if (!progress_.best || now < best_) {
        best_ = now;
        progress_.best = {dampers[i], figures[i]};
      }
    }
    stopped_ = stopped_ || !go_on_(progress_);
  }
  /// Whether the search is to end.
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  SuiteObjective objective_;
  SuiteLimits limits_;
  const RecordWatch& go_on_;
  std::mutex one_at_a_time_;
  RecordProgress progress_;
  SuiteRank best_;
  std::atomic<bool> stopped_{false};
};

}  // namespace stillpoint::design
