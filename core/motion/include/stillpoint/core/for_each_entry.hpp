// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <exception>
#include <functional>
#include <optional>
#include <stdexcept>

namespace stillpoint {

/// An exception from an entry of a loop, with the message of its cause.
class EntryError : public std::runtime_error {
 public:
  EntryError(std::ptrdiff_t entry, const std::exception_ptr& cause);

  [[nodiscard]] std::ptrdiff_t entry() const noexcept { return entry_; }
  [[nodiscard]] const std::exception_ptr& cause() const noexcept { return cause_; }

 private:
  std::ptrdiff_t entry_;
  std::exception_ptr cause_;
};

/// How many threads, 1 or more; empty: one per hardware thread. No result depends on it.
using Threads = std::optional<int>;

/// Calls body(i) for each i from 0 to size - 1 on several threads.
/// Each i is called by one thread only, so no result depends on their number.
///
/// `go_on`, if not empty, is called before each entry, by several threads at once; when it returns
/// false the remaining entries are skipped, and when it throws that is thrown. If body throws, no
/// further entry begins, and EntryError is thrown for the first entry that threw, for every number
/// of threads. Throws InputError for threads < 1, and for more than the system can start.
void for_each_entry(std::ptrdiff_t size, const Threads& threads, const std::function<bool()>& go_on,
                    const std::function<void(std::ptrdiff_t)>& body);

}  // namespace stillpoint
