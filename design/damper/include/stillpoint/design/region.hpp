// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/practice.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/works_for.hpp>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::design {

/// Why no (f, Delta) is admissible, by the two constraints that exclude each other.
enum class Conflict {
  none,
  amplitude_against_return,        ///< f2 > f3, or their boxes do not fit: condition (10) fails
  amplitude_against_f_max,         ///< f2 > f_max
  amplitude_against_acceleration,  ///< f2 > f4
  acceleration_alone,              ///< S > acceleration_max without any friction
  stop_against_start,              ///< Delta1 > Delta2 over the tolerance box
  stop_against_delta_max,          ///< Delta1 > delta_max
  no_arrival,                      ///< of several arrivals none has a box that fits
  narrower_than_rounding,          ///< the rest of the region lies between neighbouring doubles
};

/// The admissible region max(f2, 0) <= f <= f3, Delta1(f) < Delta <= Delta2, and its part within
/// the limits. f1, f2, f3 and delta2 are the paper's; f2 is negative where amplitude does not bind.
struct Region {
  bool feasible{false};
  Conflict conflict{Conflict::none};
  double f1{0};
  double f2{0};
  double f3{0};
  /// f <= f4 keeps S = sqrt(f^2 + p^2 V0^2) within acceleration_max; negative where p V0 alone is
  /// above that. Empty without the limit.
  std::optional<double> f4;
  double delta2{0};
  double beta_min{0};  ///< V0/(sqrt(2) p), condition (10); the least double that is feasible
  /// The interval of feasible f within every limit, for the middle of the tolerance box. Empty if
  /// not feasible. The lower end itself is excluded where it comes from Delta (Delta1 < Delta is
  /// strict) or is 0.
  std::optional<double> f_lower;
  std::optional<double> f_upper;
};

/// Edges are computed in long double and rounded inwards, so that what is admissible in doubles is
/// admissible. With several arrivals f_lower and f_upper are the least and the largest f of all
/// strips, the other edges those of the first arrival. Throws InputError (problem.hpp).
[[nodiscard]] Region admissible_region(const Problem& problem, const Limits& limits = {});

/// The dampers that stop at one arrival, within the limits: docs/theory.md section 12.
struct Strip {
  std::int64_t arrival{1};
  double beta_min{0};             ///< below it there is none, (49)
  std::optional<double> f_lower;  ///< as in Region; empty if no box of the tolerance asked for fits
  std::optional<double> f_upper;
  double tolerance{0};  ///< the largest of any of them, whatever was asked for
};

/// The strips of the arrivals that are allowed, without those that are empty for any tolerance.
/// Throws InputError.
[[nodiscard]] std::vector<Strip> strips(const Problem& problem, const Limits& limits = {});

/// The Delta with which a damper with that f stops the mass at the n-th arrival: the lower edge is
/// excluded, the peak and the limits are not looked at. Good to a few roundings; empty where there
/// is none. Throws InputError.
struct DeltaRange {
  double low;
  double high;
};
[[nodiscard]] std::optional<DeltaRange> delta_range(const Problem& problem, std::int64_t arrival,
                                                    double f);

/// The arrival, of those that are allowed, at which the damper stops the mass at x = 0 by the
/// problem's criterion; empty where it stops at none. The peak and the limits are not looked at.
/// Throws as admissible() does.
[[nodiscard]] std::optional<std::int64_t> arrival_of(const Problem& problem, double f,
                                                     double delta);

/// Why the region is empty, as a sentence with the numbers; empty if it is not.
[[nodiscard]] std::string reason(const Region& region, const Problem& problem,
                                 const Limits& limits = {});

/// Delta1(f) of the paper, (26). Throws InputError unless f in [0, 1e300].
[[nodiscard]] double delta1_published(const Problem& problem, double f);
/// Delta1(f) of the model, (27); empty for f > f3, where the motion does not return.
[[nodiscard]] std::optional<double> delta1_exact(const Problem& problem, double f);
/// By the problem's criterion.
[[nodiscard]] std::optional<double> delta1(const Problem& problem, double f);

/// One of the five conditions, all of them edges of the region in f or Delta.
///
/// | name      | condition        | value | limit  | the motion ...                              |
/// |-----------|------------------|-------|--------|---------------------------------------------|
/// | dead_zone | f < f1           | f     | f1     | has a dead zone narrower than beta          |
/// | start     | Delta <= Delta2  | Delta | Delta2 | starts                                      |
/// | amplitude | f >= f2          | f     | f2     | stays within beta                           |
/// | return    | f <= f3          | f     | f3     | comes back to x = 0                         |
/// | stop      | Delta > Delta1   | Delta | Delta1 | stops there                                 |
///
/// slack is the distance from value to limit, positive inside; the strict ones need slack > 0.
///
/// Of a damper that stops at a later arrival, `return` and `stop` compare V0 with the least one
/// that reaches that arrival and the least that passes it, (47) of docs/theory.md.
struct Constraint {
  std::string_view name;
  std::string_view variable;  ///< f or delta, of which `value` is; v0 of a later arrival
  std::string_view relation;
  double value{0};
  double limit{0};
  double slack{0};
  bool satisfied{false};
};

/// In the order of the table. Throws InputError for a wrong problem and f or delta not in [0,
/// 1e300].
[[nodiscard]] std::array<Constraint, 5> constraints(const Problem& problem, double f, double delta);

/// With one more row for each limit that is given: f_max, delta_max, and acceleration, which is
/// f <= f4.
[[nodiscard]] std::vector<Constraint> constraints(const Problem& problem, const Limits& limits,
                                                  double f, double delta);

/// All five constraints and the limits, over the box of relative half-width `limits.tolerance`
/// around (f, delta): its worst corner is (f (1 - tolerance), delta (1 - tolerance)) for the stop,
/// because Delta1 falls with f.
[[nodiscard]] bool admissible(const Problem& problem, const Limits& limits, double f, double delta);

/// The largest tolerance for which the box around (f, delta) is admissible, for any
/// `limits.tolerance`; empty if the point itself is not.
[[nodiscard]] std::optional<double> largest_tolerance(const Problem& problem, const Limits& limits,
                                                      double f, double delta);

/// A damper and how far it may be off.
struct DesignPoint {
  double f{0};
  double delta{0};
  double tolerance{0};  ///< the largest R that it allows
};

/// Of the dampers that the task admits at tolerance 0 the one with the largest tolerance, where
/// that is less than the one asked for, so that none has it; else empty, also where none has any.
[[nodiscard]] std::optional<DesignPoint> most_tolerant(const Problem& problem,
                                                       const Limits& limits);

/// The least change of one input, with the others unchanged, that makes the region not empty.
struct Mend {
  std::string_view
      field;  ///< v0 (of a pulse k, lambda), p, beta, f_max, delta_max, acceleration_max,
  ///< tolerance or arrivals
  double value{0};
  bool upwards{false};  ///< it must grow, not shrink
};

/// One entry for each input that suffices alone; none if the region is not empty.
[[nodiscard]] std::vector<Mend> mends(const Problem& problem, const Limits& limits);

/// The changes that help where no single input suffices, because no damper has the tolerance.
struct JointMend {
  double largest_tolerance{0};  ///< of any damper, for any beta and limits
  /// The tolerance and another input, both changed by the same factor, which is the least that
  /// makes the region not empty. Neither can be closer to its old value unless the other is farther
  /// from its own.
  std::vector<Mend> mends;
};

/// Empty if the region is not empty, or if one input suffices.
[[nodiscard]] std::optional<JointMend> joint_mend(const Problem& problem, const Limits& limits);

/// A region, and where it is empty: `reason` says why, `most_tolerant` how much tolerance there is,
/// and `mends`, or else `joint_mend`, what would help.
struct RegionVerdict {
  Region region;
  std::string reason{};
  std::vector<Mend> mends{};
  std::optional<JointMend> joint_mend{};
  std::optional<DesignPoint> most_tolerant{};  ///< not of parts of a catalogue
  /// Of admissible f, with a pulse: the region is then that of the forced motion itself.
  std::optional<std::vector<FrictionInterval>> intervals{};
};

/// A region, and a damper to hold against it.
struct RegionRequest {
  Problem problem;
  Limits limits{};
  std::optional<double> f{};
  std::optional<double> delta{};  ///< with f only
  std::optional<Pulse> pulse{};   ///< in place of problem.v0
  PulseRanges pulse_ranges{};
};

/// The region, and how the damper stands in it. Under a pulse, strips, arrival and works_for are
/// empty; Delta1 is the least Delta, by either criterion, that stops the mass at its first return.
struct RegionAnswer : RegionVerdict {
  std::vector<Strip> strips{};
  std::optional<double> delta1_published{};  ///< these two with f; of a pulse as delta1_exact
  std::optional<double> delta1_exact{};      ///< empty also where the motion does not return
  std::optional<bool> admissible{};          ///< this and what follows with f and delta
  std::optional<double> tolerance{};         ///< the largest that the damper has
  std::optional<std::int64_t> arrival{};     ///< of an admissible one, at which it stops
  std::vector<Constraint> constraints{};
  std::optional<WorksFor> works_for{};  ///< these two if the point itself is admissible
  std::optional<Practice> practice{};
};

/// The answer in one line for people: the interval of f, or why the region is empty.
[[nodiscard]] std::string summary(const RegionVerdict& verdict);

/// Throws InputError as admissible_region does, for f or delta not in [0, 1e300], and for delta
/// without f; with a pulse as a design under it does (design.hpp).
[[nodiscard]] RegionAnswer answer(const RegionRequest& request);

}  // namespace stillpoint::design
