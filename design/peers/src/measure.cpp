// SPDX-License-Identifier: MIT
#include <stillpoint/core/seconds.hpp>
#include <stillpoint/peers/measure.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stillpoint::peers {

namespace {

double seconds_of(const std::function<void()>& call, long repeats) {
  const double begun = seconds_now();
  for (long i = 0; i < repeats; ++i) {
    call();
  }
  return (seconds_now() - begun) / static_cast<double>(repeats);
}

/// Calls, and the number that makes a batch, from their first runs.
struct Case {
  const std::function<void()>& call;
  double first;
  long repeats;
  std::vector<double> batches;

  Case(const std::function<void()>& what, const MeasureOptions& options)
      : call(what), first(seconds_of(what, 1)), repeats(repeats_of(options.batch_seconds)) {
    // The first call pays for cold caches, and the machine may delay any of them: with too few
    // repeats every batch would be a cold one.
    for (int again = 0; again < 2 && first <= options.slow; ++again) {
      first = std::min(first, seconds_of(call, std::min(repeats, 16L)));
      repeats = repeats_of(options.batch_seconds);
    }
  }

  /// One batch. The calls of the other cases have emptied the caches; a call to fill them again is
  /// not timed where it is one of many.
  void add_batch() {
    if (repeats > 1) {
      call();
    }
    batches.push_back(seconds_of(call, repeats));
  }

 private:
  [[nodiscard]] long repeats_of(double batch_seconds) const {
    return std::max(1L, std::lround(std::min(1e9, batch_seconds / std::max(first, 1e-9))));
  }
};

Timing summary(std::vector<double> batches) {
  std::sort(batches.begin(), batches.end());
  const auto quantile = [&](std::size_t quarters) {
    return batches[(batches.size() - 1) * quarters / 4];
  };
  return {quantile(2), quantile(1), quantile(3), static_cast<int>(batches.size())};
}

}  // namespace

std::vector<Timing> measure(const std::vector<std::function<void()>>& calls,
                            const MeasureOptions& options) {
  std::vector<Case> cases;
  cases.reserve(calls.size());
  for (const auto& call : calls) {
    cases.emplace_back(call, options);
  }
  for (int batch = 0; batch < options.batches; ++batch) {
    for (Case& now : cases) {
      if (now.first <= options.slow) {
        now.add_batch();
      }
    }
  }
  std::vector<Timing> timings;
  timings.reserve(cases.size());
  for (const Case& done : cases) {
    timings.push_back(done.batches.empty() ? Timing{done.first, done.first, done.first, 1}
                                           : summary(done.batches));
  }
  return timings;
}

}  // namespace stillpoint::peers
