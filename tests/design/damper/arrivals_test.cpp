// SPDX-License-Identifier: MIT
#include "any_task.hpp"
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(arrivals_test)

// Dampers that stop the mass at a later arrival, docs/theory.md section 12. The truth is the table
// there and the simulation; the library follows it backwards.

using namespace stillpoint::design_test;

/// Of one hit, and what ranges of V0 and p leave.
BOOST_AUTO_TEST_CASE(the_tolerances_of_the_strips_are_those_of_the_table) {
  struct Known {
    Problem problem;
    std::vector<double> percent;
  };
  constexpr double two_decimals = 0.005 + 1e-4;
  const auto of_beta = [](double beta) { return Problem{1, 1, beta, Criterion::exact, 6}; };
  for (const Known& known :
       {Known{of_beta(0.8), {22.22}}, Known{of_beta(0.9), {37.61, 18.71, 8.128, 1.613}},
        Known{of_beta(0.95), {37.61, 28.02, 16.44, 11.24, 8.166, 6.005}},
        Known{of_beta(0.99), {37.61, 32.70, 19.61, 14.00, 10.88, 8.893}},
        Known{of_beta(2), {37.61, 33.333, 20, 14.286, 11.111, 9.091}},
        Known{ranged(0.9, 1.1, 0.95, 1.05, 2), {21.7164, 14.49}},
        Known{ranged(0.8, 1.2, 0.95, 1.05, 1), {7.16}}}) {
    const auto list = strips(known.problem);
    BOOST_REQUIRE(list.size() == known.percent.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
      BOOST_TEST(list[i].arrival == static_cast<std::int64_t>(i + 1));
      BOOST_TEST(std::abs(100 * list[i].tolerance - known.percent[i]) < two_decimals);
    }
  }
  const auto little = strips({1, 1, 2, Criterion::exact, 3}, {0.001, std::nullopt, 0});
  BOOST_TEST(std::abs(little[0].tolerance - 0.002) < 1e-5);
  BOOST_TEST(std::abs(little[1].tolerance - 1.0 / 3) < 1e-6);
}

/// Of (51) and the table of section 12: V0 = p = 1, beta not binding, f at most 0.001.
BOOST_AUTO_TEST_CASE(more_arrivals_are_offered_where_they_help) {
  const auto offered = [](double beta, double tolerance, std::optional<double> delta_max,
                          std::int64_t arrivals = 1) -> std::int64_t {
    const Problem problem{1, 1, beta, Criterion::exact, arrivals};
    const auto list = mends(problem, {0.001, delta_max, tolerance});
    const auto found = std::ranges::find(list, "arrivals", &Mend::field);
    return found == list.end() ? 0 : static_cast<std::int64_t>(found->value);
  };
  BOOST_TEST(offered(1, 0.3, {}) == 2);
  BOOST_TEST(offered(1, 0.34, {}) == 0);   // above 1/3
  BOOST_TEST(offered(0.9, 0.3, {}) == 0);  // the peak of f = 0.001 is 0.999
  BOOST_TEST(offered(1, 0, {}) == 0);      // there is one with the first arrival
  // A passage takes Delta = 0.05 of the energy 1/2 and a half-cycle 2 f x = 0.002 at most, so that
  // 0.03 to 0.05 are left at the tenth arrival, which stops it, and 0.08 to 0.1 at the ninth.
  const std::int64_t tenth = offered(1, 0, 0.05);
  BOOST_TEST(tenth == 10);
  BOOST_TEST(offered(1, 0, 0.05, 9) == tenth);
  BOOST_TEST(offered(1, 0, 0.05, 10) == 0);
}

BOOST_AUTO_TEST_CASE(a_damper_that_stops_the_mass_too_late_is_explained) {
  const Problem problem{1, 1, 2, Criterion::exact, 3};
  const Limits little{1e-3, 0.01, 0};
  const Region region = admissible_region(problem, little);
  BOOST_TEST((region.conflict == Conflict::no_arrival));
  BOOST_TEST(reason(region, problem, little)->find("passes x = 0 3 times") != std::string::npos);
  // The weakest damper of the box of the largest: f and delta are at most 1/1.2 of the limits.
  const Limits rough{1e-3, 0.01, 0.2};
  const std::string text = reason(admissible_region(problem, rough), problem, rough).value();
  const std::string_view says = "would have to be below ";
  const double v0 = std::stod(text.substr(text.find(says) + says.size()));
  const auto passes = [](double speed) {
    return free_response({1, 0.8 / 1.2 * 1e-3, 0.8 / 1.2 * 0.01, {}}, {0, speed}).zero_passages;
  };
  BOOST_TEST(passes(v0 * (1 - 1e-4)) < 3);
  BOOST_TEST(passes(v0 * (1 + 1e-4)) >= 3);
  const Limits wide{1e-3, std::nullopt, 0.4};
  const Region narrow = admissible_region(problem, wide);
  BOOST_TEST((narrow.conflict == Conflict::no_arrival));
  BOOST_TEST(reason(narrow, problem, wide)->find("first 3 arrivals") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_room_along_the_reach_edge_changes_its_sign_once) {
  // (50) with both sides followed back by (39), in long double; phi_b = 1.
  const auto square = [](long double phi, long double d, long double radius, int steps) {
    for (int i = 0; i < steps; ++i) {
      radius = 2 * phi + std::sqrt(radius * radius + d);
    }
    return radius * radius - phi * phi;
  };
  int changed = 0;
  for (const int n : {2, 3, 4, 5, 7, 10, 20, 50, 200}) {
    // Above kappa = 1 - 1/n the room is positive at last, (51); at 1 it is an identity.
    for (int k = 1; k < 60; ++k) {
      const long double kappa = k / 60.0L;
      int changes = 0;
      bool positive = false;
      for (int i = 0; i <= 600; ++i) {
        const long double delta = std::pow(10.0L, -6 + i / 40.0L);
        const bool now = square(kappa, kappa * delta, kappa, n) > square(1, delta, 3, n - 1);
        changes += now != positive;
        positive = now;
      }
      BOOST_TEST(changes <= 1, "n = " << n << ", kappa = " << static_cast<double>(kappa));
      changed += changes;
    }
  }
  BOOST_TEST(changed > 20);
}

BOOST_AUTO_TEST_SUITE_END()
