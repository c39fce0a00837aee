// SPDX-License-Identifier: MIT
#include "figure_facts.hpp"

// What is drawn lies where its values are, and its values are those of the report.

namespace {

using namespace stillpoint::browser_test;
using nlohmann::json;

constexpr double six_digits = 1e-5;  // of the coordinates that marks carry, and more

std::vector<json> named(const json& figure, const std::string& name) {
  std::vector<json> found;
  for (const json& mark : figure["rest"]["marks"]) {
    if (mark["name"] == name) {
      found.push_back(mark["at"]);
    }
  }
  return found;
}

const json& figure_of(const char* page, const char* id) {
  return seen(Scheme::light)[page]["1280"]["figures"][id];
}

void check_value(const json& seen, double due) {
  BOOST_TEST(std::abs(seen.get<double>() - due) <= six_digits * std::abs(due),
             seen << " instead of " << due);
}

/// The turns of the motion are those of the report, and so is its rest off x = 0.
void check_turns(const char* page, double time, double length) {
  const json& figure = figure_of(page, "motion");
  const json& half_cycles = pages().reports.at(page)["half_cycles"];
  BOOST_TEST_REQUIRE(half_cycles.size() >= 10U);
  for (const json& cycle : half_cycles) {
    const double t = cycle["peak_time"].get<double>() * time;
    const double x = cycle["side"].get<double>() * cycle["peak"].get<double>() * length;
    const auto turns = named(figure, cycle["arrival_speed"].is_null() ? "rest" : "turn");
    BOOST_TEST(std::ranges::any_of(turns,
                                   [&](const json& at) {
                                     return std::abs(at[0].get<double>() - t) <= six_digits * t &&
                                            std::abs(at[1].get<double>() - x) <=
                                                six_digits * std::abs(x);
                                   }),
               "no turn at " << t << ", " << x);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE(marks)

BOOST_AUTO_TEST_CASE(lie_where_their_values_are) {
  std::size_t count = 0;
  for_each_figure([&count](const json& figure) {
    for (const json& mark : figure["rest"]["marks"]) {
      BOOST_TEST_CONTEXT(mark["name"]) {
        check_near(mark["seen"], mark["due"], pixel_tolerance);
        ++count;
      }
    }
  });
  BOOST_TEST(count > 100U);
}

BOOST_AUTO_TEST_CASE(ticks_lie_where_their_numbers_say) {
  for_each_figure([](const json& figure) {
    for (const json& tick : figure["rest"]["ticks"]) {
      const double seen = tick["seen"];
      BOOST_TEST(std::abs(seen - tick["due"].get<double>()) <= pixel_tolerance, tick.dump());
      // The middle of digits lies a little above that of the box of the text.
      const double aside = tick["axis"] == "x" ? pixel_tolerance : 2;
      BOOST_TEST(std::abs(seen - tick["label"].get<double>()) <= aside, tick.dump());
    }
  });
}

BOOST_AUTO_TEST_CASE(are_the_design_and_the_point_asked_for) {
  const json& report = pages().reports.at("design");
  const auto design = named(figure_of("design", "region"), "design");
  BOOST_TEST_REQUIRE(design.size() == 1U);
  check_value(design[0][0], report["physical"]["f"]);
  check_value(design[0][1], 1e3 * report["physical"]["delta_m"].get<double>());
  const auto point = named(figure_of("region", "region"), "point, admissible");
  BOOST_TEST_REQUIRE(point.size() == 1U);
  check_value(point[0][0], 0.26);
  check_value(point[0][1], 0.37);
  BOOST_TEST(figure_of("infeasible", "region")["rest"]["marks"].empty());
}

BOOST_AUTO_TEST_CASE(are_the_turns_of_the_motion) {
  check_turns("free", 1, 1);
  const json& forced = pages().reports.at("forced");
  check_turns("forced", forced["physical"]["time_unit_s"], millimetres(forced));
}

BOOST_AUTO_TEST_SUITE_END()
