// SPDX-License-Identifier: MIT
#pragma once

// The base acceleration W(tau) in units of g, tau >= 0. Outside the stated intervals W = 0.

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <type_traits>
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

// A pulse lasts `turns` times 2 pi / lambda. It is a sine with that `phase`, or the square of one
// if `squared`, or straight between `corners`. What computes with it follows from these; a load
// with another law also needs its load_at here and its part of src/kernel.

/// The first is at 0, the last at 1; the load jumps from 0 and to 0 there.
struct PulseCorner {
  double time;  ///< as a part of the duration
  double load;  ///< as a part of k
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
  static constexpr std::array<PulseCorner, 2> corners{{{0, 1}, {1, 1}}};
  Real k{0};
  Real lambda{1};
};
using Rectangle = BasicRectangle<double>;

/// It rises to k and then drops to 0: with a terminal peak.
template <class Real>
struct BasicSawtooth {
  static constexpr std::string_view name = "sawtooth";
  static constexpr double turns = 0.5;
  static constexpr std::array<PulseCorner, 2> corners{{{0, 0}, {1, 1}}};
  Real k{0};
  Real lambda{1};
};
using Sawtooth = BasicSawtooth<double>;

/// It rises in a tenth of its duration and falls in a tenth: IEC 60068-2-27.
template <class Real>
struct BasicTrapezoid {
  static constexpr std::string_view name = "trapezoid";
  static constexpr double turns = 0.5;
  static constexpr std::array<PulseCorner, 4> corners{{{0, 0}, {0.1, 1}, {0.9, 1}, {1, 0}}};
  Real k{0};
  Real lambda{1};
};
using Trapezoid = BasicTrapezoid<double>;

/// k sin^2(lambda tau) = k (1 - cos(2 lambda tau))/2.
template <class Real>
struct BasicHaversine {
  static constexpr std::string_view name = "haversine";
  static constexpr double turns = 0.5;
  static constexpr double phase = 0;
  static constexpr bool squared = true;
  Real k{0};
  Real lambda{1};
};
using Haversine = BasicHaversine<double>;

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
                                     BasicFullSine<Real>, BasicRectangle<Real>, BasicSawtooth<Real>,
                                     BasicTrapezoid<Real>, BasicHaversine<Real>, BasicRecord<Real>>;
using Excitation = BasicExcitation<double>;

template <class Kind>
concept IsPulse = requires {
  Kind::turns;
};
template <class Kind>
concept IsSine = requires(const Kind& kind) {
  kind.phase;
};
/// The square of a sine.
template <class Kind>
concept IsSquare = requires {
  Kind::squared;
};
template <class Kind>
concept IsPolygon = requires {
  Kind::corners;
};

/// The same load as a record, which ends at `duration`.
template <class Real, IsPolygon Polygon>
[[nodiscard]] BasicRecord<Real> record_of(const Polygon& pulse, const Real& duration) {
  BasicRecord<Real> record;
  for (const auto& [time, load] : Polygon::corners) {
    record.times.push_back(Real(time) * duration);
    record.values.push_back(Real(load) * pulse.k);
  }
  return record;
}

/// W(tau) for 0 <= tau < duration, for figures and for integrators to compare with: the kernels,
/// which do not use it, are more exact.
template <IsSine Sine>
[[nodiscard]] double load_at(const Sine& wave, double tau) {
  const double sine = std::sin(wave.lambda * tau + wave.phase);
  return wave.k * (IsSquare<Sine> ? sine * sine : sine);
}
template <IsPolygon Polygon>
[[nodiscard]] double load_at(const Polygon& pulse, double tau) {
  const double part = pulse.lambda * tau / (2 * Polygon::turns * std::numbers::pi);
  const auto* to = Polygon::corners.begin() + 1;
  while (to + 1 != Polygon::corners.end() && to->time <= part) {
    ++to;
  }
  const auto* const from = to - 1;
  return pulse.k *
         (from->load + (to->load - from->load) * ((part - from->time) / (to->time - from->time)));
}

/// "half-sine" and so on, of all kinds in a variant.
template <class Kinds>
inline constexpr auto kind_names =
    []<class... Kind>(std::type_identity<std::variant<Kind...>> /*kinds*/) {
      return std::array<std::string_view, sizeof...(Kind)>{Kind::name...};
    }(std::type_identity<Kinds>());

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
/// during the pulse. Empty if the mass never moves, |k| <= f, and for other loads than pulses to
/// one side. Throws InputError as require_valid does, and unless f >= 0.
[[nodiscard]] std::optional<EquivalentStart> equivalent_start(const Excitation& pulse, double f);

}  // namespace stillpoint
