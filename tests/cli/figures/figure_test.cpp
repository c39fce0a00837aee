// SPDX-License-Identifier: MIT
#include "figure_parts.hpp"
#include "figure_sheet.hpp"
#include "figure_words.hpp"
#include "testing/contains.hpp"
#include "testing/folder.hpp"
#include "testing/printing.hpp"

#include <stillpoint/figures/figure.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <random>

BOOST_AUTO_TEST_SUITE(figure_test)

using namespace stillpoint::figures;

/// On axes that make a unit 37 pixels wide and 27 high.
Figure empty() {
  Figure figure;
  figure.id = "all";
  figure.title = "A < B & \"C\"";
  figure.description = "One of everything.";
  figure.x = {"time, s", 0, 10};
  figure.y = {"x, mm", -5, 5};
  return figure;
}

Figure one_of_everything() {
  Figure figure = empty();
  figure.map = {2, 2, {0, 1, 1, 0}, {{"#000000", "black"}, {"#ffffff", "white"}}, {}};
  figure.areas = {{"area", {{0, 0}, {1, 0}, {1, 1}}, Ink::sky},
                  {"box", {{5, 0}, {6, 0}, {6, 1}, {5, 1}}, Ink::blue, AreaLook::box},
                  {"hatched", {{7, -4}, {9, -4}, {9, -2}, {7, -2}}, Ink::grey, AreaLook::hatched}};
  figure.add_band("band", 2, 4, Ink::grey);
  figure.curves = {{"curve", {{{0, 0}, {10, 5}}, {{5, -5}, {10, -5}}}, Ink::orange, Dash::dashed}};
  figure.marks = {{"mark", {{5, 2.5}}, Shape::diamond, Ink::green},
                  {"hollow", {{1, -1}}, Shape::disc, Ink::blue, Fill::hollow},
                  {"square", {{2, -1}}, Shape::square, Ink::grey},
                  {"star", {{3, -1}}, Shape::star, Ink::orange},
                  {"triangle", {{4, -1}}, Shape::triangle, Ink::purple},
                  {"wedge", {{5, -1}}, Shape::wedge, Ink::amber},
                  {"cross", {{6, -1}}, Shape::cross, Ink::sky}};
  figure.notes = {{"note", {1, 3}}};
  return figure;
}

/// Its rows are 12 pixels high: too low for a label on one, not on two.
Figure map_of_kinds() {
  Figure figure = empty();
  figure.id = "map";
  figure.map = {2,
                22,
                std::vector<std::uint8_t>(44, 0),
                {{"#ffffff", "a"},
                 {"#88ccee", "b", "3"},
                 {"#4488aa", "c", "3"},
                 {"#c04a00", "too large, 1 %", "too large", Hatch::one_way},
                 {"#222222", "alone", "alone", Hatch::crossed}},
                {{"#ffffff", "a"},
                 {"#88ccee", "b"},
                 {"#c04a00", "too large", "", Hatch::one_way},
                 {"#222222", "alone", "", Hatch::crossed}}};
  for (const auto& [from, to, entry] :
       {std::array{4, 8, 1}, {8, 12, 2}, {20, 30, 3}, {42, 43, 4}}) {
    std::fill(figure.map.cells.begin() + from, figure.map.cells.begin() + to, entry);
  }
  figure.curves = {{.name = "", .strokes = {{{0, -1}, {10, -1}}}, .hover = false}};
  return figure;
}

/// A loop with arrows, a limit, a peak between lines, strips of one key, a gap thinner than its
/// hatching, a mark beyond the axes, and a part enlarged.
Figure lines_and_words() {
  Figure figure = empty();
  figure.id = "lines";
  figure.areas = {{.name = "3",
                   .outline = {{1, -5}, {1.2, -5}, {1.2, 5}, {1, 5}},
                   .ink = Ink::purple,
                   .key = "arrivals 3, 6"},
                  {.name = "6",
                   .outline = {{2, -5}, {2.2, -5}, {2.2, 5}, {2, 5}},
                   .ink = Ink::purple,
                   .key = "arrivals 3, 6"},
                  {"gap", {{0, 4}, {9, 4}, {9, 4.15}, {0, 4.15}}, Ink::grey, AreaLook::hatched},
                  {"other gap", {{7, 1}, {9, 1}, {9, 3}, {7, 3}}, Ink::grey, AreaLook::hatched}};
  const std::vector<FigurePoint> loop{{5, 2}, {6, 0}, {5, -2}, {4, 0}, {5, 2}};
  figure.curves = {{.name = "loop", .strokes = {loop, loop}, .directed = true},
                   {.name = "limit 2.5",
                    .strokes = {{{0, 2.5}, {10, 2.5}}},
                    .dash = Dash::dashed,
                    .labelled = true},
                   {.name = "", .strokes = {{{0, 1.6}, {10, 1.6}}}, .ink = Ink::orange},
                   {"never", {}, Ink::amber}};
  figure.marks = {{"far off", {{1000, -4}}}, {"turn", {{5, 2}}, Shape::diamond, Ink::green}};
  figure.notes = {{"peak 2", {5, 2}}};
  figure.inset = {{"", 4.9, 5.1}, {"", 1.9, 2.1}};
  return figure;
}

using stillpoint::test::contains;

BOOST_AUTO_TEST_SUITE(figure)

BOOST_AUTO_TEST_CASE(matches_the_golden_file) {
  Figure figure = one_of_everything();
  figure.map = {};
  static const std::regex bytes("base64,[^\"]*");  // of an image are zlib's
  for (const auto& [name, shown] : {std::pair{std::string("figure.svg"), figure},
                                    {"map.svg", map_of_kinds()},
                                    {"lines.svg", lines_and_words()}}) {
    const std::string drawn = svg(shown, Frame::alone);
    std::ofstream(name) << drawn;
    BOOST_TEST(
        std::regex_replace(drawn, bytes, "base64,") ==
            stillpoint::test::text_of(STILLPOINT_GOLDEN "/" + name),
        "look at the " << name << " that this test has written; if it is right, it is golden");
  }
}

/// Random lines, areas, bands and points. A peak is named off them, or on a ground.
BOOST_AUTO_TEST_CASE(words_have_room_of_their_own) {
  std::mt19937_64 random(20'261'127);
  const auto place = [&random] { return std::uniform_real_distribution<double>(0, 10)(random); };
  const auto point = [&place] { return FigurePoint{place(), place()}; };
  int led = 0;
  for (int i = 0; i < 300; ++i) {
    Figure figure;
    figure.x = {"x", 0, 10};
    figure.y = {"y", 0, 10};
    for (auto k = random() % 4; k > 0; --k) {
      figure.notes.push_back({"peak " + std::to_string(k), point()});
      figure.marks.push_back({"", {figure.notes.back().at}});
    }
    for (auto k = random() % 30; k > 0; --k) {
      figure.curves.push_back({.name = k < 3 ? "limit " + std::to_string(k) : "",
                               .strokes = {{{0, place()}, {10, place()}}},
                               .labelled = k < 3});
    }
    for (auto k = random() % 4; k > 0; --k) {
      const FigurePoint at = point();
      const FigurePoint to = point();
      figure.areas.push_back({.name = "area " + std::to_string(k),
                              .outline = {at, {to.x, at.y}, to, {at.x, to.y}},
                              .look = k == 1 ? AreaLook::box : AreaLook::filled});
    }
    if (i % 2 == 0) {
      const auto [from, to] = std::minmax({place(), place()});
      figure.add_band("band", from, to, Ink::grey);
    }
    if (i % 3 == 0) {
      const FigurePoint at = point();
      figure.marks.push_back({"far", {{1000, at.y}}});
      figure.inset = {{"", at.x, at.x + 0.1}, {"", at.y, at.y + 0.1}};
    }
    const auto names = names_in_place(figure, {figure.x, figure.y, 400, 300});
    const auto& words = names.words;
    for (std::size_t now = 0; now < words.size(); ++now) {
      const auto& [text, centre, upright, leader, on_lines] = words[now];
      const auto reach = [](const PlacedName& name) {
        const FigurePoint level{text_width(name.text) / 2, text_height / 2};
        return name.upright ? FigurePoint{level.y, level.x} : level;
      };
      const FigurePoint half = reach(words[now]);
      BOOST_TEST_CONTEXT("figure " << i << ", " << text << " at " << centre.x << ", " << centre.y) {
        BOOST_TEST((centre.x >= half.x - 1 && centre.x <= 401 - half.x));
        BOOST_TEST((centre.y >= half.y - 1 && centre.y <= 301 - half.y));
        BOOST_TEST((!names.inset || centre.x + half.x < names.inset->left + 4 ||
                    centre.x - half.x > names.inset->right - 4 ||
                    centre.y + half.y < names.inset->top + 4 ||
                    centre.y - half.y > names.inset->bottom - 4));
        for (std::size_t other = 0; other < now; ++other) {
          const FigurePoint beside = reach(words[other]);
          BOOST_TEST((std::abs(centre.x - words[other].centre.x) > half.x + beside.x - 2 ||
                      std::abs(centre.y - words[other].centre.y) > half.y + beside.y - 2),
                     words[other].text);
        }
        for (const FigureCurve& curve : figure.curves) {
          for (double x = centre.x - half.x + 2;
               text.starts_with("peak") && !on_lines && x < centre.x + half.x - 2; ++x) {
            const auto& ends = curve.strokes.front();
            const double y = 300 - 30 * (ends[0].y + x / 400 * (ends[1].y - ends[0].y));
            BOOST_TEST(std::abs(y - centre.y) > half.y - 2, "on a line");
          }
        }
        led += leader.empty() ? 0 : 1;
      }
    }
  }
  BOOST_TEST(led > 20);
}

BOOST_AUTO_TEST_CASE(draws_points_where_the_axes_say) {
  // The plot is 370 x 270: x = 5 is at 185, y = 2.5 a quarter from the top, at 67.5.
  const std::string text = svg(one_of_everything(), Frame::in_page);
  BOOST_TEST(contains(text, "data-plot=\"66 28 370 270\""));
  BOOST_TEST(contains(text, "translate(185.00 67.50)\" data-name=\"mark\" data-at=\"5 2.5\""));
  BOOST_TEST(contains(text, "d=\"M0.00 135.00L370.00 0.00M185.00 270.00L370.00 270.00\""));
  BOOST_TEST(contains(text, "d=\"M74.00 270.00L148.00 270.00L148.00 0.00L74.00 0.00Z\""));
}

BOOST_AUTO_TEST_CASE(has_round_ticks) {
  BOOST_TEST(ticks({"", 0, 10}) == (std::vector<double>{0, 2, 4, 6, 8, 10}),
             boost::test_tools::per_element());
  BOOST_TEST(ticks({"", -0.5, 1.2}) == (std::vector<double>{-0.5, 0, 0.5, 1}),
             boost::test_tools::per_element());
  for (const double scale : {1e-300, 1e-9, 3.0, 7e20, 1e300}) {
    const auto list = ticks({"", -0.3 * scale, 0.9 * scale});
    BOOST_TEST(list.size() >= 3U);
    BOOST_TEST(list.size() <= 8U);
  }
}

BOOST_AUTO_TEST_CASE(has_powers_of_ten_as_ticks_of_a_logarithmic_axis) {
  using enum Scale;
  BOOST_TEST(ticks({"", 2e-3, 5, logarithmic}) == (std::vector<double>{1e-2, 1e-1, 1}),
             boost::test_tools::per_element());
  BOOST_TEST(ticks({"", 1e-16, 1, logarithmic}) ==
                 (std::vector<double>{1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 1}),
             boost::test_tools::per_element());
  BOOST_TEST(ticks({"", 2, 11, logarithmic}) == (std::vector<double>{2, 4, 6, 8, 10}),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(places_values_by_the_scale_of_their_axis) {
  const FigureAxis axis{"", 1e-4, 1e4, Scale::logarithmic};
  BOOST_TEST(axis.position(1) == 0.5);
  BOOST_TEST(axis.position(0) == -1);
  BOOST_TEST(axis.value(0.75) == 100, boost::test_tools::tolerance(1e-15));
  Figure figure = one_of_everything();
  figure.x = axis;
  figure.marks[0].points[0].x = 1;
  BOOST_TEST(contains(svg(figure, Frame::in_page), "translate(185.00 67.50)"));
}

/// Six digits would not distinguish 0.3 and 0.3000001, and 1e150 would be too long written out.
BOOST_AUTO_TEST_CASE(ticks_are_told_apart_and_stay_within_the_figure) {
  const auto narrow = tick_labels(ticks({"", 0.3, 0.3000001}));
  BOOST_TEST_REQUIRE(narrow.size() >= 3U);
  for (std::size_t i = 1; i < narrow.size(); ++i) {
    BOOST_TEST(narrow[i] != narrow[i - 1]);
  }
  BOOST_TEST(narrow[1] == "0.30000002");
  // The second of these is short by chance.
  BOOST_TEST(tick_labels({0.35355339, 0.3535534}).front() == "0.35355339");
  BOOST_TEST(tick_labels({0, 1e150}).back() == "1e+150");
  BOOST_TEST(tick_labels({0, 1e5}).back() == "100000");
  Figure figure = one_of_everything();
  figure.y = {"", 0, 1};
  const double usual = plot_left(figure);
  figure.y = {"y", 0.3, 0.3000001};
  constexpr double digit = 8;                        // the width of one of 13 pixels at least
  BOOST_TEST(plot_left(figure) >= 14 + 10 * digit);  // beside the name of the axis
  BOOST_TEST(plot_left(figure) > usual);
}

// Wide letters of 13 pixels reach 12 above their baseline and 3 below it.
BOOST_AUTO_TEST_CASE(labels_keep_clear_of_each_other_at_the_corner) {
  Figure figure = one_of_everything();
  figure.x = {"f", 0.319, 0.369};
  figure.y = {"delta", 0, 0.5};
  const std::string wide = svg(figure, Frame::in_page);
  BOOST_TEST(contains(wide, "y=\"315\" text-anchor=\"middle\">0.32</text>"));
  BOOST_TEST(contains(wide, "y=\"299.00\" text-anchor=\"end\">0</text>"));
  figure.x = {"f", 0, 0.5};
  const std::string narrow = svg(figure, Frame::in_page);
  BOOST_TEST(contains(narrow, "y=\"315\" text-anchor=\"middle\">0</text>"));
  BOOST_TEST(contains(narrow, "y=\"302.00\" text-anchor=\"end\">0</text>"));
}

/// A pixel is 0.027 s wide and 0.037 mm high.
BOOST_AUTO_TEST_CASE(the_legend_leaves_out_what_is_too_thin_to_see) {
  Figure figure = one_of_everything();
  figure.map = {};
  figure.areas = {{"sliver", {{0, 0}, {9, 0}, {9, 0.01}, {0, 0.01}}, Ink::sky},
                  {"pixel", {{0, 1}, {9, 1}, {9, 1.04}, {0, 1.04}}, Ink::sky},
                  {"thin", {{0, 2}, {9, 2}, {9, 2.07}, {0, 2.07}}, Ink::sky},
                  {"tiny box", {{5, 0}, {5.001, 0}, {5.001, 1}, {5, 1}}, Ink::blue, AreaLook::box}};
  figure.add_band("blink", 2, 2.01, Ink::grey);
  for (const double from : {3, 5, 7}) {
    figure.add_band("often", from, from + 0.02, Ink::amber);
  }
  const std::string text = svg(figure, Frame::in_page);
  for (const char* name : {"thin", "tiny box", "often"}) {
    BOOST_TEST(contains(text, "<text x=\"30\">" + std::string(name)), name);
  }
  for (const char* name : {"sliver", "pixel", "blink"}) {
    BOOST_TEST(!contains(text, "<text x=\"30\">" + std::string(name)), name);
  }
}

// 400 pixels by 300 with 10 by 10 units: y = 5 is 150 pixels from the top.
PlacedName placed(const Figure& figure, const std::string& text) {
  const auto words = names_in_place(figure, {figure.x, figure.y, 400, 300}).words;
  const auto found = std::ranges::find(words, text, &PlacedName::text);
  BOOST_TEST_REQUIRE((found != words.end()), text);
  return *found;
}

BOOST_AUTO_TEST_CASE(draws_an_inset_outside_the_plot_that_zooms) {
  Figure figure = one_of_everything();
  figure.inset = {{"", 4.9, 5.1}, {"", 2.4, 2.6}};
  const std::string text = svg(figure, Frame::in_page);
  BOOST_TEST(text.find("class=\"inset\"") > text.find(R"(class="frame")"));
  BOOST_TEST(!contains(svg(one_of_everything(), Frame::in_page), "class=\"inset\""));
  // What the inset shows may reach beyond the frame; what is drawn around it does not.
  figure.inset = {{"", -1e3, 5.1}, {"", -1e3, 1e3}};
  const std::string beyond = svg(figure, Frame::in_page);
  const std::string lens = beyond.substr(beyond.find("class=\"lens\" d="));
  BOOST_TEST_REQUIRE(lens.size() < beyond.size());
  BOOST_TEST(!contains(lens.substr(0, lens.find("/>")), "-"));
}

BOOST_AUTO_TEST_CASE(prose_does_not_break_numbers_or_short_equations) {
  BOOST_TEST(prose("a peak of 9.8 m/s2") == "a peak of 9.8\u00a0m/s\u00b2");
  BOOST_TEST(prose("takes 6 \u00b5s") == "takes 6\u00a0\u00b5s");
  BOOST_TEST(prose("rest at x = 0") == "rest at x\u00a0=\u00a00");
  BOOST_TEST(prose("delta = 0.03 = 5.9 mm") == "delta\u00a0=\u00a00.03 =\u00a05.9\u00a0mm");
  BOOST_TEST(prose("needs f >= f2 = 0.5, x <= 1") ==
             "needs f\u00a0\u2265\u00a0f2\u00a0=\u00a00.5, x\u00a0\u2264\u00a01");
  BOOST_TEST(prose("inside (f + delta/w)") == "inside (f\u00a0+\u00a0delta/w)");
  BOOST_TEST(prose("--delta-max keeps it small") ==
             "<span class=\"number\">--delta-max</span> keeps it small");
  BOOST_TEST(prose("off by 6.2e-09, or -3") ==
             "off by <span class=\"number\">6.2e-09,</span> or -3");
  BOOST_TEST(prose("(EN 1998-2)") == "<span class=\"number\">(EN\u00a01998-2)</span>");
  BOOST_TEST(prose("off by +-5 %") == "off by \u00b15\u00a0%");
  BOOST_TEST(prose("half-cycles of part P25-N5 < x = y") ==
             "half-cycles of part P25-N5\u00a0&lt;\u00a0x = y");
}

BOOST_AUTO_TEST_CASE(sheet_draws_every_figure_and_one_legend) {
  Figure other = one_of_everything();
  other.id = "other";
  const std::string text = svg(FigureSheet{"sheet", "Both", "Two.", {one_of_everything(), other}});
  BOOST_TEST(contains(text, "all-title"));
  BOOST_TEST(contains(text, "x=\"450\" y=\""));
  const std::string entry = ">mark</text>";
  BOOST_TEST(contains(text, entry));
  BOOST_TEST(text.find(entry) == text.rfind(entry));
}

BOOST_AUTO_TEST_CASE(has_an_axis_around_values_that_are_all_the_same) {
  for (const double value : {0.0, 3.0, -2.0}) {
    const FigureAxis axis = axis_around("", value, value);
    BOOST_TEST(axis.least < value);
    BOOST_TEST(axis.most > value);
  }
  BOOST_TEST(axis_around("", 0, 0).most == 1);
}

BOOST_AUTO_TEST_CASE(map_is_a_png) {
  // base64 of the signature and of the header's length and name.
  // 1200 = 0x4b0 pixels across and down, though it has 2 by 2 cells: they stay sharp in print.
  BOOST_TEST(map_base64(one_of_everything().map).starts_with("iVBORw0KGgoAAAANSUhEUgAABLAAAASw"));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
