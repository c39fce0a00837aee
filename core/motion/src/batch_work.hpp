// SPDX-License-Identifier: MIT
#pragma once

// The one loop over threads: for_each_entry, and the batches, whose threads each keep their own
// state, draw their entries themselves, and name the array and the first wrong entry.

#include "batch_entries.hpp"

#include <stillpoint/core/batch.hpp>

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>

namespace stillpoint {

/// The entries left to do, and the error of the first that failed.
class EntryThreads {
 public:
  /// Hands out `block` entries at a time. `go_on`: as in for_each_entry; it must outlive this.
  EntryThreads(std::ptrdiff_t size, std::ptrdiff_t block, const std::function<bool()>& go_on)
      : size_(size), block_(block), go_on_(go_on) {}

  /// A block for one thread; empty if none is left, or nothing goes on.
  EntryRange next();

  /// False if an entry has failed or go_on returned false.
  [[nodiscard]] bool goes_on() { return wanted() && !failed_; }
  /// Asks go_on, until it has returned false.
  [[nodiscard]] bool wanted();

  /// Runs `entry`, and keeps the error of the first entry that throws. Blocks are handed out in
  /// order and finished once begun, so which entry that is does not depend on the threads.
  void guard(std::ptrdiff_t i, const std::function<void()>& entry);

  /// Whether go_on returned false.
  [[nodiscard]] bool stopped() const { return stopped_; }

  /// Calls `worker` on that many threads, but on no more than there are blocks; then throws what
  /// go_on threw, or EntryError if an entry failed. InputError for threads < 1, and for more than
  /// can be started.
  void run(const Threads& threads, const std::function<void()>& worker);

 private:
  std::ptrdiff_t size_;
  std::ptrdiff_t block_;
  const std::function<bool()>& go_on_;
  std::atomic<std::ptrdiff_t> next_{0};
  std::atomic<bool> failed_{false};
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;
  std::ptrdiff_t failed_entry_{0};
  std::exception_ptr error_;
  std::exception_ptr worker_error_;  ///< of go_on, or of what a worker does outside of its guard
};

/// All of them with one v0 and one p, which must outlive the result.
BatchEntries entries_of(const double& v0, const double& p, const BatchValues& f,
                        const BatchValues& delta);

/// Throws InputError if the arrays have different lengths.
BatchEntries entries_of(const BatchValues& v0, const BatchValues& p, const BatchValues& f,
                        const BatchValues& delta);

/// Throws InputError if there are not as many as entries.
void require_entries(const char* field, const BatchValues& values, std::ptrdiff_t size);

/// With the damping of each, unless `zeta` is empty.
void damp(BatchEntries& entries, const Eigen::ArrayXd& zeta);

/// Calls worker(EntryThreads&) on several threads; it draws its entries and runs each in a guard.
/// Then throws the first error, with the entry in it, or Cancelled if go_on returned false.
void run_batch(const BatchEntries& entries, std::ptrdiff_t block, const Threads& threads,
               const std::function<bool()>& go_on,
               const std::function<void(EntryThreads&)>& worker);

}  // namespace stillpoint
