// SPDX-License-Identifier: MIT
#include "testing/test.hpp"

#include <stillpoint/report/sweep.hpp>
#include <stillpoint/sweep/open_rows.hpp>
#include <stillpoint/sweep/run.hpp>
#include <stillpoint/sweep/spec.hpp>

#include <set>

BOOST_AUTO_TEST_SUITE(sweep_figure_test)

using namespace stillpoint;
using sweep::Quantity;
using test::contains;

namespace {

/// Of a hit with V0 = p = 1 from x = 0.
report::SweepReport swept(std::string_view f, std::string_view delta) {
  sweep::SweepSpec spec;
  spec.axes = {{Quantity::v0, sweep::Axis({1})},
               {Quantity::p, sweep::Axis({1})},
               {Quantity::x0, sweep::Axis({0})},
               {Quantity::f, sweep::parse_axis("f", f)},
               {Quantity::delta, sweep::parse_axis("delta", delta)}};
  spec.columns = sweep::default_columns(spec);
  spec.output = "/dev/null";
  report::SweepReport report{spec};
  report.map.emplace(spec);
  report.summary = sweep::run(spec, *sweep::open_rows(spec), {.map = &*report.map});
  return report;
}

}  // namespace

BOOST_AUTO_TEST_CASE(has_the_values_in_the_middle_of_their_cells) {
  report::SweepReport report = swept("0.1:0.4:4", "0.01:1:3:log");
  const figures::Figure figure = page(report).figures.at(0);
  BOOST_TEST(figure.x.least == 0.05, tt::tolerance(1e-12));
  BOOST_TEST(figure.x.most == 0.45, tt::tolerance(1e-12));
  BOOST_TEST(figure.y.position(0.1) == 0.5, tt::tolerance(1e-12));
  BOOST_TEST(figure.y.position(0.01) == 1 / 6.0, tt::tolerance(1e-12));
  BOOST_TEST(figure.x.label == "constant friction f");
  BOOST_TEST(figure.y.label == "point friction Δ (log scale)");
  BOOST_TEST(contains(text(document(report), {.verbosity = report::Verbosity::full}),
                      "0.01 to 1, 3 values in equal ratios"));
  // The key has two colours, of which one is hatched, and each that occurs; numbers, or words,
  // stand in the areas.
  const std::set<std::uint8_t> shades(figure.map.cells.begin(), figure.map.cells.end());
  BOOST_TEST_REQUIRE(figure.map.key.size() == 2 + shades.size());
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

// At f = 0.1 Delta1 is 0.324 published and 0.319 exact, by (26) and (27) of docs/theory.md.
BOOST_AUTO_TEST_CASE(says_where_the_bound_is_that_it_does_not_show) {
  const auto caption = [](std::string_view delta) {
    return page(swept("0.0999:0.1001:3", delta)).figures.at(0).caption;
  };
  BOOST_TEST(contains(caption("0.3235:0.3245:3"), "the line is a bound"));
  BOOST_TEST(contains(caption("0.3235:0.3245:3"), "; Δ₁ exact lies below the figure."));
  BOOST_TEST(contains(caption("0.3185:0.3195:3"), "; Δ₁ published lies above the figure."));
  BOOST_TEST(!contains(caption("0.318:0.325:3"), "the figure"));
  BOOST_TEST(contains(caption("0:0.5:3"), "; the lowest row is Δ = 0, without a notch."));
}

BOOST_AUTO_TEST_CASE(names_the_record) {
  report::SweepReport report = swept("0.1:0.4:4", "0.01:1:3");
  report.spec.kind = sweep::SweepKind::forced;
  report.record = "kobe.AT2";
  BOOST_TEST(contains(text(document(report), {.verbosity = report::Verbosity::full}), "kobe.AT2"));
}

BOOST_AUTO_TEST_SUITE_END()
