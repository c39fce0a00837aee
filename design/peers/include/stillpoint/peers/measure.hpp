// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

namespace stillpoint::peers {

/// Seconds per call.
struct Timing {
  double median{0};
  double low{0};   ///< lower quartile of the batches
  double high{0};  ///< upper quartile
  int batches{0};
};

struct MeasureOptions {
  int batches{21};
  double batch_seconds{
      1e-3};         ///< a batch repeats a call for about this long: less than a time slice
  double slow{0.2};  ///< a call that takes longer is timed once: Timing::batches is 1
};

/// Times all calls, a batch of each in turn and then the next batch of each, so that other work of
/// the machine affects them alike.
[[nodiscard]] std::vector<Timing> measure(const std::vector<std::function<void()>>& calls,
                                          const MeasureOptions& options);

}  // namespace stillpoint::peers
