// SPDX-License-Identifier: MIT
#pragma once

#include "run_program.hpp"

namespace stillpoint::cli_test {

/// A mass at rest, to be shaken.
inline Arguments at_rest(const Arguments& more) {
  return joined({"simulate", "--p", "1", "--f", "0.1", "--delta", "0.01"}, more);
}

inline Arguments pulse(const char* type, const Arguments& more = {}) {
  return at_rest(joined({"--excitation", type, "--k", "0.5", "--lambda", "2"}, more));
}

inline const Arguments harmonic = pulse("harmonic", {"--t-end", "20"});

}  // namespace stillpoint::cli_test
