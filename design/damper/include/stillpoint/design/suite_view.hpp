// SPDX-License-Identifier: MIT
#pragma once

// What reports show about a design under records: parts of the plane of f and delta, with its
// period and width, and its spectrum.

#include <stillpoint/design/record_design_result.hpp>
#include <stillpoint/design/spectrum.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace stillpoint::design {

/// A cell of the plane.
struct SuiteCell {
  double value{0};       ///< the objective
  double excess{0};      ///< as that of figures: 0 if they meet the limits
  std::size_t fault{0};  ///< of suite_figure_kinds, the one that exceeds its limit most; else their
                         ///< number: it never rests, or too late
};
struct SuiteView {
  Interval f;
  Interval delta;
  std::vector<SuiteCell> cells;  ///< from the lowest delta up, and with each from the lowest f on
  /// The values where every limit is met, the damper's own included, which may be better than any
  /// cell; low > high if it is met nowhere.
  Interval values;
  std::size_t side{60};  ///< cells along each

  [[nodiscard]] bool any_good() const { return values.low <= values.high; }
  /// Those of figures, from the least on, each once.
  [[nodiscard]] std::vector<double> excesses() const;
  /// The number of the one that a damper lies in, or else the nearest.
  [[nodiscard]] std::size_t cell(const SuiteDamper& damper) const;
};

/// Where the objective is good, or about a damper that violates a limit as all others do: the worst
/// over the tolerance about each place. Empty if f or delta was not searched.
[[nodiscard]] std::optional<SuiteView> overview(const RecordDesign& result);
/// The box of the design and as much again about it, each damper by itself; empty without one.
[[nodiscard]] std::optional<SuiteView> close_up(const RecordDesign& result);

/// Of the damper found under the records of a case, from a quarter of its period to twice that.
[[nodiscard]] Spectrum spectrum_about(const RecordDesign& result, std::size_t in_case);

}  // namespace stillpoint::design
