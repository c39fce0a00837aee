// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/design.hpp>

namespace stillpoint::design {

/// A point that was found, simulated and checked.
[[nodiscard]] Finding finding_of(const Problem& problem, const Limits& limits,
                                 const SearchResult& found);

}  // namespace stillpoint::design
