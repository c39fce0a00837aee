// SPDX-License-Identifier: MIT
#include "testing/test.hpp"

#include <stillpoint/report/sweep.hpp>
#include <stillpoint/sweep/open_rows.hpp>
#include <stillpoint/sweep/run.hpp>
#include <stillpoint/sweep/spec.hpp>

BOOST_AUTO_TEST_SUITE(sweep_figure_test)

BOOST_AUTO_TEST_CASE(has_the_values_in_the_middle_of_their_cells) {
  using namespace stillpoint;
  using sweep::Quantity;
  using test::contains;
  sweep::SweepSpec spec;
  spec.axes = {{Quantity::v0, sweep::Axis({1})},
               {Quantity::p, sweep::Axis({1})},
               {Quantity::x0, sweep::Axis({0})},
               {Quantity::f, sweep::parse_axis("f", "0.1:0.4:4")},
               {Quantity::delta, sweep::parse_axis("delta", "0.01:1:3:log")}};
  spec.columns = sweep::default_columns(spec);
  spec.output = "/dev/null";
  report::SweepReport report{spec};
  report.map.emplace(spec);
  report.summary = sweep::run(spec, *sweep::open_rows(spec), {.map = &*report.map});
  const figures::Figure figure = page(report).figures.at(0);
  BOOST_TEST(figure.x.least == 0.05, tt::tolerance(1e-12));
  BOOST_TEST(figure.x.most == 0.45, tt::tolerance(1e-12));
  BOOST_TEST(figure.y.position(0.1) == 0.5, tt::tolerance(1e-12));
  BOOST_TEST(figure.y.position(0.01) == 1 / 6.0, tt::tolerance(1e-12));
  // The key has two colours, of which one is hatched, and that of dampers whose notch holds the
  // mass; numbers, or words, stand in the areas.
  BOOST_TEST_REQUIRE(figure.map.key.size() == 3U);
  BOOST_TEST(figure.map.key[0].name == "stops at x = 0");
  BOOST_TEST(!figure.map.key[0].hatched);
  BOOST_TEST(figure.map.key[1].name == "stops off centre");
  BOOST_TEST(figure.map.key[1].hatched);
  BOOST_TEST(figure.map.labels.at(0) == "1");
  BOOST_TEST(figure.map.labels.at(sweep::SweepClass::ranges * 2) == "never starts");
  BOOST_TEST(figure.caption ==
             "The mass stops at x = 0 in blue areas and off centre in hatched ones, the darker the "
             "fewer half-cycles it takes; the lines are bounds from theory of a stop on the first "
             "return.");
  // The boundaries of the first return are those of the paper's notch.
  BOOST_TEST(!figure.curves.empty());
  report.spec.axes.push_back({Quantity::notch_width, sweep::Axis({0.1})});
  const figures::Figure built = page(report).figures.at(0);
  BOOST_TEST(built.curves.empty());
  BOOST_TEST(built.map.key[0].name == "stops in the notch");
}

BOOST_AUTO_TEST_SUITE_END()
