// SPDX-License-Identifier: MIT
#pragma once

#include "kernel/exact_sum.hpp"

#include <stillpoint/core/excitation.hpp>

#include <functional>

namespace stillpoint {

/// The largest |W| from one p tau to another, for Transmitted. It refers to the excitation. In a
/// separate file, so that the run, which hardly ever calls it, is compiled without it.
std::function<double(const ExactSum<double>&, const ExactSum<double>&)> load_while_held(
    const Excitation& excitation, double p);

}  // namespace stillpoint
