// SPDX-License-Identifier: MIT
#pragma once

// A figure that is hard to compute, and the three ways to it that the page of accuracy compares.

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
  std::string why;    ///< what is hard about it
  std::string naive;  ///< the formula that people write first; empty: there is none
  Inputs<double> inputs;
  std::function<Inputs<double>(Dice&)> neighbour;  ///< inputs as hard as those
  std::function<double(const Inputs<double>&)> kernel;
  std::function<double(const Inputs<double>&)> by_naive;  ///< empty as `naive`
  std::function<Exact(const Inputs<Exact>&)> exact;
  int neighbours{2000};
  bool alike{false};  ///< most neighbours have about the condition number of `inputs`
};

[[nodiscard]] std::vector<HardCase> free_cases();
[[nodiscard]] std::vector<HardCase> region_cases();
[[nodiscard]] std::vector<HardCase> forced_cases();

}  // namespace stillpoint::accuracy
