// SPDX-License-Identifier: MIT
#pragma once

#include "kernel/damped_harmonic_piece.hpp"
#include "kernel/drive_phase.hpp"
#include "kernel/drives.hpp"
#include "kernel/hold.hpp"
#include "kernel/piece_end.hpp"

#include <utility>

namespace stillpoint {

/// W = K sin psi on a mass with damping, of which only the sliding pieces know.
template <class Real>
class DampedHarmonicDrive : public HarmonicDrive<Real> {
 public:
  /// `k` is the amplitude.
  DampedHarmonicDrive(const DrivePhase<Real>& phase, Load<Real> k, TippingMargin<Real>& margin,
                      Real zeta)
      : HarmonicDrive<Real>(phase, std::move(k), margin),
        r_(phase.ratio()),
        zeta_(std::move(zeta)),
        margin_(margin) {}

  [[nodiscard]] DampedHarmonicPiece<Real> piece(const Sliding<Real>& from) const {
    return {this->start_of(from), r_, zeta_, margin_};
  }

  [[nodiscard]] typename DampedHarmonicPiece<Real>::End first_event(
      const DampedHarmonicPiece<Real>& piece, const Real& limit, bool want_arrival) const {
    return piece.first_event(limit, want_arrival);
  }

 private:
  Real r_;
  Real zeta_;
  TippingMargin<Real>& margin_;
};

}  // namespace stillpoint
