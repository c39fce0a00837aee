// SPDX-License-Identifier: MIT
#include "load_while_held.hpp"
#include "kernel/excitation_run.hpp"

namespace stillpoint {

std::function<double(const ExactSum<double>&, const ExactSum<double>&)> load_while_held(
    const Excitation& excitation, double p) {
  return largest_load_of(excitation, p);
}

}  // namespace stillpoint
