// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/state.hpp>

#include <Eigen/Core>

#include <functional>

namespace stillpoint {

/// One value per entry. Anything that is not contiguous is copied first.
using BatchValues = Eigen::Ref<const Eigen::ArrayXd>;

struct BatchOptions {
  Eigen::ArrayXd zeta{};     ///< if not empty, the damping of each oscillator
  double breakaway{1};       ///< of each oscillator
  bool times{false};         ///< stop_time as well
  bool acceleration{false};  ///< peak_absolute_acceleration as well
  /// As in FreeOptions: if a single entry may take more half-cycles, the batch is refused.
  double half_cycle_limit{1e8};
  Threads threads{};
  /// If not empty, called now and then, by several threads at once; when it returns false the batch
  /// throws Cancelled.
  std::function<bool()> go_on{};
};

/// The metrics of entry i are the i-th of each array, and they are those of free_response.
///
/// An array cannot hold an empty value, so the outcome says which values exist: where outcome[i] is
/// never_stops, half_cycles[i] and stop_time[i] are infinite and stop_position[i] is 0, and these
/// three values have no meaning.
struct BatchResult {
  Eigen::ArrayXd peak_amplitude;
  Eigen::ArrayXd half_cycles;
  Eigen::Array<Outcome, Eigen::Dynamic, 1> outcome;
  Eigen::ArrayXd stop_position;
  Eigen::ArrayXd stop_time;                   ///< empty unless asked for
  Eigen::ArrayXd peak_absolute_acceleration;  ///< the same

  [[nodiscard]] Eigen::Index size() const { return peak_amplitude.size(); }
};

/// The free motions from x = 0 with v0 of the oscillators (p, f[i], delta[i]). `result` is resized
/// if its size differs, so a large sweep in blocks reuses the same memory.
///
/// Counts, outcomes and values are bit for bit those of free_response, for every instruction set
/// and number of threads: docs/batch.md. With a breakaway friction alone they run without lanes.
///
/// Throws InputError for input that free_response refuses, with the entry in the field ("f[17]"),
/// for arrays of different lengths, and for threads < 1; TooManyHalfCycles, naming the entry, as
/// free_response does. The first such entry is named, and `result` is then unusable.
void free_batch(double v0, double p, const BatchValues& f, const BatchValues& delta,
                const BatchOptions& options, BatchResult& result);

/// The same with v0[i] and p[i].
void free_batch(const BatchValues& v0, const BatchValues& p, const BatchValues& f,
                const BatchValues& delta, const BatchOptions& options, BatchResult& result);

template <class Speeds, class Frequencies>
[[nodiscard]] BatchResult free_batch(const Speeds& v0, const Frequencies& p, const BatchValues& f,
                                     const BatchValues& delta, const BatchOptions& options = {}) {
  BatchResult result;
  free_batch(v0, p, f, delta, options, result);
  return result;
}

}  // namespace stillpoint
