// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/batch.hpp>
#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/forced_motion.hpp>

#include <limits>
#include <vector>

namespace stillpoint {

struct ForcedBatchOptions {
  /// Of each scene. Several threads may call its go_on at once, each with the tau of its own scene.
  ForcedOptions scene;
  int threads{0};  ///< 0: as many as the machine runs at once. No result depends on it.
  double hold{std::numeric_limits<double>::infinity()};  ///< of every oscillator
  Surface surface{};                                     ///< under every mass
};

/// The motions from x = 0 with v0 of the oscillators (p, f[i], delta[i]), all under one excitation:
/// forced_response of each, for every number of threads.
///
/// Throws what forced_response throws, with the first wrong entry in the field ("f[17]") or the
/// message, and InputError for arrays of different lengths and for threads < 0.
[[nodiscard]] std::vector<ForcedResponse> forced_batch(double v0, double p, const BatchValues& f,
                                                       const BatchValues& delta,
                                                       const Excitation& excitation,
                                                       const ForcedBatchOptions& options = {});

/// The same with v0[i] and p[i].
[[nodiscard]] std::vector<ForcedResponse> forced_batch(const BatchValues& v0, const BatchValues& p,
                                                       const BatchValues& f,
                                                       const BatchValues& delta,
                                                       const Excitation& excitation,
                                                       const ForcedBatchOptions& options = {});

}  // namespace stillpoint
