// SPDX-License-Identifier: MIT
#include "design/peers/reference_scenes.hpp"

#include <stillpoint/peers/comparison.hpp>

namespace stillpoint::peers {

BOOST_AUTO_TEST_SUITE(comparison_test)

void every_peer_is(Run run, const Comparison& comparison) {
  for (std::size_t i = 1; i < comparison.rows.size(); ++i) {
    BOOST_TEST(comparison.rows[i].run == run, comparison.rows[i].name);
  }
  BOOST_TEST(comparison.rows.front().run == Run::done);
  BOOST_TEST(comparison.rows.front().counts_right);
}

BOOST_AUTO_TEST_CASE(where_nothing_moves_no_peer_is_run) {
  const auto nothing_moves = [](const Scene& s) { every_peer_is(Run::nothing_moves, compare(s)); };
  nothing_moves(with(NoExcitation{}, {1, 0.1, 0.2}, {0, 0.1}, 1));    // caught at the start
  nothing_moves(with(NoExcitation{}, {1, 0.5, 0}, {0.25, 0}, 1));     // in the dead zone
  nothing_moves(with(Rectangle{0.05, 1}, {1, 0.1, 0}, {0, 0}, 1));    // k < f
  nothing_moves(with(Harmonic{0.05, 1}, {1, 0.1, 0}, {0, 0}, 1000));  // held for ever
  every_peer_is(Run::done, compare(with(NoExcitation{}, {1, 0.5, 0}, {1, 0}, 10)));
}

BOOST_AUTO_TEST_CASE(what_has_no_end_to_follow_it_to_is_refused) {
  const auto scene_of = [](const Oscillator& oscillator) {
    return comparison_scene({.oscillator = oscillator, .start = {0, 1}, .half_cycle_limit = {}});
  };
  BOOST_CHECK_THROW(static_cast<void>(scene_of({1, 0, 0})), InputError);
  // 1e9 half-cycles by the map, 1e150 by the closed form, which no integer counts.
  BOOST_CHECK_THROW(static_cast<void>(scene_of({1, 1e-9, 1e-9})), TooManyHalfCycles);
  BOOST_CHECK_THROW(static_cast<void>(scene_of({1e150, 1, 0})), TooManyHalfCycles);
}

// f just below k: the mass moves by 1e-23, and the width of the regularised model is then so small
// that its run would take for ever.
BOOST_AUTO_TEST_CASE(a_mass_that_hardly_moves_is_given_up) {
  const Comparison found = compare(with(FullSine{1, 0.5}, {1, 0.999999999999, 0.125}, {0, 0}, 30));
  BOOST_TEST(found.rows.front().result.turns == 1);
  BOOST_TEST(found.rows.front().peak_error < 1e-8);
  BOOST_TEST(found.rows.back().run == Run::too_long);
  BOOST_TEST(found.rows.back().name == "regularised");
}

// dopri5's errors of S1 follow its tolerance in any units, since both are relative to the peak. In
// units of a power of two (f by it, Delta by its square) only exponents differ, for every method.
BOOST_AUTO_TEST_CASE(errors_are_relative) {
  std::optional<Comparison> first;
  for (const double unit : {1.0, 0x1p-17, 0x1p-330, 0x1p330}) {
    const Comparison found =
        compare(with(NoExcitation{}, {1, 0.02 * unit, 0.02 * unit * unit}, {0, unit}, 140));
    first = first.value_or(found);
    BOOST_TEST_REQUIRE(found.rows.size() == first->rows.size());
    for (std::size_t i = 0; i < found.rows.size(); ++i) {
      const MethodRow& row = found.rows[i];
      const MethodRow& same = first->rows[i];
      BOOST_TEST_CONTEXT(row.name << ", unit " << unit) {
        BOOST_TEST(row.counts_right == same.counts_right);
        BOOST_TEST(row.result.steps == same.result.steps);
        BOOST_TEST(row.peak_error == same.peak_error, boost::test_tools::tolerance(1e-9));
        BOOST_TEST(row.end_error == same.end_error, boost::test_tools::tolerance(1e-9));
      }
    }
  }
  const MethodRow& loose = first->rows[1];
  BOOST_TEST(loose.name == "dopri5");
  BOOST_TEST(loose.setting.value().value == 1e-6);
  BOOST_TEST(loose.counts_right);
  BOOST_TEST(loose.peak_error > 1e-8);
  BOOST_TEST(loose.peak_error < 1e-6);
  BOOST_TEST(loose.end_error < 2e-6);
  BOOST_TEST(first->rows.front().peak_error < 4e-16);
  BOOST_TEST(first->rows.front().end_error < 1e-15);
}

BOOST_AUTO_TEST_CASE(real_notches_are_compared_with_50_digits) {
  const auto request = [](const Oscillator& oscillator, const Surface& surface,
                          const Excitation& excitation = {}) {
    return SimulationRequest{.oscillator = oscillator,
                             .start = {0, 1},
                             .excitation = excitation,
                             .surface = surface,
                             .half_cycle_limit = {}};
  };
  for (const SimulationRequest& one :
       {request({1, 0.26, 0.37}, {0.05, {}}), request({1, 0.02, 0.02}, {0.1, {{0.3, 0.04}}}),
        request({1, 0.05, 0.05}, {0.1, {}}, HalfSine{0.5, 1}),
        request({1, 0.1, 0}, {{}, {{0.2, 0.3}, {0.5, 0.15}}}),
        request({1, 0.05, 0.05, 0.2}, {}, HalfSine{0.5, 1})}) {
    const Comparison found = compare(comparison_scene(one));
    BOOST_TEST(found.rows.front().counts_right);
    BOOST_TEST(found.rows.front().peak_error <= 1e-15);
    BOOST_TEST(found.rows.front().end_error <= 1e-14);
    bool regularised = false;
    for (const MethodRow& row : found.rows) {
      regularised = regularised || row.name == "regularised";
      if ((row.name == "dopri5" && row.setting->value == 1e-12) ||
          (row.name == "RK4" && row.setting->value < 0.002)) {
        BOOST_TEST(row.counts_right);
        BOOST_TEST(row.end_error <= 1e-8);
      }
    }
    BOOST_TEST(regularised == !one.oscillator.hold.has_value());  // the model has no hold
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::peers
