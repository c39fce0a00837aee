// SPDX-License-Identifier: MIT
#include "readout.hpp"

// Wheel, drag and double click. Axes are read off the ticks, as a reader does.

namespace {

using namespace stillpoint::browser_test;
using nlohmann::json;

constexpr double tick_digits_pixels = 0.5;  // the error of eight-digit ticks, and of pixels

/// How far a place is beyond a box; negative inside.
double beyond(const json& box, const json& place) {
  const double x = place[0];
  const double y = place[1];
  return std::max({box["left"].get<double>() - x, x - box["right"].get<double>(),
                   box["top"].get<double>() - y, y - box["bottom"].get<double>()});
}

/// The ticks lie on one line for each axis, and all marks where that line says; those beyond the
/// frame are hidden.
void check_consistent(const json& state) {
  const TickedAxis x(state, "x");
  const TickedAxis y(state, "y");
  for (const json& tick : state["ticks"]) {
    const TickedAxis& axis = tick["axis"] == "x" ? x : y;
    BOOST_TEST(
        std::abs(axis.place(tick["value"]) - tick["seen"].get<double>()) <= tick_digits_pixels,
        tick.dump());
  }
  for (const json& mark : state["marks"]) {
    check_near(mark["seen"], json{x.place(mark["at"][0]), y.place(mark["at"][1])},
               2 * tick_digits_pixels);
    const double out = beyond(state["frame"], mark["seen"]);
    BOOST_TEST((mark["hidden"] == (out > 0) || std::abs(out) < 1), mark.dump());
  }
}

/// The value at a place, by the ticks.
json values_at(const json& state, const json& place) {
  return {TickedAxis(state, "x").value(place[0]), TickedAxis(state, "y").value(place[1])};
}

/// The second state shows at place + by what the first shows at the place.
void check_moved(const json& from, const json& to, const json& place, const json& by) {
  const json values = values_at(from, place);
  const TickedAxis x(to, "x");
  const TickedAxis y(to, "y");
  check_near(json{x.place(values[0]), y.place(values[1])},
             json{place[0].get<double>() + by[0].get<double>(),
                  place[1].get<double>() + by[1].get<double>()},
             2 * tick_digits_pixels);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(zooming)

BOOST_AUTO_TEST_CASE(zooms_about_itself) {
  for_each_ticked_figure([](const json& figure) {
    const json& zoom = figure["zoom"];
    BOOST_TEST(zoom["taken_without_key"] == false);  // the page scrolls
    BOOST_TEST(zoom["without_key"] == zoom["before"]);
    BOOST_TEST(zoom["taken"] == true);
    check_consistent(zoom["zoomed"]);
    check_moved(zoom["before"], zoom["zoomed"], zoom["anchor"], {0, 0});
    for (const char* axis : {"x", "y"}) {
      const double growth =
          TickedAxis(zoom["zoomed"], axis).slope() / TickedAxis(zoom["before"], axis).slope();
      BOOST_TEST(growth > 2);
      BOOST_TEST(growth < 10);
    }
    check_shown(zoom["hover"], zoom["zoomed"], figure["rest"]["marks"].empty() ? 50 : 1);
  });
}

BOOST_AUTO_TEST_CASE(drags_the_plot) {
  for_each_ticked_figure([](const json& figure) {
    const json& zoom = figure["zoom"];
    check_consistent(zoom["dragged"]);
    check_moved(zoom["zoomed"], zoom["dragged"], zoom["anchor"], zoom["by"]);
    BOOST_TEST(zoom["let_go"] == zoom["dragged"]);
    BOOST_TEST(zoom["lost"] == zoom["dragged"]);
  });
}

BOOST_AUTO_TEST_CASE(returns_to_the_whole) {
  for_each_figure([](const json& figure) {
    const json& zoom = figure["zoom"];
    BOOST_TEST(zoom["restored"] == zoom["before"]);
    // The page scrolls then.
    BOOST_TEST(zoom["taken_at_whole"] == false);
    BOOST_TEST(zoom["taken_outside"] == false);
  });
}

BOOST_AUTO_TEST_SUITE_END()
