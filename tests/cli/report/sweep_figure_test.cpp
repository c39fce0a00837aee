// SPDX-License-Identifier: MIT
#include "design/sweep/sweep_spec.hpp"

#include <stillpoint/report/sweep.hpp>
#include <stillpoint/sweep/open_rows.hpp>

BOOST_AUTO_TEST_SUITE(sweep_figure_test)

using namespace stillpoint;
using figures::Hatch;
using sweep::Quantity;
using test::contains;

report::SweepReport report_of(const sweep::SweepSpec& spec) {
  report::SweepReport report{spec};
  report.map.emplace(spec);
  report.summary = sweep::run(spec, *sweep::open_rows(spec), {.map = &*report.map});
  return report;
}

/// Of a hit with V0 = p = 1 from x = 0.
report::SweepReport swept(std::string_view f, std::string_view delta) {
  sweep::SweepSpec spec =
      sweep_test::free_spec(sweep::parse_axis("f", f), sweep::parse_axis("delta", delta));
  spec.columns = sweep::default_columns(spec);
  spec.output = "/dev/null";
  return report_of(spec);
}

/// By a load of 0.3 at most.
report::SweepReport shaken(std::string_view f, std::string_view delta) {
  sweep::SweepSpec spec = swept(f, delta).spec;
  spec.kind = sweep::SweepKind::forced;
  spec.axes[0].axis = sweep::Axis({0});
  spec.excitation = Harmonic{.k = 0.3, .lambda = 1.3, .duration = 30};
  spec.columns = sweep::default_columns(spec);
  return report_of(spec);
}

BOOST_AUTO_TEST_CASE(has_the_values_in_the_middle_of_their_cells) {
  report::SweepReport report = swept("0.1:0.4:4", "0.01:1:3:log");
  const figures::Figure figure = page(report).figures.at(0);
  BOOST_TEST(figure.x.least == 0.05, tt::tolerance(1e-12));
  BOOST_TEST(figure.x.most == 0.45, tt::tolerance(1e-12));
  BOOST_TEST(figure.y.position(0.1) == 0.5, tt::tolerance(1e-12));
  BOOST_TEST(figure.y.position(0.01) == 1 / 6.0, tt::tolerance(1e-12));
  BOOST_TEST(figure.x.label == "constant friction f");
  BOOST_TEST(figure.y.label == "point friction Δ (log scale)");
  // The key has two colours, of which one is hatched, and each that occurs; numbers, or words,
  // stand in the areas.
  const std::set<std::uint8_t> shades(figure.map.cells.begin(), figure.map.cells.end());
  BOOST_TEST_REQUIRE(figure.map.key.size() == 2 + shades.size());
  BOOST_TEST(figure.map.key[0].name == "stops at x = 0");
  BOOST_TEST((figure.map.key[0].hatch == Hatch::none));
  BOOST_TEST(figure.map.key[1].name == "stops off centre");
  BOOST_TEST((figure.map.key[1].hatch == Hatch::one_way));
  BOOST_TEST(figure.map.palette.at(0).label == "1");
  BOOST_TEST(figure.map.palette.at(sweep::SweepClass::ranges * 2).label == "never starts");
  // The boundaries of the first return are those of the paper's notch.
  BOOST_TEST(!figure.curves.empty());
  report.spec.axes.push_back({Quantity::notch_width, sweep::Axis({0.1})});
  const figures::Figure built = page(report).figures.at(0);
  BOOST_TEST(built.curves.empty());
  BOOST_TEST(built.map.key[0].name == "stops in the notch");
  for (const Quantity beyond : {Quantity::damping, Quantity::breakaway}) {
    report.spec.axes.back() = {beyond, sweep::Axis({1.5})};
    BOOST_TEST(page(report).figures.at(0).curves.empty());
  }
}

/// Delta2 is 0.5; the middle of the last row is at 0.49 or 0.52, its edge beyond 0.5.
BOOST_AUTO_TEST_CASE(draws_no_edge_in_the_last_half_of_a_cell) {
  for (const bool beyond : {false, true}) {
    const figures::Figure drawn =
        page(swept("0.1:0.4:4", beyond ? "0.1:0.52:4" : "0.1:0.49:4")).figures.at(0);
    BOOST_TEST(drawn.y.most > 0.5);
    BOOST_TEST(std::ranges::count(drawn.curves, "held ↑", &figures::FigureCurve::name) == beyond);
  }
}

BOOST_AUTO_TEST_CASE(has_no_swatch_twice_in_its_key_and_no_shade_of_a_few_cells) {
  const figures::FigureMap map = page(swept("0.01:0.6:40", "0:0.6:40")).figures.at(0).map;
  std::set<std::string> swatches;
  for (const auto& entry : map.key) {
    BOOST_TEST(swatches.insert(entry.colour).second, entry.name);
    const auto index =
        std::ranges::find(map.palette, entry.name, &figures::MapShade::name) - map.palette.begin();
    const auto cells = std::ranges::count(map.cells, index);
    BOOST_TEST((entry.name.starts_with("stops ") || cells > 32), entry.name);
  }
  BOOST_TEST(map.palette.at(0).name == "centred after 1 half-cycle");
  BOOST_TEST(contains(map.palette.at(4).name, " half-cycles"));
}

BOOST_AUTO_TEST_CASE(has_an_entry_of_its_own_where_the_notch_locks) {
  const figures::Figure figure = page(shaken("0.02:0.4:20", "0:0.3:10")).figures.at(0);
  const auto lock = std::ranges::find(figure.map.key, "locked at x = 0", &figures::MapShade::name);
  BOOST_TEST_REQUIRE((lock != figure.map.key.end()));
  BOOST_TEST((lock->hatch == Hatch::crossed));
  BOOST_TEST(contains(svg(figure, figures::Frame::in_page), ">locked at x = 0</text>"));
  BOOST_TEST(std::ranges::count(figure.map.key, Hatch::crossed, &figures::MapShade::hatch) == 3);
}

/// Under a load that locks most of them; each shade has peaks above those of the one before.
BOOST_AUTO_TEST_CASE(shades_motions_that_lock_by_their_peaks) {
  const report::SweepReport report = shaken("0.02:0.28:20", "0.01:0.3:10");
  const sweep::SweepMap& map = report.map.value();
  const figures::Figure figure = page(report).figures.at(0);
  std::map<std::uint8_t, Interval> peaks;
  for (std::size_t i = 0; i < map.cells().size(); ++i) {
    if (map.cells()[i] == sweep::SweepClass::locked) {
      const double peak = map.peaks()[i];
      const auto [at, first] = peaks.try_emplace(figure.map.cells[i], Interval{peak, peak});
      at->second = {std::min(at->second.low, peak), std::max(at->second.high, peak)};
    }
  }
  BOOST_TEST_REQUIRE(peaks.size() > 3);
  BOOST_TEST(peaks.begin()->first >= sweep::SweepClass::count);
  BOOST_TEST((std::ranges::adjacent_find(peaks, [](const auto& one, const auto& next) {
                return one.second.high > next.second.low;
              }) == peaks.end()));
  BOOST_TEST(std::ranges::any_of(figure.map.key, [](const figures::MapShade& key) {
    return key.hatch == Hatch::crossed && key.name.starts_with("locked, peak from ");
  }));
  // Not 0, which is the peak of what never moves.
  BOOST_TEST(std::ranges::none_of(figure.map.key, [](const figures::MapShade& key) {
    return key.name.ends_with("peak from 0");
  }));
}

/// "locked, peak 0.10 to 0.30", rounded inwards by a fiftieth of their distance at most, or "up to
/// 0.30".
BOOST_AUTO_TEST_CASE(numbers_in_areas_hold_for_all_of_their_cells) {
  const report::SweepReport report = shaken("0.02:0.28:20", "0:0.3:10");
  const figures::FigureMap map = page(report).figures.at(0).map;
  std::set<std::string> met;
  for (std::size_t cell = 0; cell < map.cells.size(); ++cell) {
    const figures::MapShade& shade = map.palette[map.cells[cell]];
    const std::size_t peak_at = shade.name.find(", peak ");
    if (peak_at != std::string::npos) {
      const std::string range = shade.name.substr(peak_at + 7);
      const double peak = report.map->peaks()[cell];
      const double most = std::stod(range.substr(range.find("to ") + 3));
      const double least = range.starts_with("up") ? 0 : std::stod(range);
      const double rounding = 0.02 * (most - least) / 0.96;
      BOOST_TEST(least <= peak + rounding, range << " of " << peak);
      BOOST_TEST(peak <= most + rounding, range << " of " << peak);
      BOOST_TEST((shade.label == range || most <= 1.1 * least + rounding), shade.label);
      met.insert(range);
    }
  }
  BOOST_TEST(met.size() > 3U);
}

BOOST_AUTO_TEST_SUITE_END()
