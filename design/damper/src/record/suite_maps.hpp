// SPDX-License-Identifier: MIT
#pragma once

// The maps of a task: of dampers with constant friction alone, with a notch alone, with both.

#include "record/suite_scan.hpp"
#include "record/suite_search.hpp"

#include <array>
#include <deque>
#include <optional>

namespace stillpoint::design {

inline constexpr std::array every_friction{SuiteFrictions::constant, SuiteFrictions::point,
                                           SuiteFrictions::both};

[[nodiscard]] bool has_friction(const RecordDesignRequest& task, SuiteFrictions frictions);

/// A space with the map of its boxes.
struct MappedSpace {
  MappedSpace(const Suites& suite, const RecordDesignRequest& task, SuiteFrictions which,
              SuiteWatch& watch);

  SuiteFrictions frictions;
  SuiteSpace space;
  SuiteScan scan;
  std::optional<BoxedDamper> nearest{};  ///< to the limits
};

/// Each is made when it is needed. What is referred to must outlive them.
class SuiteMaps {
 public:
  SuiteMaps(const Suites& suite, const RecordDesignRequest& task, SuiteWatch& watch)
      : suite_(suite), task_(task), watch_(watch) {}

  /// About what the maps, candidates and verifications take.
  void expect();

  MappedSpace& add(SuiteFrictions frictions) {
    return all_.emplace_back(suite_, task_, frictions, watch_);
  }
  /// Those of frictions that have none.
  void add_missing();

  /// Null if there is none yet.
  [[nodiscard]] MappedSpace* of(SuiteFrictions frictions);
  [[nodiscard]] std::deque<MappedSpace>& all() { return all_; }

  /// Whether no damper at all is near the limits.
  [[nodiscard]] bool are_hopeless(const SuiteGoal& goal) const;

  /// The best of all frictions, looked for briefly.
  [[nodiscard]] std::optional<VerifiedBox> least(const SuiteGoal& goal);

 private:
  const Suites& suite_;
  const RecordDesignRequest& task_;
  SuiteWatch& watch_;
  std::deque<MappedSpace> all_;  // which refer to their own members
};

}  // namespace stillpoint::design
