// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/oscillator.hpp>

#include <optional>
#include <vector>

namespace stillpoint {

/// Friction `f` for |x| < `to`, from the zone before it on.
template <class Real>
struct BasicFrictionZone {
  Real to{0};
  Real f{0};
};
using FrictionZone = BasicFrictionZone<double>;

/// What the mass slides on, if not the paper's constant friction with a notch without width:
/// docs/notches.md.
template <class Real>
struct BasicSurface {
  /// The notch acts on |x| < notch_width / 2, as friction f + delta / notch_width. Empty: only at x
  /// = 0.
  std::optional<Real> notch_width{};
  /// In order of |x|. Beyond the last one the oscillator's own f acts.
  std::vector<BasicFrictionZone<Real>> zones{};

  /// The paper's.
  [[nodiscard]] bool plain() const { return !notch_width && zones.empty(); }
};
using Surface = BasicSurface<double>;

/// Whether only the paper's friction slows the motion, and holds it: others have no closed forms.
template <class Real>
[[nodiscard]] bool paper_motion(const BasicOscillator<Real>& oscillator,
                                const BasicSurface<Real>& surface) {
  return surface.plain() && oscillator.coulomb();
}

/// Throws InputError, naming the field ("notch-width", "friction-zones 2: f", ...), unless
///   notch_width is in [1e-150, 1e150] and p times it as well, and there is no finite hold beside
///   it; edges increase, and they and p times them are in [1e-150, 1e150]; each friction, and that
///   of the notch, is what f may be.
void require_valid(const Oscillator& oscillator, const Surface& surface);

}  // namespace stillpoint
