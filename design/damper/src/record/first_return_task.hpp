// SPDX-License-Identifier: MIT
#pragma once

// A task of one hit or one pulse at whose first return every damper must stop: its best damper and
// what would help are found along f, as those of a pulse, docs/theory.md section 8.

#include <stillpoint/design/region_result.hpp>
#include <stillpoint/design/suite_task.hpp>

#include <optional>
#include <vector>

namespace stillpoint::design {

/// A damper and its tolerance, in those of the request.
struct DamperAlongF {
  SuiteDamper damper;
  double scale{1};
};

class FirstReturnTask {
 public:
  /// Empty if a completed request is another task.
  [[nodiscard]] static std::optional<FirstReturnTask> of(const RecordDesignRequest& task);

  /// The best for the objective, with the tolerance that is required; empty if there is none.
  [[nodiscard]] std::optional<DamperAlongF> best() const;
  /// Each that would help alone, where there is none, but for a residual or another arrival.
  [[nodiscard]] std::vector<Mend> mends() const;

 private:
  PulseProblem problem_;
  Limits limits_;
  Objective objective_{Objective::robust};
  double p_{1};
  bool bounds_delta_itself_{false};  ///< and not its box: nobody did
  double whole_{1};                  ///< the largest side of the tolerance of the request
};

}  // namespace stillpoint::design
