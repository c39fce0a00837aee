// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/forced_motion.hpp>

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <optional>

// For forced motions whose answer is known by hand.

namespace stillpoint::test {

/// Of a value known by hand, relative above 1.
inline constexpr double by_hand = 1e-14;

inline ForcedResponse run(const Oscillator& oscillator, const Start& start,
                          const Excitation& excitation, std::optional<double> t_end = {},
                          const Surface& surface = {}) {
  return forced_response(oscillator, start, excitation, {.t_end = t_end}, surface);
}

inline ForcedResponse until(double t_end, const Oscillator& oscillator, const Start& start,
                            const Excitation& excitation) {
  return run(oscillator, start, excitation, t_end);
}

inline void close(double value, double expected, double tolerance = by_hand) {
  BOOST_TEST(std::abs(value - expected) <= tolerance * std::fmax(1, std::abs(expected)),
             value << " expected " << expected << " off by " << value - expected);
}

/// W = k for ever, as a record whose end lies far behind t_end.
inline Record constant(double k) {
  return {{k, k}, 1e6, {}};
}

}  // namespace stillpoint::test
