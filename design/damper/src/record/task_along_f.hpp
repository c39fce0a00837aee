// SPDX-License-Identifier: MIT
#pragma once

// A task of one hit, or of one pulse at whose first return every damper must stop: its best damper
// and what would help are found along f, docs/theory.md sections 8 and 12.

#include <stillpoint/design/record_design_result.hpp>
#include <stillpoint/design/region_result.hpp>
#include <stillpoint/design/suite_task.hpp>
#include <stillpoint/design/works_for.hpp>

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

namespace stillpoint::design {

/// A damper and its tolerance, in those of the request.
struct DamperAlongF {
  SuiteDamper damper;
  double scale{1};
};

/// Values of f of which the feasible delta is told.
inline constexpr std::size_t told_values_of_f = 61;
/// Evenly from end to end.
[[nodiscard]] std::vector<double> values_in(const Interval& range, std::size_t count);

class TaskAlongF {
 public:
  /// Empty if a completed request is another task.
  [[nodiscard]] static std::optional<TaskAlongF> of(const RecordDesignRequest& task);
  /// What a damper for a hit works for; empty if the request is another task or the damper fails.
  [[nodiscard]] static std::optional<WorksFor> works_for(const RecordDesignRequest& task,
                                                         const SuiteDamper& damper);

  [[nodiscard]] bool of_hit() const { return std::holds_alternative<Problem>(problem_); }

  /// The best for the objective, with the tolerance that is required; empty if there is none.
  [[nodiscard]] std::optional<DamperAlongF> best() const;
  /// From the best towards the most tolerant one, where the best leaves no room to verify it.
  [[nodiscard]] std::vector<SuiteDamper> towards_room(const SuiteDamper& best) const;
  /// Every damper for a hit; empty for a pulse.
  [[nodiscard]] std::optional<FeasibleRegion> feasible() const;
  /// Each that would help alone. It leaves that room, of the tolerance and as a part of the limits:
  /// of a single damper the box could not be verified.
  [[nodiscard]] std::vector<Mend> mends(double room) const;
  /// Whether these say how far the limit of that figure has to move.
  [[nodiscard]] bool moves(const SuiteFigureKind& kind) const;

 private:
  /// Of a task that may also be judged.
  static TaskAlongF posed(const RecordDesignRequest& task);
  /// In the units of the request.
  [[nodiscard]] std::optional<DesignPoint> searched(Objective objective) const;
  /// Without constant friction no rest is off centre, whichever arrival stops the mass.
  [[nodiscard]] std::optional<DesignPoint> without_friction() const;

  std::variant<Problem, PulseProblem> problem_;
  Limits limits_;
  Objective objective_{Objective::robust};
  bool bounds_delta_itself_{false};  ///< and not its box: nobody did
  double whole_{1};                  ///< the largest side of the tolerance of the request
  double p_{1};
};

/// A task along f, where it is one, and its best damper there.
struct AlongF {
  explicit AlongF(const RecordDesignRequest& request)
      : task(TaskAlongF::of(request)), best(task ? task->best() : std::nullopt) {}

  std::optional<TaskAlongF> task;
  std::optional<DamperAlongF> best;
};

}  // namespace stillpoint::design
