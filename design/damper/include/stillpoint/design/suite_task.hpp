// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/interval.hpp>
#include <stillpoint/core/names.hpp>
#include <stillpoint/core/simulation.hpp>
#include <stillpoint/design/box_shape.hpp>
#include <stillpoint/design/figures.hpp>
#include <stillpoint/design/part.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/records/record_suite.hpp>
#include <stillpoint/records/units.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::design {

/// What to minimise over the box of the tolerance: the transmitted acceleration, the largest
/// displacement, the residual one. Or the box to be the largest within the limits.
enum class SuiteObjective { acceleration, amplitude, residual, robust, time };

using stillpoint::name;

/// How the figures of all records are combined.
enum class Combine { max, mean };

using records::SuiteRecord;

/// The record times its scale.
[[nodiscard]] Record scaled(const SuiteRecord& record);
[[nodiscard]] double peak_load(const SuiteRecord& record);  ///< the largest |W|
[[nodiscard]] double peak_load(const std::vector<SuiteRecord>& records);

/// On the combined figures of a case; empty: no limit.
struct SuiteLimits {
  std::optional<double> peak{};          ///< > 0
  std::optional<double> acceleration{};  ///< transmitted, in g; > 0
  std::optional<double> residual{};      ///< >= 0
  std::optional<double> jump{};          ///< of the velocity at a notch without width; >= 0
  std::optional<double> passages{};      ///< of x = 0, after which the motion goes on
  std::optional<double> stop_time{};     ///< of hits and pulses; > 0
  std::optional<double> late{};          ///< periods from the end of a load to the rest under it
};

/// What moves the mass in one case of a task, records, a pulse or a hit, and what is required
/// under it.
inline constexpr double least_weakest = 1e-3;

struct LoadCase {
  std::string name{};  ///< may be empty of a single one
  std::vector<SuiteRecord> records{};
  std::optional<Pulse> pulse{};
  std::optional<double> v0{};  ///< of a hit, > 0
  /// Of a hit or pulse that varies: the least part of this v0 or k, at least `least_weakest`; 0 for
  /// every one down to nothing, of which the weak ones need not move the mass.
  double weakest{1};
  std::optional<Combine> combine{};  ///< default: max for fewer than seven records, else mean
  SuiteLimits limits{};

  [[nodiscard]] bool of_records() const { return !pulse && !v0; }
};

/// One of the motions of a case.
struct CaseMotion {
  std::string name;  ///< of the record or the pulse, or "hit"
  double scale{1};   ///< of the record
  Start start{};
  std::optional<Pulse> pulse{};
  Excitation load{};
};

/// "Largest of 2 records", "Under the record"; of a case with its combination.
[[nodiscard]] std::string suite_words(const LoadCase& load_case);

/// Each record, or the hit or the pulse.
[[nodiscard]] std::vector<CaseMotion> motions_of(const LoadCase& load_case);

[[nodiscard]] double peak_load(const Excitation& load);  ///< the largest |W|
/// The largest |W|, or of hits p v0, what the spring exerts without a damper.
[[nodiscard]] double peak_load(const LoadCase& load_case, double p);

/// How far a built damper may be off: each of its values lies between 1 - below and 1 + above times
/// that of the design, in any combination.
struct SuiteTolerance {
  Spread f{0.1, 0.1};
  Spread delta{0.1, 0.1};
  Spread width{0.1, 0.1};
  Spread period{};

  /// Whether the damper is built as it is designed; a width alone does not count.
  [[nodiscard]] bool exact() const {
    return f.above + f.below + delta.above + delta.below + period.above + period.below +
               width.above + width.below ==
           0;
  }
};

/// The units in which a damper is printed: those of delta, and of the period if that is what is
/// printed instead of p.
struct PrintedUnits {
  double length{1};
  std::optional<double> time{};
};

struct RecordDesignRequest {
  std::vector<LoadCase> cases;
  // Intervals of what is searched: low >= 0; low = high fixes the variable.
  Interval p{1, 1};  ///< low > 0
  /// Default: up to the largest load, beyond which nothing moves.
  std::optional<Interval> f{};
  /// Default: up to (p peak)^2/2 + peak times the largest load, with the largest p and the limit of
  /// the peak, or without a limit the peak without a damper: the most that the spring and the load
  /// can give on the way back from there. A notch that takes more stops every return as well.
  std::optional<Interval> delta{};
  std::optional<double> f_max{};      ///< what can be manufactured: the search goes no farther
  std::optional<double> delta_max{};  ///< the same
  /// The most with which every damper of a box lets hits and pulses move the mass; found.
  std::optional<double> f_start{};
  std::optional<double> delta_start{};
  SuiteObjective objective{SuiteObjective::acceleration};
  std::optional<std::size_t> objective_case{};  ///< empty: the largest of all cases is minimised
  std::optional<double> hold{};                 ///< as that of Oscillator
  /// Of the notch; low = high fixes it. Not beside a hold. Empty: a notch without a width.
  std::optional<Interval> width{};
  /// Every damper of this box must meet the limits. With the objective `robust`, the shape of the
  /// box that is enlarged; a smaller one is an answer unless `requires_tolerance`.
  SuiteTolerance tolerance{};
  bool requires_tolerance{false};
  std::int64_t scan_points{10'000};  ///< of a scan at most, about, with two variables; in [1, 1e8]
  Threads threads{};
  /// If given, the variables of the design are rounded to the fewest digits in these units, at
  /// least five, with which it is admissible and worse by at most a relative 1e-5.
  std::optional<PrintedUnits> printed{};
  Spread spring{};             ///< factors between which 1/p varies, besides its tolerance
  Interval zeta{};             ///< anywhere in which the damping may be, with every damper
  double breakaway{1};         ///< as that of Oscillator
  bool judges{false};          ///< f and delta are those of a damper that is judged as it is
  bool maps{false};            ///< nothing is searched: which f and delta are feasible
  std::vector<Part> parts{};   ///< of a catalogue: f and delta are those of one of them
  std::int64_t trade_offs{0};  ///< dampers along the front of stroke and acceleration
};

/// Throws InputError.
void require_valid(const RecordDesignRequest& request);

struct SuiteDamper {
  double p{1};
  double f{0};
  double delta{0};
  double width{0};  ///< of the notch; 0: that of the paper, or one that lets go
  double load{1};   ///< what comes with it: from the least part of any load of the task to 1
  /// The same: from 0 with the least damping of the task to 1 with the most.
  double damping{0};

  [[nodiscard]] std::optional<double> notch_width() const {
    return width > 0 ? std::optional(width) : std::nullopt;
  }
};

/// The figures of the motions of a case, combined.
struct SuiteFigures {
  double peak{0};          ///< largest |x|
  double acceleration{0};  ///< largest transmitted one, in g
  double residual{0};      ///< |x| at the final rest
  double margin{1};        ///< the smallest decision margin of all motions
  double jump{0};          ///< largest of the velocity at a notch without width
  double late{0};          ///< periods from the end of a load to its rest; always the most
  double passages{0};      ///< of x = 0, after which the motion goes on
  double stop_time{0};     ///< the latest of hits and pulses
  /// False: a motion never rests, or not within 10 000 half-cycles. Then the figures have no
  /// meaning.
  bool settled{true};
};

/// Those of each case; none: not known.
using TaskFigures = std::vector<SuiteFigures>;
using EachFigures = std::span<const SuiteFigures>;  ///< the same where they lie

/// Whether they are known and all motions come to rest.
[[nodiscard]] bool settled(EachFigures figures);
/// The worst of each figure in all cases.
[[nodiscard]] SuiteFigures largest(EachFigures figures);

/// The least part of its strongest load that must come back with a damper: of every hit down to
/// nothing the weakest that its notch lets go.
[[nodiscard]] double weakest_part(const LoadCase& load_case, const SuiteDamper& damper);
/// The part of its strongest load that a case has with a damper.
[[nodiscard]] double load_part(const RecordDesignRequest& request, std::size_t in_case,
                               const SuiteDamper& damper);
/// The least of all cases.
[[nodiscard]] double weakest_load(const RecordDesignRequest& request);
/// A motion with that part of its load.
[[nodiscard]] CaseMotion weakened(CaseMotion motion, double part);

[[nodiscard]] Oscillator oscillator_of(const RecordDesignRequest& request,
                                       const SuiteDamper& damper);
/// The motion of a damper.
[[nodiscard]] SimulationRequest motion_of(const RecordDesignRequest& request,
                                          const SuiteDamper& damper, const CaseMotion& motion);

/// Of one motion that comes to rest.
[[nodiscard]] SuiteFigures suite_figures(const ForcedResponse& response);

/// A figure with its limit, and the objective that minimises it, if there is one.
struct SuiteFigureKind {
  std::optional<SuiteObjective> objective;
  double SuiteFigures::*value;
  std::optional<double> SuiteLimits::*limit;
  std::string_view field;       ///< of the limit in reports, as that of a Mend
  std::string_view constraint;  ///< its name there, and that of what it bounds
  std::string_view variable;
  std::string_view words;
  records::Dimension dimension;
};

inline constexpr auto suite_figure_kinds = std::to_array<SuiteFigureKind>(
    {{SuiteObjective::amplitude, &SuiteFigures::peak, &SuiteLimits::peak, "beta", "amplitude",
      "peak", "stroke", records::Dimension::length},
     {SuiteObjective::acceleration, &SuiteFigures::acceleration, &SuiteLimits::acceleration,
      "acceleration_max", "acceleration", "acceleration", "transmitted acceleration",
      records::Dimension::gravities},
     {SuiteObjective::residual, &SuiteFigures::residual, &SuiteLimits::residual, "residual",
      "residual", "residual", "residual", records::Dimension::length},
     {std::nullopt, &SuiteFigures::jump, &SuiteLimits::jump, "jump_max", "jump", "jump",
      "jump of velocity", records::Dimension::velocity},
     {std::nullopt, &SuiteFigures::passages, &SuiteLimits::passages, "arrivals", "stop", "passages",
      "number of passages", records::Dimension::none},
     {SuiteObjective::time, &SuiteFigures::stop_time, &SuiteLimits::stop_time, "stop_time",
      "stop_time", "stop_time", "time to rest", records::Dimension::time}});

/// Where each figure of a case is the largest, as suite_figure_kinds.
using WorstDampers = std::array<SuiteDamper, suite_figure_kinds.size()>;

/// The figure that is minimised; with `robust`, the first that has a limit in some case.
[[nodiscard]] const SuiteFigureKind& minimised(const RecordDesignRequest& request);

/// A damper is rejected if a decision of a motion is closer than this to the other outcome: neither
/// the check nor a real damper could tell which of the two it is.
inline constexpr double least_suite_margin = 1e-6;

/// The sum of what the figures exceed, relative to each limit (if no residual is allowed, to the
/// peak); 1e9 if it never rests.
[[nodiscard]] double excess(const SuiteFigures& figures, const SuiteLimits& limits);
/// The larger of each.
[[nodiscard]] SuiteFigures worse(const SuiteFigures& one, const SuiteFigures& other);
[[nodiscard]] TaskFigures worse(TaskFigures one, const TaskFigures& other);
/// The same in place; those of as many cases.
void worsen(TaskFigures& worst, EachFigures other);
void worsen(std::span<SuiteFigures> worst, EachFigures other);

/// The figures are those of the damper or the worst over its box.
struct SuitePoint {
  SuiteDamper damper;
  TaskFigures figures;
};

/// What is not required: the worst over samples of the box where all periods, or all loads, are
/// off by this part to either side.
struct SuiteOutlook {
  static constexpr double off{0.05};
  TaskFigures period;
  TaskFigures scale;
};

/// The progress of a search.
struct RecordProgress {
  std::int64_t evaluations{0};
  std::int64_t expected{0};          ///< about this many at the end
  std::optional<SuitePoint> best{};  ///< whose box was verified, so far
};
/// Called now and then by several threads, but one at a time; returning false ends the search.
using RecordWatch = std::function<bool(const RecordProgress&)>;

}  // namespace stillpoint::design
