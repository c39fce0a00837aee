// SPDX-License-Identifier: MIT
#include "damped_task.hpp"

BOOST_AUTO_TEST_SUITE(task_along_f_test)

// One hit, or a pulse at whose first return the mass must stop, searched along f: without damping
// it has the exact answers of a hit and of a pulse, with it what helps does and is the least.

using namespace stillpoint::design_test;

/// Room that a mend leaves so that the task which it mends can be verified: of the tolerance, and
/// as a part of a limit, which moves another input by more. And by which the box of a damper steps
/// back from its edges, absolute.
constexpr double to_find = 5e-4;
constexpr double of_mend = 1e-2;
constexpr double of_tolerance = 1e-4;

DesignRequest drawn(RandomSource& random) {
  DesignRequest request;
  Problem& problem = request.problem;
  problem.v0 = random.log_uniform(0.3, 3);
  problem.p = random.log_uniform(0.3, 3);
  problem.criterion = Criterion::exact;
  problem.beta = problem.v0 / problem.p * random.uniform(0.4, 0.95);
  if (random.pick(2) == 0) {
    const double lambda = problem.p * random.log_uniform(1, 10);
    const double k = problem.v0 * lambda / 2;
    request.pulse = random.pick(2) == 0 ? Pulse(HalfSine{k, lambda}) : Pulse(Rectangle{k, lambda});
  } else {
    random.one_in(3, problem.v0_low,
                  [&] { return random.pick(2) == 0 ? 0 : problem.v0 * random.uniform(0.8, 1); });
    random.one_in(3, problem.residual, [&] { return problem.beta * random.uniform(0.02, 0.3); });
    problem.arrivals = 1 + static_cast<std::int64_t>(random.pick(3));
  }
  Limits& limits = request.limits;
  limits.delta_max = problem.v0 * problem.v0 * random.uniform(0.05, 0.4);
  random.one_in(2, limits.tolerance, [&] { return random.uniform(0.02, 0.3); });
  return request;
}

double value_of(const std::vector<Mend>& mends, std::string_view field) {
  const auto mend = std::ranges::find(mends, field, &Mend::field);
  return mend == mends.end() ? 0 : mend->value;
}

BOOST_AUTO_TEST_CASE(without_damping_the_answers_are_the_exact_ones) {
  RandomSource random(4210);
  int found = 0;
  int mended = 0;
  for (int i = 0; i < 16; ++i) {
    DesignRequest request = drawn(random);
    const DesignResult exact = design::design(request);
    const double zeta = i % 8 == 0 ? 0 : 1e-9;
    const RecordDesign now = design::design(as_case(request, {zeta, zeta}));
    BOOST_TEST_CONTEXT("task " << i << ", beta " << request.problem.beta) {
      BOOST_TEST(exact.finding.has_value() == now.finding.has_value());
      if (exact.finding && now.finding) {
        ++found;
        BOOST_TEST(now.finding->cross_check.passed);
        constexpr double most = 0.95;  // that a box of a case grows to
        BOOST_TEST(std::abs(now.largest_tolerance.value() -
                            std::min(exact.finding->point.tolerance, most)) <= of_tolerance);
      }
      request.limits.tolerance += exact.finding ? 0 : to_find;
      const std::vector<Mend> mends = design::design(request).mends;
      for (const Mend& each : mends) {
        ++mended;
        BOOST_TEST_CONTEXT(each.field) {
          BOOST_TEST(std::abs(value_of(now.mends, each.field) / each.value - 1) <=
                     (each.field == "tolerance" ? 4 * to_find / each.value : of_mend));
        }
      }
    }
  }
  BOOST_TEST(found > 3);
  BOOST_TEST(mended > 12);
}

BOOST_AUTO_TEST_CASE(with_damping_what_helps_does_and_is_the_least) {
  RandomSource random(4211);
  int mended = 0;
  for (int i = 0; i < 16; ++i) {
    const double least = random.uniform(0.01, 0.2);
    DesignRequest request = drawn(random);
    const Interval zeta{least, request.pulse || i % 2 == 0 ? least : least + 0.05};
    const std::vector<Mend> mends = design::design(as_case(request, zeta)).mends;
    for (const auto& [field, input] :
         {std::pair("beta", &request.problem.beta), {"p", &request.problem.p}}) {
      const double value = value_of(mends, field);
      const double given = *input;
      const double short_of = value * (value > given ? 1 - of_mend : 1 + of_mend);
      const bool is_far = (short_of > given) == (value > given);
      for (const auto& [tried, helps] : {std::pair(value, true), {short_of, false}}) {
        if (value > 0 && (helps || is_far)) {
          *input = tried;
          BOOST_TEST(design::design(as_case(request, zeta)).finding.has_value() == helps,
                     "task " << i << ": " << field << " " << tried << " after " << given);
          ++mended;
        }
      }
      *input = given;
    }
  }
  BOOST_TEST(mended > 12);
}

BOOST_AUTO_TEST_SUITE_END()
