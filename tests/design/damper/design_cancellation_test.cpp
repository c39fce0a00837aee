// SPDX-License-Identifier: MIT
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(design_cancellation_test)

using namespace stillpoint::design_test;

/// How often `work` asks, if nobody cancels it.
int times_asked(const std::function<void()>& work) {
  int asked = 0;
  const Cancellable cancellable([&] {
    ++asked;
    return true;
  });
  work();
  return asked;
}

/// `work` asks at least that often, and ends when the answer is no, at the first time and midway.
void check_cancellable(const std::function<void()>& work, int at_least) {
  const int times = times_asked(work);
  BOOST_TEST(times >= at_least);
  for (const int last : {1, times / 2}) {
    int asked = 0;
    const Cancellable cancellable([&] { return ++asked < last; });
    BOOST_CHECK_THROW(work(), Cancelled);
    BOOST_TEST(asked == last);
  }
}

/// Without an upper bound of f the strips are endless.
Problem many_arrivals() {
  return {.beta = 2, .arrivals = 100};
}

std::vector<Part> some_parts(int count) {
  stillpoint::design_test::RandomSource random(24);
  std::vector<Part> parts;
  parts.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    parts.push_back({std::to_string(i), random.uniform(0, 0.35), random.uniform(0, 0.5)});
  }
  return parts;
}

BOOST_AUTO_TEST_CASE(a_design_asks_at_each_strip) {
  constexpr int some = 50;  // not every strip is looked at
  DesignRequest request{.problem = many_arrivals()};
  check_cancellable([&] { static_cast<void>(design::design(request)); }, some);
  request.problem.residual = 0.01;
  check_cancellable([&] { static_cast<void>(design::design(request)); }, some);
}

BOOST_AUTO_TEST_CASE(a_task_without_a_design_asks_while_it_is_mended) {
  const DesignRequest request{.problem = many_arrivals(), .limits = {.tolerance = 0.9}};
  check_cancellable([&] { static_cast<void>(design::design(request)); }, 10);
}

BOOST_AUTO_TEST_CASE(a_catalogue_asks_at_each_part) {
  const std::vector<Part> parts = some_parts(1000);
  DesignRequest request{.problem = {.beta = 0.9}};
  check_cancellable([&] { static_cast<void>(choose(request, parts)); }, 1000);
  request.limits.tolerance = 0.9;  // none is admissible
  check_cancellable([&] { static_cast<void>(choose(request, parts)); }, 2000);
}

BOOST_AUTO_TEST_CASE(a_front_asks_at_each_damper) {
  const Problem problem{.beta = 0.9};
  check_cancellable([&] { static_cast<void>(trade_off(problem, {}, 50)); }, 50);
}

BOOST_AUTO_TEST_CASE(a_design_for_a_pulse_asks_at_each_motion) {
  DesignRequest request{
      .problem = {.beta = 3}, .pulse = HalfSine{0.5, 0.5}, .pulse_ranges = {.lambda_high = 5}};
  check_cancellable([&] { static_cast<void>(design::design(request)); }, 1000);
}

BOOST_AUTO_TEST_SUITE_END()
