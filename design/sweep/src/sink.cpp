// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/sink.hpp>

#include <fmt/format.h>

namespace stillpoint::sweep {

std::string description(const LeftRows& left) {
  if (left.count == 0) {
    return "nothing is written";
  }
  if (!left.file) {
    return "the rows before it are written";
  }
  return fmt::format("{} kept in {}",
                     left.count == 1 ? "1 row is" : fmt::format("{} rows are", left.count),
                     *left.file);
}

}  // namespace stillpoint::sweep
