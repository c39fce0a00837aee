// SPDX-License-Identifier: MIT
#pragma once

#include "run_program.hpp"

/// Commands that would be correct without what is added to them.
namespace stillpoint::cli_test::right {

inline Arguments design(const Arguments& more = {}) {
  return "design --v0 1 --p 1 --beta 0.9" + more;
}

inline Arguments design(double beta, const Arguments& more = {}) {
  return Arguments{"design", "--v0", "1", "--p", "1", "--beta", in_full(beta)} + more;
}

inline Arguments region(const Arguments& more = {}) {
  return "region --v0 1 --p 1 --beta 0.9" + more;
}

inline Arguments simulate(const Arguments& more = {}) {
  return "simulate --v0 1 --p 1 --f 0.02 --delta 0.02" + more;
}

inline Arguments sweep(const Arguments& more = {}) {
  return "sweep --v0 1 --p 1" + more;
}

inline Surroundings with_input(const std::string& text) {
  return {.input = text};
}

/// Of a scene of `design`, within its braces.
inline const std::string good = R"("v0": 1, "p": 1, "beta": 0.9)";

inline const Surroundings to_a_full_device{.output = StandardOutput::file,
                                           .output_file = "/dev/full"};

}  // namespace stillpoint::cli_test::right
