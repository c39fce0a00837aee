// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace stillpoint::design {

/// ", and no f with a tolerance of 10 % fits between", where the values themselves leave room
/// between `least` and `most`; `box` is the tolerance asked for, behind a comma.
inline std::string none_between(std::string_view variable, double least, double most,
                                const std::string& box) {
  return least > most || box.empty()
             ? ""
             : fmt::format(", and no {}{} fits between", variable, box.substr(1));
}

}  // namespace stillpoint::design
