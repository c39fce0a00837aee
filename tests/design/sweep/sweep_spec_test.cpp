// SPDX-License-Identifier: MIT
#include "design/sweep/sweep_spec.hpp"

BOOST_AUTO_TEST_SUITE(sweep_spec_test)

using namespace stillpoint::sweep_test;
using enum Quantity;

void check_refused(const SweepSpec& spec, const char* field) {
  test::check_refused(field, [&] { require_valid(spec); });
}

SweepSpec small() {
  return free_spec(Axis({0.1, 0.2}), Axis({0, 0.3, 0.4}));
}

BOOST_AUTO_TEST_CASE(of_a_grid_counts_its_entries) {
  require_valid(small());
  BOOST_TEST(entries(small()).value() == 6);
  BOOST_TEST(varies(small(), f));
  BOOST_TEST(!varies(small(), v0));
}

BOOST_AUTO_TEST_CASE(default_columns_are_what_varies_and_the_results) {
  BOOST_TEST((default_columns(small()) ==
              std::vector{f, delta, peak_amplitude, half_cycles, outcome, stop_position}));
  SweepSpec design;
  design.kind = SweepKind::design;
  design.axes = {{v0, Axis({1})}, {p, Axis({1})}, {beta, Axis({0.8, 0.9})}};
  BOOST_TEST((default_columns(design, true) == std::vector{beta, feasible, f, delta, tolerance,
                                                           peak_amplitude, stop_time,
                                                           peak_absolute_acceleration}));
  // It is not a formula where the notch has a width.
  SweepSpec built = small();
  built.axes.push_back({notch_width, Axis({0.1})});
  BOOST_TEST((default_columns(built).back() == peak_absolute_acceleration));
}

BOOST_AUTO_TEST_CASE(columns_are_read_by_name) {
  BOOST_TEST((parse_columns("stop-time,f", SweepKind::free) == std::vector{stop_time, f}));
  for (const char* wrong : {"", "f,", "sticks", "beta", "f,f"}) {
    BOOST_CHECK_THROW(static_cast<void>(parse_columns(wrong, SweepKind::free)), InputError);
  }
}

BOOST_AUTO_TEST_CASE(that_is_not_valid_names_the_field) {
  SweepSpec spec = small();
  spec.axes.pop_back();
  check_refused(spec, "delta");  // missing

  spec = small();
  spec.axes.push_back({f, Axis({1})});
  check_refused(spec, "f");  // twice

  spec = small();
  spec.axes.push_back({beta, Axis({1})});
  check_refused(spec, "beta");  // not an input of a motion

  spec = small();
  spec.columns = {};
  check_refused(spec, "columns");
  spec.columns = {sticks};
  check_refused(spec, "columns");  // of forced motions only

  spec.columns = {hold};
  check_refused(spec, "columns");  // not given

  spec = small();
  spec.axes.push_back({notch_width, Axis({0.1, 0})});
  check_refused(spec, "notch-width");
  spec.axes.back().axis = Axis({0.1});
  require_valid(spec);
  spec.axes.push_back({hold, Axis({0.1})});
  check_refused(spec, "hold");  // a width holds by its friction
  spec = small();
  spec.axes.push_back({hold, Axis({0.1, -0.1})});
  check_refused(spec, "hold");
  spec = small();
  spec.zones = {{0.2, 0.1}, {0.1, 0.1}};
  check_refused(spec, "friction-zones 2: to");

  spec = small();
  spec.threads = 0;
  check_refused(spec, "threads");

  spec = small();
  spec.half_cycle_limit = 0;
  check_refused(spec, "half-cycle-limit");

  check_refused(free_spec(Axis({0.1, -0.1}), Axis({0})), "f");  // a corner
  const Axis long_axis(0, 1, 1'000'000'000, Axis::Spacing::linear);
  check_refused(free_spec(long_axis, long_axis), "delta");  // 1e18 entries
}

BOOST_FIXTURE_TEST_CASE(beside_a_list_gives_one_value_of_each_other_input, Folder) {
  write("list.csv", "f,delta\n0.1,0.2\n");
  SweepSpec spec = small();
  spec.list = std::make_shared<List>(path("list.csv"));
  check_refused(spec, "f");  // a column as well

  spec.axes = {{v0, Axis({1, 2})}, {p, Axis({1})}, {x0, Axis({0})}};
  check_refused(spec, "v0");  // two values
  spec.axes.front() = {v0, Axis({1})};
  require_valid(spec);
  BOOST_TEST(!entries(spec));
  BOOST_TEST(varies(spec, f));
}

BOOST_AUTO_TEST_SUITE_END()
