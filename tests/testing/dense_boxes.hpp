// SPDX-License-Identifier: MIT
#pragma once

// The boxes of dampers under records by brute force, from the kernel's responses alone: none of the
// code of the search.

#include <stillpoint/core/record_batch.hpp>
#include <stillpoint/design/record_design.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

namespace stillpoint::test {

/// f, Delta, the period 1/p and the width of the notch.
using DamperValues = std::array<double, 4>;

inline DamperValues values_of(const design::SuiteDamper& damper) {
  return {damper.f, damper.delta, 1 / damper.p, damper.width};
}

/// A design with the worst of its box.
struct DenseBox {
  DamperValues design{};
  double value{0};  ///< of the objective
};

class DenseBoxes {
 public:
  /// Of the request of a RecordDesign.
  explicit DenseBoxes(const design::RecordDesignRequest& task) : task_(task) {
    for (const design::SuiteRecord& record : task.cases.front().records) {
      loads_.push_back(design::scaled(record));
    }
    const design::SuiteTolerance& of = task.tolerance;
    spreads_ = {of.f, of.delta, of.period, of.width};
    const Interval width = task.width.value_or(Interval());
    ranges_ = {*task.f, *task.delta, {1 / task.p.high, 1 / task.p.low}, width};
  }

  /// Peak, transmitted acceleration, residual and jump of all records combined, and the latest rest
  /// in periods; all infinite if a motion does not rest.
  using Figures = std::array<double, 5>;

  [[nodiscard]] std::vector<Figures> figures(const std::vector<DamperValues>& dampers) const {
    const auto size = static_cast<Eigen::Index>(dampers.size());
    const auto column = [&](std::size_t i) -> Eigen::ArrayXd {
      return Eigen::ArrayXd::NullaryExpr(size, [&](Eigen::Index k) {
        const double value = dampers[static_cast<std::size_t>(k)].at(i);
        return i == 2 ? 1 / value : value;
      });
    };
    RecordBatchOptions options;
    options.hold = task_.hold;
    options.half_cycle_limit = 10'000;
    options.threads = task_.threads;
    options.notch_width = column(3);
    const bool mean = *task_.cases.front().combine == design::Combine::mean;
    const double share = mean ? 1 / static_cast<double>(loads_.size()) : 1;
    std::vector<Figures> all(dampers.size(), Figures{});
    for (const Record& load : loads_) {
      const RecordBatchResult found =
          record_batch(0, column(2), column(0), column(1), load, options);
      const double end = duration(Excitation(load)).value();
      for (Eigen::Index k = 0; k < size; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const bool rests = found.outcome[k] != Outcome::running &&
                           found.outcome[k] != Outcome::never_stops &&
                           found.half_cycles[k] <= 10'000;
        const double late =
            std::max(0.0, found.stop_time[k] - end) / dampers[i][2] / (2 * std::numbers::pi);
        const Figures now{found.peak_amplitude[k], found.peak_absolute_acceleration[k],
                          std::abs(found.stop_position[k]), found.jump[k], late};
        for (std::size_t n = 0; n < now.size(); ++n) {
          const double value = rests ? now.at(n) : HUGE_VAL;
          all[i].at(n) =
              mean && n < 4 ? all[i].at(n) + share * value : std::max(all[i].at(n), value);
        }
      }
    }
    return all;
  }

  /// By how much a limit is exceeded, as a part of it; 0 or less: all are met.
  [[nodiscard]] double excess(const Figures& figures) const {
    double most = -1;
    const design::SuiteLimits& of = task_.cases.front().limits;
    const std::array limits{of.peak, of.acceleration, of.residual, of.jump, of.late};
    for (std::size_t n = 0; n < limits.size(); ++n) {
      if (const std::optional<double>& limit = limits.at(n)) {
        most = std::max(most, *limit > 0               ? figures.at(n) / *limit - 1
                              : figures.at(n) > *limit ? HUGE_VAL
                                                       : 0);
      }
    }
    return most;
  }

  [[nodiscard]] double objective(const Figures& figures) const {
    return task_.objective == design::SuiteObjective::amplitude  ? figures[0]
           : task_.objective == design::SuiteObjective::residual ? figures[2]
                                                                 : figures[1];
  }

  /// So many random dampers of a box, a quarter of them on its boundary; `scale` times the
  /// tolerance.
  [[nodiscard]] std::vector<DamperValues> samples(const DamperValues& design, std::size_t count,
                                                  std::uint64_t seed, double scale = 1) const {
    std::mt19937_64 random(seed);
    std::vector<DamperValues> list;
    for (std::size_t k = 0; k < count; ++k) {
      DamperValues now = design;
      for (std::size_t i = 0; i < now.size(); ++i) {
        double part = std::ldexp(static_cast<double>(random() >> 11U), -52) - 1;
        if (k % 4 == 0 && k / 4 % now.size() == i) {
          part = k / 16 % 2 == 0 ? -1 : 1;
        }
        now.at(i) *= 1 + scale * part * (part < 0 ? spreads_.at(i).below : spreads_.at(i).above);
      }
      list.push_back(now);
    }
    return list;
  }

  /// The dampers of the grid of `best`.
  [[nodiscard]] std::size_t points(int steps, bool constant) const {
    return Grid(*this, steps, constant).size();
  }

  /// The best box of a grid that is even in logarithms, with so many steps to a box, among those
  /// that survive 4000 random dampers. Without Delta if `constant`. A box at an edge of the grid
  /// does not count.
  [[nodiscard]] std::optional<DenseBox> best(int steps, bool constant) const {
    const Grid grid(*this, steps, constant);
    std::vector<Figures> worst = figures(grid.points());
    for (std::size_t axis = 0; axis < 4; ++axis) {
      worst = grid.slid(worst, axis);
    }
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < worst.size(); ++i) {
      if (excess(worst[i]) <= 0 && !grid.at_edge(i)) {
        order.push_back(i);
      }
    }
    std::ranges::sort(order, {}, [&](std::size_t i) { return objective(worst[i]); });
    constexpr std::size_t most_tried = 40;
    for (std::size_t k = 0; k < std::min(order.size(), most_tried); ++k) {
      const DamperValues design = grid.design(order[k]);
      double value = objective(worst[order[k]]);
      bool survives = true;
      for (const Figures& each : figures(samples(design, 4000, 7))) {
        survives = survives && excess(each) <= 0;
        value = std::max(value, objective(each));
      }
      if (survives) {
        return DenseBox{design, value};
      }
    }
    return std::nullopt;
  }

 private:
  /// Whether the period or the width is searched as well.
  [[nodiscard]] bool has_many_axes() const {
    return ranges_[2].low < ranges_[2].high || ranges_[3].low < ranges_[3].high;
  }

  /// The points of a box along an axis are consecutive ones of the grid.
  class Grid {
   public:
    Grid(const DenseBoxes& of, int steps, bool constant) {
      // Of the end of a range that begins at 0.
      const double least_part = of.has_many_axes() && !constant ? 1e-2 : 1e-3;
      constexpr double exact = 0.02;
      for (std::size_t i = 0; i < 4; ++i) {
        Interval range = of.ranges_.at(i);
        const design::Spread& spread = of.spreads_.at(i);
        if (range.high == 0 || (constant && (i == 1 || i == 3))) {
          continue;
        }
        range.low = range.low > 0 ? range.low : least_part * range.high;
        const double down = -std::log1p(-spread.below);
        const double box = down + std::log1p(spread.above);
        Side& side = sides_.at(i);
        const double length = std::log(range.high / range.low);
        side.window = box > 0 ? (length > 0 ? steps : std::min(steps, 2)) : 0;
        side.step = side.window > 0 ? box / side.window : length > 0 ? exact / steps * 4 : 0;
        side.first = std::log(range.low) - (side.window > 0 ? down : 0);
        side.lead = side.window > 0 ? down : 0;
        side.boxes = 1 + (side.step > 0 ? static_cast<std::size_t>(length / side.step) : 0);
        side.is_there = true;
      }
    }

    [[nodiscard]] std::size_t size() const {
      std::size_t count = 1;
      for (const Side& side : sides_) {
        count *= side.points();
      }
      return count;
    }

    [[nodiscard]] std::vector<DamperValues> points() const {
      std::vector<DamperValues> list(size());
      for (std::size_t k = 0; k < list.size(); ++k) {
        std::size_t left = k;
        for (std::size_t i = 4; i-- > 0;) {
          const Side& side = sides_.at(i);
          list[k].at(i) = side.value(left % side.points(), 0);
          left /= side.points();
        }
      }
      return list;
    }

    /// The worst of each window along an axis; those after it have been points so far.
    [[nodiscard]] std::vector<Figures> slid(const std::vector<Figures>& of,
                                            std::size_t axis) const {
      std::size_t inner = 1;
      for (std::size_t i = axis + 1; i < 4; ++i) {
        inner *= sides_.at(i).points();
      }
      const Side& side = sides_.at(axis);
      const std::size_t points = side.points();
      const std::size_t outer = of.size() / points / inner;
      std::vector<Figures> list(outer * side.boxes * inner, Figures{});
      for (std::size_t o = 0; o < outer; ++o) {
        for (std::size_t b = 0; b < side.boxes; ++b) {
          for (std::size_t k = b; k <= b + static_cast<std::size_t>(side.window); ++k) {
            for (std::size_t i = 0; i < inner; ++i) {
              Figures& worst = list[(o * side.boxes + b) * inner + i];
              const Figures& now = of[(o * points + k) * inner + i];
              for (std::size_t n = 0; n < worst.size(); ++n) {
                worst.at(n) = std::max(worst.at(n), now.at(n));
              }
            }
          }
        }
      }
      return list;
    }

    [[nodiscard]] DamperValues design(std::size_t box) const {
      DamperValues values{};
      for (std::size_t i = 4; i-- > 0;) {
        const Side& side = sides_.at(i);
        values.at(i) = side.value(box % side.boxes, side.lead);
        box /= side.boxes;
      }
      return values;
    }

    [[nodiscard]] bool at_edge(std::size_t box) const {
      bool edge = false;
      for (std::size_t i = 4; i-- > 0;) {
        const std::size_t boxes = sides_.at(i).boxes;
        const std::size_t place = box % boxes;
        edge = edge || (boxes > 1 && (place == 0 || place + 1 == boxes));
        box /= boxes;
      }
      return edge;
    }

   private:
    struct Side {
      double first{0};
      double step{0};
      int window{0};
      double lead{0};
      std::size_t boxes{1};
      bool is_there{false};

      [[nodiscard]] std::size_t points() const { return boxes + static_cast<std::size_t>(window); }
      [[nodiscard]] double value(std::size_t place, double from) const {
        return is_there ? std::exp(first + from + step * static_cast<double>(place)) : 0;
      }
    };
    std::array<Side, 4> sides_;
  };

  design::RecordDesignRequest task_;
  std::vector<Record> loads_;
  std::array<design::Spread, 4> spreads_;
  std::array<Interval, 4> ranges_;
};

}  // namespace stillpoint::test
