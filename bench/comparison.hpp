// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/peers/measure.hpp>
#include "free_modes.hpp"
#include "machine.hpp"
#include "many_dampers.hpp"
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
