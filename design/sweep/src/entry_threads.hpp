// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <functional>
#include <stdexcept>
#include <string>

namespace stillpoint::cli {

/// An entry of a block is refused, for the reason that the message gives.
class EntryError : public std::runtime_error {
 public:
  EntryError(Eigen::Index entry, const std::string& reason)
      : std::runtime_error(reason), entry_(entry) {}

  [[nodiscard]] Eigen::Index entry() const noexcept { return entry_; }

 private:
  Eigen::Index entry_;
};

/// Calls body(i) for each i from 0 to size - 1, on `threads` threads. Each i is one thread's alone,
/// so that nothing depends on their number; what it throws becomes an EntryError, of the first
/// entry that does. After an interrupt the rest is left.
void for_each_entry(Eigen::Index size, int threads, const std::function<void(Eigen::Index)>& body);

}  // namespace stillpoint::cli
