// SPDX-License-Identifier: MIT
#include "drawn_pages.hpp"

// What a reader must see in the figures of a page.

BOOST_AUTO_TEST_SUITE(page_figures_test)

using namespace stillpoint;
using namespace stillpoint::report;
using namespace stillpoint::test;

HtmlPage region(double beta, double f, double delta) {
  const design::RegionRequest request{
      .problem = {.v0 = 1, .p = 1, .beta = beta}, .f = f, .delta = delta};
  return page(RegionReport{request, design::answer(request)});
}

/// Under a record of three values.
design::RecordDesignRequest under_three(const Interval& f, const Interval& delta) {
  return {.cases = {{.records = {{"three", Record{{0.4, -0.2, 0}, 1, {}}, 1}}}},
          .f = f,
          .delta = delta};
}

/// What the hits do: from 0 to the end of the axis without gaps, below what it works for and above
/// a limit.
void check_hits(const Figure& drawn) {
  double reached = 0;
  for (const figures::FigureArea& area : drawn.areas) {
    if (!area.name.starts_with("works for ") && !area.name.starts_with("above ")) {
      BOOST_TEST(area.outline[0].x == reached, area.name);
      reached = area.outline[1].x;
    }
  }
  BOOST_TEST(reached == drawn.x.most);
}

/// Each has a name of its own and a caption of one sentence, and lies within the numbers that it
/// draws.
void check_whole(const HtmlPage& page) {
  BOOST_TEST(!page.figures.empty());
  std::set<std::string> ids;
  const auto check_points = [](const std::vector<figures::FigurePoint>& points) {
    for (const figures::FigurePoint& at : points) {
      BOOST_TEST((std::isfinite(at.x) && std::isfinite(at.y)));
    }
  };
  std::map<std::string, figures::Ink> of_arrival;  // is the same in each figure
  for (const Figure& drawn : page.figures) {
    BOOST_TEST_CONTEXT(drawn.id) {
      BOOST_TEST(ids.insert(drawn.id).second);
      BOOST_TEST((!drawn.title.empty() && !drawn.description.empty()));
      const std::string caption = drawn.caption();
      BOOST_TEST((caption.empty() || (caption.ends_with('.') && !contains(caption, ". "))),
                 caption);
      BOOST_TEST((drawn.x.least < drawn.x.most && drawn.y.least < drawn.y.most));
      for (const auto& area : drawn.areas) {
        const std::size_t arrival = area.name.find("arrival ");
        if (arrival != std::string::npos) {
          const auto& [name, ink] = *of_arrival.emplace(area.name.substr(arrival), area.ink).first;
          BOOST_TEST((ink == area.ink), name);
        }
        check_points(area.outline);
      }
      for (const auto& curve : drawn.curves) {
        std::ranges::for_each(curve.strokes, check_points);
      }
      for (const auto& marks : drawn.marks) {
        check_points(marks.points);
      }
      BOOST_TEST(!contains(svg(drawn, figures::Frame::in_page), "nan"));
      if (drawn.id == "hits") {
        check_hits(drawn);
      }
    }
  }
  for (int arrival = 2; arrival <= 12; ++arrival) {
    const auto one = of_arrival.find("arrival " + std::to_string(arrival - 1));
    const auto next = of_arrival.find("arrival " + std::to_string(arrival));
    BOOST_TEST(
        (one == of_arrival.end() || next == of_arrival.end() || one->second != next->second));
  }
}

/// Of hits, pulses, ranges and residuals, with one damper given and designed, and of motions.
BOOST_AUTO_TEST_CASE(each_figure_is_whole_whatever_the_task) {
  Dice dice(20'261'127);
  for (int i = 0; i < 60; ++i) {
    design::Problem problem{.v0 = dice.power_of_ten(-1, 1), .p = dice.power_of_ten(-1, 1)};
    const double scale = problem.v0 / problem.p;
    problem.beta = scale * dice.uniform(0.5, 1.5);
    problem.arrivals = 1 + static_cast<int>(dice.below(dice.once_in(4) ? 40 : 3));
    if (dice.once_in(3)) {
      problem.residual = scale * dice.power_of_ten(-2, 0);
    }
    if (dice.once_in(3)) {
      problem.v0_low = problem.v0 * dice.uniform(0, 1);
      problem.p_high = problem.p * dice.uniform(1, 1.2);
    }
    design::Limits limits;
    if (dice.once_in(3)) {
      limits.f_max = problem.v0 * problem.p * dice.uniform(0.01, 0.5);
      limits.tolerance = dice.uniform(0, 0.4);
    }
    std::optional<design::Pulse> pulse;
    if (dice.once_in(4)) {
      pulse = HalfSine{dice.uniform(0.1, 2), dice.power_of_ten(0, 1.5)};
      problem = {.p = 1, .beta = dice.power_of_ten(-2, 0)};  // of a pulse
    }
    BOOST_TEST_CONTEXT("task " << i) {
      design::RegionRequest region{.problem = problem, .limits = limits};
      region.pulse = pulse;
      check_whole(page(RegionReport{region, design::answer(region)}));
      region.f = dice.power_of_ten(-3, 0);
      region.delta = dice.power_of_ten(-3, 0);
      check_whole(page(RegionReport{region, design::answer(region)}));
      SimulationRequest motion =
          simulation_of({1, dice.power_of_ten(-3, 0), dice.power_of_ten(-4, -1)}, {0, 1});
      if (dice.once_in(2)) {
        motion.excitation = Harmonic{.k = 0.3, .lambda = dice.power_of_ten(-1, 1), .duration = 40};
      }
      if (dice.once_in(3)) {
        motion.surface = {dice.power_of_ten(-4, 0), {{dice.uniform(0, 1), dice.uniform(0, 0.2)}}};
      }
      check_whole(page_of(motion));
      if (i < 10) {
        design::DesignRequest design{problem, limits, {}};
        design.pulse = pulse;
        check_whole(page(DesignReport{design::design(design), {}}));
      }
    }
  }
  check_whole(isolator());
}

/// A point near the edge f3 = 0.35355 leaves a tolerance of 0.0015 %.
BOOST_AUTO_TEST_CASE(a_tolerance_too_small_to_see_is_enlarged) {
  const Figure drawn = figure(region(0.9, 0.35355, 0.3), "region");
  BOOST_TEST(drawn.inset.has_value());
}

/// With f <= 0.001 that of the first arrival lies between 0.5 - f and 0.5; without the limit it
/// fills the figure.
BOOST_AUTO_TEST_CASE(a_strip_too_thin_to_see_is_enlarged_and_named) {
  design::RegionRequest request{.problem = {.v0 = 1, .p = 1, .beta = 1, .arrivals = 2}};
  const Figure wide = figure(page(RegionReport{request, design::answer(request)}), "region");
  BOOST_TEST(!wide.inset.has_value());
  request.limits.f_max = 0.001;
  const Figure thin = figure(page(RegionReport{request, design::answer(request)}), "region");
  BOOST_TEST_REQUIRE(thin.inset.has_value());
  BOOST_TEST(thin.inset->y.least > 0.49);
  BOOST_TEST(thin.inset->y.least < 0.499);
  BOOST_TEST(thin.inset->y.most > 0.5);
  BOOST_TEST(thin.inset->x.least == 0);  // nothing is left of the axis
  BOOST_TEST(thin.inset->x.most > 0.001);
  BOOST_TEST(contains(svg(thin, figures::Frame::in_page), ">arrival 1</text>"));
  BOOST_TEST(!has_note(thin, "arrival 1"));  // which would stand in another area
}

BOOST_AUTO_TEST_CASE(a_point_far_off_does_not_flatten_the_region) {
  const HtmlPage far = region(0.9, 50, 0.37);
  const HtmlPage near = region(0.9, 0.26, 0.37);
  BOOST_TEST(figure(far, "region").x.most == figure(near, "region").x.most);
  BOOST_TEST(contains(figure(far, "region").marks.back().name, "f = 50"));
}

/// beta = 0.6: f2 = 0.5333 above f3 = 0.35355; condition (10) asks for 1/sqrt(2) = 0.70711.
BOOST_AUTO_TEST_CASE(the_gap_is_shaded_and_the_mend_is_the_title) {
  const HtmlPage page = region(0.6, 0.4, 0.3);
  const Figure& drawn = figure(page, "region");
  const auto& gap = named(drawn.areas, "gap: no f returns within 0.6");
  BOOST_TEST(gap.outline.front().x == 1 / std::sqrt(8.0), tt::tolerance(1e-12));
}

/// With a hold, every record that frees the mass is felt as f + hold.
BOOST_AUTO_TEST_CASE(of_records_that_are_felt_alike_the_worst_has_the_largest_stroke) {
  design::RecordDesign result;
  ForcedResponse response;
  response.stop_position = 0;
  response.peak_absolute_acceleration = 0.1;
  response.peak_amplitude = 1;
  ForcedResponse larger = response;
  larger.peak_absolute_acceleration *= 1 - 1e-15;
  larger.peak_amplitude = 2;
  result.request.cases.emplace_back();
  result.finding.emplace().responses = {{response, larger, response}};
  BOOST_TEST(worst_motion(result, 0) == 1U);
}

/// beta = 0.9 is exceeded from V0 = 1.136 on, and sqrt(f^2 + V0^2) = 1.08 from there to V0 =
/// sqrt(1.08^2 - f^2).
BOOST_AUTO_TEST_CASE(hits_above_the_limit_of_the_acceleration_are_shown) {
  const design::DesignRequest request{.problem = {.v0 = 1, .p = 1, .beta = 0.9},
                                      .limits = {.acceleration_max = 1.08}};
  const DesignReport report{design::design(request), {}};
  const double f = report.result.finding->point.f;
  const Figure drawn = figure(page(report), "hits");
  const auto& above = named(drawn.areas, "above 1.08 g");
  BOOST_TEST(above.outline[0].x == std::sqrt(1.08 * 1.08 - f * f), tt::tolerance(1e-12));
  BOOST_TEST(above.outline[1].x == named(drawn.areas, "too far").outline[0].x);
  BOOST_TEST(report.result.finding->works_for->hit.high.value() ==
                 std::min(above.outline[0].x, report.result.finding->works_for->hit.high.value()),
             tt::tolerance(1e-12));
  BOOST_TEST(!has(figure(isolator(), "hits").areas, "above 0.1 g"));
}

/// Of 2 V0 the hits that it works for are 1e-4 wide, or 0.11 m/s of 0.8.
BOOST_AUTO_TEST_CASE(hits_too_few_to_see_are_enlarged) {
  const design::DesignRequest request{.problem = {.v0 = 1, .p = 1, .beta = 0.7072}};
  const Figure drawn = figure(page(DesignReport{design::design(request), {}}), "hits");
  BOOST_TEST_REQUIRE(drawn.inset.has_value());
  BOOST_TEST(drawn.inset->x.least < 0.9999);
  BOOST_TEST(drawn.inset->x.least > 0.999);
  BOOST_TEST(drawn.inset->x.most > 1);
  BOOST_TEST(!figure(isolator(), "hits").inset.has_value());
}

/// f from 0.9 to 1.2 and Delta from 0.95 to 1.05 times the design's, or some multiple of that.
BOOST_AUTO_TEST_CASE(a_tolerance_of_each_side_is_drawn_as_it_is) {
  const design::DesignRequest hit{.problem = {.v0 = 1, .p = 1, .beta = 1}};
  const design::DesignRequest pulsed{.problem = {.p = 1, .beta = 0.05}, .pulse = HalfSine{0.5, 20}};
  for (design::DesignRequest request : {hit, pulsed}) {
    request.limits.delta_max = 0.5;
    request.limits.tolerance = 0.2;
    request.limits.shape = {0.5, 1, 0.25, 0.25};
    const design::DesignResult result = design::design(request);
    BOOST_TEST_REQUIRE(result.finding.has_value());
    const auto& [f, delta, tolerance] = result.finding->point;
    const Figure drawn = figure(page(DesignReport{result, {}}), "region");
    const auto box =
        std::ranges::find(drawn.areas, figures::AreaLook::box, &figures::FigureArea::look);
    BOOST_TEST_REQUIRE((box != drawn.areas.end()));
    BOOST_TEST(box->name.starts_with("tolerance: f -"), box->name);
    const auto& [low, high] = std::pair(box->outline[0], box->outline[2]);
    BOOST_TEST(low.x == f * (1 - tolerance * 0.5));
    BOOST_TEST(high.x == f * (1 + tolerance));
    BOOST_TEST(low.y == delta * (1 - tolerance * 0.25));
    BOOST_TEST(high.y == delta * (1 + tolerance * 0.25));
    BOOST_TEST(high.x <= drawn.x.most);
    BOOST_TEST(high.y <= drawn.y.most);
  }
}

/// f = 0.3 without a notch: the dead zone of 0.3 is within the residual, and so is every rest,
/// after 0 passages up to V0 = sqrt(0.9^2 - 0.3^2) = 0.8485.
BOOST_AUTO_TEST_CASE(a_rest_within_the_residual_is_not_off_centre) {
  design::RegionRequest request{
      .problem = {.v0 = 1, .p = 1, .beta = 1, .residual = 0.6}, .f = 0.3, .delta = 0};
  const Figure drawn = figure(page(RegionReport{request, design::answer(request)}), "hits");
  const std::string direct = "within the residual";
  BOOST_TEST(std::abs(named(drawn.areas, direct).outline.at(1).x - std::sqrt(0.72)) < 1e-15);
  BOOST_TEST(named(drawn.areas, direct + " after 1 passage").outline.at(0).x ==
             named(drawn.areas, direct).outline.at(1).x);
}

/// What is felt is friction at least, and 0.4 where friction holds the mass.
BOOST_AUTO_TEST_CASE(maps_show_where_a_damper_is_good_and_what_is_about_it) {
  design::RecordDesignRequest request = under_three({0, 0.4}, {0, 1});
  request.cases.front().limits.jump = 9;
  RecordDesignReport report{design::design(request), {}};
  constexpr double f = 0.1;
  constexpr double delta = 0.5;
  report.result.nearest.damper = {1, f, delta, 0};
  design::SuiteBox& box = report.result.finding->box;
  box.f = {f * 0.9, f * 1.1};
  box.delta = {delta * 0.9, delta * 1.1};
  const Figure all = figure(page(report), "map");
  BOOST_TEST(all.x.least == 0);
  BOOST_TEST(all.x.most > f);
  BOOST_TEST(all.x.most < 0.4);
  const Figure near = figure(page(report), "map-near");
  BOOST_TEST(all.folded.empty());
  BOOST_TEST(near.folded == "Without any error of f and Δ");
  constexpr double rounding = 1e-12;
  BOOST_TEST(std::abs(near.x.least - f * 0.8) <= rounding);
  BOOST_TEST(std::abs(near.y.most - delta * 1.2) <= rounding);
  for (const Figure& shown : {all, near}) {
    const std::vector<figures::FigurePoint> outline =
        named(shown.curves, "the tolerance").strokes.at(0);
    BOOST_TEST(outline.at(0).x == f * 0.9);
    BOOST_TEST(outline.at(0).y == delta * 0.9);
    BOOST_TEST(outline.at(2).x == f * 1.1);
    BOOST_TEST(outline.at(2).y == delta * 1.1);
  }
  box.f = {f, f};
  const figures::HtmlPage exact = page(report);
  BOOST_TEST(std::ranges::none_of(exact.figures,
                                  [](const Figure& figure) { return figure.id == "map-near"; }));
}

/// Also the jump at a notch, whose lilac has more blue than red.
BOOST_AUTO_TEST_CASE(all_that_violates_a_limit_is_hatched_whatever_its_colour) {
  design::RecordDesignRequest request = under_three({0, 0.3}, {0, 0.2});
  request.cases.front().limits.jump = 1e-3;
  const figures::FigureMap map =
      figure(page(RecordDesignReport{design::design(request), {}}), "map").map;
  std::set<std::string> violated;
  for (const std::uint8_t cell : map.cells) {
    const figures::MapShade& shade = map.palette[cell];
    const bool is_violated = !shade.label.ends_with(" g");  // but names the limit
    BOOST_TEST((shade.hatch == figures::Hatch::one_way) == is_violated, shade.name);
    violated.insert(shade.label);
  }
  BOOST_TEST(violated.contains("jump too large"));
  BOOST_TEST(violated.size() >= 2U);
}

/// Under the one record, as far as the worst stroke of the box, beyond that of the design.
BOOST_AUTO_TEST_CASE(the_worst_damper_of_the_box_is_drawn_beside_the_design) {
  const design::RecordDesignRequest request = under_three({0.1, 0.1}, {0, 0});
  const auto farthest = [&](const char* name) {
    const RecordDesignReport report{design::design(request), {}};
    const Figure drawn = figure(page(report), "record-1");
    double far = 0;
    for (const figures::FigurePoint& point : named(drawn.curves, name).strokes.at(0)) {
      far = std::max(far, std::abs(point.y));
    }
    return far;
  };
  const design::RecordDesign result = design::design(request);
  const double worst = result.finding->box.worst.front().peak;
  const double own = result.finding->point.figures.front().peak;
  constexpr double of_the_drawing = 1e-3;  // the peak may lie between two samples
  BOOST_TEST(worst > own * 1.01);
  BOOST_TEST(std::abs(farthest("worst stroke in tolerance") / worst - 1) <= of_the_drawing);
  BOOST_TEST(std::abs(farthest("x") / own - 1) <= of_the_drawing);
}

/// The damper of the third arrival.
BOOST_AUTO_TEST_CASE(the_strip_of_the_damper_lies_in_front) {
  design::RegionRequest request{
      .problem = {.v0 = 1, .p = 1, .beta = 1, .arrivals = 4}, .f = 0.1, .delta = 0.05};
  const design::RegionAnswer answer = design::answer(request);
  BOOST_TEST_REQUIRE((answer.arrival == 3));
  const Figure drawn = figure(page(RegionReport{request, answer}), "region");
  const auto place = [&](const char* name) {
    return std::ranges::find(drawn.areas, name, &figures::FigureArea::name) - drawn.areas.begin();
  };
  BOOST_TEST(place("arrival 1") < place("arrival 4"));
  BOOST_TEST(place("arrival 4") < place("arrival 3"));
}

/// The notch stops far stronger pulses than the one asked for.
BOOST_AUTO_TEST_CASE(all_pulses_that_a_damper_works_for_are_shown) {
  design::RegionRequest request{.problem = {.p = 1, .beta = 0.05}, .f = 0.002, .delta = 0.006};
  request.pulse = FullSine{0.5, 20};
  const design::RegionAnswer answer = design::answer(request);
  BOOST_TEST_REQUIRE(answer.works_for.has_value());
  const double strongest = answer.works_for->hit.high.value();
  BOOST_TEST(strongest > 1);
  const Figure drawn = figure(page(RegionReport{request, answer}), "pulses");
  BOOST_TEST(drawn.x.most > strongest);
  BOOST_TEST(named(drawn.areas, "too far").outline.at(1).x == drawn.x.most);
}

/// f2 = 0.3 is eight times f3 = 0.0375, where the gap begins.
BOOST_AUTO_TEST_CASE(the_figure_reaches_the_far_end_of_a_gap) {
  const design::RegionRequest request{.problem = {.v0 = 1, .p = 1, .beta = 0.2}};
  const design::Region found = design::answer(request).region;
  const Figure drawn = figure(page(RegionReport{request, design::answer(request)}), "region");
  BOOST_TEST_REQUIRE(!found.feasible);
  BOOST_TEST_REQUIRE(found.f2 > 4 * found.f3);
  BOOST_TEST(drawn.x.most > found.f2);
}

BOOST_AUTO_TEST_SUITE_END()
