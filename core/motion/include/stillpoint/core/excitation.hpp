// SPDX-License-Identifier: MIT
#pragma once

// The base acceleration W(tau) in units of g, tau >= 0. Outside the stated intervals W = 0.

#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace stillpoint {

/// W = k sin(lambda tau + phase) for 0 <= tau < duration.
template <class Real>
struct BasicHarmonic {
  static constexpr std::string_view name = "harmonic";
  Real k{0};
  Real lambda{1};  ///< > 0
  Real phase{0};
  std::optional<Real> duration{};  ///< >= 0; empty: it never ends
};
using Harmonic = BasicHarmonic<double>;

// A pulse lasts `turns` times 2 pi / lambda. It is a sine with that `phase` or, with a `line`,
// straight from one part of k to another. What computes with it follows from these; a load with
// another law also needs its load_at here and its part of src/kernel.

/// The load at the beginning and at the end, as parts of k.
struct PulseLine {
  double begin;
  double end;
};

template <class Real>
struct BasicHalfSine {
  static constexpr std::string_view name = "half-sine";
  static constexpr double turns = 0.5;
  static constexpr double phase = 0;
  Real k{0};
  Real lambda{1};
};
using HalfSine = BasicHalfSine<double>;

template <class Real>
struct BasicFullSine {
  static constexpr std::string_view name = "full-sine";
  static constexpr double turns = 1;
  static constexpr double phase = 0;
  Real k{0};
  Real lambda{1};
};
using FullSine = BasicFullSine<double>;

template <class Real>
struct BasicRectangle {
  static constexpr std::string_view name = "rectangle";
  static constexpr double turns = 0.5;
  static constexpr PulseLine line{1, 1};
  Real k{0};
  Real lambda{1};
};
using Rectangle = BasicRectangle<double>;

/// W is linear between samples. It is 0 before the first and after the last sample, where it may
/// jump; a single sample has no duration.
template <class Real>
struct BasicRecord {
  static constexpr std::string_view name = "record";
  std::vector<Real> values;
  Real step{0};             ///< sample i is at i * step; > 0 unless times are given
  std::vector<Real> times;  ///< empty, or the time of each sample: >= 0 and growing
};
using Record = BasicRecord<double>;

/// W = 0.
struct NoExcitation {
  static constexpr std::string_view name = "none";
};

/// A new kind of excitation is one of these.
template <class Real>
using BasicExcitation = std::variant<NoExcitation, BasicHarmonic<Real>, BasicHalfSine<Real>,
                                     BasicFullSine<Real>, BasicRectangle<Real>, BasicRecord<Real>>;
using Excitation = BasicExcitation<double>;

template <class Kind>
concept IsPulse = requires {
  Kind::turns;
};
template <class Kind>
concept IsSine = requires(const Kind& kind) {
  kind.phase;
};
template <class Kind>
concept IsLine = requires {
  Kind::line;
};

/// W(tau) for 0 <= tau < duration, for figures and for integrators to compare with: the kernels,
/// which do not use it, are more exact.
[[nodiscard]] double load_at(const IsSine auto& sine, double tau) {
  return sine.k * std::sin(sine.lambda * tau + sine.phase);
}
template <IsLine Line>
[[nodiscard]] double load_at(const Line& pulse, double tau) {
  const double part = pulse.lambda * tau / (2 * Line::turns * std::numbers::pi);
  return pulse.k * (Line::line.begin + (Line::line.end - Line::line.begin) * part);
}

/// That of its kind.
[[nodiscard]] inline std::string_view name(const Excitation& excitation) {
  return std::visit([](const auto& kind) { return kind.name; }, excitation);
}

/// p tau, lambda tau and the phase are at most this in a run under an excitation: beyond it sines
/// lose their digits.
inline constexpr double largest_phase = 1e15;

/// The excitation is 0 from here on; empty if it never ends.
[[nodiscard]] std::optional<double> duration(const Excitation& excitation);

/// Throws InputError, naming the field ("lambda", "record value 17", ...), unless
///   |k| <= 1e150, lambda and duration within [1e-150, 1e150] (a duration of 0 is right as well),
///   |phase| <= 1e15, and in a record at least one sample, values as k, step as lambda, times
///   within [0, 1e150], growing.
void require_valid(const Excitation& excitation);

/// The free motion that replaces a short pulse: it leaves x = 0 at `tau` with `speed`.
struct EquivalentStart {
  double speed{0};  ///< > 0
  double tau{0};    ///< since the start of the pulse; without friction the pulse's centroid
};

/// The start of the free motion under friction f that is in the same state at the end of the pulse
/// as the mass, to second order in p / lambda: docs/forced.md section 8. Friction already acts
/// during the pulse. Empty if the mass never moves, |k| <= f. Throws InputError as require_valid
/// does, and unless f >= 0.
[[nodiscard]] std::optional<EquivalentStart> equivalent_start(const HalfSine& pulse, double f);
[[nodiscard]] std::optional<EquivalentStart> equivalent_start(const Rectangle& pulse, double f);

}  // namespace stillpoint
