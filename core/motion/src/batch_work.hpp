// SPDX-License-Identifier: MIT
#pragma once

// What the free and the forced batch share: the checks of the arrays, threads over blocks of
// entries, and errors that name the first entry at fault.

#include "batch_entries.hpp"

#include <stillpoint/core/batch.hpp>

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>

namespace stillpoint {

/// All of them with one v0 and one p, which must outlive the result.
BatchEntries entries_of(const double& v0, const double& p, const BatchValues& f,
                        const BatchValues& delta);

/// Throws InputError if the arrays have different lengths.
BatchEntries entries_of(const BatchValues& v0, const BatchValues& p, const BatchValues& f,
                        const BatchValues& delta);

/// The entries left to do, and the error of the first that failed.
class BatchWork {
 public:
  BatchWork(const BatchEntries& entries, std::ptrdiff_t block) : entries_(entries), block_(block) {}

  /// A block for one thread; empty where none is left, or one has failed.
  EntryRange next();

  /// Runs `entry`, and keeps the error of the first entry to throw. Blocks are handed out in order
  /// and finished once begun, so that it does not depend on the threads which one that is.
  void guard(std::ptrdiff_t i, const std::function<void()>& entry);

  /// Calls `run` in so many threads, 0: as many as the machine runs at once, but no more than there
  /// are blocks; then throws the first error. InputError for threads < 0.
  void in_threads(int threads, const std::function<void()>& run);

 private:
  void fail(std::ptrdiff_t i, const std::exception_ptr& error);

  const BatchEntries& entries_;
  std::ptrdiff_t block_;
  std::atomic<std::ptrdiff_t> next_{0};
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  std::ptrdiff_t failed_entry_{0};
  std::exception_ptr error_;
};

}  // namespace stillpoint
