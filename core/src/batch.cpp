// SPDX-License-Identifier: MIT
#include <stillpoint/core/batch.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>

#include <fmt/format.h>

#include <cstddef>
#include <limits>

namespace stillpoint {

namespace {

using Eigen::Index;

/// A value for all entries (stride 0) or one for each (stride 1).
struct Values {
  const double* data;
  Index stride;

  double operator[](Index i) const { return data[i * stride]; }
};

struct Input {
  Values v0;
  Values p;
  Values f;
  Values delta;
  Index size;
};

Values each(const BatchValues& values) {
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

/// Entry i by the scalar kernel.
void run_entry(const Input& input, Index i, const BatchAsk& ask, BatchResult& result) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const Response response = free_response(
      {.p = input.p[i], .f = input.f[i], .delta = input.delta[i]}, {.x0 = 0, .v0 = input.v0[i]},
      {.times = ask.times, .margin = false, .half_cycle_limit = ask.half_cycle_limit});
  result.peak_amplitude[i] = response.peak_amplitude;
  result.half_cycles[i] = response.half_cycles.value_or(infinite);
  result.outcome[i] = response.outcome;
  result.stop_position[i] = response.stop_position.value_or(0);
  if (ask.times) {
    result.stop_time[i] = response.stop_time.value_or(infinite);
  }
}

void run(const Input& input, const BatchAsk& ask, BatchResult& result) {
  require_valid(ask);
  resize(result, input.size, ask.times);
  for (Index i = 0; i < input.size; ++i) {
    try {
      run_entry(input, i, ask, result);
    } catch (const InputError& error) {
      throw error.in_entry(i);
    } catch (const TooManyHalfCycles& error) {
      throw error.in_entry(i);
    }
  }
}

}  // namespace

void free_batch(double v0, double p, const BatchValues& f, const BatchValues& delta,
                const BatchAsk& ask, BatchResult& result) {
  require_size("delta", delta, f.size());
  run({{&v0, 0}, {&p, 0}, each(f), each(delta), f.size()}, ask, result);
}

void free_batch(const BatchValues& v0, const BatchValues& p, const BatchValues& f,
                const BatchValues& delta, const BatchAsk& ask, BatchResult& result) {
  require_size("v0", v0, f.size());
  require_size("p", p, f.size());
  require_size("delta", delta, f.size());
  run({each(v0), each(p), each(f), each(delta), f.size()}, ask, result);
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
