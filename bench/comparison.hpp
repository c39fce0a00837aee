// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/peers/measure.hpp>
#include "machine.hpp"
#include "methods.hpp"

#include <optional>
#include <string>
#include <vector>

namespace stillpoint::bench {

/// The errors of a result. They are absolute, in the dimensionless units of the
/// scene.
struct Verdict {
  double peak{0};
  double end{0};  ///< of the stop time of a free motion; of x and v at the end of a forced one
  bool counts_right{
      false};          ///< passages, turns, sticks; for a free motion also that it stops at zero
  std::string counts;  ///< "64, 64, 0"

  [[nodiscard]] double largest() const { return peak > end ? peak : end; }
  /// Right counts and no error above `bound`.
  [[nodiscard]] bool reaches(double bound) const { return counts_right && largest() <= bound; }
};

/// A method with one setting on one scene.
struct Row {
  double setting{0};
  peers::Timing time;
  Verdict verdict;
};

struct MethodRows {
  Method method;
  std::vector<Row> rows;  ///< in the order of the settings

  /// The fastest row that meets the bound.
  [[nodiscard]] const Row* cheapest(double bound) const;
};

struct SceneRows {
  peers::ReferenceScene scene;
  std::vector<MethodRows> methods;  ///< the kernel first

  [[nodiscard]] const Row& kernel() const { return methods.front().rows.front(); }
};

/// The fastest rival on a scene for a bound on its errors.
struct Rival {
  const MethodRows* method;
  const Row* row;
  double ratio;  ///< its time over the kernel's
};

[[nodiscard]] std::optional<Rival> best_rival(const SceneRows& scene, double bound);

/// Nanoseconds for one of something.
struct Unit {
  std::string what;
  peers::Timing seconds;
};

/// In other units.
void scale(peers::Timing& timing, double by);

/// Times of the free kernel per half-cycle in each mode, of free_peak per motion, and of the
/// hardware square root.
[[nodiscard]] std::vector<Unit> free_modes(const peers::Scene& scene,
                                           const peers::MeasureOptions& options);

/// Scene S6: what the scan of a record design does, eleven records and 10^4 dampers, on one thread.
struct ManyDampers {
  std::vector<Unit> rows;   ///< the whole scene in the lanes, one by one, and by a peer
  double sampled{0};        ///< this many of the dampers were run one by one; times are scaled
  double samples{0};        ///< of all records
  double error_of_peak{0};  ///< the peer's largest
  double wrong_counts{0};   ///< of the peer's motions, as a part
};

/// `record` is that of S5; the eleven are made from it by scale and step.
[[nodiscard]] ManyDampers many_dampers(const Record& record, const peers::MeasureOptions& options);

/// All results of one run; the reports only render them.
struct Comparison {
  Machine machine;
  peers::MeasureOptions options;
  double seconds{0};  ///< duration of the run
  std::vector<SceneRows> scenes;
  std::vector<Unit> free_modes;  ///< on scene S2
  ManyDampers many;              ///< scene S6
};

/// "passages, turns, sticks"
[[nodiscard]] std::string counts_of(const peers::Result& result);

[[nodiscard]] Comparison compare(const std::vector<peers::ReferenceScene>& scenes,
                                 const peers::MeasureOptions& options);

}  // namespace stillpoint::bench
