// SPDX-License-Identifier: MIT
#pragma once

// Checks that several tests share.

#include "testing/exact_run.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>

namespace stillpoint::test {

/// |value - expected| <= tolerance * |expected|; failures print both.
inline void near(const char* what, double value, double expected, double tolerance) {
  BOOST_TEST(std::abs(value - expected) <= tolerance * std::abs(expected),
             what << " = " << value << ", expected " << expected);
}

/// Both to a few roundings.
inline void peaks(const Response& response, double amplitude, double acceleration) {
  near("peak_amplitude", response.peak_amplitude, amplitude, 1e-15);
  near("peak_acceleration", response.peak_acceleration, acceleration, 1e-15);
}

/// The counts and the outcome of a motion.
inline void ends(const Response& response, const End& expected) {
  BOOST_TEST(as_run(response).end == expected,
             "got " << as_run(response).end << ", expected " << expected);
}

}  // namespace stillpoint::test
