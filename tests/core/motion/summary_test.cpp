// SPDX-License-Identifier: MIT
#include "motion.hpp"

#include <initializer_list>

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(summary_test)

template <class Enum>
void names_lead_back(std::initializer_list<Enum> all) {
  for (const Enum value : all) {
    BOOST_TEST(!name(value).empty());
    BOOST_TEST((parse<Enum>(name(value)) == value), name(value));
  }
  BOOST_TEST(names<Enum>().size() == all.size());
  BOOST_TEST(!parse<Enum>("Start").has_value());
  BOOST_TEST(!parse<Enum>("").has_value());
}

BOOST_AUTO_TEST_CASE(each_name_leads_back_to_its_enumerator) {
  using enum Outcome;
  names_lead_back({stopped_at_zero, stopped_in_dead_zone, never_stops, caught_at_start, running,
                   stopped_in_notch});
  names_lead_back({EventKind::start, EventKind::arrival, EventKind::passage, EventKind::turn,
                   EventKind::excitation_end, EventKind::stick, EventKind::release, EventKind::rest,
                   EventKind::end});
}

BOOST_AUTO_TEST_CASE(a_free_motion_in_one_line) {
  // p = v0 = 1. f = 1: the radius about x = -1 is sqrt(2), the peak sqrt(2) - 1 after pi / 4.
  BOOST_TEST(summary(free_response({1, 1, 0}, {0, 1})) ==
             "stops at x = 0.414214 at tau = 0.785398 after 1 half-cycle, peak 0.414214");
  // delta = 0.4 takes 0.8 of v^2 = 1 at the first return, after pi, and the rest at the second.
  BOOST_TEST(summary(free_response({1, 0, 0.4}, {0, 1})) ==
             "stops at x = 0 at tau = 6.28319 after 2 half-cycles, peak 1");
  BOOST_TEST(summary(free_response({1, 0, 0.4}, {0, 1}, {.times = false})) ==
             "stops at x = 0 after 2 half-cycles, peak 1");
  BOOST_TEST(summary(free_response({2, 0, 0}, {0, 3})) ==
             "never stops (no friction where it moves), peak 1.5");
  BOOST_TEST(summary(free_response({1, 0, 1}, {0, 1})) ==
             "never leaves x = 0 (held by the point friction)");
  BOOST_TEST(summary(free_response({1, 1, 0}, {0.5, 0})) == "stays at rest at x = 0.5");
}

BOOST_AUTO_TEST_CASE(a_forced_motion_in_one_line) {
  // W = 0: x = sin tau, at tau = 1.
  BOOST_TEST(summary(forced_response({1, 0, 0}, {0, 1}, NoExcitation{}, {.t_end = 1})) ==
             "goes on at tau = 1 (x = 0.841471, v = 0.540302) after 1 half-cycle, peak 0.841471");
  BOOST_TEST(summary(forced_response({1, 1, 0}, {0, 1}, NoExcitation{}, {})) ==
             "stops at x = 0.414214 at tau = 0.785398 after 1 half-cycle, peak 0.414214");
  const ForcedOptions cut{
      .t_end = 1, .go_on = [](double /*tau*/) { return false; }, .ask_every = 1};
  const ForcedResponse none = forced_response({1, 0, 0}, {0, 1}, Harmonic{0.1, 1}, cut);
  BOOST_TEST(none.cancelled);
  BOOST_TEST(summary(none).starts_with("cut short at tau = "), summary(none));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
