// SPDX-License-Identifier: MIT
#pragma once

#include "sweep_run.hpp"
#include "sweep_task.hpp"

#include <stillpoint/core/outcome.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace stillpoint::cli {

/// How a motion ended, after how many half-cycles, in classes that a map can show.
class SweepClass {
 public:
  /// The first of each range of half-cycles.
  static constexpr std::array<int, 6> first_half_cycles{1, 2, 3, 4, 7, 16};
  static constexpr std::size_t ranges = first_half_cycles.size();
  /// At x = 0 and off it by ranges, then: does not move, never stops, runs on, has more half-cycles
  /// than the sweep allows.
  static constexpr std::size_t count = 2 * ranges + 4;

  static constexpr std::uint8_t too_many = count - 1;

  [[nodiscard]] static std::uint8_t of(Outcome outcome, double half_cycles);
};

/// One of the two axes of a map: every so manyth value of a range.
class MapAxis {
 public:
  /// Throws UsageError unless the axis is a range with two values or more.
  explicit MapAxis(const SweepAxis& swept);

  [[nodiscard]] std::int64_t cells() const { return cells_; }
  [[nodiscard]] Axis::Spacing spacing() const { return *axis_.spacing(); }
  /// The cell of value i; empty where the map leaves it out. Cell 0 has the least value.
  [[nodiscard]] std::optional<std::int64_t> cell(std::int64_t i) const;
  /// The value in the middle of a cell.
  [[nodiscard]] double value(std::int64_t cell) const;

 private:
  Axis axis_;
  std::int64_t stride_;
  std::int64_t cells_;
  bool falling_;
};

/// The (f, Delta) plane of a sweep by the classes of its motions.
class SweepMap {
 public:
  /// Throws UsageError unless the task is a grid of motions over ranges of f and delta alone.
  explicit SweepMap(const SweepTask& task);

  [[nodiscard]] const MapAxis& f() const { return f_; }
  [[nodiscard]] const MapAxis& delta() const { return delta_; }
  /// delta().cells() rows of f().cells() classes.
  [[nodiscard]] const std::vector<std::uint8_t>& cells() const { return cells_; }

  /// Takes what the block has of it.
  void add(const SweepBlock& block);
  /// Runs what no block had: the rows that an interrupted sweep had written. False after an
  /// interrupt.
  bool complete(const SweepTask& task, SweepRun& run);

 private:
  static constexpr std::uint8_t unknown = 255;

  std::uint8_t& at(std::int64_t f_cell, std::int64_t delta_cell) {
    return cells_[static_cast<std::size_t>(delta_cell * f_.cells() + f_cell)];
  }

  MapAxis f_;
  MapAxis delta_;
  std::int64_t delta_size_;
  std::vector<std::uint8_t> cells_;
};

}  // namespace stillpoint::cli
