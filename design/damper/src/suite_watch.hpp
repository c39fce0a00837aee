// SPDX-License-Identifier: MIT
#pragma once

#include "suite.hpp"

#include <atomic>
#include <cstdint>
#include <mutex>

namespace stillpoint::design {

/// Counts what a search evaluates, keeps the best so far for its user, and knows when the user has
/// had enough.
class SuiteWatch {
 public:
  SuiteWatch(const RecordDesignRequest& request, const RecordWatch& ask)
      : objective_(request.objective), limits_(request.limits), ask_(ask) {}

  void expect(std::int64_t more) { progress_.expected += more; }

  /// By several threads at once.
  void evaluated(const SuiteDamper& damper, const SuiteFigures& figures) {
    if (!ask_) {
      return;
    }
    const std::lock_guard lock(one_at_a_time_);
    ++progress_.evaluations;
    const SuiteRank now = rank(figures, objective_, limits_);
    if (!progress_.best || now < best_) {
      best_ = now;
      progress_.best = {damper, figures};
    }
    stopped_ = stopped_ || !ask_(progress_);
  }
  /// Whether the search is to end.
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  SuiteObjective objective_;
  SuiteLimits limits_;
  const RecordWatch& ask_;
  std::mutex one_at_a_time_;
  RecordProgress progress_;
  SuiteRank best_;
  std::atomic<bool> stopped_{false};
};

}  // namespace stillpoint::design
