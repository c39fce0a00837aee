// SPDX-License-Identifier: MIT
#include "entry_threads.hpp"

#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/input_error.hpp>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

namespace stillpoint {

namespace {

std::string message_of(const std::exception_ptr& cause) {
  try {
    std::rethrow_exception(cause);
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "unknown error";
  }
}

}  // namespace

EntryError::EntryError(std::ptrdiff_t entry, const std::exception_ptr& cause)
    : std::runtime_error(message_of(cause)), entry_(entry), cause_(cause) {}

EntryRange EntryThreads::next() {
  const bool stop = failed_ || (go_on_ && !go_on_());
  const std::ptrdiff_t begin = stop ? size_ : std::min(size_, next_.fetch_add(block_));
  return {begin, std::min(size_, begin + block_)};
}

void EntryThreads::guard(std::ptrdiff_t i, const std::function<void()>& entry) {
  try {
    entry();
  } catch (...) {
    const std::scoped_lock lock(mutex_);
    if (!error_ || i < failed_entry_) {
      failed_entry_ = i;
      error_ = std::current_exception();
    }
    failed_ = true;
  }
}

void EntryThreads::run(int threads, const std::function<void()>& worker) {
  if (threads < 0) {
    throw InputError("threads", threads, "must be 0 or more");
  }
  const std::ptrdiff_t at_once = std::thread::hardware_concurrency();
  const std::ptrdiff_t wanted = threads > 0 ? threads : at_once;
  const std::ptrdiff_t blocks = (size_ + block_ - 1) / block_;
  {
    std::vector<std::jthread> others;
    for (std::ptrdiff_t i = 1; i < std::min(wanted, blocks); ++i) {
      others.emplace_back(worker);
    }
    worker();
  }
  if (error_) {
    throw EntryError(failed_entry_, error_);
  }
}

void for_each_entry(std::ptrdiff_t size, int threads, const std::function<bool()>& go_on,
                    const std::function<void(std::ptrdiff_t)>& body) {
  EntryThreads entries(size, 1, go_on);
  entries.run(threads, [&] {
    for (EntryRange one = entries.next(); one.begin < one.end; one = entries.next()) {
      entries.guard(one.begin, [&] { body(one.begin); });
    }
  });
}

}  // namespace stillpoint
