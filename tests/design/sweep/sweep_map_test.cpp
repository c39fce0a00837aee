// SPDX-License-Identifier: MIT
#include "design/sweep/sweep_spec.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/sweep/map.hpp>

BOOST_AUTO_TEST_SUITE(sweep_map_test)

using namespace stillpoint::sweep_test;

SweepSpec spec_of(const std::string& f, const std::string& delta) {
  return free_spec(parse_axis("f", f), parse_axis("delta", delta));
}

/// The map of a sweep whose first `skipped` rows an earlier run had written.
SweepMap map_of(const SweepSpec& spec, std::int64_t skipped = 0) {
  SweepMap map(spec);
  SweepState found;
  found.rows = skipped;
  MemorySink sink(found);
  BOOST_TEST((run(spec, sink, {.map = &map}).end == SweepEnd::complete));
  return map;
}

std::uint8_t class_of(double f, double delta) {
  const Response response = free_response({.p = 1, .f = f, .delta = delta}, {.x0 = 0, .v0 = 1},
                                          FreeOptions{.times = false, .margin = false});
  return SweepClass::of(response.outcome, response.half_cycles.value_or(0));
}

BOOST_AUTO_TEST_CASE(says_of_each_cell_what_one_motion_says) {
  for (const auto& [f, delta] :
       std::vector<std::pair<std::string, std::string>>{{"0.001:0.5:40", "0:0.6:50"},
                                                        {"0.5:0.001:40", "0:0.6:50"},
                                                        {"0.001:0.5:40:log", "0.6:0.001:50:log"}}) {
    const SweepMap map = map_of(spec_of(f, delta));
    BOOST_TEST_REQUIRE(map.f().cells() == 40);
    BOOST_TEST_REQUIRE(map.delta().cells() == 50);
    BOOST_TEST(map.peaks().empty());
    BOOST_TEST(map.f().value(0) < map.f().value(39));
    BOOST_TEST(map.delta().value(0) < map.delta().value(49));
    for (std::int64_t row = 0; row < 50; ++row) {
      for (std::int64_t column = 0; column < 40; ++column) {
        const int cell = map.cells()[static_cast<std::size_t>(row * 40 + column)];
        BOOST_TEST(cell == int{class_of(map.f().value(column), map.delta().value(row))});
      }
    }
  }
}

/// Of 0.3 at most, so that more friction holds the mass from the start.
BOOST_AUTO_TEST_CASE(tells_where_the_notch_locks_from_where_it_stops) {
  SweepSpec spec = spec_of("0.02:0.4:20", "0:0.3:10");
  spec.kind = SweepKind::forced;
  spec.axes[0].axis = Axis({0});
  spec.excitation = Harmonic{.k = 0.3, .lambda = 1.3, .duration = 30};
  spec.columns = default_columns(spec);
  const SweepMap map = map_of(spec);
  int locked = 0;
  for (std::int64_t row = 0; row < 10; ++row) {
    for (std::int64_t column = 0; column < 20; ++column) {
      const ForcedResponse alone = forced_response(
          {1, map.f().value(column), map.delta().value(row)}, {0, 0}, spec.excitation);
      const int cell = map.cells()[static_cast<std::size_t>(row * 20 + column)];
      BOOST_TEST((cell == int{SweepClass::locked}) == alone.locked_from.has_value());
      BOOST_TEST(map.peaks()[static_cast<std::size_t>(row * 20 + column)] == alone.peak_amplitude);
      locked += alone.locked_from ? 1 : 0;
    }
  }
  BOOST_TEST(locked > 20);
  BOOST_TEST(locked < 180);
}

BOOST_AUTO_TEST_CASE(leaves_out_values_of_a_long_axis) {
  const SweepMap map = map_of(spec_of("0.001:0.5:5000", "0:0.6:3"));
  BOOST_TEST(map.f().cells() == 1667);  // every third of 5000
  const Axis all = parse_axis("f", "0.001:0.5:5000");
  for (const std::int64_t column : {0, 1, 700, 1666}) {
    BOOST_TEST(map.f().value(column) == all[3 * column]);
    BOOST_TEST(int{map.cells()[static_cast<std::size_t>(column)]} ==
               int{class_of(all[3 * column], 0)});
  }
}

BOOST_AUTO_TEST_CASE(is_the_same_after_a_resumed_sweep) {
  const SweepMap whole = map_of(spec_of("0.001:0.5:40", "0:0.6:50"));
  for (const std::int64_t skipped : {1, 49, 50, 777, 1999, 2000}) {
    BOOST_TEST(map_of(spec_of("0.001:0.5:40", "0:0.6:50"), skipped).cells() == whole.cells(),
               skipped);
  }
}

BOOST_AUTO_TEST_CASE(has_classes_that_tell_outcomes_and_half_cycles_apart) {
  using enum Outcome;
  const auto cls = [](Outcome outcome, double half_cycles) {
    return int{SweepClass::of(outcome, half_cycles)};
  };
  BOOST_TEST(cls(stopped_at_zero, 1) == 0);
  BOOST_TEST(cls(stopped_at_zero, 2) == 1);
  BOOST_TEST(cls(stopped_at_zero, 6) == 3);
  BOOST_TEST(cls(stopped_at_zero, 7) == 4);
  BOOST_TEST(cls(stopped_at_zero, 1e6) == 5);
  BOOST_TEST(cls(stopped_in_notch, 2) == 1);  // as near to the centre as its notch is wide
  BOOST_TEST(cls(stopped_in_dead_zone, 1) == 6);
  BOOST_TEST(cls(stopped_in_dead_zone, 15) == 10);
  BOOST_TEST(cls(caught_at_start, 0) == 12);
  BOOST_TEST(cls(stopped_in_dead_zone, 0) == 12);  // held where it was put
  BOOST_TEST(cls(never_stops, 1e300) == 13);
  BOOST_TEST(cls(running, 3) == 14);
}

BOOST_AUTO_TEST_CASE(needs_ranges_of_f_and_delta_alone) {
  for (const SweepSpec& spec : {spec_of("0.1,0.2", "0:0.6:50"), spec_of("0.1:0.2:3", "0"),
                                spec_of("0.1:0.1:3", "0:0.6:50")}) {
    BOOST_CHECK_THROW(SweepMap{spec}, InputError);
  }
  SweepSpec of_speeds = spec_of("0.1:0.2:3", "0:0.6:50");
  of_speeds.axes.front().axis = Axis({1, 2});
  test::check_refused("v0", [&] { return SweepMap{of_speeds}; });
}

BOOST_AUTO_TEST_CASE(may_be_stopped_when_the_rows_are_complete) {
  const SweepSpec spec = spec_of("0.1:0.2:3", "0:0.6:50");
  SweepMap map(spec);
  SweepState found;
  found.rows = 150;
  MemorySink sink(found);
  std::stop_source stop;
  sink.at_finish = [&stop] { stop.request_stop(); };
  BOOST_TEST(
      (run(spec, sink, {.stop = stop.get_token(), .map = &map}).end == SweepEnd::stopped_in_map));
  BOOST_TEST(sink.finished);
}

BOOST_AUTO_TEST_SUITE_END()
