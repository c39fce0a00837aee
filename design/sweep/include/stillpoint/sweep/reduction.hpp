// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/quantity.hpp>
#include <stillpoint/sweep/units.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// What is kept from the rows of a sweep that are not written. It consists of counts, and of rows
// chosen by their values and, if these are the same, by their places. So the reductions of parts
// add up to that of the whole, to the last bit, in any order.

namespace stillpoint::sweep {

/// A column counted in bins given by the user.
struct BinsRequest {
  Quantity column{};
  std::vector<double> edges;  ///< rising, at least two
};

struct ReductionRequest {
  std::vector<BinsRequest> histograms;
};

/// "peak_amplitude:0:1:50", "stop_time:1:100:40:log" or "f:0,0.1,0.3": low, high and the number of
/// bins, or the edges. Throws InputError.
[[nodiscard]] BinsRequest parse_bins(std::string_view text, const std::vector<Quantity>& columns,
                                     const std::optional<SweepUnits>& units);
struct RowColumn {
  std::string name;
  Form form{Form::number};
};

struct ReducedRow {
  std::int64_t entry{0};       ///< of the whole sweep, from 0
  std::vector<double> values;  ///< one for each RowColumn; none if there is no row
};

struct Histogram {
  std::size_t column{0};
  std::vector<double> edges;         ///< bin i: edges[i] <= value < edges[i + 1]; the last has both
  std::vector<std::int64_t> counts;  ///< of each bin
  std::int64_t below{0};
  std::int64_t above{0};
};

/// The finite values of one column.
struct ReducedColumn {
  std::size_t column{0};  ///< among the RowColumns
  std::int64_t count{0};
  std::int64_t absent{0};    ///< values that do not exist
  std::int64_t infinite{0};  ///< what never happens
  ReducedRow least{};        ///< if there is a value; of several the first
  ReducedRow largest{};      ///< likewise
};

struct Reduction {
  std::vector<RowColumn> row;          ///< empty if rows are written
  std::vector<ReducedColumn> columns;  ///< the results that are numbers
  std::vector<Histogram> histograms;
};

/// Whether its parts fit one another: what was read from a file may not.
[[nodiscard]] bool is_sound(const Reduction& reduction);

/// Adds the reduction of other entries of the same sweep; throws std::exception if it cannot be.
void add(Reduction& total, const Reduction& more);

struct SweepSpec;
struct SweepBlock;

/// Reduces the blocks of a sweep on several threads.
class Reducer {
 public:
  /// To go on from what was `found`, if anything.
  Reducer(const SweepSpec& spec, const Reduction& found);

  void add(const SweepBlock& block);
  [[nodiscard]] Reduction result() const;

 private:
  std::vector<Quantity> columns_;
  std::vector<Reduction> shares_;  ///< one for each thread
};

}  // namespace stillpoint::sweep
