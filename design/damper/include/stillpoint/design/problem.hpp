// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/interval.hpp>
#include <stillpoint/core/names.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace stillpoint::design {

/// Which lower bound of Delta keeps the motion at x = 0 on its first return.
enum class Criterion {
  published,  ///< the paper's condition 5: safe, too large by f^2/(2 p^2); of a later arrival
              ///< too, the last one alone: docs/theory.md section 12
  exact,      ///< the speed at x = 0 itself: sharp
};

/// The most arrivals at x = 0. The tolerance of a damper that stops at the n-th is below 1/(2n -
/// 1), 0.05 % for the last of these, and every arrival costs a step of the map.
inline constexpr std::int64_t most_arrivals = 1000;

/// With damping, where each costs as much as all before it.
inline constexpr std::int64_t most_damped_arrivals = 16;

/// Below it beta and the limits come close to the smallest normal double, where digits are lost.
inline constexpr double smallest_limit = 1e-300;

/// What the damper must do, dimensionless: stop at x = 0 after the initial velocity v0, by that
/// arrival (1 is the paper's task), with no displacement beyond beta. All positive;
/// p is the paper's p.
struct Problem {
  double v0{1};
  double p{1};
  double beta{1};
  Criterion criterion{Criterion::published};
  std::int64_t arrivals{1};
  /// With these, every requirement holds for each hit from v0_low to v0 and each spring from p to
  /// p_high: v0 and p are those of the largest peak. v0_low = 0: every hit up to v0, of which those
  /// that the notch holds need not move.
  std::optional<double> v0_low{};
  std::optional<double> p_high{};
  /// A rest with |x| <= residual is admissible as well, after at most `arrivals` half-cycles.
  std::optional<double> residual{};
  /// Of critical damping, anywhere in which it may be; below 1, and by the exact criterion. Search,
  /// strips, mends and works_for take it, to rounding and not to the last bit; nothing else does.
  Interval zeta{};
  /// As that of Oscillator, at most 2 (docs/damping.md section 6); taken by what takes zeta.
  double breakaway{1};

  /// The weakest hit that must move the mass.
  [[nodiscard]] double starting_v0() const { return v0_low.value_or(0) > 0 ? *v0_low : v0; }
  /// Whether the paper's notch catches some hits of the range at the start.
  [[nodiscard]] bool has_caught_hits(double delta) const {
    return v0_low && delta > 0 && *v0_low * *v0_low <= 2 * delta;
  }
  [[nodiscard]] double stiffest_p() const { return p_high.value_or(p); }
};

/// The strongest and the weakest hit with the softest and the stiffest spring, without the ranges,
/// the largest peak first; the weakest of every hit up to v0 is none.
[[nodiscard]] std::vector<Problem> ends_of_ranges(const Problem& problem);

/// The sides of the tolerance box as parts of the tolerance, each in [0, 1]: f may be anything from
/// f (1 - f_low R) to f (1 + f_high R), and Delta likewise.
struct BoxShape {
  double f_low{1};
  double f_high{1};
  double delta_low{1};
  double delta_high{1};

  friend bool operator==(const BoxShape&, const BoxShape&) = default;
};

/// What can be built. Every limit holds for the whole box f (1 +- tolerance), Delta (1 +-
/// tolerance), or what `shape` makes of it.
struct Limits {
  std::optional<double> f_max{};
  std::optional<double> delta_max{};
  double tolerance{0};  ///< in [0, 1)
  /// In g: the largest acceleration that the mass may feel outside the notch, S = sqrt(f^2 + p^2
  /// V0^2).
  std::optional<double> acceleration_max{};
  BoxShape shape{};
};

/// A damper and how far it may be off.
struct DesignPoint {
  double f{0};
  double delta{0};
  double tolerance{0};  ///< the largest R that it allows
};

/// One hit, one spring, no residual, no damping and the same tolerance on every side: the paper's
/// task, or that of a later arrival.
[[nodiscard]] bool is_plain(const Problem& problem, const Limits& limits);

/// Throws InputError, naming the field, unless
///   v0, p in [1e-150, 1e150]; beta in [1e-300, 1e300]; p beta in [1e-155, 1e155];
///   p beta / v0 in [1e-100, 1e100]; v0^2 / beta <= 1e305;
///   1 <= arrivals <= most_arrivals; 0 <= v0_low <= v0, 0 or in the range of v0;
///   p <= p_high <= 1e150; 0 <= residual <= 1e300.
void require_valid(const Problem& problem);

/// As above, and unless the sides of the shape are in [0, 1], not all 0; f_max and
/// acceleration_max, where given, in [1e-300, 1e300]; delta_max in [0, 1e300]; 0 <= tolerance < 1.
void require_valid(const Problem& problem, const Limits& limits);

/// As far as an input may be changed with the others as they are: as long as it stays valid
/// (above), but for one decade.
inline constexpr double far_ratio = 1e99;  // of p beta to v0, or the other way round
[[nodiscard]] Interval valid_v0(const Problem& problem);
[[nodiscard]] Interval valid_p(const Problem& problem);

using stillpoint::name;

}  // namespace stillpoint::design
