// SPDX-License-Identifier: MIT
#include "hard_case.hpp"

#include <stillpoint/design/region.hpp>

#include <cmath>

// Inputs in the order V0, p, and f or beta.

namespace stillpoint::accuracy {

namespace {

template <class Real>
Real delta1(const Inputs<Real>& in) {
  using std::sqrt;
  const Real s = sqrt(Real(in[2] * in[2] + in[0] * in[1] * in[0] * in[1]));
  return (s - in[2]) * (s - 3 * in[2]) / (2 * in[1] * in[1]);
}

template <class Real>
Real f2(const Inputs<Real>& in) {
  const Real speed = in[2] * in[1];
  return (in[0] * in[0] - speed * speed) / (2 * in[2]);
}

HardCase exact_delta1() {
  HardCase now;
  now.metric = "delta1_exact";
  now.name = "Delta1 near f3";
  now.why = "S and 3f agree";
  now.naive = "(S - f)(S - 3f)/(2 p^2)";
  now.inputs = {1, 1, (1 - 1e-10) / std::sqrt(8.0)};
  now.neighbour = [](Dice& dice) {
    const double v0 = dice.power_of_ten(-1, 1);
    const double p = dice.power_of_ten(-1, 1);
    return Inputs<double>{v0, p, v0 * p / std::sqrt(8.0) * (1 - dice.power_of_ten(-12, -6))};
  };
  now.kernel = [](const Inputs<double>& in) {
    return design::delta1_exact({in[0], in[1], in[0] / in[1], design::Criterion::exact}, in[2])
        .value();
  };
  now.by_naive = delta1<double>;
  now.exact = delta1<Exact>;
  return now;
}

HardCase amplitude_edge() {
  HardCase now;
  now.metric = "f2";
  now.name = "f2 where amplitude hardly binds";
  now.why = "V0 and beta p agree";
  now.naive = "(V0^2 - (beta p)^2)/(2 beta)";
  now.inputs = {1, 1, 1 - 1e-10};
  now.neighbour = [](Dice& dice) {
    const double v0 = dice.power_of_ten(-1, 1);
    const double p = dice.power_of_ten(-1, 1);
    return Inputs<double>{v0, p, v0 / p * (1 - dice.power_of_ten(-12, -6))};
  };
  now.kernel = [](const Inputs<double>& in) {
    return design::admissible_region({in[0], in[1], in[2], design::Criterion::published}).f2;
  };
  now.by_naive = f2<double>;
  now.exact = f2<Exact>;
  return now;
}

}  // namespace

std::vector<HardCase> region_cases() {
  return {exact_delta1(), amplitude_edge()};
}

}  // namespace stillpoint::accuracy
