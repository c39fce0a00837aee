// SPDX-License-Identifier: MIT
#pragma once

#include "settings.hpp"
#include "sweep_source.hpp"

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/search.hpp>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::cli {

enum class SweepKind {
  free,    ///< each entry is a free motion
  forced,  ///< each entry is a motion under the same excitation
  design,  ///< each entry is a design problem
};

[[nodiscard]] std::string_view name(SweepKind kind) noexcept;

enum class RowFormat { csv, npy };

[[nodiscard]] std::string_view name(RowFormat format) noexcept;

/// What a sweep is to do.
struct SweepTask {
  SweepKind kind{SweepKind::free};
  std::unique_ptr<SweepSource> source;
  std::vector<SweepAxis> axes;    ///< of a grid; of a list what is no column
  std::vector<Quantity> columns;  ///< of the output
  bool times{false};              ///< stop_time is among them

  bool listed{false};        ///< the entries are those of a list
  bool one_v0_and_p{false};  ///< the same in all entries
  bool from_zero{true};      ///< x0 = 0 in all entries
  std::optional<double> half_cycle_limit;

  Excitation excitation;
  std::optional<double> t_end;

  design::Criterion criterion{design::Criterion::published};
  design::Limits limits;
  design::SearchOptions search;

  int threads{1};
  std::optional<std::string> output;  ///< empty: standard output
  RowFormat format{RowFormat::csv};
  bool resume{false};
  /// Everything that the rows depend on but the list itself, in JSON: another task, other rows.
  std::string identity;
};

/// Throws UsageError for something missing or contradictory and InputError for a wrong value.
[[nodiscard]] SweepTask sweep_task(const Settings& settings);

}  // namespace stillpoint::cli
