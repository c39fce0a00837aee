// SPDX-License-Identifier: MIT
#pragma once

// One motion of the record batch, lane_motion.hpp, for any surface.

#include "record_lanes.hpp"

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/surface.hpp>

#include <cstddef>
#include <memory>
#include <optional>

namespace stillpoint {

class RecordMotion : public LaneEvents {
 public:
  /// Up to the first sample; returns whether a lane must continue it.
  virtual bool begin() = 0;

  /// The last sample for lanes.
  [[nodiscard]] virtual std::size_t last() const = 0;

  [[nodiscard]] virtual bool over() const = 0;

  /// Empty if it has too many half-cycles.
  [[nodiscard]] virtual std::optional<ForcedResponse> response() = 0;
};

/// The excitation is a record with an even step. What is referred to must outlive the motion.
struct LaneTask {
  Oscillator oscillator;
  Start start;
  const Excitation& excitation;
  const ForcedOptions& options;
  RecordColumns& columns;
  std::size_t lane{0};
};

[[nodiscard]] std::unique_ptr<RecordMotion> record_motion(const LaneTask& task);

/// The same on a surface that is not the paper's.
[[nodiscard]] std::unique_ptr<RecordMotion> zoned_record_motion(const LaneTask& task,
                                                                const Surface& surface);

}  // namespace stillpoint
