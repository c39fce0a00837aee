// SPDX-License-Identifier: MIT
#pragma once

// A quantity that is hard to compute, and the three ways to compute it that docs/accuracy.md
// compares.

#include "testing/exact_run.hpp"
#include "testing/random_scene.hpp"

#include <functional>
#include <string>
#include <vector>

namespace stillpoint::accuracy {

using test::Dice;
using test::Exact;

template <class Real>
using Inputs = std::vector<Real>;

struct HardCase {
  std::string name;
  std::string metric;
  std::string why;    ///< why it is hard
  std::string naive;  ///< the obvious formula; empty if there is none
  Inputs<double> inputs;
  std::function<Inputs<double>(Dice&)> neighbour;  ///< inputs as hard as those
  std::function<double(const Inputs<double>&)> kernel;
  std::function<double(const Inputs<double>&)> by_naive;  ///< empty if `naive` is
  std::function<Exact(const Inputs<Exact>&)> exact;
  int neighbours{2000};
  bool alike{false};  ///< most neighbours have about the condition number of `inputs`
};

[[nodiscard]] std::vector<HardCase> free_cases();
[[nodiscard]] std::vector<HardCase> region_cases();
[[nodiscard]] std::vector<HardCase> forced_cases();

}  // namespace stillpoint::accuracy
