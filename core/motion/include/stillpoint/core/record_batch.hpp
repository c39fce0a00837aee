// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/batch.hpp>
#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/state.hpp>
#include <stillpoint/core/surface.hpp>

#include <Eigen/Core>

#include <optional>

namespace stillpoint {

struct RecordBatchOptions {
  std::optional<double> hold{};  ///< for every oscillator
  Surface surface{};             ///< for every entry
  Eigen::ArrayXd zeta{};         ///< if not empty, the damping of each oscillator
  double breakaway{1};           ///< of every oscillator
  /// If not empty, the notch of each entry has this width in place of that of the surface, and
  /// where it is 0 none.
  Eigen::ArrayXd notch_width{};
  /// As in ForcedOptions, but a motion with more half-cycles is not an error: its outcome is
  /// `running`.
  double half_cycle_limit{1e8};
  Threads threads{};
};

/// The metrics of entry i are the i-th of each array, and they are those of forced_response.
///
/// An array cannot hold an empty value: where the outcome is never_stops or running, nothing else
/// has a meaning, and where the notch does not hold the mass locked_from is infinite.
struct RecordBatchResult {
  Eigen::Array<Outcome, Eigen::Dynamic, 1> outcome;
  Eigen::ArrayXd peak_amplitude;
  Eigen::ArrayXd peak_absolute_acceleration;
  Eigen::ArrayXd jump;
  Eigen::ArrayXd stop_position;
  Eigen::ArrayXd stop_time;
  Eigen::ArrayXd locked_from;
  Eigen::ArrayXd half_cycles;
  Eigen::ArrayXd turning_points;
  Eigen::ArrayXd sticks;
  Eigen::ArrayXd decision_margin;  ///< infinite where nothing was decided

  [[nodiscard]] Eigen::Index size() const { return outcome.size(); }
  /// Of an entry that comes to rest: its peaks and jump, where and when it rests, and its margin.
  [[nodiscard]] ForcedResponse rest_of(Eigen::Index entry) const;
};

/// The motions from x = 0 with v0 of many oscillators (p[i], f[i], delta[i]) under one record,
/// through it and free to their rests. `result` is resized if its size differs.
///
/// The values are bit for bit those of forced_response, for every instruction set and number of
/// threads: docs/batch.md. Records that give their times run without lanes.
///
/// Throws InputError for input that forced_response refuses, with the entry in the field ("f[17]"),
/// for arrays of different lengths, and for threads < 1.
void record_batch(double v0, const BatchValues& p, const BatchValues& f, const BatchValues& delta,
                  const Record& record, const RecordBatchOptions& options,
                  RecordBatchResult& result);

[[nodiscard]] RecordBatchResult record_batch(double v0, const BatchValues& p, const BatchValues& f,
                                             const BatchValues& delta, const Record& record,
                                             const RecordBatchOptions& options = {});

}  // namespace stillpoint
