// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/part.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace stillpoint::design {

/// Best first: those that are admissible by what `cost` gives for them, then by tolerance; behind
/// them those that lack tolerance, then the others by their worst miss.
[[nodiscard]] std::vector<RatedPart> best_first(
    std::vector<RatedPart> all, const std::function<double(const RatedPart&)>& cost);

/// Throws InputError unless f and delta are those of a part that is valid in an oscillator with
/// that p.
void require_valid(const Part& part, double p);

/// "none of the 30 parts of the catalogue is admissible"
[[nodiscard]] std::string none_admissible(std::size_t parts);

}  // namespace stillpoint::design
