// SPDX-License-Identifier: MIT
#pragma once

#include "record/suite.hpp"

#include <cstdint>

namespace stillpoint::design {

/// Counts what a search evaluates, keeps the best verified damper for its user, and knows when the
/// user has stopped it.
class SuiteWatch {
 public:
  explicit SuiteWatch(const RecordWatch& go_on) : go_on_(go_on) {}

  /// About this many more dampers will be evaluated than expected so far.
  void expect(std::int64_t more) { progress_.expected += more; }

  /// Adds so many dampers, then checks whether to go on.
  void evaluated(std::int64_t count) {
    progress_.evaluations += count;
    stopped_ = stopped_ || (go_on_ && !go_on_(progress_));
  }
  /// A better damper than all before whose box is verified.
  void verified(const SuitePoint& best) { progress_.best = best; }

  /// Whether the search is to end.
  [[nodiscard]] bool stopped() const { return stopped_; }
  [[nodiscard]] std::int64_t evaluations() const { return progress_.evaluations; }

 private:
  const RecordWatch& go_on_;
  RecordProgress progress_;
  bool stopped_{false};
};

}  // namespace stillpoint::design
