// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/problem.hpp>
#include <stillpoint/records/record_file.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <vector>

namespace stillpoint::cli {

// The enumerations that an option chooses from by name, in the order of --help; the first is the
// default. The objectives are design::objectives().
inline constexpr std::array criteria{design::Criterion::published, design::Criterion::exact};
inline constexpr std::array record_units{records::RecordUnits::g, records::RecordUnits::m_per_s2,
                                         records::RecordUnits::cm_per_s2};

template <class Choices>
[[nodiscard]] std::vector<std::string_view> names(const Choices& choices) {
  std::vector<std::string_view> all;
  std::ranges::transform(choices, std::back_inserter(all), [](auto one) { return name(one); });
  return all;
}

}  // namespace stillpoint::cli
