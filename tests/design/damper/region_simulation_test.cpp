// SPDX-License-Identifier: MIT
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(region_simulation_test)

// The region as the simulation sees it: points of (V0, p, beta, f, Delta) over nine decades, most
// of them close to an edge, each judged by the formulas and by the half-cycle map.

using namespace stillpoint::design_test;

constexpr std::uint64_t seed = 20'260'301;
constexpr std::int64_t points = 1'200'000;

/// Relative. Closer to a change than this, the rounding of the region's edges (a few 1e-16) and
/// that of the simulation (6e-16 for one half-cycle) may decide either way.
constexpr double undecided_within = 1e-14;
/// How many points may lie that near to tipping: the nearest are sown at 1e-12 and their margin is
/// that divided by the condition of the edge, so it takes an edge that is nearly vertical.
constexpr std::int64_t undecided_at_most = points / 1000;
/// Relative; the map's peak and f2 are rounded a few times each.
constexpr double peak_tolerance = 1e-15;

struct Sample {
  Problem problem;
  double f{0};
  double delta{0};
};

/// f / (V0 p) at which the peak is b V0 / p.
double unit_f2(double b) {
  return (1 - b) * (1 + b) / (2 * b);
}
double unit_delta1(double a, bool exact) {
  const double arc = std::sqrt(1 + a * a) - 2 * a;
  return (arc * arc - (exact ? a * a : 0)) / 2;
}

/// Ways to choose a point; the last seven put it beside an edge, at relative distances from 1e-12
/// on.
enum Sowing {
  anywhere,
  inside,
  small_f,
  between,
  at_f2,
  at_f3,
  at_start,
  at_stop,
  at_exact_stop,
  at_corner,
  at_beta_min,
  sowings
};

Sample sow(RandomSource& random, Sowing sowing) {
  constexpr double a3 = std::numbers::sqrt2 / 4;
  constexpr double b_min = std::numbers::sqrt2 / 2;
  double b = random.log_uniform(b_min, 3);
  double a = random.uniform(std::max(0.0, unit_f2(b)), a3);
  const auto between_bounds = [&](double low, double high) {
    return low + (high - low) * random.uniform(0, 1);
  };
  double d = between_bounds(unit_delta1(std::min(a, a3), random.pick(2) == 0), 0.5);
  switch (sowing) {
    case anywhere:
      b = random.log_uniform(0.1, 10);
      a = random.uniform(0, 1.5 * a3);
      d = random.uniform(0, 0.75);
      break;
    case small_f:
      b = random.log_uniform(1.01, 1e4);
      a = random.log_uniform(1e-9, a3);
      d = between_bounds(unit_delta1(a, true), 0.5) * (random.pick(2) == 0 ? 1 : random.beside());
      break;
    case between:
      d = between_bounds(unit_delta1(a, true), unit_delta1(a, false));
      break;
    case at_f2:
      b = random.uniform(b_min, 1);
      a = unit_f2(b) * random.beside();
      d = between_bounds(unit_delta1(std::min(a, a3), true), 0.5);
      break;
    case at_f3:
      a = a3 * random.beside();
      d = random.uniform(0, 0.5);
      break;
    case at_start:
      d = 0.5 * random.beside();
      break;
    case at_stop:
      d = unit_delta1(a, false) * random.beside();
      break;
    case at_exact_stop:
      d = unit_delta1(a, true) * random.beside();
      break;
    case at_corner:
      a = a3 * random.beside();
      d = random.log_uniform(1e-12, 1e-1);
      break;
    case at_beta_min:
      b = b_min * random.beside();
      a = a3 * random.beside();
      break;
    case inside:
    case sowings:
      break;
  }
  Sample sample;
  sample.problem.v0 = random.log_uniform(3e-5, 3e4);
  sample.problem.p = random.log_uniform(3e-5, 3e4);
  sample.problem.beta = b * sample.problem.v0 / sample.problem.p;
  sample.f = a * sample.problem.v0 * sample.problem.p;
  sample.delta = std::max(0.0, d) * sample.problem.v0 * sample.problem.v0;
  return sample;
}

/// Whether the formulas admit it, with either bound of Delta.
struct Verdict {
  bool published{true};
  bool exact{true};
};

Verdict ask_formulas(const Sample& sample) {
  Verdict verdict;
  for (const Constraint& constraint : constraints(sample.problem, sample.f, sample.delta)) {
    verdict.published = verdict.published && constraint.satisfied;
    verdict.exact = verdict.exact && (constraint.satisfied || constraint.name == "stop");
  }
  verdict.exact =
      verdict.exact && sample.delta > delta1_exact(sample.problem, sample.f).value_or(HUGE_VAL);
  return verdict;
}

/// Whether the mass starts, stays within beta and stops on its first return, with its dead zone
/// within beta, without any of the region's formulas; empty within undecided_within of a limit.
std::optional<bool> ask_simulation(const Sample& sample) {
  const double v0 = sample.problem.v0;
  const double p = sample.problem.p;
  const double beta = sample.problem.beta;
  const Response response = free_response({p, sample.f, sample.delta}, {0, v0}, {.times = false});
  const double dead_zone = sample.f / p / p;
  if (*response.decision_margin < undecided_within ||
      std::abs(response.peak_amplitude / beta - 1) < undecided_within ||
      std::abs(dead_zone / beta - 1) < undecided_within) {
    return std::nullopt;
  }
  return response.outcome == Outcome::stopped_at_zero && *response.stop_position == 0 &&
         *response.half_cycles == 1 && *response.zero_passages == 0 &&
         response.peak_amplitude <= beta * (1 + peak_tolerance) && dead_zone < beta;
}

BOOST_AUTO_TEST_CASE(the_simulation_shows_the_region_on_a_million_points) {
  RandomSource random(seed);
  struct Tally {
    std::int64_t published{0};
    std::int64_t inside{0};
    std::int64_t outside{0};
    std::int64_t between{0};  ///< refused by the published bound, admitted by the exact one
  };
  std::array<Tally, sowings> tallies;
  std::int64_t undecided = 0;
  for (std::int64_t i = 0; i < points; ++i) {
    const auto sowing = static_cast<Sowing>(i % sowings);
    const Sample sample = sow(random, sowing);
    const auto [published, exact] = ask_formulas(sample);
    const auto seen = ask_simulation(sample);
    if (!seen) {
      ++undecided;
      continue;
    }
    if (exact != *seen || (published && !exact)) {
      BOOST_ERROR("point " << i << ": v0 = " << sample.problem.v0 << ", p = " << sample.problem.p
                           << ", beta = " << sample.problem.beta << ", f = " << sample.f
                           << ", delta = " << sample.delta);
    }
    Tally& now = tallies.at(sowing);
    now.published += published ? 1 : 0;
    now.inside += exact ? 1 : 0;
    now.outside += exact ? 0 : 1;
    now.between += exact && !published ? 1 : 0;
  }
  BOOST_TEST(undecided <= undecided_at_most);
  // Each case occurred often enough to be significant.
  const auto all = [&](std::int64_t Tally::*kind) {
    std::int64_t sum = 0;
    for (const Tally& now : tallies) {
      sum += now.*kind;
    }
    return sum;
  };
  BOOST_TEST(all(&Tally::published) > points / 10);
  BOOST_TEST(all(&Tally::between) > points / 20);
  BOOST_TEST(all(&Tally::outside) > points / 10);
  for (const Sowing edge : {at_f2, at_f3, at_start, at_stop, at_exact_stop, at_beta_min}) {
    BOOST_TEST(tallies.at(edge).inside > points / sowings / 20);
    BOOST_TEST(tallies.at(edge).outside + tallies.at(edge).between > points / sowings / 20);
  }
}

BOOST_AUTO_TEST_SUITE_END()
