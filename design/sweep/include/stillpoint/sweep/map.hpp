// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/spec.hpp>

#include <stillpoint/core/state.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

namespace stillpoint::sweep {

struct SweepBlock;
class SweepStep;

/// How a motion ends and after how many half-cycles, in classes that a map can show.
class SweepClass {
 public:
  /// The first of each range of half-cycles.
  static constexpr std::array<int, 6> first_half_cycles{1, 2, 3, 4, 7, 16};
  static constexpr std::size_t ranges = first_half_cycles.size();
  /// Stops at x = 0 or within a notch, by ranges of half-cycles; stops beyond it, likewise; then:
  /// does not move, never stops, is not known to have stopped, is locked under the load, has more
  /// half-cycles than the sweep allows.
  static constexpr std::size_t count = 2 * ranges + 5;

  static constexpr std::uint8_t locked = count - 2;

  static constexpr std::uint8_t too_many = count - 1;

  [[nodiscard]] static std::uint8_t of(Outcome outcome, double half_cycles);
};

/// How many motions each class has, and whether any rest at x = 0, and off it.
struct ClassCounts {
  std::array<std::int64_t, SweepClass::count> of{};

  [[nodiscard]] bool centred() const { return any(0); }
  [[nodiscard]] bool off_centre() const { return any(SweepClass::ranges); }

 private:
  [[nodiscard]] bool any(std::size_t from) const {
    return std::any_of(&of[from], &of[from + SweepClass::ranges],
                       [](std::int64_t count) { return count > 0; });
  }
};

/// One of the two axes of a map: every n-th value of a range.
class MapAxis {
 public:
  /// Throws InputError unless the axis is a range with two different values or more.
  explicit MapAxis(const SweepAxis& swept, const std::optional<SweepUnits>& units = {});

  [[nodiscard]] std::int64_t cells() const { return cells_; }
  [[nodiscard]] Axis::Spacing spacing() const { return *axis_.spacing(); }
  /// The cell of value i; empty if the map leaves it out. Cell 0 has the smallest value.
  [[nodiscard]] std::optional<std::int64_t> cell(std::int64_t i) const;
  /// The value in the middle of a cell.
  [[nodiscard]] double value(std::int64_t cell) const;

 private:
  Axis axis_;
  std::int64_t stride_;
  std::int64_t cells_;
  bool falling_;
};

/// The (f, Delta) plane of a sweep, by the classes of its motions. It is filled by run().
class SweepMap {
 public:
  /// Throws InputError unless the sweep is a grid of motions over ranges of only f and delta.
  explicit SweepMap(const SweepSpec& spec);

  [[nodiscard]] const MapAxis& f() const { return f_; }
  [[nodiscard]] const MapAxis& delta() const { return delta_; }
  /// delta().cells() rows of f().cells() classes.
  [[nodiscard]] const std::vector<std::uint8_t>& cells() const { return cells_; }
  /// The peak of each of these motions; empty without a load.
  [[nodiscard]] const std::vector<double>& peaks() const { return peaks_; }
  [[nodiscard]] ClassCounts counts() const;
  /// The peaks of a class.
  [[nodiscard]] std::vector<double> peaks_of(std::size_t index) const;

  /// Fills the cells of the entries in the block.
  void add(const SweepBlock& block);
  /// Computes the cells that no block filled: the rows that an interrupted sweep had written.
  /// Returns false after a stop.
  [[nodiscard]] bool complete(const SweepSpec& spec, SweepStep& step, const std::stop_token& stop);

 private:
  static constexpr std::uint8_t unknown = 255;

  [[nodiscard]] std::size_t index(std::int64_t f_cell, std::int64_t delta_cell) const {
    return static_cast<std::size_t>(delta_cell * f_.cells() + f_cell);
  }
  /// From entry i of the block.
  void fill(std::size_t cell, const SweepBlock& block, std::int64_t i);

  MapAxis f_;
  MapAxis delta_;
  std::int64_t delta_size_;
  std::vector<std::uint8_t> cells_;
  std::vector<double> peaks_;
};

}  // namespace stillpoint::sweep
