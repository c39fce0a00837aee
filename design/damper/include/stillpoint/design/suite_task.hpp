// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/interval.hpp>
#include <stillpoint/core/names.hpp>
#include <stillpoint/records/record_suite.hpp>

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

/// What to minimise: the transmitted acceleration, the largest displacement, the residual one.
enum class SuiteObjective { acceleration, amplitude, residual };

/// "acceleration", "amplitude" or "residual".
[[nodiscard]] std::span<const Named<SuiteObjective>> enumerators(SuiteObjective) noexcept;
using stillpoint::name;

/// How the figures of all records are combined.
enum class Combine { max, mean };

[[nodiscard]] std::span<const Named<Combine>> enumerators(Combine) noexcept;

using records::SuiteRecord;

/// The record times its scale.
[[nodiscard]] Record scaled(const SuiteRecord& record);
[[nodiscard]] double peak_load(const SuiteRecord& record);  ///< the largest |W|
[[nodiscard]] double peak_load(const std::vector<SuiteRecord>& records);

/// "Largest of 2 records", "Under the record".
[[nodiscard]] std::string suite_words(Combine combine, std::size_t count);

/// On the combined figures; empty: no limit.
struct SuiteLimits {
  std::optional<double> peak{};          ///< > 0
  std::optional<double> acceleration{};  ///< transmitted, in g; > 0
  std::optional<double> residual{};      ///< >= 0
};

/// The units in which a damper is printed: those of delta, and of the period if that is what is
/// printed instead of p.
struct PrintedUnits {
  double length{1};
  std::optional<double> time{};
};

struct RecordDesignRequest {
  std::vector<SuiteRecord> records;
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
  SuiteObjective objective{SuiteObjective::acceleration};
  std::optional<Combine> combine{};  ///< default: max for fewer than seven records, else mean
  SuiteLimits limits{};
  std::optional<double> hold{};         ///< as that of Oscillator
  std::optional<double> notch_width{};  ///< not beside a hold
  double tolerance{0.1};                ///< of f and delta, for the sensitivity; in [0, 1)
  std::int64_t scan_points{10'000};     ///< about this many; in [1, 1e8]
  Threads threads{};
  /// If given, the variables of the design are rounded to the fewest digits in these units, at
  /// least five, with which it is admissible and worse by at most a relative 1e-5.
  std::optional<PrintedUnits> printed{};
};

struct SuiteDamper {
  double p{1};
  double f{0};
  double delta{0};
};

/// The figures of all records, combined.
struct SuiteFigures {
  double peak{0};          ///< largest |x|
  double acceleration{0};  ///< largest transmitted one, in g
  double residual{0};      ///< |x| at the final rest
  double margin{1};        ///< the smallest decision margin of all motions
  /// False: a motion never rests, or not within 10 000 half-cycles. Then the figures have no
  /// meaning.
  bool settled{true};
};

/// Of one motion that comes to rest.
[[nodiscard]] SuiteFigures suite_figures(const ForcedResponse& response);

/// A figure that an objective minimises, and its limit.
struct SuiteFigureKind {
  SuiteObjective objective;
  double SuiteFigures::*value;
  std::optional<double> SuiteLimits::*limit;
  std::string_view limit_field;  ///< in reports
  std::string_view words;
};

inline constexpr auto suite_figure_kinds = std::to_array<SuiteFigureKind>(
    {{SuiteObjective::amplitude, &SuiteFigures::peak, &SuiteLimits::peak, "max_displacement",
      "stroke"},
     {SuiteObjective::acceleration, &SuiteFigures::acceleration, &SuiteLimits::acceleration,
      "acceleration_max", "transmitted acceleration"},
     {SuiteObjective::residual, &SuiteFigures::residual, &SuiteLimits::residual, "residual",
      "residual"}});

[[nodiscard]] constexpr const SuiteFigureKind& kind_of(SuiteObjective which) {
  return *std::ranges::find(suite_figure_kinds, which, &SuiteFigureKind::objective);
}
/// The figure that the objective minimises, and its name.
[[nodiscard]] constexpr double value_of(const SuiteFigures& figures, SuiteObjective which) {
  return figures.*kind_of(which).value;
}
[[nodiscard]] constexpr std::string_view quantity(SuiteObjective which) {
  return kind_of(which).words;
}

/// A damper is rejected if a decision of a motion is closer than this to the other outcome: neither
/// the check nor a real damper could tell which of the two it is.
inline constexpr double least_suite_margin = 1e-6;

/// The sum of what the figures exceed, relative to each limit (if no residual is allowed, to the
/// peak), and what the margin lacks; 1e9 if it never rests.
[[nodiscard]] double excess(const SuiteFigures& figures, const SuiteLimits& limits);
/// Whether it is 0: the damper rests, with that margin, and meets the limits.
[[nodiscard]] bool admissible(const SuiteFigures& figures, const SuiteLimits& limits);

/// All motions start from rest at x = 0.
struct SuitePoint {
  SuiteDamper damper;
  SuiteFigures figures;
};

/// The progress of a search.
struct RecordProgress {
  std::int64_t evaluations{0};
  std::int64_t expected{0};  ///< about this many at the end
  std::optional<SuitePoint>
      best{};  ///< so far; if none is admissible, the one that violates the limits least
};
/// Called now and then by several threads, but one at a time; returning false ends the search.
using RecordWatch = std::function<bool(const RecordProgress&)>;

}  // namespace stillpoint::design
