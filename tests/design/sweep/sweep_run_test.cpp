// SPDX-License-Identifier: MIT
#include "design/sweep/sweep_spec.hpp"

#include <stillpoint/core/forced_motion.hpp>

#include <chrono>
#include <cstring>
#include <thread>

BOOST_AUTO_TEST_SUITE(sweep_run_test)

using namespace stillpoint::sweep_test;
using enum Quantity;
using Fields = std::vector<std::vector<std::string>>;

Fields rows_of(const SweepSpec& spec) {
  MemorySink sink;
  const SweepSummary summary = run(spec, sink);
  BOOST_TEST((summary.end == SweepEnd::complete));
  BOOST_TEST(sink.finished);
  BOOST_TEST(summary.state.rows == sink.rows);
  return fields_of(sink.text);
}

/// Asserts that a field is the number, to the last bit; "" for none.
void check_same(const std::string& field, const std::optional<double>& number) {
  BOOST_TEST(field.empty() == !number);
  if (number && !field.empty()) {
    BOOST_TEST(std::stod(field) == *number);
  }
}

void check_response(const std::vector<std::string>& row, std::size_t first,
                    const Response& response) {
  check_same(row.at(first), response.peak_amplitude);
  check_same(row.at(first + 1), response.half_cycles);
  BOOST_TEST(row.at(first + 2) == name(response.outcome));
  check_same(row.at(first + 3), response.stop_position);
  check_same(row.at(first + 4), response.stop_time);
}

/// With a width or a hold, in zones, free and under a load.
BOOST_AUTO_TEST_CASE(in_real_notches_has_the_rows_of_one_motion) {
  for (const Quantity input : {notch_width, hold}) {
    SweepSpec spec = free_spec(Axis({0.02, 0.26}), Axis({0.02, 0.37}));
    spec.axes.push_back({input, input == hold ? Axis({0, 0.2}) : Axis({0.01, 0.2})});
    spec.zones = {{0.3, 0.05}};
    for (const Excitation& load : {Excitation(NoExcitation{}), Excitation(HalfSine{0.5, 0.7})}) {
      const bool is_forced = load.index() > 0;
      spec.kind = is_forced ? SweepKind::forced : SweepKind::free;
      spec.excitation = load;
      spec.columns = default_columns(spec, true);
      const Fields rows = rows_of(spec);
      BOOST_TEST_REQUIRE(rows.size() == 9U);
      for (std::size_t i = 1; i < 9; ++i) {
        const auto value = [&](std::size_t column) { return std::stod(rows[i][column]); };
        Oscillator oscillator{.p = 1, .f = value(0), .delta = value(1)};
        Surface surface{{}, spec.zones};
        (input == hold ? oscillator.hold : surface.notch_width) = value(2);
        const ForcedResponse motion = forced_response(oscillator, {0, 1}, load, {}, surface);
        check_response(rows[i], 3, motion);
        const auto column = std::ranges::find(rows[0], "peak_absolute_acceleration");
        BOOST_TEST_REQUIRE((column != rows[0].end()));
        check_same(rows[i].at(static_cast<std::size_t>(column - rows[0].begin())),
                   motion.peak_absolute_acceleration);
        if (is_forced) {
          check_same(rows[i].at(9), motion.final_position);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(as_npy_has_packed_records) {
  SweepSpec spec = free_spec(Axis({0.1, 0.2}), Axis({0.7}));
  spec.format = RowFormat::npy;
  spec.columns = {f, outcome};
  MemorySink sink;
  run(spec, sink);
  BOOST_TEST(sink.text.starts_with(std::string("\x93NUMPY\x01\x00", 8)));
  const std::size_t header = sink.text.find('\n') + 1;
  BOOST_TEST(header % 64 == 0U);
  BOOST_TEST_REQUIRE(sink.text.size() == header + 2 * 9);
  double value = 0;
  std::memcpy(&value, sink.text.data() + header + 9, sizeof(value));
  BOOST_TEST(value == 0.2);
  // delta = 0.7 > v0^2 / 2 catches the mass at once: outcome 3.
  BOOST_TEST(sink.text.back() == '\x03');
  // With a width it stops in the notch: outcome 6.
  spec.axes.push_back({notch_width, Axis({0.1})});
  MemorySink in_notch;
  BOOST_TEST(run(spec, in_notch).state.outcomes.at(6) == 2);
  BOOST_TEST(in_notch.text.back() == '\x06');
}

BOOST_AUTO_TEST_CASE(every_outcome_has_a_number_of_its_own) {
  for (std::size_t i = 0; i < sweep_outcome_count; ++i) {
    if (const auto outcome = motion_outcome(i)) {
      BOOST_TEST(sweep_outcome(*outcome) == i);
      BOOST_TEST(sweep_outcome_name(i) == name(*outcome));
    } else {
      BOOST_TEST(i == too_many_half_cycles);
    }
  }
  BOOST_TEST(sweep_outcome_name(5) == "too_many_half_cycles");  // in files since before the notches
  BOOST_TEST(sweep_outcome_name(6) == "stopped_in_notch");
}

BOOST_AUTO_TEST_CASE(tells_its_progress_and_stops_when_asked) {
  const SweepSpec spec = free_spec(Axis(1e-4, 1, 1'000'000, Axis::Spacing::linear),
                                   Axis(1e-4, 1, 1'000'000, Axis::Spacing::linear));
  MemorySink sink;
  std::stop_source stop;
  std::int64_t told = 0;
  const auto progress = [&](const SweepState& state) {
    BOOST_TEST(state.rows > told);
    told = state.rows;
    if (told > 1000) {
      stop.request_stop();
    }
  };
  const SweepSummary summary = run(spec, sink, {.stop = stop.get_token(), .progress = progress});
  BOOST_TEST((summary.end == SweepEnd::stopped));
  BOOST_TEST(summary.state.rows == told);
  BOOST_TEST(static_cast<std::int64_t>(fields_of(sink.text).size()) == told + 1);  // and a header
  BOOST_TEST(!sink.finished);
}

// Its first block would take days.
BOOST_AUTO_TEST_CASE(of_slow_motions_stops_within_its_first_block) {
  SweepSpec spec = free_spec(Axis({5e-11}), Axis(1e-13, 2e-13, 10000, Axis::Spacing::linear));
  spec.half_cycle_limit = 1e11;
  MemorySink sink;
  std::stop_source stop;
  const std::jthread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    stop.request_stop();
  });
  const SweepSummary summary = run(spec, sink, {.stop = stop.get_token()});
  BOOST_TEST((summary.end == SweepEnd::stopped));
  BOOST_TEST(summary.state.rows == 0);
}

BOOST_AUTO_TEST_CASE(refuses_a_spec_that_is_not_valid) {
  MemorySink sink;
  BOOST_CHECK_THROW(run(free_spec(Axis({-1}), Axis({0})), sink), InputError);
  BOOST_TEST(sink.text.empty());
}

BOOST_AUTO_TEST_SUITE_END()
