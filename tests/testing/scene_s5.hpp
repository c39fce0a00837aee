// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>

#include <cmath>

namespace stillpoint::test {

/// Scene S5: two wave packets, 3000 samples every 0.02.
inline Record record_s5() {
  Record record{{}, 0.02, {}};
  for (int i = 0; i < 3000; ++i) {
    const double t = i * 0.02;
    const double first = (t - 20) / 10;
    const double second = (t - 25) / 12;
    record.values.push_back(0.4 * std::exp(-first * first) * std::sin(2.3 * t) +
                            0.2 * std::exp(-second * second) * std::sin(5.1 * t + 1));
  }
  return record;
}

/// The same rounded to multiples of 2^-36: the doubles of data/reference/make_forced_reference.py,
/// for any last bits of exp and sin.
inline Record rounded_record_s5() {
  Record record = record_s5();
  for (double& value : record.values) {
    value = std::ldexp(std::nearbyint(std::ldexp(value, 36)), -36);
  }
  return record;
}

}  // namespace stillpoint::test
