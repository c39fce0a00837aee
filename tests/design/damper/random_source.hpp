// SPDX-License-Identifier: MIT
#pragma once

// Random problems that repeat: the same numbers on every machine, from a seed that is printed.

#include "testing/test.hpp"

#include <stillpoint/design.hpp>

namespace stillpoint::design_test {

inline const std::vector<design::Objective> objectives = [] {
  std::vector<design::Objective> list;
  for (const auto& [objective, name] : enumerators(design::Objective())) {
    list.push_back(objective);
  }
  return list;
}();

class RandomSource {
 public:
  explicit RandomSource(std::uint64_t seed) : seed_(seed), engine_(seed) {
    BOOST_TEST_MESSAGE("seed " << seed);
  }

  [[nodiscard]] std::uint64_t seed() const { return seed_; }

  double uniform(double low, double high) {
    constexpr double unit = 0x1p-53;
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * unit);
  }

  /// Each decade as likely as the next.
  double log_uniform(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }

  /// 0, 1, ..., count - 1.
  int pick(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }

  /// In one case of `count`, `value` becomes what `draw` returns.
  template <class Value, class Draw>
  void one_in(int count, Value& value, const Draw& draw) {
    if (pick(count) == 0) {
      value = draw();
    }
  }

 private:
  std::uint64_t seed_;
  std::mt19937_64 engine_;
};

inline design::Objective random_objective(RandomSource& random) {
  return objectives[static_cast<std::size_t>(random.pick(static_cast<int>(objectives.size())))];
}

/// V0 and p over nine decades each, and with them beta over eighteen; p beta / V0 from `least` to
/// `most`.
inline design::Problem random_problem(RandomSource& random, double least, double most) {
  design::Problem problem{.v0 = random.log_uniform(3e-5, 3e4), .p = random.log_uniform(3e-5, 3e4)};
  problem.beta = random.log_uniform(least, most) * problem.v0 / problem.p;
  problem.criterion = random.pick(2) == 0 ? design::Criterion::published : design::Criterion::exact;
  return problem;
}

/// One with a region that is not empty: p beta / V0 from 0.708 to 3.
inline design::Problem random_feasible_problem(RandomSource& random) {
  return random_problem(random, std::numbers::sqrt2 / 2 + 1e-3, 3);
}

/// The same limits with another tolerance asked for.
inline design::Limits with_tolerance(design::Limits limits, double tolerance) {
  limits.tolerance = tolerance;
  return limits;
}

}  // namespace stillpoint::design_test
