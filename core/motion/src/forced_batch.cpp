// SPDX-License-Identifier: MIT
#include "batch_work.hpp"
#include "forced_response_of_valid.hpp"

#include <stillpoint/core/forced_batch.hpp>

#include <cstddef>
#include <optional>

namespace stillpoint {

namespace {

/// Checks scene after scene. The check of an excitation depends only on p, and a record is long, so
/// consecutive equal values of p are checked once.
class SceneCheck {
 public:
  SceneCheck(const Excitation& excitation, const std::optional<double>& t_end)
      : excitation_(excitation), t_end_(t_end) {}

  void require(const Oscillator& oscillator, const Start& start) {
    if (oscillator.p == checked_p_) {
      require_valid(oscillator, start);
      return;
    }
    require_valid(oscillator, start, excitation_, t_end_);
    checked_p_ = oscillator.p;
  }

 private:
  const Excitation& excitation_;
  const std::optional<double>& t_end_;
  std::optional<double> checked_p_;
};

std::vector<ForcedResponse> run(const BatchEntries& entries, const Excitation& excitation,
                                const ForcedBatchOptions& options) {
  std::vector<ForcedResponse> responses(static_cast<std::size_t>(entries.size));
  run_batch(entries, 1, options.threads, [&](EntryThreads& work) {
    SceneCheck check(excitation, options.scene.t_end);
    for (EntryRange scene = work.next(); scene.begin < scene.end; scene = work.next()) {
      const std::ptrdiff_t i = scene.begin;
      work.guard(i, [&] {
        const Oscillator oscillator{entries.p[i], entries.f[i], entries.delta[i], options.hold};
        const Start start{0, entries.v0[i]};
        check.require(oscillator, start);
        require_valid(oscillator, options.surface);
        responses[static_cast<std::size_t>(i)] =
            forced_response_of_valid(oscillator, start, excitation, options.scene, options.surface);
      });
    }
  });
  return responses;
}

}  // namespace

std::vector<ForcedResponse> forced_batch(double v0, double p, const BatchValues& f,
                                         const BatchValues& delta, const Excitation& excitation,
                                         const ForcedBatchOptions& options) {
  return run(entries_of(v0, p, f, delta), excitation, options);
}

std::vector<ForcedResponse> forced_batch(const BatchValues& v0, const BatchValues& p,
                                         const BatchValues& f, const BatchValues& delta,
                                         const Excitation& excitation,
                                         const ForcedBatchOptions& options) {
  return run(entries_of(v0, p, f, delta), excitation, options);
}

}  // namespace stillpoint
