// SPDX-License-Identifier: MIT
#include "free_lanes.hpp"

#include <stillpoint/core/batch.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>
#include <vector>

namespace stillpoint {

namespace {

using Eigen::Index;

constexpr Index block = 4096;  // entries that a thread takes at a time
constexpr double infinite = std::numeric_limits<double>::infinity();

EntryValues each(const BatchValues& values) {
  return {values.data(), 1};
}

void require_size(const char* field, const BatchValues& values, Index size) {
  if (values.size() != size) {
    throw InputError(field, fmt::format("an array of {}", values.size()),
                     fmt::format("must have as many entries as f, {}", size));
  }
}

void require_valid(const BatchAsk& ask) {
  require_within("half_cycle_limit", ask.half_cycle_limit, 1, 1e15);
  if (ask.threads < 0) {
    throw InputError("threads", ask.threads, "must be 0 or more");
  }
}

void resize(BatchResult& result, Index size, bool times) {
  result.peak_amplitude.resize(size);
  result.half_cycles.resize(size);
  result.outcome.resize(size);
  result.stop_position.resize(size);
  result.stop_time.resize(times ? size : 0);
}

/// What all threads share: the entries that are left, and the first error.
class Work {
 public:
  Work(const FreeLanesInput& input, Index size, const FreeLanesOutput& output)
      : input_(input), size_(size), output_(output) {}

  [[nodiscard]] const FreeLanesInput& input() const { return input_; }
  [[nodiscard]] const FreeLanesOutput& output() const { return output_; }

  EntryRange next() {
    const Index begin = failed_ ? size_ : std::min(size_, next_.fetch_add(block));
    return {begin, std::min(size_, begin + block)};
  }

  /// Keeps the error of the first entry. Blocks are handed out in order and finished once begun, so
  /// which one that is does not depend on the threads.
  void fail(Index entry, const std::exception_ptr& error) {
    const std::scoped_lock lock(mutex_);
    if (!error_ || entry < failed_entry_) {
      failed_entry_ = entry;
      error_ = error;
    }
    failed_ = true;
  }

  void rethrow_error() const {
    if (error_) {
      std::rethrow_exception(error_);
    }
  }

 private:
  const FreeLanesInput& input_;
  Index size_;
  const FreeLanesOutput& output_;
  std::atomic<Index> next_{0};
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  Index failed_entry_{0};
  std::exception_ptr error_;
};

/// Entry i by the scalar kernel.
void run_entry(const FreeLanesInput& input, Index i, const FreeLanesOutput& output) {
  const bool times = output.stop_time != nullptr;
  const Response response = free_response(
      {.p = input.p[i], .f = input.f[i], .delta = input.delta[i]}, {.x0 = 0, .v0 = input.v0[i]},
      {.times = times, .margin = false, .half_cycle_limit = input.half_cycle_limit});
  output.peak_amplitude[i] = response.peak_amplitude;
  output.half_cycles[i] = response.half_cycles.value_or(infinite);
  output.outcome[i] = response.outcome;
  output.stop_position[i] = response.stop_position.value_or(0);
  if (times) {
    output.stop_time[i] = response.stop_time.value_or(infinite);
  }
}

/// `error` in entry i. A value that stands for all entries has none.
InputError in_entry(const InputError& error, Index i, const FreeLanesInput& input) {
  const bool for_all = (error.field() == "v0" && input.v0.stride == 0) ||
                       (error.field() == "p" && input.p.stride == 0);
  return for_all ? error : error.in_entry(i);
}

class OneThread final : public FreeLanesSource {
 public:
  explicit OneThread(Work& work) : work_(work) {}

  EntryRange next() override { return work_.next(); }

  void run_alone(Index i) override {
    try {
      run_entry(work_.input(), i, work_.output());
    } catch (const InputError& error) {
      work_.fail(i, std::make_exception_ptr(in_entry(error, i, work_.input())));
    } catch (const TooManyHalfCycles& error) {
      work_.fail(i, std::make_exception_ptr(error.in_entry(i)));
    }
  }

 private:
  Work& work_;
};

Index number_of_threads(int asked, Index size) {
  const auto wanted =
      asked > 0 ? Index{asked} : Index{std::max(1U, std::thread::hardware_concurrency())};
  return std::clamp(Index{(size + block - 1) / block}, Index{1}, wanted);
}

void run(const FreeLanesInput& input, Index size, const BatchAsk& ask, BatchResult& result) {
  resize(result, size, ask.times);
  const FreeLanesOutput output{result.peak_amplitude.data(), result.half_cycles.data(),
                               result.outcome.data(), result.stop_position.data(),
                               ask.times ? result.stop_time.data() : nullptr};
  Work work(input, size, output);
  const auto run_thread = [&work] {
    OneThread source(work);
    run_free_lanes(work.input(), work.output(), source);
  };
  {
    std::vector<std::jthread> others;
    for (Index i = 1; i < number_of_threads(ask.threads, size); ++i) {
      others.emplace_back(run_thread);
    }
    run_thread();
  }
  work.rethrow_error();
}

}  // namespace

void free_batch(double v0, double p, const BatchValues& f, const BatchValues& delta,
                const BatchAsk& ask, BatchResult& result) {
  require_valid(ask);
  require_size("delta", delta, f.size());
  run({{&v0, 0}, {&p, 0}, each(f), each(delta), ask.half_cycle_limit}, f.size(), ask, result);
}

void free_batch(const BatchValues& v0, const BatchValues& p, const BatchValues& f,
                const BatchValues& delta, const BatchAsk& ask, BatchResult& result) {
  require_valid(ask);
  require_size("v0", v0, f.size());
  require_size("p", p, f.size());
  require_size("delta", delta, f.size());
  run({each(v0), each(p), each(f), each(delta), ask.half_cycle_limit}, f.size(), ask, result);
}

BatchResult free_batch(double v0, double p, const BatchValues& f, const BatchValues& delta,
                       const BatchAsk& ask) {
  BatchResult result;
  free_batch(v0, p, f, delta, ask, result);
  return result;
}

BatchResult free_batch(const BatchValues& v0, const BatchValues& p, const BatchValues& f,
                       const BatchValues& delta, const BatchAsk& ask) {
  BatchResult result;
  free_batch(v0, p, f, delta, ask, result);
  return result;
}

}  // namespace stillpoint
