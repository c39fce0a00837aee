// SPDX-License-Identifier: MIT
#include <stillpoint/peers/measure.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>

namespace stillpoint::peers {

namespace {

double seconds_of(const std::function<void()>& call, long repeats) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  for (long i = 0; i < repeats; ++i) {
    call();
  }
  const std::chrono::duration<double> taken = Clock::now() - begin;
  return taken.count() / static_cast<double>(repeats);
}

/// Calls and, from their first runs, how many make a batch.
struct Case {
  const std::function<void()>& call;
  double first;
  long repeats;
  std::vector<double> batches;

  Case(const std::function<void()>& what, double batch_seconds)
      : call(what), first(seconds_of(what, 1)), repeats(repeats_of(batch_seconds)) {
    if (repeats > 1) {  // the first call pays for cold caches
      first = seconds_of(call, std::min(repeats, 16L));
      repeats = repeats_of(batch_seconds);
    }
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
    cases.emplace_back(call, options.batch_seconds);
  }
  for (int batch = 0; batch < options.batches; ++batch) {
    for (Case& now : cases) {
      if (now.first <= options.slow) {
        now.batches.push_back(seconds_of(now.call, now.repeats));
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
