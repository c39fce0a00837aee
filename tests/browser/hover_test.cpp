// SPDX-License-Identifier: MIT
#include "readout.hpp"

#include <limits>

// What the page shows under a mouse.

namespace {

using namespace stillpoint::browser_test;
using nlohmann::json;

constexpr double region_samples = 2.5;        // pixels from a point of a curve to its next sample
constexpr double motion_samples = 12;         // the same, of 60 samples a period
constexpr double hundredth_of_a_unit = 1e-3;  // two decimals of about 300 units, for values near 1

/// "centred after 7–15" for instance, of 15 half-cycles and a rest at x = 0.
bool is_named(const MapRow& row, const std::string& name) {
  static const std::regex form(
      R"((centred|off centre) after (\d+)(–(\d+)| or more)? half-cycles?)");
  std::smatch parts;
  if (!std::regex_match(name, parts, form)) {
    return false;
  }
  const double first = std::stod(parts[2]);
  const double last = parts[4].matched   ? std::stod(parts[4])
                      : parts[3].matched ? std::numeric_limits<double>::infinity()
                                         : first;
  return (parts[1] == "centred") == (row.outcome == "stopped_at_zero") &&
         first <= row.half_cycles && row.half_cycles <= last;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hovering)

BOOST_AUTO_TEST_CASE(shows_the_values_of_marks) {
  for_each_ticked_figure([](const json& figure) {
    for (const json& hover : figure["hover_marks"]) {
      const auto readout = check_shown(hover, figure["rest"], 1);
      BOOST_TEST((readout && !readout->name.empty()));
      BOOST_TEST(!hover["ring"].is_null());
    }
  });
}

BOOST_AUTO_TEST_CASE(shows_the_bounds_of_the_report) {
  for (const char* look : {"1280", "400"}) {
    const json& figure = seen(Scheme::light)["design"][look]["figures"]["region"];
    const auto name = [&figure](std::size_t i) {
      const auto readout = check_shown(figure["hover_asked"][i], figure["rest"], region_samples);
      return readout ? readout->name : "nothing";
    };
    BOOST_TEST(name(0) == "least Δ (Δ₁ published)");
    BOOST_TEST(name(1) == "least Δ (Δ₁ exact)");
  }
}

BOOST_AUTO_TEST_CASE(shows_the_first_arc) {
  // Of the page "free": x = sin t - f (1 - cos t), x' its derivative, and energy 1/2 - f x is left.
  constexpr double f = 0.02;
  const auto x_at = [](double t) { return std::sin(t) - f * (1 - std::cos(t)); };
  for (const char* look : {"1280", "400"}) {
    const json& figures = seen(Scheme::light)["free"][look]["figures"];
    const auto shown = [&figures](const char* id) {
      const json& figure = figures[id];
      const auto readout = check_shown(figure["hover_asked"][0], figure["rest"], motion_samples);
      BOOST_TEST_REQUIRE(readout.has_value());
      return *readout;
    };
    const Readout motion = shown("motion");
    BOOST_TEST(motion.name == "x");
    BOOST_TEST(std::abs(motion.y - x_at(motion.x)) <= hundredth_of_a_unit);
    const Readout phase = shown("phase");
    BOOST_TEST(phase.name == "motion");
    const double energy = (phase.x * phase.x + phase.y * phase.y) / 2;
    BOOST_TEST(std::abs(energy - (0.5 - f * phase.x)) <= hundredth_of_a_unit);
    const Readout left = shown("energy");
    BOOST_TEST(std::abs(left.y - (0.5 - f * x_at(left.x))) <= hundredth_of_a_unit);
  }
}

BOOST_AUTO_TEST_CASE(shows_what_a_cell_of_a_map_stands_for) {
  const auto rows = map_rows();
  for (const char* look : {"1280", "400"}) {
    const json& hovers = seen(Scheme::light)["sweep"][look]["figures"]["map"]["hover_asked"];
    BOOST_TEST_REQUIRE(hovers.size() == rows.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto readout = parsed(hovers[i]["readout"]);
      BOOST_TEST_REQUIRE(readout.has_value(), hovers[i].dump());
      if (hovers[i]["ring"].is_null()) {  // else a curve is near
        BOOST_TEST(is_named(rows[i], readout->name), hovers[i] << " of " << rows[i].half_cycles);
        ++count;
      }
    }
    BOOST_TEST(count > rows.size() / 2);
  }
}

BOOST_AUTO_TEST_CASE(shows_its_own_place_if_nothing_is_near) {
  std::size_t count = 0;
  for_each_ticked_figure([&count](const json& figure) {
    const json& hover = figure["hover_corner"];
    const auto readout = parsed(hover["readout"]);
    BOOST_TEST_REQUIRE(readout.has_value(), hover.dump());
    if (hover["ring"].is_null()) {
      BOOST_TEST(readout->name.empty() == (figure["has_map"] == false), hover.dump());
      check_near(place(*readout, figure["rest"]), hover["pointer"], 1);
      ++count;
    }
  });
  BOOST_TEST(count >= 6U);  // the three regions at least, at both widths
}

BOOST_AUTO_TEST_CASE(shows_nothing_outside_the_plot) {
  for_each_figure([](const json& figure) {
    BOOST_TEST(figure["hover_title"]["readout"] == "");
    BOOST_TEST(figure["hover_title"]["ring"].is_null());
    BOOST_TEST(figure["after_leaving"] == "");
  });
}

BOOST_AUTO_TEST_SUITE_END()
