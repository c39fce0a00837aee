// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/interval.hpp>
#include <stillpoint/core/names.hpp>
#include <stillpoint/design/figures.hpp>
#include <stillpoint/design/problem.hpp>

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace stillpoint::design {

using Pulse = std::variant<HalfSine, FullSine, Rectangle, Sawtooth, Trapezoid, Haversine>;

/// With these, every requirement holds for each k from k_low to that of the pulse and for each
/// lambda from that of the pulse to lambda_high.
struct PulseRanges {
  std::optional<double> k_low{};
  std::optional<double> lambda_high{};
};

/// A problem in which a pulse moves the mass from rest, instead of an initial velocity.
struct PulseProblem {
  Pulse pulse;
  double p{1};
  double beta{1};
  Criterion criterion{Criterion::published};
  PulseRanges ranges{};
  std::optional<double> p_high{};  ///< as that of Problem
  double zeta{0};                  ///< of the spring's critical damping

  [[nodiscard]] bool has_ranges() const {
    return ranges.k_low.has_value() || ranges.lambda_high.has_value() || p_high.has_value();
  }
};

[[nodiscard]] PulseProblem pulse_problem(const Problem& problem, const Pulse& pulse,
                                         const PulseRanges& ranges);
/// Whether a hit, or the pulse in its place, or the period has a range.
[[nodiscard]] inline bool has_ranges(const Problem& problem, const std::optional<Pulse>& pulse,
                                     const PulseRanges& ranges) {
  return pulse ? pulse_problem(problem, *pulse, ranges).has_ranges()
               : problem.v0_low || problem.p_high;
}

/// lambda / p is at most the first, as far as a forced run reaches, and p / lambda the second: a
/// half-sine of 50 natural periods, during which a weakly damped mass swings as often.
inline constexpr double fastest_pulse = 1e12;
inline constexpr double slowest_pulse = 100;
/// No answer looks for a longer pulse than this p / lambda, unless it was given: when the mass
/// swings many times before it returns, a region is too expensive to compute a hundred of them.
inline constexpr double slowest_examined = 10;

/// Throws InputError, naming the field, unless k > 0, lambda / p is from 0.01 to 1e12, and the
/// problem of the velocity k / lambda is valid (problem.hpp); at both ends of each range, the low
/// one not above the high one.
void require_valid(const PulseProblem& problem, const Limits& limits = {});

[[nodiscard]] double peak_load(const Pulse& pulse);          ///< k
[[nodiscard]] double angular_frequency(const Pulse& pulse);  ///< lambda
/// The same kind of pulse.
[[nodiscard]] Pulse with(const Pulse& pulse, double k, double lambda);
[[nodiscard]] std::string_view name(const Pulse& pulse);  ///< "half-sine" and so on
[[nodiscard]] Excitation excitation(const Pulse& pulse);
/// As in core; empty if the mass never moves, and for a full sine, which leaves no velocity.
[[nodiscard]] std::optional<EquivalentStart> equivalent_start(const Pulse& pulse, double f);

/// Delta >= this stops the mass at its first return under friction f: half the square of the
/// arrival speed, by the published criterion f^2/(2 p^2) more; with ranges the largest. Empty if
/// the mass does not return.
[[nodiscard]] std::optional<double> least_delta(const PulseProblem& problem, double f);
/// The same as a function of f, for many f.
[[nodiscard]] std::function<std::optional<double>(double)> least_delta(const PulseProblem& problem);

/// The Delta with which a damper of that f keeps all limits over the box of their tolerance, up to
/// infinity without a largest Delta; empty if there is none. As a function of f, for many f.
[[nodiscard]] std::function<std::optional<Interval>(double)> feasible_delta(
    const PulseProblem& problem, const Limits& limits);

/// Why a pulse does not act like an initial velocity.
enum class PulseWarning {
  pulse_not_short,     ///< p / lambda > 0.2
  friction_not_small,  ///< f / k > 0.2
};

/// The largest values for any pulse with any spring in the ranges: docs/theory.md section 15.
struct PulseWorst {
  double peak{0};
  double acceleration{0};  ///< transmitted
  double stop_time{0};
};

/// The motion under a pulse; with ranges the one with the largest peak.
struct PulseMotion {
  Pulse pulse;
  double p{0};
  ForcedResponse response;
  std::optional<PulseWorst> worst{};  ///< of the ranges, for an admissible damper
};

/// The design under its pulse, followed from rest by the exact forced motion, and how far the
/// reduction to an initial velocity would be off.
struct PulseCheck : PulseMotion {
  double shortness{0};       ///< p / lambda, the paper's eps for p = 1
  double friction_ratio{0};  ///< f / k
  std::optional<EquivalentStart>
      start;                         ///< of the reduction; these three are empty for a full sine
  std::optional<double> peak_error;  ///< of the reduced motion's peak, relative to the true one
  std::optional<double> stop_time_error;  ///< of start.tau + its stop time, likewise; empty also
                                          ///< where it does not stop at x = 0
  std::vector<PulseWarning> warnings;     ///< why it would be off
  double even_tolerance{0};  ///< the largest of f and Delta at once, whatever the shape of the box
};

}  // namespace stillpoint::design
