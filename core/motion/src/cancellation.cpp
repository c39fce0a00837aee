// SPDX-License-Identifier: MIT
#include <stillpoint/core/cancellation.hpp>

#include <utility>

namespace stillpoint {

namespace {

/// Of this thread.
thread_local const Cancellable* innermost = nullptr;

}  // namespace

Cancellable::Cancellable(std::function<bool()> go_on)
    : go_on_(std::move(go_on)), outer_(std::exchange(innermost, this)) {}

Cancellable::~Cancellable() {
  innermost = outer_;
}

void cancellation_point() {
  for (const Cancellable* now = innermost; now != nullptr; now = now->outer_) {
    if (!now->go_on_()) {
      throw Cancelled();
    }
  }
}

}  // namespace stillpoint
