// SPDX-License-Identifier: MIT
#include "drawn_pages.hpp"

// Each point of the region's figure lies in one area, and what that says is what the motion does.

BOOST_AUTO_TEST_SUITE(region_sides_test)

using namespace stillpoint;
using namespace stillpoint::report;
using design::Problem;
using figures::AreaLook;
using figures::Figure;
using figures::FigureArea;
using figures::FigurePoint;
using test::Dice;

Figure region_of(const Problem& problem, const design::Limits& limits = {}) {
  const design::RegionRequest request{.problem = problem, .limits = limits};
  return test::figure(page(RegionReport{request, design::answer(request)}), "region");
}

bool holds(const std::vector<FigurePoint>& outline, const FigurePoint& at) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto& [x0, y0] = outline[i];
    const auto& [x1, y1] = outline[(i + 1) % outline.size()];
    if ((y0 > at.y) != (y1 > at.y) && at.x < x0 + (at.y - y0) / (y1 - y0) * (x1 - x0)) {
      inside = !inside;
    }
  }
  return inside;
}

/// The names of all areas there but the tolerance.
std::vector<std::string> said(const Figure& figure, const FigurePoint& at) {
  std::vector<std::string> names;
  for (const FigureArea& area : figure.areas) {
    if (area.look != AreaLook::box && holds(area.outline, at)) {
      names.push_back(area.name.substr(0, area.name.find(": exceeds")));
    }
  }
  return names;
}

/// Of one hit on one spring.
std::string truth(const Problem& problem, const FigurePoint& at) {
  const auto& [f, delta] = at;
  Problem exact = problem;
  exact.criterion = design::Criterion::exact;
  if (design::admissible(exact, {}, f, delta) && !design::admissible(problem, {}, f, delta)) {
    return "stops, but not by the published criterion";
  }
  if (2 * delta > problem.v0 * problem.v0) {
    return "notch holds at the start";
  }
  const Response motion = free_response({problem.p, f, delta}, {0, problem.v0});
  if (motion.peak_amplitude > problem.beta) {
    return "too weak";
  }
  const double r = problem.residual.value_or(0);
  if (f >= problem.beta * problem.p * problem.p) {
    return "too strong: dead zone";
  }
  if ((f <= r * problem.p * problem.p || motion.peak_amplitude <= r) &&
      motion.zero_passages < problem.arrivals) {
    return "any rest within the residual";
  }
  if (motion.zero_passages >= problem.arrivals) {
    return "notch too weak";
  }
  if (motion.stops_at_zero) {
    return "arrival " + std::to_string(static_cast<int>(*motion.zero_passages) + 1);
  }
  if (std::abs(*motion.stop_position) <= r) {
    return "an arrival";  // the strip before or after it
  }
  // Not where even more friction brings the first peak within r.
  const double short_peak = (problem.v0 * problem.v0 / r - r * problem.p * problem.p) / 2;
  const bool too_strong =
      motion.zero_passages == 0 && !(r > 0 && short_peak < problem.beta * problem.p * problem.p);
  return problem.residual ? (too_strong ? "too strong: rests too far off" : "rests too far off")
                          : (too_strong ? "too strong: does not return" : "rests off centre");
}

/// Edges are drawn with straight lines, so a point counts only if all around it is as it is.
bool is_off_edges(const Problem& problem, const Figure& figure, const FigurePoint& at) {
  constexpr double apart = 0.004;  // of the axes
  const double dx = apart * (figure.x.most - figure.x.least);
  const double dy = apart * (figure.y.most - figure.y.least);
  const std::vector<FigurePoint> beside{{dx, 0}, {-dx, 0}, {0, dy}, {0, -dy}};
  return std::ranges::all_of(beside, [&](const FigurePoint& by) {
    return truth(problem, {at.x + by.x, std::max(0.0, at.y + by.y)}) == truth(problem, at);
  });
}

/// An only area of one arrival has no number.
bool is_said(const std::string& name, const std::string& expected, const Problem& problem) {
  const bool rests = expected.starts_with("an") || expected == "arrival 1";
  return name == "admissible"                  ? problem.arrivals == 1 && rests
         : expected == "an arrival"            ? name.starts_with("arrival ")
         : expected == "too strong: dead zone" ? name.starts_with(expected)
                                               : name == expected;
}

FigurePoint anywhere(Dice& dice, const Figure& figure) {
  return {figure.x.value(dice.uniform(0.01, 0.99)), figure.y.value(dice.uniform(0.01, 0.99))};
}

BOOST_AUTO_TEST_CASE(of_one_hit_are_what_the_motion_does) {
  Dice dice(20261);
  std::map<std::string, int> met;
  for (int i = 0; i < 40; ++i) {
    Problem problem{.v0 = dice.power_of_ten(-1, 1), .p = dice.power_of_ten(-1, 1)};
    problem.criterion = dice.once_in(2) ? design::Criterion::exact : design::Criterion::published;
    problem.arrivals = 1 + dice.below(5);
    const double scale = problem.v0 / problem.p;
    problem.beta = scale * dice.uniform(0.85, 1.2);
    if (dice.once_in(2)) {
      problem.residual = scale * (dice.once_in(2) ? dice.uniform(0.01, 0.1) : dice.uniform(0.4, 1));
    }
    if (problem.arrivals == 1 && !problem.residual) {
      problem.arrivals = 2;  // the names of strips
    }
    const Figure figure = region_of(problem);
    for (int k = 0; k < 200; ++k) {
      const FigurePoint at = anywhere(dice, figure);
      if (!is_off_edges(problem, figure, at)) {
        continue;
      }
      const std::string expected = truth(problem, at);
      const auto names = said(figure, at);
      BOOST_TEST_CONTEXT("problem " << i << ", f " << at.x << ", delta " << at.y << ": "
                                    << expected) {
        BOOST_TEST_REQUIRE(names.size() == 1U);
        BOOST_TEST(is_said(names[0], expected, problem), names[0]);
      }
      ++met[expected];
    }
  }
  for (const char* name :
       {"notch holds at the start", "too weak", "any rest within the residual", "notch too weak",
        "arrival 1", "arrival 2", "arrival 3", "rests too far off", "rests off centre",
        "stops, but not by the published criterion", "too strong: rests too far off",
        "too strong: does not return", "too strong: dead zone"}) {
    BOOST_TEST(met[name] > 20, name << ": " << met[name]);
  }
}

BOOST_AUTO_TEST_CASE(the_line_of_a_tolerance_surrounds_the_dampers_that_keep_it) {
  for (const auto& [arrivals, residual] : {std::pair(1, 0.0), {3, 0.0}, {3, 0.15}}) {
    Problem problem{.v0 = 1, .p = 1, .beta = 0.95, .arrivals = arrivals};
    if (residual > 0) {
      problem.residual = residual;
    }
    const design::Limits limits{.tolerance = 0.1, .shape = {1, 0.5, 0.8, 1}};
    const Figure figure = region_of(problem, limits);
    const auto& line =
        test::named(figure.curves, "tolerance: f -10 to +5 %, Δ -8 to +10 % asked for");
    Dice dice(20263);
    int inside = 0;
    for (int k = 0; k < 1000; ++k) {
      const FigurePoint at = anywhere(dice, figure);
      const auto keeps = [&](double dx, double dy) {
        const FigurePoint by{at.x + dx * figure.x.most, std::max(0.0, at.y + dy * figure.y.most)};
        return design::admissible(problem, limits, by.x, by.y);
      };
      constexpr double apart = 0.004;  // of the axes: edges are drawn with straight lines
      const bool expected = keeps(0, 0);
      if (keeps(apart, 0) == expected && keeps(-apart, 0) == expected &&
          keeps(0, apart) == expected && keeps(0, -apart) == expected) {
        const bool drawn = std::ranges::any_of(
            line.strokes, [&at](const auto& stroke) { return holds(stroke, at); });
        BOOST_TEST(drawn == expected, "arrivals " << arrivals << ", residual " << residual << ", f "
                                                  << at.x << ", delta " << at.y);
        inside += drawn ? 1 : 0;
      }
    }
    BOOST_TEST(inside > 100);
  }
}

/// Of ranges: a hit and a spring that do what the area says, or none that does otherwise.
BOOST_AUTO_TEST_CASE(of_ranges_are_what_some_motion_does) {
  Dice dice(20262);
  std::map<std::string, int> met;
  for (int i = 0; i < 30; ++i) {
    Problem problem{.v0 = 1, .p = 1, .beta = dice.uniform(0.9, 1.3)};
    problem.criterion = design::Criterion::exact;
    problem.arrivals = 1 + dice.below(4);
    problem.v0_low = dice.uniform(0.85, 0.99);
    problem.p_high = dice.uniform(1, 1.1);
    const Figure figure = region_of(problem);
    const auto motion = [&](const FigurePoint& at, double part_v, double part_p) {
      const double v0 = *problem.v0_low + part_v * (problem.v0 - *problem.v0_low);
      return free_response({problem.p + part_p * (*problem.p_high - problem.p), at.x, at.y},
                           {0, v0});
    };
    for (int k = 0; k < 100; ++k) {
      const FigurePoint at = anywhere(dice, figure);
      const auto names = said(figure, at);
      if (names.size() != 1) {
        // Two polygons meet within the width of a line.
        const double dx = 0.004 * (figure.x.most - figure.x.least);
        const double dy = 0.004 * (figure.y.most - figure.y.least);
        BOOST_TEST((said(figure, {at.x + dx, at.y}) != said(figure, {at.x - dx, at.y}) ||
                    said(figure, {at.x, at.y + dy}) != said(figure, {at.x, at.y - dy})),
                   "problem " << i << ", f " << at.x << ", delta " << at.y << ": " << names.size()
                              << " areas; v0 from " << *problem.v0_low << ", p to "
                              << *problem.p_high << ", beta " << problem.beta << ", arrivals "
                              << problem.arrivals);
        continue;
      }
      constexpr double near = 1.01;  // the outlines are polygons
      const std::string& name = names[0];
      ++met[name.substr(0, 9)];
      BOOST_TEST_CONTEXT("problem " << i << ", f " << at.x << ", delta " << at.y << ": " << name) {
        if (name == "notch holds at the start") {
          BOOST_TEST(2 * at.y * near > *problem.v0_low * *problem.v0_low);
        } else if (name == "too weak") {
          BOOST_TEST(motion(at, 1, 0).peak_amplitude * near > problem.beta);
        } else if (name == "too strong: does not return") {
          BOOST_TEST(*motion({at.x * near, at.y}, 0, 0).half_cycles <= 1);
          BOOST_TEST(!motion({at.x * near, at.y}, 0, 0).stops_at_zero);
        } else if (name == "notch too weak") {
          BOOST_TEST(*motion({at.x / near, at.y / near}, 1, 1).zero_passages >= problem.arrivals);
        } else if (name == "some hits rest off centre") {
          // Somewhere between the two corners; the gap may be thin.
          bool found = false;
          constexpr int steps = 4000;
          for (int s = 0; s <= steps && !found; ++s) {
            const double part = static_cast<double>(s) / steps;
            found = !motion(at, part, part).stops_at_zero;
          }
          BOOST_TEST((found || at.x < 0.01));
        } else {
          const std::vector<std::array<double, 2>> parts{
              {0, 0}, {1, 0}, {0, 1}, {1, 1}, {dice.uniform(0, 1), dice.uniform(0, 1)}};
          for (const auto& [v, p] : parts) {
            const Response one = motion(at, v, p);
            BOOST_TEST(one.stops_at_zero);
            BOOST_TEST(one.peak_amplitude <= problem.beta * near);
          }
        }
      }
    }
  }
  for (const char* name : {"notch hol", "too weak", "too stron", "notch too", "some hits",
                           "arrival 1", "arrival 2", "admissibl"}) {
    BOOST_TEST(met[name] > 20, name << ": " << met[name]);
  }
}

/// Beyond the strips that can be told apart one area stands for the rest.
BOOST_AUTO_TEST_CASE(many_arrivals_are_one_area_down_to_the_last) {
  const Problem problem{.v0 = 1, .p = 1, .beta = 1, .arrivals = 40};
  const Figure figure = region_of(problem);
  BOOST_TEST(test::has(figure.areas, "arrival 12"));
  BOOST_TEST(!test::has(figure.areas, "arrival 13"));
  const FigureArea& later = test::named(figure.areas, "arrivals 13 to 40, thin strips with gaps");
  // At f = 0 the n-th arrival stops for Delta of 1/(2n) to 1/(2(n - 1)).
  BOOST_TEST(std::abs(later.outline.front().y - 1.0 / 80) < 1e-12);
  BOOST_TEST(std::abs(later.outline.back().y - 1.0 / 24) < 1e-12);
}

BOOST_AUTO_TEST_CASE(limits_come_before_what_lies_behind_them) {
  const Problem problem{.v0 = 1, .p = 1, .beta = 1, .arrivals = 3};
  const Figure figure = region_of(problem, {.f_max = 0.15, .delta_max = 0.2});
  const auto only = [&](double f, double delta) {
    const auto names = said(figure, {f, delta});
    BOOST_TEST_REQUIRE(names.size() == 1U);
    return names[0];
  };
  BOOST_TEST(only(0.1, 0.3) == "above the largest Δ");
  BOOST_TEST(only(0.2, 0.3) == "above the largest f");
  BOOST_TEST(only(0.38, 0.3) == "too strong: does not return");
  BOOST_TEST(only(0.1, 0.19) == "arrival 2");
}

BOOST_AUTO_TEST_SUITE_END()
