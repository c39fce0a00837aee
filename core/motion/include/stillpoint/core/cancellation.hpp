// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <functional>

namespace stillpoint {

/// Thrown by a computation that is no longer wanted.
class Cancelled : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "cancelled"; }
};

/// While it lives, the computations of this thread that may take seconds ask `go_on` now and then,
/// and those of the Cancellables around it, and throw Cancelled once one returns false. Motions
/// under a load and loops over threads have a go_on of their own instead and return what they have.
class Cancellable {
 public:
  explicit Cancellable(std::function<bool()> go_on);
  Cancellable(const Cancellable&) = delete;
  Cancellable& operator=(const Cancellable&) = delete;
  ~Cancellable();

 private:
  friend void cancellation_point();

  std::function<bool()> go_on_;
  const Cancellable* outer_;
};

/// Throws Cancelled if the computation of this thread is no longer wanted.
void cancellation_point();

}  // namespace stillpoint
