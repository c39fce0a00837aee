// SPDX-License-Identifier: MIT
#include "batch_work.hpp"
#include "forced_response_of_valid.hpp"
#include "record_lanes.hpp"
#include "record_motion.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/record_batch.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>

namespace stillpoint {

namespace {

/// After this many samples the lanes that have ended are removed.
constexpr std::size_t samples_between_looks = 128;

void resize(RecordBatchResult& result, Eigen::Index size) {
  result.outcome.resize(size);
  for (Eigen::ArrayXd RecordBatchResult::*const column :
       {&RecordBatchResult::peak_amplitude, &RecordBatchResult::peak_absolute_acceleration,
        &RecordBatchResult::jump, &RecordBatchResult::stop_position, &RecordBatchResult::stop_time,
        &RecordBatchResult::locked_from, &RecordBatchResult::half_cycles,
        &RecordBatchResult::turning_points, &RecordBatchResult::sticks,
        &RecordBatchResult::decision_margin}) {
    (result.*column).resize(size);
  }
}

void keep(RecordBatchResult& result, Eigen::Index i, const std::optional<ForcedResponse>& found) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const ForcedResponse response = found.value_or(ForcedResponse());
  result.outcome[i] = found ? response.outcome : Outcome::running;
  result.peak_amplitude[i] = response.peak_amplitude;
  result.peak_absolute_acceleration[i] = response.peak_absolute_acceleration;
  result.jump[i] = response.jump;
  result.stop_position[i] = response.stop_position.value_or(0);
  result.stop_time[i] = response.stop_time.value_or(infinite);
  result.locked_from[i] = response.locked_from.value_or(infinite);
  result.half_cycles[i] = response.half_cycles.value_or(0);
  result.turning_points[i] = response.turning_points.value_or(0);
  result.sticks[i] = response.sticks;
  result.decision_margin[i] = response.decision_margin.value_or(infinite);
}

/// The motions of one block of entries.
class RecordBlock {
 public:
  RecordBlock(const Excitation& excitation, const ForcedOptions& options, bool damped)
      : excitation_(excitation), record_(std::get<Record>(excitation)), options_(options) {
    columns_.damped = damped;
  }

  void add(std::size_t lane, const Oscillator& oscillator, const Start& start,
           const Surface& surface) {
    const LaneTask task{oscillator, start, excitation_, options_, columns_, lane};
    motions_.at(lane) = paper_motion(oscillator, surface) ? record_motion(task)
                                                          : zoned_record_motion(task, surface);
    events_.at(lane) = motions_.at(lane).get();
    if (motions_.at(lane)->begin()) {
      live_.at(count_++) = lane;
    }
  }

  /// All of them through the record, and no lane remains.
  void run() {
    std::size_t begin = 0;
    while (count_ > 0) {
      const std::size_t end = std::min(begin + samples_between_looks, reach());
      run_record_lanes(record_.values.data(), begin, end, live_.data(), count_, columns_,
                       events_.data());
      begin = end;
      const auto ended = [&](std::size_t lane) {
        return motions_[lane]->over() || motions_[lane]->last() == begin;
      };
      auto* const live_end = live_.data() + count_;
      auto* const rest = std::remove_if(live_.data(), live_end, ended);
      count_ = static_cast<std::size_t>(rest - live_.data());
      // Groups those at rest, since they need less work.
      std::partition(live_.data(), rest,
                     [&](std::size_t lane) { return columns_[RecordValue::sign][lane] != 0; });
    }
  }

  /// For a lane since it was added.
  std::optional<ForcedResponse> take(std::size_t lane) {
    std::optional<ForcedResponse> response = motions_.at(lane)->response();
    motions_.at(lane).reset();
    return response;
  }
  [[nodiscard]] bool has(std::size_t lane) const { return motions_.at(lane) != nullptr; }

 private:
  /// The first sample at which a lane is through the record: by rounding, they may differ by one.
  std::size_t reach() {
    std::size_t first = record_.values.size() - 1;
    for (std::size_t k = 0; k < count_; ++k) {
      first = std::min(first, motions_[live_.at(k)]->last());
    }
    return first;
  }

  const Excitation& excitation_;
  const Record& record_;
  const ForcedOptions& options_;
  RecordColumns columns_{};
  std::array<std::unique_ptr<RecordMotion>, record_lanes> motions_;
  std::array<LaneEvents*, record_lanes> events_{};
  std::array<std::size_t, record_lanes> live_{};
  std::size_t count_{0};
};

/// Checks scene after scene under one record, which is long: its check depends on the oscillator
/// only through p, which it allows between two bounds. So every p between two allowed ones is
/// allowed.
class SceneCheck {
 public:
  explicit SceneCheck(const Excitation& record) : record_(record) {}

  void require(const Oscillator& oscillator, const Start& start) {
    if (least_p_ <= oscillator.p && oscillator.p <= most_p_) {
      require_valid(oscillator, start);
      return;
    }
    require_valid(oscillator, start, record_, std::nullopt);
    least_p_ = std::min(least_p_, oscillator.p);
    most_p_ = std::max(most_p_, oscillator.p);
  }

 private:
  const Excitation& record_;
  double least_p_{std::numeric_limits<double>::infinity()};
  double most_p_{0};
};

/// One by one: under records with times of their own.
std::optional<ForcedResponse> alone(const Oscillator& oscillator, const Start& start,
                                    const Excitation& excitation, const ForcedOptions& options,
                                    const Surface& surface) {
  try {
    return forced_response_of_valid(oscillator, start, excitation, options, surface);
  } catch (const TooManyHalfCycles&) {
    return std::nullopt;
  }
}

}  // namespace

ForcedResponse RecordBatchResult::rest_of(Eigen::Index entry) const {
  ForcedResponse response;
  response.peak_amplitude = peak_amplitude[entry];
  response.peak_absolute_acceleration = peak_absolute_acceleration[entry];
  response.jump = jump[entry];
  response.stop_position = stop_position[entry];
  response.stop_time = stop_time[entry];
  response.decision_margin = decision_margin[entry];
  return response;
}

void record_batch(double v0, const BatchValues& p, const BatchValues& f, const BatchValues& delta,
                  const Record& record, const RecordBatchOptions& options,
                  RecordBatchResult& result) {
  require_within("half_cycle_limit", options.half_cycle_limit, 1, 1e15);
  const Eigen::ArrayXd speeds = Eigen::ArrayXd::Constant(f.size(), v0);
  BatchEntries entries = entries_of(speeds, p, f, delta);
  entries.v0.stride = 0;
  resize(result, entries.size);
  const ForcedOptions scene{.half_cycle_limit = options.half_cycle_limit};
  const Excitation excitation = record;
  const bool in_lanes = record.times.empty();
  if (options.notch_width.size() > 0) {
    require_entries("notch-width", options.notch_width, entries.size);
    entries.notch_width = {options.notch_width.data(), 1};
  }
  damp(entries, options.zeta);
  run_batch(entries, record_lanes, options.threads, {}, [&](EntryThreads& work) {
    SceneCheck check(excitation);
    const auto undamped = std::make_unique<RecordBlock>(excitation, scene, false);
    const auto damped =
        options.zeta.size() > 0 ? std::make_unique<RecordBlock>(excitation, scene, true) : nullptr;
    const Start start{0, v0};
    Surface surface = options.surface;
    for (EntryRange range = work.next(); range.begin < range.end; range = work.next()) {
      const auto lane = [&](Eigen::Index i) { return static_cast<std::size_t>(i - range.begin); };
      for (Eigen::Index i = range.begin; i < range.end; ++i) {
        work.guard(i, [&] {
          const Oscillator oscillator{entries.p[i], entries.f[i],    entries.delta[i],
                                      options.hold, entries.zeta[i], options.breakaway};
          check.require(oscillator, start);
          if (entries.notch_width.stride != 0) {
            surface.notch_width.reset();
            if (entries.notch_width[i] != 0) {
              surface.notch_width = entries.notch_width[i];
            }
          }
          require_valid(oscillator, surface);
          if (in_lanes) {
            (oscillator.zeta > 0 ? damped : undamped)->add(lane(i), oscillator, start, surface);
          } else {
            keep(result, i, alone(oscillator, start, excitation, scene, surface));
          }
        });
      }
      for (RecordBlock* block : {undamped.get(), damped.get()}) {
        if (block == nullptr) {
          continue;
        }
        block->run();
        for (Eigen::Index i = range.begin; i < range.end; ++i) {
          if (block->has(lane(i))) {
            keep(result, i, block->take(lane(i)));
          }
        }
      }
    }
  });
}

RecordBatchResult record_batch(double v0, const BatchValues& p, const BatchValues& f,
                               const BatchValues& delta, const Record& record,
                               const RecordBatchOptions& options) {
  RecordBatchResult result;
  record_batch(v0, p, f, delta, record, options, result);
  return result;
}

}  // namespace stillpoint
