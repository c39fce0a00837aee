// SPDX-License-Identifier: MIT
#include "record/suite_valleys.hpp"

#include <algorithm>
#include <utility>

namespace stillpoint::design {

std::vector<std::size_t> valleys(std::int64_t points, std::size_t variables,
                                 const std::vector<SuiteRank>& ranks, std::size_t most) {
  const auto side = static_cast<std::size_t>(points);
  std::size_t around = 1;
  for (std::size_t i = 0; i < variables; ++i) {
    around *= 3;
  }
  const auto is_valley = [&](std::size_t index) {
    for (std::size_t step = 0; step < around; ++step) {
      std::size_t neighbour = 0;
      std::size_t stride = 1;
      bool inside = true;
      for (std::size_t i = 0, left = index, move = step; i < variables;
           ++i, left /= side, move /= 3, stride *= side) {
        const std::size_t place = left % side + move % 3;  // one more than the neighbour's
        inside = inside && place >= 1 && place <= side;
        neighbour += (place - 1) * stride;
      }
      if (inside && std::pair(ranks[neighbour], neighbour) < std::pair(ranks[index], index)) {
        return false;
      }
    }
    return true;
  };
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    if (is_valley(i)) {
      list.push_back(i);
    }
  }
  std::ranges::sort(list, {}, [&](std::size_t i) { return std::pair(ranks[i], i); });
  list.resize(std::min(list.size(), most));
  return list;
}

}  // namespace stillpoint::design
