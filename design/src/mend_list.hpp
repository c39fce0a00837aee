// SPDX-License-Identifier: MIT
#pragma once

// Mends of a case, a struct with `limits`, that `fits(case)` tells from one without a design.

#include "nearest_fit.hpp"

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/region.hpp>

#include <string_view>
#include <vector>

namespace stillpoint::design {

/// The mend of one input, `change(case, value)` sets it, on the way from what it is towards `to`.
template <class Case, class Fits, class Change>
void add_mend(std::vector<Mend>& list, const Case& base, const Fits& fits, std::string_view field,
              double from, double to, const Change& change) {
  const auto fits_with = [&](double value) {
    Case changed = base;
    change(changed, value);
    return fits(changed);
  };
  if (const auto value = nearest_fit(from, to, fits_with)) {
    list.push_back({field, *value, *value > from});
  }
}

/// Those of the limits that are set.
template <class Case, class Fits>
void add_limit_mends(std::vector<Mend>& list, const Case& base, const Fits& fits) {
  const Limits& limits = base.limits;
  if (limits.f_max) {
    add_mend(list, base, fits, "f_max", *limits.f_max, largest_square,
             [](Case& now, double value) { now.limits.f_max = value; });
  }
  if (limits.delta_max) {
    add_mend(list, base, fits, "delta_max", *limits.delta_max, largest_square,
             [](Case& now, double value) { now.limits.delta_max = value; });
  }
  if (limits.tolerance > 0) {
    add_mend(list, base, fits, "tolerance", limits.tolerance, 0.0,
             [](Case& now, double value) { now.limits.tolerance = value; });
  }
}

}  // namespace stillpoint::design
