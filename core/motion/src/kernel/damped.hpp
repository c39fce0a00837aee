// SPDX-License-Identifier: MIT
#pragma once

// A law of friction with viscous damping beside it: docs/damping.md. In the units of
// forced_run.hpp, where damping takes 2 zeta v.

#include "kernel/damped_terms.hpp"

#include <utility>

namespace stillpoint {

template <class Law, class Real>
class Damped : public Law {
 public:
  static constexpr bool damped = true;

  Damped(Law law, const Real& zeta) : Law(std::move(law)), swing_(zeta) {}

  [[nodiscard]] const DampedSwing<Real>& swing() const { return swing_; }
  [[nodiscard]] const Real& zeta() const { return swing_.zeta(); }
  [[nodiscard]] Real drag(const Real& v) const { return 2 * zeta() * v; }

 private:
  DampedSwing<Real> swing_;
};

}  // namespace stillpoint
