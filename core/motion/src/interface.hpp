// SPDX-License-Identifier: MIT
#pragma once

namespace stillpoint {

/// What others derive from and call by reference.
class Interface {
 public:
  Interface() = default;
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;
  virtual ~Interface() = default;
};

}  // namespace stillpoint
