// SPDX-License-Identifier: MIT
#include "dense_scan.hpp"

#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/input_error.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>
#include <vector>

namespace stillpoint::bench {

namespace {

using design::Combine;
using design::RecordDesignRequest;
using design::SuiteDamper;
using design::SuiteObjective;

constexpr double points_of_a_grid = 333'333;
/// A damper that is worse than the design by more is not followed to its end.
constexpr double of_interest = 1.05;
/// In cells of the first grid, to each side.
constexpr double about_cells = 2;
constexpr double half_cycles = 10'000;

/// sqrt(f), sqrt(delta), 1/p.
using Place = std::array<double, 3>;

Place place(const SuiteDamper& damper) {
  return {std::sqrt(damper.f), std::sqrt(damper.delta), 1 / damper.p};
}
SuiteDamper at(const Place& place) {
  return {1 / place[2], place[0] * place[0], place[1] * place[1]};
}

struct Box {
  Place low;
  Place high;

  [[nodiscard]] bool varies(std::size_t i) const { return low.at(i) < high.at(i); }
  /// Points along a side that varies of a grid of all.
  [[nodiscard]] double side() const {
    double variables = 0;
    for (std::size_t i = 0; i < low.size(); ++i) {
      variables += varies(i) ? 1 : 0;
    }
    return std::pow(points_of_a_grid, 1 / variables);
  }
};

class DenseScan {
 public:
  DenseScan(const RecordDesignRequest& task, double found)
      : task_(task), best_(found * of_interest) {
    for (const design::SuiteRecord& record : task.records) {
      loads_.emplace_back(design::scaled(record));
    }
  }

  void run(const Box& box) {
    std::array<std::int64_t, 3> sides{};
    for (std::size_t i = 0; i < sides.size(); ++i) {
      sides.at(i) = box.varies(i) ? static_cast<std::int64_t>(box.side()) : 1;
    }
    const std::int64_t size = sides[0] * sides[1] * sides[2];
    for_each_entry(size, {}, {}, [&](std::ptrdiff_t index) {
      Place here = box.low;
      for (std::size_t i = 0; i < sides.size(); index /= sides.at(i), ++i) {
        if (sides.at(i) > 1) {
          const auto part =
              static_cast<double>(index % sides.at(i)) / static_cast<double>(sides.at(i) - 1);
          here.at(i) += part * (box.high.at(i) - box.low.at(i));
        }
      }
      try_damper(at(here));
    });
    points_ += size;
  }

  /// The best of the grids so far; infinite if none matters.
  [[nodiscard]] DenseBest best() const {
    return best_damper_ ? DenseBest{*best_damper_, best_, points_}
                        : DenseBest{{}, HUGE_VAL, points_};
  }

 private:
  void try_damper(const SuiteDamper& damper) {
    const double value = objective(damper);
    if (value < best_) {
      const std::lock_guard lock(one_at_a_time_);
      if (value < best_) {
        best_ = value;
        best_damper_ = damper;
      }
    }
  }

  /// Infinite if a limit is violated, and as soon as it cannot be better than the best. The record
  /// that decided last is first, because it usually decides again.
  [[nodiscard]] double objective(const SuiteDamper& damper) {
    const bool largest = *task_.combine == Combine::max;
    const double share = largest ? 1 : 1 / static_cast<double>(loads_.size());
    double peak = 0;
    double acceleration = 0;
    double residual = 0;
    const auto add = [&](double& sum, double value) {
      sum = largest ? std::max(sum, value) : sum + value * share;
    };
    const ForcedOptions options{.half_cycle_limit = half_cycles};
    const std::size_t first = telling_;
    for (std::size_t i = 0; i < loads_.size(); ++i) {
      const std::size_t index = (first + i) % loads_.size();
      const Excitation& load = loads_[index];
      try {
        const ForcedResponse one =
            forced_response({damper.p, damper.f, damper.delta, task_.hold}, {}, load, options,
                            Surface{task_.notch_width, {}});
        if (!one.stop_position || one.decision_margin.value_or(1) < design::least_suite_margin) {
          telling_ = index;
          return HUGE_VAL;
        }
        add(peak, one.peak_amplitude);
        add(acceleration, one.peak_absolute_acceleration);
        add(residual, std::abs(*one.stop_position));
      } catch (const TooManyHalfCycles&) {
        return HUGE_VAL;
      }
      const double value = task_.objective == SuiteObjective::amplitude  ? peak
                           : task_.objective == SuiteObjective::residual ? residual
                                                                         : acceleration;
      if (peak > task_.limits.peak.value_or(HUGE_VAL) ||
          residual > task_.limits.residual.value_or(HUGE_VAL) ||
          acceleration > task_.limits.acceleration.value_or(HUGE_VAL) || value >= best_) {
        telling_ = index;
        return HUGE_VAL;
      }
      if (i + 1 == loads_.size()) {
        return value;
      }
    }
    return HUGE_VAL;
  }

  const RecordDesignRequest& task_;
  std::vector<Excitation> loads_;
  std::mutex one_at_a_time_;
  std::atomic<double> best_;
  std::atomic<std::size_t> telling_{0};
  std::optional<SuiteDamper> best_damper_;
  std::int64_t points_{0};
};

/// Around a damper, within `whole`.
Box about(const Box& whole, const SuiteDamper& damper) {
  const Place middle = place(damper);
  Box box = whole;
  for (std::size_t i = 0; i < middle.size(); ++i) {
    const double reach = about_cells * (whole.high.at(i) - whole.low.at(i)) / whole.side();
    box.low.at(i) = std::max(whole.low.at(i), middle.at(i) - reach);
    box.high.at(i) = std::min(whole.high.at(i), middle.at(i) + reach);
  }
  return box;
}

}  // namespace

DenseBest dense_best(const RecordDesignRequest& request, const SuiteDamper& found, double value) {
  const Box whole{place({request.p.high, request.f->low, request.delta->low}),
                  place({request.p.low, request.f->high, request.delta->high})};
  DenseScan scan(request, value);
  scan.run(whole);
  if (std::isfinite(scan.best().value)) {
    scan.run(about(whole, scan.best().damper));
  }
  scan.run(about(whole, found));
  return scan.best();
}

}  // namespace stillpoint::bench
