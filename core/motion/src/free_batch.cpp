// SPDX-License-Identifier: MIT
#include "batch_work.hpp"
#include "damped_free.hpp"
#include "damped_lanes.hpp"
#include "free_lanes.hpp"
#include "kernel/first_leg.hpp"

#include <stillpoint/core/batch.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace stillpoint {

namespace {

using Eigen::Index;

constexpr Index block = 4096;  // entries that a thread takes at once

void resize(BatchResult& result, Index size, const BatchOptions& options) {
  result.peak_amplitude.resize(size);
  result.half_cycles.resize(size);
  result.outcome.resize(size);
  result.stop_position.resize(size);
  result.stop_time.resize(options.times ? size : 0);
  result.peak_absolute_acceleration.resize(options.acceleration ? size : 0);
}

/// Feeds the lanes of one thread.
class FreeBatchSource final : public FreeLanesSource, public DampedLanesSource {
 public:
  FreeBatchSource(const BatchEntries& entries, const BatchOptions& options, BatchResult& result,
                  EntryThreads& work)
      : entries_(entries), options_(options), result_(result), work_(work) {}

  EntryRange next() override {
    const EntryRange range = work_.next();
    for (Index i = range.begin; options_.acceleration && i < range.end; ++i) {
      result_.peak_absolute_acceleration[i] = acceleration(i);
    }
    return range;
  }

  [[nodiscard]] bool goes_on() override { return work_.goes_on(); }

  bool begin(std::size_t lane, LaneValues& values) override {
    while (true) {
      if (range_.begin == range_.end) {
        range_ = work_.next();
        if (range_.begin == range_.end) {
          return false;
        }
      }
      const Index i = range_.begin++;
      if (entries_.zeta[i] != cycle_.zeta) {
        cycle_ = damped_cycle(entries_.zeta[i]);
      }
      const std::optional<DampedFree> motion = damped_free(oscillator(i), start(i), cycle_);
      if (motion && ordinary(*motion)) {
        running_.resize(std::max(running_.size(), lane + 1));
        running_[lane] = {i, *motion};
        values = {motion->phi, motion->held, motion->notch,
                  cycle_.zeta, cycle_.decay, motion->speed};
        return true;
      }
      run_alone(i);
    }
  }

  void end(std::size_t lane, const LaneValues& values) override {
    const auto value = [&](LaneValue of) { return values[static_cast<std::size_t>(of)]; };
    const Running& run = running_[lane];
    DampedEnd end{.farthest = value(LaneValue::farthest),
                  .peak = value(LaneValue::peak),
                  .excursion = value(LaneValue::excursion),
                  .passages = value(LaneValue::passages),
                  .phase = value(LaneValue::phase)};
    if (end.peak > run.motion.held && end.excursion >= 0) {
      end.at_zero = true;
      end.phase -= value(LaneValue::late);
    }
    Response response = response_of(run.motion, end);
    if (options_.acceleration) {
      response.peak_absolute_acceleration = largest_acceleration(run.motion);
    }
    keep(run.entry, response);
  }

  void run_alone(Index i) override {
    if (work_.stopped()) {
      return;
    }
    work_.guard(i, [&] { keep(i, response(i)); });
  }

 private:
  struct Running {
    Index entry{0};
    DampedFree motion;
  };

  /// Valid, and for lanes: only the map of half-cycles finds its end, surely within the limit.
  [[nodiscard]] bool ordinary(const DampedFree& motion) const {
    const double v = motion.speed;
    const double most_passages =
        std::min(v * v / motion.notch, (v + motion.phi) / (2 * motion.phi));
    return motion.notch > 0 && motion.p > 1 / largest_speed && motion.p < largest_speed &&
           motion.cycle.zeta <= largest_zeta && options_.breakaway >= 1 &&
           options_.breakaway <= largest_breakaway &&
           most_passages < options_.half_cycle_limit * (1 - 0x1p-40);
  }

  [[nodiscard]] Oscillator oscillator(Index i) const {
    return {.p = entries_.p[i],
            .f = entries_.f[i],
            .delta = entries_.delta[i],
            .zeta = entries_.zeta[i],
            .breakaway = options_.breakaway};
  }

  [[nodiscard]] Start start(Index i) const { return {.x0 = 0, .v0 = entries_.v0[i]}; }

  [[nodiscard]] Response response(Index i) const {
    return free_response(
        oscillator(i), start(i),
        {.times = options_.times, .margin = false, .half_cycle_limit = options_.half_cycle_limit});
  }

  /// From x = 0 it is that of the first leg: docs/theory.md section 3.
  [[nodiscard]] double acceleration(Index i) const {
    const HalfCycleMap<double> map(oscillator(i));
    return first_leg(map, start(i)).acceleration * map.p;
  }

  void keep(Index i, const Response& response) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    result_.peak_amplitude[i] = response.peak_amplitude;
    result_.half_cycles[i] = response.half_cycles.value_or(infinite);
    result_.outcome[i] = response.outcome;
    result_.stop_position[i] = response.stop_position.value_or(0);
    if (options_.acceleration) {
      result_.peak_absolute_acceleration[i] = response.peak_absolute_acceleration;
    }
    if (options_.times) {
      result_.stop_time[i] = response.stop_time.value_or(infinite);
    }
  }

  const BatchEntries& entries_;
  const BatchOptions& options_;
  BatchResult& result_;
  EntryThreads& work_;
  DampedCycle cycle_;
  EntryRange range_{0, 0};  ///< left for the lanes with damping
  std::vector<Running> running_;
};

void run(BatchEntries entries, const BatchOptions& options, BatchResult& result) {
  require_within("half_cycle_limit", options.half_cycle_limit, 1, 1e15);
  damp(entries, options.zeta);
  const bool damped = options.zeta.size() != 0 || options.breakaway != 1;
  resize(result, entries.size, options);
  const FreeLanesOutput output{result.peak_amplitude.data(), result.half_cycles.data(),
                               result.outcome.data(), result.stop_position.data(),
                               options.times ? result.stop_time.data() : nullptr};
  run_batch(entries, block, options.threads, options.go_on, [&](EntryThreads& work) {
    FreeBatchSource source(entries, options, result, work);
    if (damped) {
      run_damped_lanes(source);
    } else {
      run_free_lanes(entries, options.half_cycle_limit, output, source);
    }
  });
}

}  // namespace

void free_batch(double v0, double p, const BatchValues& f, const BatchValues& delta,
                const BatchOptions& options, BatchResult& result) {
  run(entries_of(v0, p, f, delta), options, result);
}

void free_batch(const BatchValues& v0, const BatchValues& p, const BatchValues& f,
                const BatchValues& delta, const BatchOptions& options, BatchResult& result) {
  run(entries_of(v0, p, f, delta), options, result);
}

}  // namespace stillpoint
