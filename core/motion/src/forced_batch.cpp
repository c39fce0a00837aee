// SPDX-License-Identifier: MIT
#include "batch_work.hpp"
#include "forced_response_of_valid.hpp"

#include <stillpoint/core/forced_batch.hpp>

#include <cstddef>

namespace stillpoint {

namespace {

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
