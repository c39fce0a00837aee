// SPDX-License-Identifier: MIT
#pragma once

#include "record/suite_scan.hpp"
#include "record/suite_search.hpp"
#include "record/task_along_f.hpp"

#include <optional>

namespace stillpoint::design {

/// A damper with the largest box within the limits that was found.
struct LargestBox {
  double scale{0};  ///< of the tolerance of the request
  VerifiedBox verified;
};

/// Of a scale above the lower end and up to the upper one. From a scan that a search of the whole
/// tolerance has made, the likeliest alone is grown; without one there is a scan for it, and the
/// box is as large as it can be. Empty if not even an exact damper was found.
[[nodiscard]] std::optional<LargestBox> largest_box(const Suites& suite,
                                                    const RecordDesignRequest& task,
                                                    SuiteFrictions frictions, Interval scales,
                                                    const SuiteScan* scan, SuiteWatch& watch);

/// That of a damper whose size is known, but for rounding, with few digits; empty if it fails.
[[nodiscard]] std::optional<LargestBox> largest_box_about(const Suites& suite,
                                                          const RecordDesignRequest& task,
                                                          const DamperAlongF& known, double most,
                                                          SuiteWatch& watch);

}  // namespace stillpoint::design
