// SPDX-License-Identifier: MIT
#pragma once

// A law of friction with viscous damping beside it: docs/damping.md. In the units of
// forced_run.hpp, where damping takes 2 zeta v.

#include <utility>

namespace stillpoint {

template <class Law, class Real>
class Damped : public Law {
 public:
  static constexpr bool damped = true;

  Damped(Law law, Real zeta) : Law(std::move(law)), zeta_(std::move(zeta)) {}

  [[nodiscard]] const Real& zeta() const { return zeta_; }
  [[nodiscard]] Real drag(const Real& v) const { return 2 * zeta_ * v; }

 private:
  Real zeta_;
};

}  // namespace stillpoint
