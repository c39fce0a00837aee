// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/simulation.hpp>

namespace stillpoint::test {

/// All else is as it is in an empty request.
inline SimulationRequest simulation_of(const Oscillator& oscillator, const Start& start = {},
                                       const Excitation& excitation = {},
                                       std::optional<double> t_end = {}) {
  SimulationRequest request;
  request.oscillator = oscillator;
  request.start = start;
  request.excitation = excitation;
  request.t_end = t_end;
  return request;
}

}  // namespace stillpoint::test
