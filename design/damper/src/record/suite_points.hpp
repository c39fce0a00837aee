// SPDX-License-Identifier: MIT
#pragma once

// The points of a search under records, and the phases that find better ones: suite_descent.cpp,
// suite_population.cpp.

#include "record/suite_scan.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace stillpoint::design {

/// A point of the box with its rank. Of equal ones a search keeps the first.
struct RankedPoint {
  std::vector<double> unit;
  SuiteFigures figures;
  SuiteRank rank{};
};

/// Objectives that differ by less than this part are equal but for rounding.
inline constexpr double no_difference = 1e-6;

/// Evaluates and ranks the points of one search.
class SuitePoints {
 public:
  SuitePoints(const Suite& suite, const SuiteBox& box, SuiteObjective objective,
              const SuiteLimits& limits, const Threads& threads, SuiteWatch& watch)
      : suite_(suite),
        box_(box),
        objective_(objective),
        limits_(limits),
        threads_(threads),
        watch_(watch) {}

  [[nodiscard]] const SuiteBox& box() const { return box_; }
  [[nodiscard]] std::size_t records() const { return suite_.loads().size(); }
  [[nodiscard]] const Threads& threads() const { return threads_; }
  [[nodiscard]] bool stopped() const { return watch_.stopped(); }

  /// Several threads may call this at once.
  [[nodiscard]] RankedPoint ranked(std::vector<double> unit) const;
  /// The same on all threads; `evaluations` counts these.
  [[nodiscard]] std::vector<RankedPoint> all_ranked(std::vector<std::vector<double>> units);
  [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }

  /// The best valleys of a scan of the box, at most `most`.
  [[nodiscard]] std::vector<RankedPoint> valleys_of(const SuiteScan& scan, std::size_t most) const;

 private:
  const Suite& suite_;
  const SuiteBox& box_;
  SuiteObjective objective_;
  SuiteLimits limits_;
  Threads threads_;
  SuiteWatch& watch_;
  std::int64_t evaluations_{0};
};

/// The points of a grid, so many to a side, that no neighbour betters, best first; at most `most`.
[[nodiscard]] std::vector<std::size_t> valleys(std::int64_t points, std::size_t variables,
                                               const std::vector<SuiteRank>& ranks,
                                               std::size_t most);

/// A search by NLopt.
struct SuiteDescent {
  RankedPoint best;  ///< that it tried, the start included
  const char* algorithm;
  std::string status;  ///< NLopt's own
  int evaluations{0};
};

/// From each start, with this first step. If asked, a global search comes first, which takes
/// longest, with a descent from its best.
[[nodiscard]] std::vector<SuiteDescent> descents(const SuitePoints& points,
                                                 const std::vector<RankedPoint>& starts,
                                                 double first_step, bool global);

/// The best of each population that is bred from `found` and from points about `best`.
[[nodiscard]] std::vector<RankedPoint> bred(SuitePoints& points,
                                            const std::vector<RankedPoint>& found,
                                            const RankedPoint& best);

}  // namespace stillpoint::design
