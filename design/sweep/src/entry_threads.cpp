// SPDX-License-Identifier: MIT
#include "entry_threads.hpp"

#include "progress.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace stillpoint::cli {

namespace {

using Eigen::Index;

/// The first refusal: whatever order the threads come in, since each entry before it was begun
/// before it.
class FirstError {
 public:
  void note(Index entry, const char* reason) {
    const std::scoped_lock lock(mutex_);
    if (!error_ || entry < error_->entry()) {
      error_.emplace(entry, reason);
    }
    any_ = true;
  }
  [[nodiscard]] bool any() const { return any_; }
  void rethrow() const {
    if (error_) {
      throw EntryError(*error_);
    }
  }

 private:
  std::mutex mutex_;
  std::optional<EntryError> error_;
  std::atomic<bool> any_{false};
};

}  // namespace

void for_each_entry(Index size, int threads, const std::function<void(Index)>& body) {
  std::atomic<Index> next{0};
  FirstError error;
  const auto work = [&] {
    while (!error.any() && !Progress::interrupted()) {
      const Index i = next.fetch_add(1, std::memory_order_relaxed);
      if (i >= size) {
        return;
      }
      try {
        body(i);
      } catch (const std::exception& refused) {
        error.note(i, refused.what());
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (Index i = 1; i < std::min<Index>(threads, size); ++i) {
      others.emplace_back(work);
    }
    work();
  }
  error.rethrow();
}

}  // namespace stillpoint::cli
