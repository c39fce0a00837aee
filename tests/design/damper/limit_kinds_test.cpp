// SPDX-License-Identifier: MIT
// What follows from a row of the table of limits, for each of them.

#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(limit_kinds_test)

using namespace stillpoint::design_test;

/// No damper of either task keeps it.
constexpr double too_small = 1e-3;

Limits limited(const LimitKind& kind, double value) {
  Limits limits;
  limits.*kind.value = value;
  return limits;
}

/// One of the mends is of that limit: its value suffices, and one a little smaller does not.
template <class Feasible>
void check_mend(const LimitKind& kind, const std::vector<Mend>& mends, const Feasible& feasible) {
  const auto mend = std::ranges::find(mends, kind.field, &Mend::field);
  BOOST_TEST_REQUIRE((mend != mends.end()));
  BOOST_TEST(mend->upwards);
  BOOST_TEST(feasible(limited(kind, mend->value)));
  constexpr double a_little = 1e-9;
  BOOST_TEST(!feasible(limited(kind, mend->value * (1 - a_little))));
}

bool has(const std::vector<Constraint>& list, const LimitKind& kind, bool satisfied) {
  return std::ranges::any_of(list, [&](const Constraint& now) {
    return now.name == kind.constraint && now.satisfied == satisfied;
  });
}

/// Of a design and of a part, after a hit and under a pulse.
BOOST_AUTO_TEST_CASE(each_leaves_no_damper_and_is_mended) {
  const std::vector<Part> parts{{"a", 0.24, 0.4}};
  for (const bool pulsed : {false, true}) {
    for (const LimitKind& kind : limit_kinds()) {
      DesignRequest request{.problem = {1, 1, 0.8}};
      if (pulsed) {
        request = {.problem = {.p = 1, .beta = 0.8}, .pulse = stillpoint::Rectangle{0.5, 1}};
      }
      const auto with = [&](const Limits& limits) {
        request.limits = limits;
        return request;
      };
      BOOST_TEST_CONTEXT(kind.field << (pulsed ? ", pulsed" : "")) {
        const DesignResult empty = design::design(with(limited(kind, too_small)));
        BOOST_TEST(!empty.region.feasible);
        BOOST_TEST(empty.region.limit == &kind);
        BOOST_TEST((empty.reason->find(kind.quantity) != std::string::npos));
        check_mend(kind, empty.mends, [&](const Limits& now) {
          return design::design(with(now)).finding.has_value();
        });
        const Choice choice = choose(with(limited(kind, too_small)), parts);
        BOOST_TEST(has(choice.parts.front().violated, kind, false));
        check_mend(kind, choice.result.mends, [&](const Limits& now) {
          return choose(with(now), parts).parts.front().admissible;
        });
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(each_is_a_condition_with_the_edge_of_the_region) {
  const Problem problem{1, 1, 0.8};
  for (const LimitKind& kind : limit_kinds()) {
    BOOST_TEST_CONTEXT(kind.field) {
      const Limits limits = limited(kind, kind.figure ? 1.03 : 0.3);
      const double edge = limit_edges(problem, limits).front().edge;
      const double outside = std::nextafter(edge, HUGE_VAL);
      const auto at = [&](double value) {
        return kind.bounds_f() ? constraints(problem, limits, value, 0.2)
                               : constraints(problem, limits, 0.25, value);
      };
      BOOST_TEST(has(at(edge), kind, true));
      BOOST_TEST(has(at(outside), kind, false));
      BOOST_TEST((kind.bounds_f() ? largest_f_allowed(problem, limits)
                                  : largest_delta_allowed(limits)) == edge);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
