// SPDX-License-Identifier: MIT
#include <stillpoint/core/cancellation.hpp>

#include <utility>

namespace stillpoint {

namespace {

/// The question of this thread's innermost Cancellable.
thread_local const std::function<bool()>* asked = nullptr;

}  // namespace

Cancellable::Cancellable(std::function<bool()> go_on)
    : go_on_(std::move(go_on)), outer_(std::exchange(asked, &go_on_)) {}

Cancellable::~Cancellable() {
  asked = outer_;
}

void cancellation_point() {
  if (asked != nullptr && !(*asked)()) {
    throw Cancelled();
  }
}

}  // namespace stillpoint
