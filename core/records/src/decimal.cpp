// SPDX-License-Identifier: MIT
#include <stillpoint/records/decimal.hpp>
#include <stillpoint/records/number.hpp>

#include <fmt/format.h>

namespace stillpoint::records {

namespace {

/// By way of the decimal digits, because powers of ten beyond 1e22 are no doubles. No locale
/// changes how these are written or read.
double nearest_decimal(double value, int digits) {
  const ScannedNumber found = scan_number(fmt::format("{:.{}e}", value, digits - 1));
  return found.fault == NumberFault::none ? found.value : value;
}

}  // namespace

double decimal(double value, int digits, Rounding rounding) {
  double found = nearest_decimal(value, digits);
  const auto misses = [&] {
    return rounding == Rounding::up ? found < value : rounding == Rounding::down && found > value;
  };
  // The nearest is at most half of its last digit away.
  const double outwards = (rounding == Rounding::up) == (value > 0) ? 1 : -1;
  for (double part = 0x1p-52; misses(); part *= 2) {
    found = nearest_decimal(value * (1 + outwards * part), digits);
  }
  return found;
}

}  // namespace stillpoint::records
