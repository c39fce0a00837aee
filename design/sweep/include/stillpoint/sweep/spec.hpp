// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/names.hpp>
#include <stillpoint/core/surface.hpp>
#include <stillpoint/design/catalogue.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/search.hpp>
#include <stillpoint/sweep/axis.hpp>
#include <stillpoint/sweep/list.hpp>
#include <stillpoint/sweep/part.hpp>
#include <stillpoint/sweep/reduction.hpp>
#include <stillpoint/sweep/units.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::sweep {

enum class SweepKind {
  free,    ///< each entry is a free motion
  forced,  ///< each entry is a motion under the excitation, or under one of several records
  design,  ///< each entry is a design problem
};

using stillpoint::name;

enum class RowFormat { csv, npy };

struct NamedRecord {
  std::string name;
  Record record;
};

/// What a sweep computes, and where its rows go. Without `units` everything is dimensionless.
struct SweepSpec {
  SweepKind kind{SweepKind::free};
  /// Inputs and results of the rows are physical, see units.hpp, and so is a list. Excitation,
  /// t_end, zones and limits are dimensionless by these units.
  std::optional<SweepUnits> units{};
  /// The values of each of inputs(kind). The entries are all combinations; with a list, an axis has
  /// one value and stands for an input that is not a column. Without hold or notch_width the notch
  /// is the paper's. v0_low, p_high and the like are the other ends of an axis of ranges, or
  /// columns of the list. trade_off, if given, is 1 to N, also with a list: instead of its design
  /// each problem has the N dampers of its front.
  std::vector<SweepAxis> axes;
  std::shared_ptr<List> list;        ///< empty for a grid; it is read once, from its beginning
  std::optional<SweepPart> part;     ///< only these entries; the file can be merged
  std::optional<ListExtent> listed;  ///< of the whole list: needed for a part of one
  std::vector<Quantity> columns;     ///< of the output; see default_columns
  /// If given, the rows are not written but reduced, see Reducer.
  std::optional<ReductionRequest> reduction;
  int threads{1};  ///< no result depends on it

  std::optional<double> half_cycle_limit;  ///< of motions, 1 to 1e15; empty: as in core
  std::vector<FrictionZone> zones;         ///< of motions; see Surface
  Excitation excitation;                   ///< of forced motions, as is
  /// If any, they are the excitations instead; record and record_scale then have an axis each.
  std::vector<NamedRecord> records;
  std::optional<double> t_end;  ///< required if the excitation never ends

  design::Problem task;  ///< of design problems, without the inputs that are given; so are
  std::optional<design::Pulse>
      pulse;  ///< in place of v0: a pulse of its kind, without k and lambda
  design::Limits limits;
  design::SearchOptions search;
  std::vector<design::Part> parts;  ///< if any, a design is the best of these

  std::optional<std::string> output;  ///< a file; empty: standard output
  RowFormat format{RowFormat::csv};
  bool resume{false};  ///< continue what an interrupted sweep left of `output`
  /// Everything that the rows of the whole sweep depend on except the entries of a list, as a JSON
  /// object. A sweep is resumed only if this is the same as when it began, and parts are merged
  /// only if it is the same in all.
  std::string identity{"{}"};
};

/// The number of entries; empty for a list that was not counted. Throws InputError above 1e15.
[[nodiscard]] std::optional<std::int64_t> entries(const SweepSpec& spec);

/// The entries to compute: all, or those of the part. For a list that is not split the count is
/// empty.
struct OwnEntries {
  std::int64_t first{0};
  std::optional<std::int64_t> count{};
};
[[nodiscard]] OwnEntries own_entries(const SweepSpec& spec);

/// Whether the input has an axis or is a column of the list.
[[nodiscard]] bool given(const SweepSpec& spec, Quantity input);

/// How many rows a problem has: the dampers of its front, else 1.
[[nodiscard]] std::int64_t dampers_of_each(const SweepSpec& spec);

/// Whether the input takes more than one value.
[[nodiscard]] bool varies(const SweepSpec& spec, Quantity input);

/// Of an input with one value: that, without its unit.
[[nodiscard]] double only_value(const SweepSpec& spec, Quantity input);

/// Whether every motion starts at x = 0.
[[nodiscard]] bool from_zero(const SweepSpec& spec);

/// Whether only the paper's friction slows every motion, a constant f and all of delta at x = 0.
[[nodiscard]] bool plain_motion(const SweepSpec& spec);

/// Throws InputError for an input that is missing, given twice or wrong. For a grid the corners are
/// checked: what is wrong with a grid usually shows there, before hours are spent on it.
void require_valid(const SweepSpec& spec);

/// Throws InputError for an input with a unit that is beyond what can be built, as it was given:
/// "velocity = -1 m/s: must be from 1e-30 to 1e+30 m/s".
void require_in_units(const SweepSpec& spec, Quantity input, double value);

/// Throws InputError if the other end of a range of `input` is on the wrong side of the end that
/// stands for it.
void require_in_order(const SweepSpec& spec, Quantity input, double value, double other);

/// The inputs of an entry, in the order of the columns. For motions, hold and notch_width may be
/// left out; for designs, the other ends of ranges, residual and arrivals; k and lambda are those
/// of a pulse.
[[nodiscard]] std::span<const Quantity> inputs(SweepKind kind);

/// The results of an entry, in the order of the columns.
[[nodiscard]] std::span<const Quantity> results(SweepKind kind);

/// The inputs that vary, then the results: stop_time, which takes longer, only with `times`; for
/// designs stop_position and arrival only if they can differ from 0 and from what was asked.
[[nodiscard]] std::vector<Quantity> default_columns(const SweepSpec& spec, bool times = false);

/// "f,delta,peak_amplitude". Throws InputError for a name that is not a column of this kind, and
/// for one that occurs twice.
[[nodiscard]] std::vector<Quantity> parse_columns(std::string_view text, SweepKind kind,
                                                  const std::optional<SweepUnits>& units = {});

/// Adds the start that a motion need not be given, x = 0, and v = 0 if something else moves it, and
/// puts the axes in the order of the columns.
void add_default_start(SweepSpec& spec);

}  // namespace stillpoint::sweep
