// SPDX-License-Identifier: MIT
#include "motion.hpp"

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(forced_half_cycles_test)

constexpr std::int64_t all = 1'000'000;

struct Case {
  const char* name;
  Oscillator oscillator;
  Start start;
  Excitation excitation;
  double t_end;
};

/// Growing, sticking, shaken by a record, by a pulse and out of rest; with a notch and without.
std::vector<Case> runs() {
  return {{"resonance", {1, 0.05, 0.01}, {0, 0.5}, Harmonic{0.2, 1}, 200},
          {"sticks", {1, 0.18, 0}, {0, 0.5}, Harmonic{0.2, 0.35}, 200},
          {"record", {1, 0.05, 0}, {0, 0}, record_s5(), 59.98},
          {"record with a notch", {1, 0.05, 0.001}, {0, 0.5}, record_s5(), 59.98},
          {"pulse", {2, 0.1, 0.01}, {0.3, -1}, HalfSine{0.5, 3}, 100},
          {"short pulse", {1, 0.05, 0.02}, {0, 0}, Rectangle{4, 20}, 100},
          {"from aside", {1, 0, 0.03}, {-0.7, 0}, FullSine{0.5, 2}, 100}};
}

std::vector<HalfCycle> list_of(const Case& run, std::int64_t most = all) {
  return forced_half_cycles(run.oscillator, run.start, run.excitation, run.t_end, most);
}

void follow_one_another(const Case& run, const std::vector<HalfCycle>& list) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    const HalfCycle& now = list[i];
    BOOST_TEST(now.index == static_cast<std::int64_t>(i) + 1);
    BOOST_TEST(now.last == (i + 1 == list.size()));
    BOOST_TEST(now.start_time <= now.peak_time);
    BOOST_TEST(now.peak_time <= now.end_time);
    BOOST_TEST(std::abs(now.side) == 1);
    BOOST_TEST((now.arrival_speed || now.last));
    if (i > 0) {
      const HalfCycle& before = list[i - 1];
      BOOST_TEST(now.start_time == before.end_time);
      BOOST_TEST(before.end_position == 0);
      BOOST_TEST(now.side == -before.side);
      const double left = std::pow(*before.arrival_speed, 2) - 2 * run.oscillator.delta;
      close(std::pow(now.departure_speed, 2), left, 1e-12);
      close(*before.impulse, *before.arrival_speed - now.departure_speed, 1e-12);
    }
    BOOST_TEST(now.impulse.has_value() == now.arrival_speed.has_value());
  }
}

/// Peaks as soon as the peak is reached, not when a stick there ends. Returns how many stick.
int lie_on_the_path(const Case& run, const std::vector<HalfCycle>& list) {
  int stuck = 0;
  const ForcedTrajectory path(run.oscillator, run.start, run.excitation, {run.t_end});
  for (const HalfCycle& now : list) {
    close(path.at(now.peak_time).x, now.side * now.peak, 1e-13);
    close(path.at(now.end_time).x, now.end_position, 1e-13);
    // Nothing between its ends is farther out, or on the other side.
    const double start = now.index == 1 ? std::abs(run.start.x0) : 0;
    for (int i = 1; i < 20; ++i) {
      const double tau = now.start_time + (now.end_time - now.start_time) * i / 20;
      const double x = path.at(tau).x * now.side;
      BOOST_TEST(x <= now.peak + 1e-13);
      BOOST_TEST(x >= -start - 1e-13);
    }
    const auto first = std::ranges::find_if(path.events(), [&](const Event& event) {
      return event.state.tau >= now.start_time && std::abs(event.state.x) == now.peak;
    });
    BOOST_TEST_REQUIRE((first != path.events().end()));
    BOOST_TEST(now.peak_time == first->state.tau);
    stuck += std::next(first)->kind == EventKind::stick ? 1 : 0;
  }
  return stuck;
}

/// The largest peak and the end are those of the metrics.
void are_the_ones_that_the_metrics_count(const Case& run, const std::vector<HalfCycle>& list) {
  const auto response =
      forced_response(run.oscillator, run.start, run.excitation, {.t_end = run.t_end});
  BOOST_TEST(static_cast<double>(list.size()) == *response.half_cycles);
  BOOST_TEST(std::ranges::max(list, {}, &HalfCycle::peak).peak == response.peak_amplitude);
  BOOST_TEST(list.back().end_time == *response.end_time);
  BOOST_TEST(list.back().end_position == *response.final_position);
}

BOOST_AUTO_TEST_CASE(are_those_of_the_motion_and_as_many_as_asked_are_the_first_of_all) {
  int stuck = 0;
  for (const Case& run : runs()) {
    BOOST_TEST_CONTEXT(run.name) {
      const auto whole = list_of(run);
      BOOST_TEST_REQUIRE(whole.size() > 1U);
      follow_one_another(run, whole);
      stuck += lie_on_the_path(run, whole);
      are_the_ones_that_the_metrics_count(run, whole);
      for (const std::size_t most :
           {std::size_t{0}, std::size_t{1}, whole.size() - 1, whole.size(), whole.size() + 1}) {
        const auto some = list_of(run, static_cast<std::int64_t>(most));
        BOOST_TEST_REQUIRE(some.size() == std::min(most, whole.size()));
        BOOST_TEST(std::equal(some.begin(), some.end(), whole.begin()));
      }
    }
  }
  BOOST_TEST(stuck > 10);
}

// Without friction the mass comes back with the speed 1 at pi. The notch takes the energy 0.5,
// which stops it, and lets it go when the load exceeds 1.5: the structure felt the whole stop.
BOOST_AUTO_TEST_CASE(a_stop_in_a_notch_that_lets_go_is_felt_whole) {
  Record late{{0, 0, 2, 2}, 0, {0, 4, 5, 20}};
  const auto list = forced_half_cycles({1, 0, 0.5, 1.5}, {0, 1}, late, 20, all);
  BOOST_TEST_REQUIRE(list.size() > 1U);
  close(*list[0].arrival_speed, 1, 1e-14);
  BOOST_TEST(*list[0].impulse == *list[0].arrival_speed);
  BOOST_TEST(list[1].departure_speed == 0);
  // A notch with a width is felt as an acceleration.
  for (const HalfCycle& now :
       forced_half_cycles({1, 0.02, 0.02}, {0, 1}, NoExcitation{}, 50, all, {}, {0.1, {}})) {
    BOOST_TEST(!now.impulse);
  }
}

BOOST_AUTO_TEST_CASE(end_with_the_final_rest_not_with_the_load_that_proves_it_final) {
  Dice dice(1);
  int under_load = 0;
  for (int i = 0; i < 2000; ++i) {
    const ForcedScene<> scene = random_forced_scene(dice);
    const auto response = forced_response(scene.motion.oscillator(), scene.motion.start(),
                                          scene.excitation, {.t_end = scene.t_end});
    const auto list = forced_half_cycles(scene.motion.oscillator(), scene.motion.start(),
                                         scene.excitation, scene.t_end, all);
    if (!list.empty() && response.stop_time) {
      under_load += !(*response.stop_time >= duration(scene.excitation)) ? 1 : 0;
      BOOST_TEST(list.back().end_time == *response.stop_time, scene);
      BOOST_TEST(list.back().end_position == *response.stop_position, scene);
    }
  }
  BOOST_TEST(under_load > 10);
}

BOOST_AUTO_TEST_CASE(of_a_motion_left_at_a_passage_end_with_one_of_no_length) {
  int left_there = 0;
  for (int i = 1; i <= 20; ++i) {
    const Start start{0, 0.2 + 0.1 * i};
    for (const double delta : {0.0, 0.01}) {
      const Case run{"", {1, 0.05, delta}, start, Harmonic{0.2, 1}, 20};
      const HalfCycle first = list_of(run, 1).front();
      const auto list =
          forced_half_cycles(run.oscillator, start, run.excitation, first.end_time, all);
      if (list.size() == 2 && list[1].peak == 0) {  // otherwise rounding leaves it just before
        ++left_there;
        BOOST_TEST(list[1].side == -first.side);
        BOOST_TEST(list[1].peak_time == first.end_time);
        BOOST_TEST(list[1].end_time == first.end_time);
        BOOST_TEST(list[1].last);
      }
    }
  }
  BOOST_TEST(left_there > 5);
}

BOOST_AUTO_TEST_CASE(of_a_free_motion_are_those_of_the_walk) {
  const Oscillator oscillator{1.5, 0.02, 0.01};
  for (const Start& start : {Start{0, 1}, Start{0.3, 0.5}, Start{0.3, -0.5}, Start{2, 0}}) {
    const auto expected = first_half_cycles(oscillator, start, all);
    for (const Excitation& nothing :
         {Excitation(NoExcitation{}), Excitation(Harmonic{0, 1}), Excitation(Rectangle{0, 1}),
          Excitation(Record{{0, 0, 0}, 1, {}})}) {
      const auto list = forced_half_cycles(oscillator, start, nothing, 1000, all);
      BOOST_TEST_REQUIRE(list.size() == expected.size());
      for (std::size_t i = 0; i < list.size(); ++i) {
        BOOST_TEST(list[i].side == expected[i].side);
        for (const auto member :
             {&HalfCycle::start_time, &HalfCycle::departure_speed, &HalfCycle::peak_time,
              &HalfCycle::peak, &HalfCycle::end_time, &HalfCycle::end_position}) {
          close(list[i].*member, expected[i].*member, 1e-12);
        }
        BOOST_TEST(list[i].arrival_speed.has_value() == expected[i].arrival_speed.has_value());
        close(list[i].arrival_speed.value_or(0), expected[i].arrival_speed.value_or(0), 1e-12);
        BOOST_TEST(list[i].last == expected[i].last);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(run_no_further_than_the_last_that_is_listed) {
  // A run to the end would take days.
  const auto list = forced_half_cycles({1, 0.05, 0.01}, {0, 0.5}, Harmonic{0.2, 1}, 1e14, 5);
  BOOST_TEST(list.size() == 5U);
  BOOST_TEST(forced_half_cycles({1, 0.05, 0}, {0, 0.5}, Harmonic{0.2, 1}, 1e14, 0).empty());
}

BOOST_AUTO_TEST_CASE(end_where_asked) {
  double reached = 0;
  int asked = 0;
  const auto until_third_question = [&](double tau) {
    BOOST_TEST(tau > reached);
    reached = tau;
    return ++asked < 3;
  };
  const auto list = forced_half_cycles({1, 0.05, 0.01}, {0, 0.5}, Harmonic{0.2, 1}, 1e14, all,
                                       until_third_question);
  BOOST_TEST(asked == 3);
  BOOST_TEST_REQUIRE(!list.empty());
  BOOST_TEST(list.back().end_time <= reached);
  BOOST_TEST(list.size() < 10'000U);
}

BOOST_AUTO_TEST_CASE(a_mass_that_stays_has_none) {
  // Held by friction, held by the notch, not shaken.
  BOOST_TEST(forced_half_cycles({1, 0.3, 0.1}, {0, 0}, Harmonic{0.2, 1}, 50, all).empty());
  BOOST_TEST(forced_half_cycles({1, 0.1, 0.6}, {0, 1}, Harmonic{9, 1}, 50, all).empty());
  BOOST_TEST(forced_half_cycles({1, 0.1, 0.1}, {0.05, 0}, NoExcitation{}, 50, all).empty());
}

BOOST_AUTO_TEST_CASE(more_than_are_allowed_refuse_the_motion) {
  const auto run = [](std::optional<double> limit) {
    return *forced_response({1, 0.05, 0.01}, {0, 0.5}, Harmonic{0.2, 1},
                            {.t_end = 200, .half_cycle_limit = limit})
                .half_cycles;
  };
  const double half_cycles = run({});
  BOOST_TEST(half_cycles > 50);
  BOOST_TEST(run(half_cycles) == half_cycles);
  BOOST_CHECK_THROW(run(half_cycles - 1), TooManyHalfCycles);
  BOOST_CHECK_THROW(run(0), InputError);
}

// Held until k sin(lambda tau) balances friction and spring: from rest at x0 until
// k sin(lambda tau) = f - p^2 |x0|, where the motion goes inwards, or f + p^2 |x0|, outwards.
BOOST_AUTO_TEST_CASE(of_a_mass_held_from_its_start_begin_at_the_release) {
  const Harmonic load{0.3, 0.5};
  const auto first = [&](const Oscillator& oscillator, const Start& start) {
    return forced_half_cycles(oscillator, start, load, 20, 1).front();
  };
  const HalfCycle at_zero = first({1, 0.06, 0}, {0, 0});
  BOOST_TEST(std::abs(at_zero.start_time - 2 * std::asin(0.06 / 0.3)) <= 1e-14);
  BOOST_TEST(at_zero.peak_time > at_zero.start_time);
  const HalfCycle inwards = first({1, 0.06, 0}, {0.05, 0});
  BOOST_TEST(std::abs(inwards.start_time - 2 * std::asin(0.01 / 0.3)) <= 1e-14);
  BOOST_TEST(inwards.peak_time == inwards.start_time);
  BOOST_TEST(inwards.peak == 0.05);
  const HalfCycle outwards = first({1, 0.06, 0}, {-0.05, 0});
  BOOST_TEST(std::abs(outwards.start_time - 2 * std::asin(0.11 / 0.3)) <= 1e-14);
  BOOST_TEST(outwards.peak_time > outwards.start_time);
  // A hit that the notch caught leaves with no speed; one that moves the mass starts at once.
  const HalfCycle freed = first({1, 0.02, 0.1, 0.1}, {0, 0.1});
  BOOST_TEST(std::abs(freed.start_time - 2 * std::asin(0.12 / 0.3)) <= 1e-14);
  BOOST_TEST(freed.departure_speed == 0);
  BOOST_TEST(first({1, 0.06, 0}, {0, 1}).start_time == 0);
}

BOOST_AUTO_TEST_CASE(of_wrong_input_are_refused) {
  for (const double t_end : {0.0, std::numeric_limits<double>::infinity()}) {
    check_refused("t_end", [&] {
      (void)forced_half_cycles({1, 0, 0}, {0, 1}, NoExcitation{}, t_end, all);
    });
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
