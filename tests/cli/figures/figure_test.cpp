// SPDX-License-Identifier: MIT
#include "figure_map.hpp"
#include "figure_names.hpp"
#include "testing/contains.hpp"
#include "testing/printing.hpp"

#include <stillpoint/figures/figure.hpp>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(figure_test)

namespace {

using namespace stillpoint::figures;

/// One of everything, on axes that make a unit 37 pixels wide and 27 high.
Figure one_of_everything() {
  Figure figure;
  figure.id = "all";
  figure.title = "A < B & \"C\"";
  figure.description = "One of everything.";
  figure.x = {"time, s", 0, 10};
  figure.y = {"x, mm", -5, 5};
  figure.map = {2, 2, {0, 1, 1, 0}, {{"#000000", "black"}, {"#ffffff", "white"}}, {}};
  figure.bands = {{"band", 2, 4, Ink::grey}};
  figure.areas = {{"area", {{0, 0}, {1, 0}, {1, 1}}, Ink::sky},
                  {"box", {{5, 0}, {6, 0}, {6, 1}, {5, 1}}, Ink::blue, AreaLook::box},
                  {"hatched", {{7, -4}, {9, -4}, {9, -2}, {7, -2}}, Ink::grey, AreaLook::hatched}};
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

std::string golden(const std::string& name) {
  std::ifstream file(std::string(STILLPOINT_GOLDEN) + "/" + name);
  BOOST_TEST_REQUIRE(file.good(), name);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

using stillpoint::test::contains;

}  // namespace

BOOST_AUTO_TEST_SUITE(figure)

BOOST_AUTO_TEST_CASE(matches_the_golden_file) {
  Figure figure = one_of_everything();
  figure.map = {};  // its bytes are zlib's
  const std::string drawn = svg(figure, Frame::alone);
  std::ofstream("figure.svg") << drawn;
  BOOST_TEST(drawn == golden("figure.svg"),
             "look at the figure.svg that this test has written; if it is right, it is golden");
}

BOOST_AUTO_TEST_CASE(draws_points_where_the_axes_say) {
  // The plot is 370 x 270: x = 5 is at 185, y = 2.5 a quarter from the top, at 67.5.
  const std::string text = svg(one_of_everything(), Frame::in_page);
  BOOST_TEST(contains(text, "data-plot=\"66 28 370 270\""));
  BOOST_TEST(contains(text, "translate(185.00 67.50)\" data-name=\"mark\" data-at=\"5 2.5\""));
  BOOST_TEST(contains(text, "d=\"M0.00 135.00L370.00 0.00M185.00 270.00L370.00 270.00\""));
  BOOST_TEST(contains(text, "d=\"M74.00 0V270H148.00V0Z\""));
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

// Of the range of a low figure, +-0.35 by halves would be 0 alone.
BOOST_AUTO_TEST_CASE(a_low_figure_has_at_least_three_values_beside_it) {
  Figure figure = one_of_everything();
  figure.height = 160;
  figure.y = {"W", -0.37, 0.31};
  const std::string text = svg(figure, Frame::in_page);
  BOOST_TEST(contains(text, ">-0.2</text>"));
  BOOST_TEST(contains(text, ">0.2</text>"));
  figure.y = {"acceleration, g", 0, 0.65};  // by halves only 0 and 0.5
  BOOST_TEST(contains(svg(figure, Frame::in_page), ">0.4</text>"));
}

BOOST_AUTO_TEST_CASE(names_areas_where_there_is_room) {
  Figure figure = one_of_everything();
  figure.map = {};
  figure.marks = {};
  figure.areas = {{"roomy", {{0, 0}, {9, 0}, {9, 4}, {0, 4}}, Ink::sky},
                  {"too narrow", {{9.8, 0}, {9.9, 0}, {9.9, 1}, {9.8, 1}}, Ink::sky}};
  const std::string text = svg(figure, Frame::in_page);
  const std::size_t plot_ends = text.find(R"(class="frame")");
  BOOST_TEST(text.find(">roomy</text>") < plot_ends);
  BOOST_TEST(text.find(">roomy</text>") == text.rfind(">roomy</text>"));  // not in the legend
  BOOST_TEST(text.find(">too narrow</text>") > plot_ends);
}

/// A pixel is 0.027 s wide and 0.037 mm high.
BOOST_AUTO_TEST_CASE(the_legend_leaves_out_what_is_too_thin_to_see) {
  Figure figure = one_of_everything();
  figure.map = {};
  figure.areas = {{"sliver", {{0, 0}, {9, 0}, {9, 0.01}, {0, 0.01}}, Ink::sky},
                  {"pixel", {{0, 1}, {9, 1}, {9, 1.04}, {0, 1.04}}, Ink::sky},
                  {"thin", {{0, 2}, {9, 2}, {9, 2.07}, {0, 2.07}}, Ink::sky},
                  {"tiny box", {{5, 0}, {5.001, 0}, {5.001, 1}, {5, 1}}, Ink::blue, AreaLook::box}};
  figure.bands = {{"blink", 2, 2.01, Ink::grey},
                  {"often", 3, 3.01, Ink::amber},
                  {"often", 5, 5.01, Ink::amber},
                  {"often", 7, 7.01, Ink::amber}};
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

BOOST_AUTO_TEST_CASE(words_keep_clear_of_lines_and_on_their_side_of_a_limit) {
  Figure figure;
  figure.x = {"x", 0, 10};
  figure.y = {"y", 0, 10};
  figure.marks = {{"", {{5, 5}}}};
  figure.notes = {{"peak 0.5", {5, 5}}};
  // A limit 12 pixels above the mark and a line 3 below it: there is room below the line.
  figure.curves = {{.name = "limit", .strokes = {{{0, 5.4}, {10, 5.4}}}, .labelled = true},
                   {.name = "", .strokes = {{{0, 4.9}, {10, 4.9}}}}};
  const PlacedName below = placed(figure, "peak 0.5");
  BOOST_TEST(below.centre.y - 7 > 153);
  // Even a limit through the mark, half a pixel above its middle.
  figure.curves = {{.name = "limit", .strokes = {{{0, 5.02}, {10, 5.02}}}, .labelled = true}};
  BOOST_TEST(placed(figure, "peak 0.5").centre.y > 150);
  // A limit below the mark, and nothing above: there.
  figure.curves = {{.name = "limit", .strokes = {{{0, 4.6}, {10, 4.6}}}, .labelled = true}};
  BOOST_TEST(placed(figure, "peak 0.5").centre.y < 150);
}

/// Lines 12 pixels above and 12 below the mark leave no room of 16 between them, and words need two
/// more on either side.
BOOST_AUTO_TEST_CASE(a_line_leads_to_the_point_of_words_that_are_not_close_to_it) {
  Figure figure;
  figure.x = {"x", 0, 10};
  figure.y = {"y", 0, 10};
  figure.notes = {{"peak", {5, 5}}};
  BOOST_TEST(placed(figure, "peak").leader.empty());
  figure.curves = {{.name = "", .strokes = {{{0, 5.4}, {10, 5.4}}}},
                   {.name = "", .strokes = {{{0, 4.6}, {10, 4.6}}}},
                   {.name = "", .strokes = {{{0, 5}, {10, 5}}}}};
  const PlacedName away = placed(figure, "peak");
  BOOST_TEST_REQUIRE(away.leader.size() == 2U);
  BOOST_TEST(std::abs(away.leader[0].y - away.centre.y) == 8);  // the edge of the words
  BOOST_TEST(away.leader[1].x == 200);
  BOOST_TEST(away.leader[1].y == 150);
  BOOST_TEST(contains(svg(figure, Frame::in_page), "class=\"leader\""));
}

BOOST_AUTO_TEST_CASE(a_band_is_named_where_no_other_lies_on_it) {
  Figure figure;
  figure.x = {"x", 0, 10};
  figure.y = {"y", 0, 10};
  figure.bands = {{"pulse", 0, 10, Ink::sky}, {"held", 3, 7, Ink::grey}};
  BOOST_TEST(std::abs(placed(figure, "pulse").centre.x - 200) > 80);
  BOOST_TEST(std::abs(placed(figure, "held").centre.x - 200) < 20);
}

BOOST_AUTO_TEST_CASE(an_area_is_named_beside_a_line_through_it) {
  Figure figure;
  figure.x = {"x", 0, 10};
  figure.y = {"y", 0, 10};
  figure.areas = {{"centred", {{4, 0}, {6, 0}, {6, 10}, {4, 10}}, Ink::sky}};
  figure.curves = {{.name = "", .strokes = {{{0, 5}, {10, 5}}}}};
  BOOST_TEST(std::abs(placed(figure, "centred").centre.y - 150) > 7);
}

// Of 22 pixels upright words need 16, but not beside a line in the middle.
BOOST_AUTO_TEST_CASE(an_area_is_named_in_the_legend_rather_than_on_a_line) {
  Figure figure = one_of_everything();
  figure.map = {};
  figure.areas = {{"centred", {{4, -5}, {4.6, -5}, {4.6, 5}, {4, 5}}, Ink::sky}};
  figure.curves = {};
  figure.marks = {};
  figure.notes = {};
  figure.bands = {};
  BOOST_TEST(contains(svg(figure, Frame::in_page), "class=\"note\""));
  figure.curves = {{.name = "", .strokes = {{{4.3, -5}, {4.3, 5}}}}};
  const std::string text = svg(figure, Frame::in_page);
  BOOST_TEST(!contains(text, "class=\"note\""));
  BOOST_TEST(contains(text, "<text x=\"30\">centred"));
}

BOOST_AUTO_TEST_CASE(an_area_is_never_named_on_a_box) {
  Figure figure;
  figure.x = {"x", 0, 10};
  figure.y = {"y", 0, 10};
  figure.areas = {{"admissible", {{1, 0}, {9, 0}, {9, 10}, {1, 10}}, Ink::sky},
                  {"tolerance", {{1, 2}, {9, 2}, {9, 9}, {1, 9}}, Ink::blue, AreaLook::box}};
  BOOST_TEST(placed(figure, "admissible").centre.y > 240);  // below y = 2
  BOOST_TEST(placed(figure, "tolerance").centre.y < 240);
  figure.areas[1].outline = {{1, 0.3}, {9, 0.3}, {9, 9.7}, {1, 9.7}};
  BOOST_TEST(contains(svg(figure, Frame::in_page), "<text x=\"30\">admissible"));
}

/// The box hides what is below it; lines lie on it.
BOOST_AUTO_TEST_CASE(a_box_lies_between_areas_and_curves) {
  Figure figure = one_of_everything();
  figure.areas = {{"box", {{1, 2}, {9, 2}, {9, 3}, {1, 3}}, Ink::blue, AreaLook::box},
                  {"area", {{1, 0}, {9, 0}, {9, 4}, {1, 4}}, Ink::sky}};
  const std::string text = svg(figure, Frame::in_page);
  const std::size_t box = text.find("class=\"box");
  BOOST_TEST(text.find("class=\"area") < box);
  BOOST_TEST(box < text.find("class=\"curve"));
  BOOST_TEST(!contains(figure_style(), ".figure .box{fill:currentColor"));
}

BOOST_AUTO_TEST_CASE(areas_share_an_entry_of_the_key) {
  Figure figure = one_of_everything();
  figure.map = {};
  figure.areas = {{.name = "arrival 3",
                   .outline = {{1, 0}, {1.2, 0}, {1.2, 1}, {1, 1}},
                   .ink = Ink::purple,
                   .key = "arrivals 3, 6"},
                  {.name = "arrival 6",
                   .outline = {{2, 0}, {2.2, 0}, {2.2, 1}, {2, 1}},
                   .ink = Ink::purple,
                   .key = "arrivals 3, 6"}};
  const std::string text = svg(figure, Frame::in_page);
  const std::size_t entry = text.find(">arrivals 3, 6</text>");
  BOOST_TEST(entry != std::string::npos);
  BOOST_TEST(entry == text.rfind(">arrivals 3, 6</text>"));
  BOOST_TEST(!contains(text, ">arrival 6</text>"));
}

BOOST_AUTO_TEST_CASE(a_curve_without_points_is_not_in_the_key) {
  Figure figure = one_of_everything();
  figure.curves = {{"never at rest", {}, Ink::blue}};
  BOOST_TEST(!contains(svg(figure, Frame::in_page), "never at rest</text>"));
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1)) {
    ++found;
  }
  return found;
}

/// Of eight kinds, each with areas of the first between them.
BOOST_AUTO_TEST_CASE(kinds_of_hatched_areas_have_their_own_directions) {
  Figure figure = one_of_everything();
  figure.areas.clear();
  for (const char* kind : {"a", "b", "c", "d", "e", "f", "g", "h"}) {
    for (const char* name : {"a", kind}) {
      figure.areas.push_back(
          {name, {{1, 0}, {9, 0}, {9, 4}, {1, 4}}, Ink::grey, AreaLook::hatched});
    }
  }
  const std::string text = svg(figure, Frame::in_page);
  for (const char* angle : {"45", "-45", "15", "-15", "75", "-75", "0", "90"}) {
    BOOST_TEST(count(text, std::string("patternTransform=\"rotate(") + angle + ")\"") == 1U);
  }
}

/// A pixel is 0.037 mm high: the strips are 4, 20 and 1 pixels thick, the lines 7 apart.
BOOST_AUTO_TEST_CASE(a_gap_thinner_than_its_hatching_has_an_edge) {
  Figure figure = one_of_everything();
  const auto thin = [&](double high) {
    figure.areas = {
        {"gap", {{0, 1}, {9, 1}, {9, 1 + high}, {0, 1 + high}}, Ink::grey, AreaLook::hatched}};
    return contains(svg(figure, Frame::in_page), "class=\"hatched thin grey\"");
  };
  BOOST_TEST(thin(0.15));
  BOOST_TEST(!thin(0.75));
  BOOST_TEST(!thin(0.037));
}

BOOST_AUTO_TEST_CASE(arrows_do_not_pile_up) {
  Figure figure = one_of_everything();
  const std::vector<FigurePoint> line{{0, 1}, {5, 1}, {9, 1}};
  figure.curves = {{.name = "", .strokes = {line}, .directed = true}};
  const std::size_t once = count(svg(figure, Frame::in_page), "arrow");
  BOOST_TEST(once > 0U);
  figure.curves[0].strokes.push_back(line);
  BOOST_TEST(count(svg(figure, Frame::in_page), "arrow") == once);
}

/// A limit 21 pixels below the point has room on both sides, and there are lines everywhere else.
BOOST_AUTO_TEST_CASE(words_do_not_lie_on_a_limit) {
  Figure figure;
  figure.x = {"x", 0, 10};
  figure.y = {"y", 0, 10};
  figure.notes = {{"peak", {5, 5}}};
  figure.curves = {{.name = "limit", .strokes = {{{0, 4.3}, {10, 4.3}}}, .labelled = true},
                   {.name = "", .strokes = {}}};
  for (double y = 0; y < 10; y += 0.2) {
    if (std::abs(y - 4.3) > 0.6) {
      figure.curves[1].strokes.push_back({{0, y}, {10, y}});
    }
  }
  BOOST_TEST(placed(figure, "peak").centre.y <= 150);
}

/// Lines everywhere.
BOOST_AUTO_TEST_CASE(words_on_lines_have_a_ground) {
  Figure figure;
  figure.x = {"x", 0, 10};
  figure.y = {"y", 0, 10};
  figure.notes = {{"peak", {5, 5}}};
  BOOST_TEST(!placed(figure, "peak").on_lines);
  figure.curves = {{.name = "", .strokes = {}}};
  for (double y = 0; y < 10; y += 0.2) {
    figure.curves[0].strokes.push_back({{0, y}, {10, y}});
  }
  BOOST_TEST(placed(figure, "peak").on_lines);
  BOOST_TEST(contains(svg(figure, Frame::in_page), ")\"><path class=\"paper\""));
}

/// Lines leave room only far above the point and far below.
BOOST_AUTO_TEST_CASE(a_leader_keeps_clear_of_marks) {
  Figure figure;
  figure.x = {"x", 0, 10};
  figure.y = {"y", 0, 10};
  figure.notes = {{"rest", {5, 5}}};
  figure.curves = {{.name = "", .strokes = {}}};
  for (double y = 3.8; y < 6.3; y += 0.1) {
    figure.curves[0].strokes.push_back({{0, y}, {10, y}});
  }
  // Halfway along the line to the words, and so off the next one.
  const auto leader = placed(figure, "rest").leader;
  BOOST_TEST_REQUIRE(leader.size() == 2U);
  const FigurePoint middle{(leader[0].x + 200) / 2, (leader[0].y + 150) / 2};
  figure.marks = {{"", {{5, 5}, {middle.x / 40, 10 - middle.y / 30}}, Shape::cross, Ink::orange}};
  const auto next = placed(figure, "rest").leader;
  BOOST_TEST_REQUIRE(next.size() == 2U);
  const double along_x = (next[0].x - 200) / std::hypot(next[0].x - 200, next[0].y - 150);
  const double along_y = (next[0].y - 150) / std::hypot(next[0].x - 200, next[0].y - 150);
  BOOST_TEST(std::abs((middle.x - 200) * along_y - (middle.y - 150) * along_x) > 5);
}

BOOST_AUTO_TEST_CASE(marks_are_not_clipped_at_the_frame) {
  Figure figure = one_of_everything();
  figure.marks = {{"at the corner", {{0, -5}}, Shape::diamond, Ink::green}};
  const std::string text = svg(figure, Frame::in_page);
  const std::size_t pins = text.find(R"(class="plot pins" overflow="visible")");
  BOOST_TEST(pins > text.find(R"(class="frame")"));
  BOOST_TEST(pins < text.find(R"-(translate(0.00 270.00)" data-name="at the corner")-"));
}

/// Of 22 rows, of which none is the second entry yet.
FigureMap striped(std::vector<MapKey> key) {
  return {1,
          22,
          std::vector<std::uint8_t>(22, 0),
          {{"#000000", "a"}, {"#ffffff", "b", "3"}},
          std::move(key)};
}

// Turned, a digit of 10 by 14 pixels would fit a row of 12.
BOOST_AUTO_TEST_CASE(a_number_in_a_map_is_read_level) {
  Figure figure = one_of_everything();
  figure.map = striped({});
  figure.map.cells[4] = 1;
  BOOST_TEST(!contains(svg(figure, Frame::in_page), ">3</text>"));
  figure.map.cells[5] = 1;
  BOOST_TEST(contains(svg(figure, Frame::in_page), ">3</text>"));
}

BOOST_AUTO_TEST_CASE(the_key_of_a_map_explains_what_no_label_does) {
  Figure figure = one_of_everything();
  figure.map = striped({{"a", "#000000"}, {"b", "#ffffff"}});
  figure.map.cells[4] = 1;
  BOOST_TEST(contains(svg(figure, Frame::in_page), ">b</text>"));
  figure.map.cells[5] = 1;  // room for the 3
  BOOST_TEST(!contains(svg(figure, Frame::in_page), ">b</text>"));
  BOOST_TEST(contains(svg(figure, Frame::in_page), ">a</text>"));
}

/// Row 0 is the lowest.
BOOST_AUTO_TEST_CASE(the_hatching_of_a_map_ends_with_its_cells) {
  Figure figure = one_of_everything();
  const auto hatched = [&](Hatch hatch) {
    figure.map.palette[1].hatch = hatch;
    return count(svg(figure, Frame::in_page), "d=\"M1 1h1v1H1ZM0 0h1v1H0Z\"");
  };
  BOOST_TEST(hatched(Hatch::none) == 0U);
  BOOST_TEST(hatched(Hatch::one_way) == 1U);
  BOOST_TEST(hatched(Hatch::crossed) == 2U);
}

BOOST_AUTO_TEST_CASE(a_kind_with_several_areas_stays_in_the_key_of_a_map) {
  Figure figure = one_of_everything();
  figure.map = {1,
                2,
                {0, 1},
                {{"#c04a00", "too large, 1 %", "too large"}, {"#ffffff", "b"}},
                {{"too large", "#c04a00"}}};
  BOOST_TEST(count(svg(figure, Frame::in_page), ">too large</text>") == 2U);  // and in place
}

// A row is 12 pixels high, too low for the 3; two are not.
BOOST_AUTO_TEST_CASE(entries_of_a_map_with_one_label_are_one_area) {
  Figure figure = one_of_everything();
  figure.map = {1,
                22,
                std::vector<std::uint8_t>(22, 0),
                {{"#000000", "a"}, {"#ffffff", "b", "3"}, {"#888888", "c", "3"}},
                {{"b", "#ffffff"}, {"c", "#888888"}}};
  figure.map.cells[4] = 1;
  figure.map.cells[5] = 2;
  const std::string text = svg(figure, Frame::in_page);
  BOOST_TEST(contains(text, ">3</text>"));
  BOOST_TEST(!contains(text, ">b</text>"));
  BOOST_TEST(!contains(text, ">c</text>"));
}

BOOST_AUTO_TEST_CASE(a_value_in_a_map_lies_in_its_own_cells) {
  Figure figure;
  figure.x = {"x", 0, 10};
  figure.y = {"y", 0, 10};
  figure.map = {4, 1, {0, 0, 0, 0}, {{"#000000", "a"}}, {}};
  figure.map.values = {{"12", {3}}, {"34", {0, 1}}};
  const double ratio = placed(figure, "12").centre.x / placed(figure, "34").centre.x;
  BOOST_TEST(ratio > 2);  // the middles are at about 7/8 and 1/4
}

// Letters are 14 pixels high.
BOOST_AUTO_TEST_CASE(words_on_a_map_keep_clear_of_a_box) {
  Figure figure;
  figure.x = {"x", 0, 10};
  figure.y = {"y", 0, 10};
  figure.map = {1, 1, {0}, {{"#000000", "a", "label"}}, {}};
  const auto middle = placed(figure, "label").centre;
  figure.curves = {{.name = "", .strokes = {{{0, 5}, {10, 5}}}, .hover = false}};
  BOOST_TEST(std::abs(placed(figure, "label").centre.y - middle.y) >= 7);
}

BOOST_AUTO_TEST_CASE(points_to_marks_beyond_the_axes) {
  Figure figure = one_of_everything();
  figure.marks = {{"far off", {{1000, 2.5}}, Shape::disc, Ink::blue}};
  const std::string text = svg(figure, Frame::in_page);
  BOOST_TEST(contains(text, "translate(360.00 67.50)\" data-far=\"far off\""));
  BOOST_TEST(contains(text, ">far off</text>"));
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

BOOST_AUTO_TEST_CASE(smooth_curves_pass_through_their_points_with_arrows) {
  Figure figure = one_of_everything();
  figure.curves = {{.name = "circle",
                    .strokes = {{{5, 4}, {9, 0}, {5, -4}, {1, 0}}},
                    .smooth = true,
                    .directed = true}};
  const std::string text = svg(figure, Frame::in_page);
  BOOST_TEST(contains(text, "M185.00 27.00C"));
  BOOST_TEST(contains(text, " 333.00 135.00C"));
  BOOST_TEST(contains(text, "disc arrow"));
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

/// Its cells have the same colours in dark.
BOOST_AUTO_TEST_CASE(words_on_a_map_keep_their_colours) {
  Figure figure = one_of_everything();
  BOOST_TEST(contains(svg(figure, Frame::in_page), "class=\"note on-map\""));
  BOOST_TEST(contains(dark_figure_style(), ".note.on-map{fill:#222;stroke:#fff}"));
  figure.map = {};
  BOOST_TEST(!contains(svg(figure, Frame::in_page), "on-map"));
}

BOOST_AUTO_TEST_CASE(map_is_a_png) {
  // base64 of the signature and of the header's length and name.
  // 1200 = 0x4b0 pixels across and down, though it has 2 by 2 cells: they stay sharp in print.
  BOOST_TEST(map_base64(one_of_everything().map).starts_with("iVBORw0KGgoAAAANSUhEUgAABLAAAASw"));
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
