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
  const auto refused = [](const char* field, const std::function<void(SweepSpec&)>& spoil) {
    SweepSpec spec = small();
    spoil(spec);
    check_refused(spec, field);
  };
  const auto with = [](Quantity input, const std::vector<double>& values) {
    return [=](SweepSpec& spec) { spec.axes.push_back({input, Axis(values)}); };
  };
  refused("delta", [](auto& spec) { spec.axes.pop_back(); });  // missing
  refused("f", with(f, {1}));                                  // twice
  refused("beta", with(beta, {1}));                            // not an input of a motion
  refused("columns", [](auto& spec) { spec.columns = {}; });
  refused("columns", [](auto& spec) { spec.columns = {sticks}; });  // of forced motions only
  refused("columns", [](auto& spec) { spec.columns = {hold}; });    // not given
  refused("notch-width", with(notch_width, {0.1, 0}));
  refused("hold", with(hold, {0.1, -0.1}));
  SweepSpec wide = small();
  with(notch_width, {0.1})(wide);
  require_valid(wide);
  with(hold, {0.1})(wide);
  check_refused(wide, "hold");  // a width holds by its friction
  refused("friction-zones 2: to", [](auto& spec) { spec.zones = {{0.2, 0.1}, {0.1, 0.1}}; });
  refused("threads", [](auto& spec) { spec.threads = 0; });
  refused("half-cycle-limit", [](auto& spec) { spec.half_cycle_limit = 0; });
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
