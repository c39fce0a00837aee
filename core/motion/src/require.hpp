// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/input_error.hpp>

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

namespace stillpoint {

/// Throws InputError unless `right`, with a bound that is formatted only then.
template <class... Parts>
void require(bool right, std::string_view field, double value, fmt::format_string<Parts...> bound,
             Parts&&... parts) {
  if (!right) {
    throw InputError(std::string(field), value, fmt::format(bound, std::forward<Parts>(parts)...));
  }
}

}  // namespace stillpoint
