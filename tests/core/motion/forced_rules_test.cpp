// SPDX-License-Identifier: MIT
#include "motion.hpp"

// Each rule of docs/forced.md section 1 and of docs/notches.md, with inputs for which the answer is
// simple, and each outcome once. notch_hold_test and notch_width_test have what takes many motions.

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(forced_rules_test)

using std::acos;
using std::cos;
using std::sin;
using std::sqrt;

constexpr auto caught = Outcome::caught_at_start;
constexpr auto at_zero = Outcome::stopped_at_zero;
constexpr auto in_notch = Outcome::stopped_in_notch;
constexpr auto in_dead_zone = Outcome::stopped_in_dead_zone;
constexpr auto never_stops = Outcome::never_stops;
constexpr auto running = Outcome::running;

/// What is known by hand of a motion.
struct Known {
  std::optional<Outcome> outcome{};
  std::optional<double> half_cycles{}, passages{}, turns{}, sticks{}, stick_time{};
  std::optional<double> peak{}, arrival{}, stop_time{}, rest{}, end_time{}, x{}, v{};
  std::optional<double> felt{};         ///< peak_absolute_acceleration
  std::optional<double> locked_from{};  ///< under a load that is `felt`
  std::optional<bool> leaves_rest{};
};

struct Rule {
  Oscillator oscillator;
  Start start;
  Excitation excitation;
  std::optional<double> t_end;
  Known known;
  Surface surface{};
};

std::ostream& operator<<(std::ostream& stream, const Rule& rule) {
  const double p = rule.oscillator.p;
  const double f = rule.oscillator.f;
  const double delta = rule.oscillator.delta;
  const std::optional<double>& hold = rule.oscillator.hold;
  return stream << "p " << p << ", f " << f << ", delta " << delta << ", hold "
                << hold.value_or(HUGE_VAL) << ", x0 " << rule.start.x0 << ", v0 " << rule.start.v0
                << ", width " << rule.surface.notch_width.value_or(0) << ", load "
                << rule.excitation.index() << " until " << rule.t_end.value_or(HUGE_VAL);
}

/// A notch with a width; friction without point friction within |x| = 1.
Surface notch(double width) {
  return {width, {}};
}
const Surface ice{{}, {{1, 0}}};

Rule rule(const Oscillator& oscillator, const Start& start, const Excitation& excitation,
          std::optional<double> t_end, const Known& known, const Surface& surface = {}) {
  return {oscillator, start, excitation, t_end, known, surface};
}

Known locked_under(double load) {
  return {.outcome = caught, .felt = load, .locked_from = 0};
}

const std::vector<Rule> rules{
    // v0^2 = 1 < 2 Delta is caught, whatever W does; v0^2 = 2 Delta sets off and pays nothing: up
    // to x = 1, back with v^2 = 1 <= 2 Delta.
    rule({1, 0, 0.51}, {0, 1}, Harmonic{100, 1}, 10,
         {.outcome = caught, .half_cycles = 0, .stop_time = 0}),
    rule({1, 0, 0.5}, {0, 1}, {}, 10, {.outcome = at_zero, .peak = 1, .stop_time = pi}),
    // From rest at x = -1: arrives with v = 1, goes on with v^2 = 1 - 2 * 0.18 = 0.64, and without
    // a notch with 1.
    rule({1, 0, 0.18}, {-1, 0}, constant(0), pi / 2 + 0.1,
         {.passages = 1, .arrival = 1, .v = 0.8 * cos(0.1)}),
    rule({1, 0, 0}, {-1, 0}, {}, 1.6, {.passages = 1, .arrival = 1, .v = sin(1.6)}),
    // W = 1 pushes from x = 0.25, v = 0 back: about -1 with amplitude 1.25, at x = 0 v^2 = 0.5625 <
    // 2 * 0.3. That rest is final; a hold of 0.9 is exceeded at once: it sets off again from v = 0,
    // about -1 up to -2 and back. One of 1 holds it.
    rule({1, 0, 0.3}, {0.25, 0}, constant(1), 1e3,
         {.outcome = at_zero,
          .sticks = 0,
          .arrival = 0.75,
          .stop_time = acos(0.8),
          .end_time = acos(0.8),
          .felt = 1,
          .locked_from = acos(0.8)}),
    rule({1, 0, 0.3, 0.9}, {0.25, 0}, constant(1), 6,
         {.passages = 1, .sticks = 0, .peak = 2, .x = -1 + cos(6 - acos(0.8))}),
    rule({1, 0, 0.3, 1}, {0.25, 0}, constant(1), 6,
         {.outcome = running, .passages = 0, .sticks = 1, .stick_time = 6 - acos(0.8), .x = 0}),
    rule({1, 0, 0.3}, {0.25, 0}, constant(1), 0.1, {.felt = 0.25}),
    // W = 1, f = 2, from x0 = 0 with v0 = 3: about -3 with radius hypot(3, 3), turns at x = 3 sqrt
    // 2 - 3 = 1.24; there W + x = 2.24 > f: sets off. With v0 = 1: turns at sqrt 10 - 3 = 0.16 and
    // sticks; the record might still release it.
    rule({1, 2, 0}, {0, 3}, constant(1), 100, {.turns = 2}),
    rule({1, 2, 0}, {0, 1}, constant(1), 100,
         {.outcome = running,
          .turns = 1,
          .sticks = 1,
          .stick_time = 100 - std::atan2(1, 3),
          .x = sqrt(10.0) - 3}),
    // W = 0.2 sin(tau / 2) exceeds f = 0.1 at tau = pi / 3, and there v'' = -W' = -0.1 cos(pi / 6):
    // x = -0.1 cos(pi / 6) h^3 / 6 to first order.
    rule({1, 0.1, 0}, {0, 0}, Harmonic{0.2, 0.5}, pi / 3 - 1e-3, {.half_cycles = 0, .x = 0}),
    rule({1, 0.1, 0}, {0, 0}, Harmonic{0.2, 0.5}, pi / 3 + 1e-3,
         {.sticks = 1, .stick_time = pi / 3, .x = -0.1 * cos(pi / 6) * 1e-9 / 6}),
    // So does it f + h = 0.05 + 0.05, and the hold that a start of v0^2 = 1 < 2 Delta leaves.
    rule({1, 0.05, 0.5, 0.05}, {0, 0}, Harmonic{0.2, 0.5}, pi / 3 - 1e-6, {.half_cycles = 0}),
    rule({1, 0.05, 0.5, 0.05}, {0, 0}, Harmonic{0.2, 0.5}, pi / 3 + 1e-6,
         {.passages = 0, .sticks = 1, .stick_time = pi / 3, .leaves_rest = false}),
    rule({1, 0, 0.51, 0.1}, {0, 1}, Harmonic{0.2, 0.5}, 2,
         {.half_cycles = 1, .stick_time = pi / 3}),
    rule({1, 0, 0.51, 0.2}, {0, 1}, Harmonic{0.2, 0.5}, 2, {.outcome = caught, .stop_time = 0}),
    rule({1, 0, 0.51, 0.2}, {0, 1}, HalfSine{0.2, 0.5}, {}, {.outcome = caught}),
    // What the notch catches, v0^2 = 0.01 < 2 Delta, feels the load itself; of the last but one its
    // crest is at pi/4.
    rule({1, 0.02, 0.1}, {0, 0.1}, Rectangle{-0.3, 0.5}, 1, locked_under(0.3)),
    rule({1, 0.02, 0.1}, {0, 0.1}, Rectangle{-0.3, 0.5}, {}, locked_under(0.3)),
    rule({1, 0.02, 0.1}, {0, 0.1}, HalfSine{0.3, 2}, {}, locked_under(0.3)),
    rule({1, 0.02, 0.1}, {0, 0.1}, HalfSine{0.3, 2}, 0.5, locked_under(0.3 * sin(1.0))),
    rule({1, 0.02, 0.1}, {0, 0.1}, FullSine{-0.3, 2}, 100, locked_under(0.3)),
    // A notch without any hold only takes energy: each load but 0 sets the mass free.
    rule({1, 0, 0.3, 0}, {0.25, 0}, constant(1), 6, {.passages = 1}),
    rule({1, 0, 0.3, 0}, {0, 0}, constant(1e-300), 6, {.half_cycles = 1}),
    rule({1, 0, 0.3, 0}, {0, 0}, constant(0), 6, {.half_cycles = 0}),
    // Once the load is over a rest in the notch is final.
    rule({1, 0.02, 0.3, 0.05}, {0, 0}, HalfSine{0.5, 2}, {}, {.outcome = at_zero, .rest = 0}),
    // f + h = 0.29 is felt at the release at asin(0.29 / 0.3) / 0.5; a notch that holds all of the
    // load locks from the start.
    rule({1, 0.09, 0.1, 0.2}, {0, 0}, Harmonic{0.3, 0.5}, 2.7, {.half_cycles = 1, .felt = 0.29}),
    rule({1, 0.09, 0.1, 0.25}, {0, 0}, Harmonic{0.3, 0.5}, 60, {.felt = 0.3, .locked_from = 0}),
    // W = -1, f = 0.25 from x = 0: about 0.75, turns at 1.5, back about 1.25: turns at 1 and rests.
    rule({1, 0.25, 0.4}, {0, 0}, constant(-1), 100,
         {.turns = 2, .peak = 1.5, .x = 1, .leaves_rest = true}),
    rule({1, 0.25, 0.4}, {0, 0}, constant(-0.25), 100, {.leaves_rest = false}),
    // A load that never exceeds f.
    rule({1, 0.2, 0}, {0.1, 0}, Harmonic{0.1, 3}, 50,
         {.outcome = in_dead_zone, .stop_time = 0, .rest = 0.1}),
    // W = 1 for pi, f = 0: x = -(1 - cos tau) comes to -2 with v = 0 as the pulse ends, and swings
    // on. With f = 1/8 and W = 1.125 the pulse ends at -2 again; then the peaks fall by 0.25 each:
    // eight swings end at 0 within rounding.
    rule({1, 0, 0}, {0, 0}, Rectangle{1, 1}, {}, {.outcome = never_stops, .peak = 2}),
    rule({1, 0.125, 0}, {0, 0}, Rectangle{1.125, 1}, {}, {.stop_time = 9 * pi}),
    // W = -1 holds x = 1 (no load at all) for pi; then it swings back freely, f = 0.21: peaks 0.58,
    // 0.16 of 1, and rests there. With p = 2 lengths are a quarter.
    rule({2, 0.21, 0}, {0.25, 0}, Rectangle{-1, 2}, {}, {.half_cycles = 3, .rest = 0.04}),
    rule({1, 0.21, 0}, {1, 0}, Rectangle{-1, 1}, {},
         {.half_cycles = 3, .sticks = 1, .stick_time = pi}),
    rule({1, 0.21, 0}, {1, 0}, Rectangle{-1, 1}, 50,
         {.half_cycles = 3, .sticks = 1, .stick_time = pi}),
    // From rest under W = 1 it turns at x = -2 at tau = pi: where the pulse ends, within an ulp,
    // and at
    // a sample to the last bit.
    rule({1, 0, 0}, {0, 0}, Rectangle{1, 1}, 2 * pi, {.peak = 2, .x = 2}),
    rule({1, 0, 0}, {0, 0}, Record{{1, 1, 1, 1}, pi, {}}, 3 * pi, {.peak = 2, .x = -2}),
    // One sample lasts no time.
    rule({1, 0.05, 0.01}, {0, 0}, Record{{5}, 0.01, {}}, 10,
         {.outcome = at_zero, .half_cycles = 0}),
    // Before a record begins the motion is free.
    rule({1, 0.1, 0}, {0, 1}, Record{{-0.2}, 0, {0.36}}, 0.1,
         {.end_time = 0.1, .x = sin(0.1) + 0.1 * cos(0.1) - 0.1}),
    // From x0 = 2 (f - |W|): about half of it to 0, exactly, where it neither turns nor passes.
    rule({1, 0.5, 0}, {1, 0}, constant(0), 50,
         {.half_cycles = 1, .passages = 0, .turns = 0, .x = 0}),
    rule({1, 0.625, 0}, {-1, 0}, constant(-0.125), 50,
         {.half_cycles = 1, .passages = 0, .turns = 0, .x = 0}),
    rule({1, 0.3125, 0}, {0.5, 0}, constant(0.0625), 50,
         {.half_cycles = 1, .passages = 0, .turns = 0, .x = 0}),
    // p = 1, f = 0.125 beyond |x| = 0.5, 0.375 within. From x = 2: v^2 = 4 - 0.25 - 0.25 * 1.5 =
    // 3.375 at 0.5, 3.375 + 0.25 - 0.375 = 3.25 at 0.
    rule({1, 0.125, 0}, {2, 0}, {}, 4, {.passages = 1, .arrival = sqrt(3.25), .felt = 1.875},
         {{}, {{0.5, 0.375}}}),
    // V0 = p = 1, f = 0: a start leaves the notch freely, up to x = 1, although Delta/w = 50. A
    // turn inside ends that: V0 = 0.004, w/2 = 0.005. From rest f + Delta/w = 0.1 + 0.2 hold.
    rule({1, 0, 0.5}, {0, 1}, {}, 1.6, {.peak = 1}, notch(0.01)),
    rule({1, 0, 0.5}, {0, 0.004}, {}, {}, {.outcome = in_notch, .rest = 0.004}, notch(0.01)),
    rule({1, 0.1, 0.2}, {0, 0}, constant(0.3), 10, {.half_cycles = 0}, notch(1)),
    rule({1, 0.1, 0.2}, {0, 0}, constant(0.31), 10, {.half_cycles = 1}, notch(1)),
    // From x = 1, f = 0, within w/2 = 0.1 friction 5 Delta: v^2 = 1 - x^2 - 10 Delta (0.1 - x),
    // which is 0 at 0 for Delta = 1, at 10 - sqrt(99) for 2, at 3.75 - sqrt(14.0625 + 0.25) for
    // 0.75, and 0.7 at x = 0 for 0.3.
    rule({1, 0, 1}, {1, 0}, {}, {}, {.rest = 0}, notch(0.2)),
    rule({1, 0, 2}, {1, 0}, {}, {},
         {.outcome = in_notch, .passages = 0, .turns = 1, .rest = 10 - sqrt(99.0)}, notch(0.2)),
    rule({1, 0, 0.75}, {1, 0}, {}, {},
         {.outcome = in_notch, .passages = 1, .rest = 3.75 - sqrt(14.3125)}, notch(0.2)),
    rule({1, 0, 0.3}, {1, 0}, {}, pi, {.outcome = running, .passages = 1, .arrival = sqrt(0.7)},
         notch(0.2)),
    // f = 0 within |x| < 1, 0.5 beyond: v0 = 1 comes to x = 1 with v = 0 exactly. The spring pulls
    // it back with 1 > 0, so it swings for ever between 1 and -1. From x = 1.5 with f = 1.25 to x =
    // 1 with v = 0, and there friction 2 within holds it.
    rule({1, 0.5, 0}, {0, 1}, {}, 20, {.passages = 6, .turns = 6, .peak = 1}, ice),
    rule({1, 1.25, 0}, {1.5, 0}, {}, {}, {.outcome = in_dead_zone, .rest = 1}, {{}, {{1, 2}}}),
    // From beyond it loses energy until it swings within |x| < 1, or rests outside. A notch at x =
    // 0 stops it, also after a pulse: v_k^2 = 0.81 - 0.2 (k - 1).
    rule({1, 0.5, 0}, {0, 0.9}, {}, {}, {.outcome = never_stops, .peak = 0.9}, ice),
    rule({1, 0.5, 0}, {0, 1.5}, {}, {}, {.outcome = never_stops}, ice),
    rule({1, 1.5, 0}, {1.25, 0}, {}, {}, {.outcome = in_dead_zone}, ice),
    rule({2, 0.1, 0}, {0, 1}, {}, {}, {.outcome = never_stops}, {{}, {{0.1, 0}}}),
    rule({2, 0.1, 0}, {0.05, 0}, {}, {}, {.outcome = never_stops, .felt = 0.2}, {{}, {{0.1, 0}}}),
    rule({1, 0.5, 0.1}, {0, 0.9}, {}, {},
         {.outcome = at_zero, .half_cycles = 5, .stop_time = 5 * pi}, ice),
    rule({1, 0.5, 0.1}, {0, 0}, Rectangle{0.6, 1}, {}, {.outcome = at_zero}, ice),
    // A notch stands on its zone: 0.5 within |x| < 0.2, 0.5 + 1 / 0.2 within 0.1.
    rule({1, 0.1, 1}, {0.05, 0}, constant(5.4), 1, {.half_cycles = 0}, {0.2, {{0.2, 0.5}}}),
    rule({1, 0.1, 1}, {0.05, 0}, constant(5.5), 1, {.half_cycles = 1}, {0.2, {{0.2, 0.5}}}),
    rule({1, 0.1, 1}, {0.15, 0}, constant(0.3), 1, {.half_cycles = 0}, {0.2, {{0.2, 0.5}}}),
    rule({1, 0.1, 1}, {0.15, 0}, constant(0.4), 1, {.half_cycles = 1}, {0.2, {{0.2, 0.5}}}),
    // The structure feels the friction of each zone. Of Delta/w = 1 within |x| < 0.1: at the start
    // 0.125 - 1, inside at most 1.125 + 0.1 on the way out, beyond the notch 0.125 + |x|. One that
    // is left freely is not felt: S = 0.125 + |x| at the peak. From rest it holds 1.125, and locks.
    rule({1, 0.125, 0.2}, {1, 0}, {}, 5, {.felt = 1.225}, notch(0.2)),
    rule({1, 0.125, 0.2}, {0, 1}, {}, 1.5, {.felt = std::hypot(1, 0.125)}, notch(0.2)),
    rule({1, 0.125, 0.2}, {0, 0}, Harmonic{1.1, 1}, 20,
         {.outcome = at_zero, .felt = 1.1, .locked_from = 0}, notch(0.2)),
};

BOOST_DATA_TEST_CASE(each_motion_is_the_one_by_hand, data::make(rules), rule) {
  const Known& known = rule.known;
  const ForcedResponse found =
      run(rule.oscillator, rule.start, rule.excitation, rule.t_end, rule.surface);
  if (known.outcome) {
    BOOST_TEST(found.outcome == *known.outcome);
  }
  const auto is = [](const std::optional<double>& value, const std::optional<double>& expected) {
    if (expected) {
      BOOST_TEST_REQUIRE(value.has_value());
      close(*value, *expected);
    }
  };
  is(found.half_cycles, known.half_cycles);
  is(found.zero_passages, known.passages);
  is(found.turning_points, known.turns);
  is(found.sticks, known.sticks);
  is(found.stick_time, known.stick_time);
  is(found.peak_amplitude, known.peak);
  is(found.arrival_speed, known.arrival);
  is(found.stop_time, known.stop_time);
  is(found.stop_position, known.rest);
  is(found.end_time, known.end_time);
  is(found.final_position, known.x);
  is(found.final_velocity, known.v);
  is(found.peak_absolute_acceleration, known.felt);
  is(found.locked_from, known.locked_from);
  is(found.largest_load_while_locked, known.locked_from ? known.felt : std::nullopt);
  BOOST_TEST(found.left_notch_from_rest == known.leaves_rest.value_or(found.left_notch_from_rest));
  BOOST_TEST((found.outcome != never_stops ||
              (!found.half_cycles && !found.stop_time && !found.end_time)));
}

BOOST_AUTO_TEST_CASE(a_run_can_be_watched_and_ended) {
  ForcedOptions options{.t_end = 1e6, .ask_every = 10};
  double reached = 0;
  options.go_on = [&](double tau) {
    BOOST_TEST(tau >= reached);
    reached = tau;
    return tau < 100;
  };
  const auto response = forced_response({1, 0.05, 0.01}, {0, 0.5}, Harmonic{0.2, 1}, options);
  BOOST_TEST(response.cancelled);
  BOOST_TEST(response.outcome == Outcome::running);
  BOOST_TEST(*response.end_time == reached);
  BOOST_TEST(reached < 150);
}

BOOST_AUTO_TEST_CASE(what_follows_an_excitation_is_the_free_motion_with_its_margin_and_its_limit) {
  // Held at x = 4 by f = 1, Delta = 0.5: x = 4 swings to 0 with v^2 = 8, goes on with 7 and so on.
  const Oscillator oscillator{1, 1, 0.5};
  const Response free = free_response(oscillator, {4, 0});
  const ForcedResponse forced = run(oscillator, {4, 0}, NoExcitation{}, std::nullopt);
  BOOST_TEST(forced.arrival_speed.value() == free.arrival_speed.value());
  BOOST_TEST(*forced.half_cycles == *free.half_cycles);
  BOOST_TEST(forced.decision_margin.value() == free.decision_margin.value());
  // v0^2 = 2 Delta (1 + 1e-6): that start is the nearest decision, |v0^2 - 2 Delta|/(v0^2 + 2
  // Delta).
  const ForcedResponse started =
      run({1, 1e-2, 0.5}, {0, std::sqrt(1 + 1e-6)}, NoExcitation{}, std::nullopt);
  BOOST_TEST(std::abs(started.decision_margin.value() - 0.5e-6) <= 1e-11);

  ForcedOptions options;
  options.half_cycle_limit = 10;  // f and Delta allow 100
  BOOST_CHECK_THROW((void)forced_response({1, 5e-3, 5e-3}, {1, 0}, NoExcitation{}, options),
                    TooManyHalfCycles);
}

BOOST_AUTO_TEST_CASE(a_mass_on_the_edge_of_sticking_at_the_crest_of_the_load_waits) {
  // |W + x| = k - |x0| = f to the last bit at tau = 0, where W is largest: it is released by the
  // next trough, not at once and again and again.
  const ForcedResponse held =
      until(10, {1, 0.045, 0}, {-0.0099999999999999985, 0}, Harmonic{0.055, 1, pi / 2});
  BOOST_TEST(held.end_time.value() == 10);
  BOOST_TEST(held.sticks >= 1);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
