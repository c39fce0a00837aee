// SPDX-License-Identifier: MIT
#pragma once

// The free half-cycle map, docs/theory.md section 3. All lengths are multiplied by p and all
// accelerations divided by p, so that everything below is a speed.
//
// | here       | paper                  | meaning                                              |
// |------------|------------------------|------------------------------------------------------|
// | phi        | f / p                  | half the width of the dead zone, as a speed          |
// | notch      | 2 Delta                | what a passage takes of v^2                          |
// | energy     | x'_+^2                 | v^2 with which a half-cycle leaves x = 0             |
// | radius     | sqrt(f^2 + V^2 p^2)/p  | of the arc up to the peak, about x = -f/p^2          |
// | peak       | p A_k                  | the peak, as a speed                                 |
// | arrival    | x'_-^2                 | v^2 with which the half-cycle comes back to x = 0    |

#include <stillpoint/core/oscillator.hpp>

#include <cmath>

namespace stillpoint {

template <class Real>
struct HalfCycleMap {
  Real p;
  Real phi;
  Real notch;

  explicit HalfCycleMap(const BasicOscillator<Real>& oscillator)
      : p(oscillator.p), phi(oscillator.f / oscillator.p), notch(2 * oscillator.delta) {}

  /// Rule 4, of a start at x = 0 with v0 != 0.
  [[nodiscard]] bool catches(const Real& v0) const { return holds_at_start(Real(notch / 2), v0); }

  [[nodiscard]] bool without_friction() const { return phi == 0 && notch == 0; }

  /// (3): B = energy / (radius + phi). The paper's radius - phi loses every digit where phi >> V.
  [[nodiscard]] Real peak(const Real& energy, const Real& radius) const {
    return energy / (radius + phi);
  }

  /// (4): the peak is at least two dead zones away, so that the return reaches x = 0.
  [[nodiscard]] bool returns(const Real& radius) const { return radius >= 3 * phi; }

  /// (5): the motion rests at the peak, inside the dead zone.
  [[nodiscard]] bool rests_at_peak(const Real& radius) const { return radius <= 2 * phi; }

  /// (6): where a swing back from a peak between one and two dead zones rests, on the same side.
  [[nodiscard]] Real swing_back_rest(const Real& radius) const { return 3 * phi - radius; }

  /// (7): a factored difference of squares; it vanishes where `returns` changes.
  [[nodiscard]] Real arrival(const Real& radius) const {
    return (radius - 3 * phi) * (radius - phi);
  }

  /// (8): the energy after an arrival; the motion continues only if this is > 0.
  [[nodiscard]] Real departure(const Real& arrival_energy) const { return arrival_energy - notch; }

  /// (7) backwards: the energy with which the half-cycle left x = 0.
  [[nodiscard]] Real departure_to(const Real& arrival_energy) const {
    const Real r = 2 * phi + radius(arrival_energy);
    return (r - phi) * (r + phi);
  }

  /// v- - v+ of a passage that leaves x = 0 with this energy.
  [[nodiscard]] Real jump_before(const Real& departure) const {
    using std::sqrt;
    return notch / (sqrt(departure + notch) + sqrt(departure));
  }

  /// (2): the next radius.
  [[nodiscard]] Real radius(const Real& energy) const {
    using std::sqrt;
    return sqrt(energy + phi * phi);
  }
};

}  // namespace stillpoint
