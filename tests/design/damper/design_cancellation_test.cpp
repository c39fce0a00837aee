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

std::vector<Part> some_parts(int count) {
  stillpoint::design_test::RandomSource random(24);
  std::vector<Part> parts;
  parts.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    parts.push_back({std::to_string(i), random.uniform(0, 0.35), random.uniform(0, 0.5)});
  }
  return parts;
}

BOOST_AUTO_TEST_CASE(whatever_takes_long_asks_again_and_again) {
  // Without an upper bound of f the strips are endless.
  const Problem many{.beta = 2, .arrivals = 100};
  Problem within = many;
  within.residual = 0.01;
  const DesignRequest pulse{
      .problem = {.beta = 3}, .pulse = HalfSine{0.5, 0.5}, .pulse_ranges = {.lambda_high = 5}};
  const std::vector<Part> parts = some_parts(1000);
  const auto designs = [](const DesignRequest& request) {
    return [request] { static_cast<void>(design::design(request)); };
  };
  const auto chooses = [&](double tolerance) {
    return [&, tolerance] {
      static_cast<void>(
          choose({.problem = {.beta = 0.9}, .limits = {.tolerance = tolerance}}, parts));
    };
  };
  struct Row {
    const char* name;
    std::function<void()> work;
    int at_least;
  };
  for (const auto& [name, work, at_least] :
       {Row{"some strips", designs({.problem = many}), 50},
        Row{"some strips with a residual", designs({.problem = within}), 50},
        Row{"mends", designs({.problem = many, .limits = {.tolerance = 0.9}}), 10},
        Row{"each motion under a pulse", designs(pulse), 1000}, Row{"each part", chooses(0), 1000},
        Row{"each part and its mends", chooses(0.9), 2000},
        Row{"each damper of a front", [] { static_cast<void>(trade_off({.beta = 0.9}, {}, 50)); },
            50}}) {
    BOOST_TEST_CONTEXT(name) {
      check_cancellable(work, at_least);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
