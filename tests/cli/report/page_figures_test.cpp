// SPDX-License-Identifier: MIT
#include "drawn_pages.hpp"
#include "testing/test.hpp"

#include <stillpoint/core/simulation.hpp>
#include <stillpoint/design/design.hpp>
#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/report.hpp>

#include <fmt/format.h>

#include <regex>
#include <set>

// What a reader must see in the figures of a page.

BOOST_AUTO_TEST_SUITE(page_figures_test)

using namespace stillpoint;
using namespace stillpoint::report;
using figures::Figure;
using figures::HtmlPage;

namespace {

using namespace stillpoint::test;

HtmlPage region(double beta, double f, double delta) {
  const design::RegionRequest request{
      .problem = {.v0 = 1, .p = 1, .beta = beta}, .f = f, .delta = delta};
  return page(RegionReport{request, design::answer(request)});
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_region_names_its_forbidden_sides_and_fills_the_tolerance_on_top) {
  const HtmlPage page = isolator();
  const Figure& drawn = figure(page, "region");
  for (const char* side : {"too weak: exceeds 150 mm", "too strong: does not return",
                           "notch too weak", "notch holds at the start"}) {
    const auto& area = named(drawn.areas, side);
    BOOST_TEST((area.look == figures::AreaLook::hatched));
  }
  BOOST_TEST((drawn.areas.back().look == figures::AreaLook::box));
  BOOST_TEST(contains(drawn.areas.back().name, "tolerance"));
  BOOST_TEST(!drawn.inset);
}

/// A point near the edge f3 = 0.35355 leaves a tolerance of 0.0015 %.
BOOST_AUTO_TEST_CASE(a_tolerance_too_small_to_see_is_enlarged) {
  const Figure drawn = figure(region(0.9, 0.35355, 0.3), "region");
  BOOST_TEST(drawn.inset.has_value());
  BOOST_TEST(contains(drawn.caption(), "; the corner enlarges f of 0.35354"), drawn.caption());
}

/// That of the least peak lies on the edge.
BOOST_AUTO_TEST_CASE(a_damper_that_must_be_exact_has_no_box) {
  design::DesignRequest request;
  request.problem = {.v0 = 1, .p = 1, .beta = 0.9};
  request.search.objective = design::Objective::amplitude;
  const Figure drawn = figure(page(DesignReport{design::design(request), {}}), "region");
  BOOST_TEST(drawn.caption() ==
             "f or Δ must be exact: the damper is within a millionth of an edge of the admissible "
             "region.");
  BOOST_TEST(!drawn.inset);
  BOOST_TEST(std::ranges::count(drawn.areas, figures::AreaLook::box, &figures::FigureArea::look) ==
             0);
  // At Delta2 = 0.5, which is admissible without any tolerance.
  BOOST_TEST(figure(region(0.9, 0.3, 0.5), "region").caption() == drawn.caption());
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

BOOST_AUTO_TEST_CASE(the_answer_about_a_damper_comes_before_that_about_all) {
  BOOST_TEST(region(0.9, 0.26, 0.37).verdict.starts_with("The damper is admissible"));
  BOOST_TEST(region(0.9, 2, 1.5).verdict.starts_with("The damper is not admissible"));
  BOOST_TEST(region(0.6, 0.4, 0.3).verdict.starts_with("The damper is not admissible"));
  const auto tone = [](double f, double delta) {
    const design::RegionRequest request{
        .problem = {.v0 = 1, .p = 1, .beta = 0.9}, .f = f, .delta = delta};
    return document(RegionReport{request, design::answer(request)}).tone;
  };
  BOOST_TEST((tone(0.26, 0.37) == Tone::good));
  BOOST_TEST((tone(2, 1.5) == Tone::bad));
}

/// beta = 0.6: f2 = 0.5333 above f3 = 0.35355; condition (10) asks for 1/sqrt(2) = 0.70711.
BOOST_AUTO_TEST_CASE(the_gap_is_shaded_and_the_mend_is_the_title) {
  const HtmlPage page = region(0.6, 0.4, 0.3);
  const Figure& drawn = figure(page, "region");
  const auto& gap = named(drawn.areas, "gap: no f returns within 0.6");
  BOOST_TEST(gap.outline.front().x == 1 / std::sqrt(8.0), tt::tolerance(1e-12));
  BOOST_TEST(drawn.title == "No damper with a beta below 0.70711");  // 0.707107, rounded up
}

/// In the unit of the figure; V0/(sqrt(2) omega) = 126.0443 mm, rounded up.
BOOST_AUTO_TEST_CASE(the_mend_of_a_task_in_metres_is_in_the_unit_of_the_figure) {
  const HtmlPage page = isolator(0.11);
  BOOST_TEST(figure(page, "region").title == "No damper with a max displacement below 126.05 mm");
  BOOST_TEST(contains(page.verdict, " a max displacement of at least 126.05 mm."), page.verdict);
  BOOST_TEST(contains(page.verdict, "a peak within 110 mm needs f >= 0.0459199"), page.verdict);
  BOOST_TEST(contains(page.report, "least stroke      126.0443 mm"), page.report);
}

/// (f3 - f2)/(f3 + f2) = 0.2222 is the largest tolerance for beta = 0.8.
BOOST_AUTO_TEST_CASE(a_lack_of_tolerance_alone_leaves_a_clear_area_that_is_not_called_admissible) {
  design::DesignRequest request;
  request.problem = {.v0 = 1, .p = 1, .beta = 0.8};
  request.limits.tolerance = 0.4;
  const Figure drawn = figure(page(DesignReport{design::design(request), {}}), "region");
  BOOST_TEST(drawn.title == "No damper with a tolerance above 22.21 %");
  BOOST_TEST(contains(drawn.caption(), "without the tolerance asked for"), drawn.caption());
  BOOST_TEST(drawn.areas.front().name == "admissible without a tolerance");
}

BOOST_AUTO_TEST_CASE(the_hits_are_those_of_the_design_with_the_range_that_it_works_for) {
  const HtmlPage page = isolator();
  const Figure& drawn = figure(page, "hits");
  for (const char* end : {"held", "centred", "too far"}) {
    BOOST_TEST(has(drawn.areas, end), end);
  }
  BOOST_TEST(contains(drawn.areas.front().name, "works for 0.34"));
  BOOST_TEST(contains(drawn.areas.front().name, "0.429"));
  BOOST_TEST(has(drawn.curves, "V₀ = 0.4 m/s"));
  // From 0 on without gaps.
  double reached = 0;
  for (std::size_t i = 1; i < drawn.areas.size(); ++i) {
    BOOST_TEST(drawn.areas[i].outline[0].x == reached);
    reached = drawn.areas[i].outline[1].x;
  }
  BOOST_TEST(reached == drawn.x.most);
}

/// Without a notch the mass rests off centre wherever it turns within the dead zone, f/p^2.
BOOST_AUTO_TEST_CASE(a_damper_that_fails_says_how_the_hit_ends) {
  const std::string fails = "The damper does not work for the hit that was asked for";
  const auto caption = [](double f, double delta) {
    return figure(region(2, f, delta), "hits").caption();
  };
  BOOST_TEST(caption(0.2, 0.7) == fails + ": such hits are held at the start.");  // V0^2 < 2 delta
  BOOST_TEST(caption(0.9, 0) == fails + ": such hits rest off centre.");
  BOOST_TEST(caption(0, 0.5) == fails + ".");  // on the edge between held and centred
}

/// With V0 = 1.1 and p = 1.05, the largest of both, sqrt(f^2 + (V0 p)^2) is felt; the motion shown
/// is that of the least p, and what it serves holds for both ends.
BOOST_AUTO_TEST_CASE(what_is_said_of_ranges_names_the_hit_and_the_spring) {
  design::DesignRequest request;
  request.problem = {.v0 = 1.1, .p = 0.95, .beta = 2, .v0_low = 0.9, .p_high = 1.05};
  request.problem.criterion = design::Criterion::exact;
  const DesignReport report{design::design(request), {}};
  const HtmlPage drawn = page(report);
  const std::string& caption = figure(drawn, "motion").caption();
  BOOST_TEST(caption.starts_with("With the strongest hit, v0 = 1.1, and the softest spring, "
                                 "p = 0.95, the mass reaches its peak of "),
             caption);
  BOOST_TEST(has(figure(drawn, "hits").curves, "V₀ = 0.9 to 1.1"));
  const std::string written = std::regex_replace(drawn.report, std::regex("\\s+"), " ");
  const double felt = std::hypot(report.result.finding->point.f, 1.1 * 1.05);
  for (const std::string& said :
       {std::string(" of the 2 allowed (strongest hit, softest spring) rest "),
        std::string(" (strongest hit, softest spring) acceleration "),
        fmt::format("{:.4g} g outside the notch (strongest hit, stiffest spring)", felt),
        fmt::format("In practice: worst end of the ranges secant stiffness "),
        fmt::format(" base shear over weight {:.4g} ", felt)}) {
    BOOST_TEST(contains(written, said), said << " in " << written);
  }
}

/// No damper serves hits of 1 to 4 as its v0 (the ratio is above sqrt 3), whatever beta is.
BOOST_AUTO_TEST_CASE(a_range_too_wide_for_any_damper_is_not_blamed_on_the_stroke) {
  design::DesignRequest request;
  request.problem = {.v0 = 0.4, .p = 1, .beta = 0.36, .v0_low = 0.1};
  const HtmlPage drawn = page(DesignReport{design::design(request), {}});
  BOOST_TEST(figure(drawn, "region").title == "No damper for hits of 0.1 to 0.4");
  BOOST_TEST(contains(drawn.verdict, "no damper stops the mass at x = 0"), drawn.verdict);
  BOOST_TEST(!contains(drawn.report, "least beta"), drawn.report);
}

BOOST_AUTO_TEST_CASE(the_hits_say_why_the_damper_works_for_no_stronger_ones) {
  design::DesignRequest request;
  request.problem = {.v0 = 0.4, .p = 0.4, .beta = 1.5, .v0_low = 0.3};
  const auto caption = [&request] {
    return figure(page(DesignReport{design::design(request), {}}), "hits").caption();
  };
  BOOST_TEST(contains(caption(), "stop too, but not by the published criterion"), caption());
  request.problem.criterion = design::Criterion::exact;
  BOOST_TEST(!contains(caption(), "published"), caption());
  request.problem.p_high = 0.44;
  BOOST_TEST(contains(caption(), "rest off centre with some spring"), caption());
}

/// The damper of the second arrival with as little friction as can be, which a program sets to
/// 1e-9.
BOOST_AUTO_TEST_CASE(a_box_of_no_width_is_seen_and_any_f_has_no_slack) {
  design::DesignRequest request;
  request.problem = {.v0 = 1, .p = 1, .beta = 1, .arrivals = 2};
  request.limits.f_max = 0.001;
  const HtmlPage drawn = page(DesignReport{design::design(request), {}});
  const Figure& region = figure(drawn, "region");
  const auto& box = named(region.areas, "tolerance ±33.33 %").outline;
  BOOST_TEST(region.x.position(box[2].x) - region.x.position(box[0].x) > 0.01);
  BOOST_TEST_REQUIRE(region.inset.has_value());  // of arrival 1, not of the box
  BOOST_TEST(region.inset->y.least > 0.49);
  BOOST_TEST(std::regex_search(drawn.report, std::regex("amplitude +any f +- +met")), drawn.report);
  BOOST_TEST(contains(drawn.report, "v0 of 0.867 to 1.00"), drawn.report);
}

/// v0 may be up to 1e150, whatever the damper is.
BOOST_AUTO_TEST_CASE(an_interval_that_ends_with_the_inputs_allowed_is_open) {
  const auto written = [](double v0) {
    design::DesignRequest request;
    request.problem = {.v0 = v0, .p = 1, .beta = v0};
    return std::regex_replace(page(DesignReport{design::design(request), {}}).report,
                              std::regex("\\s+"), " ");
  };
  BOOST_TEST(contains(written(1e150), "v0 of at least 8.57e+149 "));
  BOOST_TEST(contains(written(1e-150), "v0 of up to 1.23e-150 "));
}

/// A factor of 0.5 below and 0.25 above for f, of 0.1 on both sides for delta.
BOOST_AUTO_TEST_CASE(a_table_of_a_tolerance_with_sides_of_its_own_has_them_all) {
  design::DesignRequest request;
  request.problem = {.v0 = 1, .p = 1, .beta = 1};
  request.limits.shape = {.f_low = 1, .f_high = 0.5, .delta_low = 0.2, .delta_high = 0.2};
  DesignReport report{design::design(request), {}};
  report.trade_off = {{{0.2, 0.4, 0.5}, 0.8, 1, 3}, {{0.3, 0.4, 0.5}, 0.7, 1.1, 3}};
  const std::string drawn = page(report).report;
  BOOST_TEST(
      std::regex_search(drawn, std::regex(R"(0\.80* +1\.0* +-50 \+25 % +\+-10 % +3\.0* +0\.2)")),
      drawn);
}

/// A nearest damper just above a limit has more digits than the limit: six would not tell.
BOOST_AUTO_TEST_CASE(a_limit_exceeded_by_little_is_told_from_what_exceeds_it) {
  RecordDesignReport report;
  report.result.nearest.figures.settled = true;
  report.result.shortfalls = {{&design::suite_figure_kinds[1], 0.32, 0.32000004, 0, std::nullopt}};
  report.result.request.records = {{"three", Record{{0.4, -0.2, 0}, 1, {}}, 1}};
  const std::string sentence = verdict(report);
  BOOST_TEST(contains(sentence, "of 0.32000004 g where 0.32 g is allowed"), sentence);
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
  result.finding.emplace().responses = {response, larger, response};
  BOOST_TEST(worst_record(result) == 1U);
}

/// The force of f = 0.02350064 is 276.556 kN, that of 0.0235006 is 276.553 kN.
BOOST_AUTO_TEST_CASE(a_force_is_that_of_the_design_wherever_it_stands) {
  design::PhysicalIsolator isolator;
  isolator.period_s = 2.8;
  isolator.mass_kg = 1.2e6;
  const design::PhysicalInput physical = design::physical_input(isolator, 0.4, 0);
  const double p = physical.scales.p;
  const double length = physical.scales.length_m;
  design::DesignRequest request;
  request.problem = {.v0 = p, .p = p, .beta = 0.16 / length};
  request.limits = {.f_max = 0.03, .delta_max = 0.006 / length, .tolerance = 0.1};
  const HtmlPage drawn = page(DesignReport{design::design(request), physical});
  BOOST_TEST(contains(drawn.verdict, "276.56 kN"), drawn.verdict);
  BOOST_TEST(std::regex_search(drawn.report, std::regex("friction force +276\\.56 kN")),
             drawn.report);
}

/// beta = 0.9 is exceeded from V0 = 1.136 on, and sqrt(f^2 + V0^2) = 1.08 from there to V0 =
/// sqrt(1.08^2 - f^2).
BOOST_AUTO_TEST_CASE(hits_above_the_limit_of_the_acceleration_are_shown) {
  design::DesignRequest request;
  request.problem = {.v0 = 1, .p = 1, .beta = 0.9};
  request.limits.acceleration_max = 1.08;
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

BOOST_AUTO_TEST_CASE(the_hits_are_told_with_the_digits_that_tell_them_apart) {
  // beta just above V0/(sqrt(2) p): the damper serves hits within some 1e-4.
  design::DesignRequest request;
  request.problem = {.v0 = 1, .p = 1, .beta = 0.7072};
  const HtmlPage drawn = page(DesignReport{design::design(request), {}});
  const std::string& caption = figure(drawn, "hits").caption();
  BOOST_TEST(contains(caption, "0.9998"), caption);
  BOOST_TEST(contains(caption, "1.0000"), caption);
}

BOOST_AUTO_TEST_CASE(both_ends_of_a_narrow_range_of_hits_are_told) {
  const design::RegionRequest request{
      .problem = {.v0 = 0.3000001, .p = 1, .beta = 0.25, .v0_low = 0.3}, .f = 0.08, .delta = 0.03};
  const Figure drawn = figure(page(RegionReport{request, design::answer(request)}), "hits");
  BOOST_TEST(has(drawn.curves, "V₀ = 0.3 to 0.3000001"));
}

/// Most are 2 f or less of 2 V0 wide, two pixels. Those of a kind share an entry of the key.
BOOST_AUTO_TEST_CASE(hits_of_narrow_strips_are_named_by_their_kind) {
  const design::RegionRequest request{
      .problem = {.v0 = 1, .p = 1, .beta = 1.2, .residual = 0.001}, .f = 0.004, .delta = 0.002};
  const Figure drawn = figure(page(RegionReport{request, design::answer(request)}), "hits");
  std::set<std::string> names;
  for (const figures::FigureArea& area : drawn.areas) {
    BOOST_TEST(!area.name.empty());
    names.insert(area.key.empty() ? area.name : area.key);
  }
  BOOST_TEST(names.size() < 12U);
  const std::string text = svg(drawn, figures::Frame::in_page);
  for (const char* const kind :
       {"centred at arrivals 2, 5, 8, 11, 14, 17, …,", "off centre</text>"}) {
    BOOST_TEST(contains(text, std::string(">") + kind), kind);
  }
  BOOST_TEST(contains(text, "<title>centred at arrival 7, "));
  BOOST_TEST(!contains(text, "<title></title>"));
}

/// Of 2 V0 the hits that it works for are 1e-4 wide, or 0.11 m/s of 0.8.
BOOST_AUTO_TEST_CASE(hits_too_few_to_see_are_enlarged) {
  design::DesignRequest request;
  request.problem = {.v0 = 1, .p = 1, .beta = 0.7072};
  const Figure drawn = figure(page(DesignReport{design::design(request), {}}), "hits");
  BOOST_TEST_REQUIRE(drawn.inset.has_value());
  BOOST_TEST(drawn.inset->x.least < 0.9999);
  BOOST_TEST(drawn.inset->x.least > 0.999);
  BOOST_TEST(drawn.inset->x.most > 1);
  BOOST_TEST(!figure(isolator(), "hits").inset.has_value());
}

/// The largest V0 that the program takes is 1e150.
BOOST_AUTO_TEST_CASE(hits_that_are_not_computed_are_shown_as_such) {
  design::DesignRequest request;
  request.problem = {.v0 = 1e150, .p = 1, .beta = 0.9e150};
  const Figure drawn = figure(page(DesignReport{design::design(request), {}}), "hits");
  BOOST_TEST(drawn.x.most == 2e150);
  BOOST_TEST(named(drawn.areas, "not computed").outline[0].x == 1e150);
  BOOST_TEST(!has(figure(isolator(), "hits").areas, "not computed"));
}

/// The peak is 11 mm below the limit, and so are its words, though there is more room above.
BOOST_AUTO_TEST_CASE(the_peak_is_named_on_its_side_of_the_limit) {
  design::DesignRequest request;
  design::PhysicalIsolator isolator;
  isolator.period_s = 2.8;
  const design::PhysicalInput physical = design::physical_input(isolator, 0.4, 0);
  const double p = physical.scales.p;
  request.problem = {.v0 = p,
                     .p = p,
                     .beta = 0.15 / physical.scales.length_m,
                     .criterion = design::Criterion::exact};
  request.limits.f_max = 0.03;
  const Figure drawn = figure(page(DesignReport{design::design(request), physical}), "motion");
  const std::string text = svg(drawn, figures::Frame::in_page);
  const auto height_of = [&](const std::string& words) {
    const std::regex place(R"re(translate\([\d.]+ ([\d.]+)\)"><text class="note"[^>]*>)re" + words);
    std::smatch found;
    BOOST_TEST_REQUIRE(std::regex_search(text, found, place), words);
    return std::stod(found[1]);
  };
  BOOST_TEST(height_of("peak 139.1 mm") > (1 - drawn.y.position(150)) * drawn.height);
  BOOST_TEST(height_of("limit 150 mm") < (1 - drawn.y.position(139.1)) * drawn.height);
}

/// f from 0.9 to 1.2 and Delta from 0.95 to 1.05 times the design's, or some multiple of that.
BOOST_AUTO_TEST_CASE(a_tolerance_of_each_side_is_drawn_as_it_is) {
  design::DesignRequest hit;
  hit.problem = {.v0 = 1, .p = 1, .beta = 1};
  design::DesignRequest pulsed;
  pulsed.problem = {.p = 1, .beta = 0.05};
  pulsed.pulse = HalfSine{0.5, 20};
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

/// After half of the hits that leave the notch, it stops the mass at the first arrival.
BOOST_AUTO_TEST_CASE(each_arrival_has_its_colour_in_each_figure) {
  design::RegionRequest request{
      .problem = {.v0 = 1, .p = 1, .beta = 1.1, .arrivals = 3}, .f = 0.05, .delta = 0.3};
  const figures::HtmlPage drawn = page(RegionReport{request, design::answer(request)});
  const auto ink = [&](const char* id, const char* name) {
    return named(figure(drawn, id).areas, name).ink;
  };
  BOOST_TEST((ink("hits", "centred") != ink("hits", "centred at arrival 2")));
  BOOST_TEST((ink("hits", "centred") == ink("region", "arrival 1")));
  BOOST_TEST((ink("hits", "centred at arrival 2") == ink("region", "arrival 2")));
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

/// f = 5 turns V0 = 1 at 0.0990; below f = 0.6, where the dead zone is as wide as beta, no f rests
/// within 0.1 whose peak is within beta.
BOOST_AUTO_TEST_CASE(a_dead_zone_too_wide_is_what_is_wrong_where_the_mass_rests_as_asked) {
  const design::RegionRequest request{
      .problem = {.v0 = 1, .p = 1, .beta = 0.6, .residual = 0.1}, .f = 5, .delta = 0.1};
  const HtmlPage made = page(RegionReport{request, design::answer(request)});
  BOOST_TEST(figure(made, "hits").caption() ==
             "The damper does not work for the hit that was asked for: friction could hold the "
             "mass at 0.6.");
  const auto& sides = figure(made, "region").areas;
  BOOST_TEST(named(sides, "too strong: rests too far off").outline.at(1).x == 0.6);
  BOOST_TEST(named(sides, "too strong: dead zone exceeds 0.6").outline.at(0).x == 0.6);
}

/// Of a damper that is much better than what is around it, and of one of many that hold the mass.
BOOST_AUTO_TEST_CASE(a_damper_unlike_its_cell_of_the_map_is_told_apart) {
  design::RecordDesignRequest request;
  request.records = {{"three", Record{{0.4, -0.2, 0}, 1, {}}, 1}};
  request.f = Interval{0, 0.4};
  request.delta = Interval{0, 1};
  request.limits.jump = 9;
  const std::string words = "the damper found is better than the middle of its cell";
  RecordDesignReport unlike{design::design(request), {}};
  unlike.result.nearest.damper = {1, 0.4, 1};
  const Figure apart = figure(page(unlike), "map");
  BOOST_TEST(std::ranges::count(apart.map.cells, std::uint8_t{0}) > 0);
  BOOST_TEST(contains(apart.caption(), words), apart.caption());
  request.objective = design::SuiteObjective::amplitude;
  const Figure alike = figure(page(RecordDesignReport{design::design(request), {}}), "map");
  BOOST_TEST(!contains(alike.caption(), words), alike.caption());
}

/// What is felt is friction at least, and 0.4 where friction holds the mass.
BOOST_AUTO_TEST_CASE(maps_show_where_a_damper_is_good_and_what_is_about_it) {
  design::RecordDesignRequest request;
  request.records = {{"three", Record{{0.4, -0.2, 0}, 1, {}}, 1}};
  request.f = Interval{0, 0.4};
  request.delta = Interval{0, 1};
  request.limits.jump = 9;
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
  BOOST_TEST(contains(all.caption(), "; the search went beyond this map, over f = 0 to 0.4"),
             all.caption());
  const Figure near = figure(page(report), "map-near");
  BOOST_TEST(all.folded.empty());
  BOOST_TEST(contains(all.caption(), "a cell shows the worst within the tolerance"), all.caption());
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
  design::RecordDesignRequest request;
  request.records = {{"three", Record{{0.4, -0.2, 0}, 1, {}}, 1}};
  request.f = Interval{0, 0.3};
  request.delta = Interval{0, 0.2};
  request.limits.jump = 1e-3;
  const figures::FigureMap map =
      figure(page(RecordDesignReport{design::design(request), {}}), "map").map;
  std::set<std::string> violated;
  for (const std::uint8_t cell : map.cells) {
    const figures::MapShade& shade = map.palette[cell];
    const bool is_violated = !shade.label.empty();  // which names the limit
    BOOST_TEST((shade.hatch == figures::Hatch::one_way) == is_violated, shade.name);
    violated.insert(shade.label);
  }
  BOOST_TEST(violated.contains("jump too large"));
  BOOST_TEST(violated.size() >= 2U);
}

/// Under the one record, as far as the worst stroke of the box, beyond that of the design.
BOOST_AUTO_TEST_CASE(the_worst_damper_of_the_box_is_drawn_beside_the_design) {
  design::RecordDesignRequest request;
  request.records = {{"three", Record{{0.4, -0.2, 0}, 1, {}}, 1}};
  request.objective = design::SuiteObjective::amplitude;
  request.f = Interval{0.1, 0.1};
  request.delta = Interval{0, 0};
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
  const double worst = result.finding->box.worst.peak;
  const double own = result.finding->point.figures.peak;
  constexpr double of_the_drawing = 1e-3;  // the peak may lie between two samples
  BOOST_TEST(worst > own * 1.01);
  BOOST_TEST(std::abs(farthest("worst within the tolerance") / worst - 1) <= of_the_drawing);
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

/// The largest Delta is shown where it is not far above the least that is needed, 2.41 mm.
BOOST_AUTO_TEST_CASE(a_pulse_shows_a_largest_delta_that_is_close) {
  design::RegionRequest request;
  request.problem = {.p = 1, .beta = 0.05};
  request.pulse = HalfSine{0.5, 20};
  const auto most = [&request](double limit) {
    request.limits.delta_max = limit;
    return figure(page(RegionReport{request, design::answer(request)}), "region").y.most;
  };
  const double far = most(1);
  BOOST_TEST(most(far) > 1.1 * far);
  BOOST_TEST(most(2 * far) == far);
}

/// With little friction the strips touch, and the first is too thin for its name.
BOOST_AUTO_TEST_CASE(neighbouring_strips_differ) {
  design::RegionRequest request{.problem = {.v0 = 1, .p = 1, .beta = 1, .arrivals = 4},
                                .limits = {.f_max = 0.01}};
  const auto check = [&] {
    const Figure drawn = figure(page(RegionReport{request, design::answer(request)}), "region");
    const auto ink = [&](int arrival) {
      const std::string name = "arrival " + std::to_string(arrival);
      const auto& area = named(drawn.areas, name);
      return area.ink;
    };
    for (int arrival = 2; arrival <= 4; ++arrival) {
      BOOST_TEST((ink(arrival) != ink(arrival - 1)), arrival);
    }
    BOOST_TEST((ink(3) != ink(1)));
  };
  check();
  request.f = 0.005;  // a damper of the third strip
  request.delta = 0.2;
  check();
}

/// Every f from 0 on keeps the peak: no strip of f is too weak, not even one too narrow to see.
BOOST_AUTO_TEST_CASE(a_pulse_that_no_f_is_too_weak_for_has_no_such_side) {
  design::RegionRequest request;
  request.problem = {.p = 1, .beta = 0.05};
  request.pulse = HalfSine{0.5, 20};
  const HtmlPage drawn = page(RegionReport{request, design::answer(request)});
  const Figure& region = figure(drawn, "region");
  BOOST_TEST(has(region.areas, "admissible"));
  BOOST_TEST(!has(region.areas, "too weak: exceeds 0.05"));
}

BOOST_AUTO_TEST_CASE(arrivals_of_one_colour_share_an_entry_of_the_key) {
  const design::RegionRequest request{
      .problem = {.v0 = 1, .p = 1, .beta = 1, .arrivals = 12}, .f = 0.06, .delta = 0.01};
  const HtmlPage drawn = page(RegionReport{request, design::answer(request)});
  const auto& strips = figure(drawn, "region").areas;
  BOOST_TEST(named(strips, "arrival 9").key == "arrivals 3, 6, 9, 12");
  const auto& hits = figure(drawn, "hits").areas;
  BOOST_TEST(named(hits, "centred at arrival 3").key == "centred at arrivals 3, 6");
  for (const char* arrival : {"3", "4", "5", "6", "7"}) {
    BOOST_TEST((named(hits, std::string("centred at arrival ") + arrival).ink ==
                named(strips, std::string("arrival ") + arrival).ink));
  }
}

/// The strips of arrivals 5 and 6 there are 0.008 and 0.006 high, three or four pixels.
BOOST_AUTO_TEST_CASE(a_point_among_strips_that_its_mark_hides_is_enlarged) {
  design::RegionRequest request{
      .problem = {.v0 = 1, .p = 1, .beta = 1, .arrivals = 12}, .f = 0.06, .delta = 0.01};
  const auto inset = [&] {
    return figure(page(RegionReport{request, design::answer(request)}), "region").inset;
  };
  BOOST_TEST_REQUIRE(inset().has_value());
  BOOST_TEST(std::abs(inset()->x.position(0.06) - 0.5) < 0.1);
  BOOST_TEST(std::abs(inset()->y.position(0.01) - 0.5) < 0.5);
  request.f = 0.2;  // between strips 1 and 2, which are far apart
  request.delta = 0.1;
  BOOST_TEST(!inset().has_value());
}

/// With one arrival a rest after a passage is too late, however close it is.
BOOST_AUTO_TEST_CASE(hits_that_rest_within_the_residual_too_late_are_hatched) {
  const design::RegionRequest request{
      .problem = {.v0 = 1, .p = 1, .beta = 1, .residual = 0.6}, .f = 0.3, .delta = 0.02};
  const HtmlPage drawn = page(RegionReport{request, design::answer(request)});
  const auto& hits = figure(drawn, "hits").areas;
  BOOST_TEST((named(hits, "within the residual").look == figures::AreaLook::filled));
  const auto& late = named(hits, "within the residual after 1 passage");
  BOOST_TEST((late.look == figures::AreaLook::hatched));
  BOOST_TEST(late.key == "within the residual, but too late");
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

/// Those that rest off centre, 1e-3 of the figure, are not seen beside those that are held.
BOOST_AUTO_TEST_CASE(the_caption_of_hits_tells_what_is_beyond_a_strip_too_thin_to_see) {
  design::DesignRequest request;
  request.problem = {.v0 = 1, .p = 1, .beta = 0.8};
  const HtmlPage drawn = page(DesignReport{design::design(request), {}});
  BOOST_TEST(contains(figure(drawn, "hits").caption(),
                      "; slightly weaker ones rest off centre, weaker ones are held at the start "
                      "and stronger ones go too far"));
  BOOST_TEST(!contains(svg(figure(drawn, "hits"), figures::Frame::in_page), ">off centre</text>"));
}

BOOST_AUTO_TEST_CASE(the_caption_says_what_a_clear_area_and_a_strip_mean) {
  const auto caption = [](const design::Problem& problem) {
    const design::RegionRequest request{.problem = problem};
    return figure(page(RegionReport{request, design::answer(request)}), "region").caption();
  };
  BOOST_TEST(caption({.v0 = 1, .p = 1, .beta = 0.95, .arrivals = 4}) ==
             "A damper in the area without hatching is admissible; "
             "in each strip the mass stops at x = 0 at that arrival, in a lower strip at a later "
             "one.");
  const std::string strips = "; in each strip the mass rests within the residual at that arrival.";
  BOOST_TEST(
      contains(caption({.v0 = 1, .p = 1, .beta = 0.95, .arrivals = 2, .residual = 0.05}), strips));
  // Rests in the dead zone too: f up to the residual p^2 = 0.3 is an area of its own.
  BOOST_TEST(contains(caption({.v0 = 1, .p = 1, .beta = 0.95, .residual = 0.3}),
                      "; in the strip of an arrival the mass rests within the residual at that "
                      "arrival."));
  // The strips of arrivals from 13 on are drawn as one.
  BOOST_TEST(contains(caption({.v0 = 1, .p = 1, .beta = 1, .arrivals = 40}),
                      "; the grey area is admissible only in thin strips."));
  BOOST_TEST(!contains(caption({.v0 = 1, .p = 1, .beta = 1, .arrivals = 12}), "thin strips"));
  const design::RegionRequest only{
      .problem = {
          .v0 = 1.1, .p = 1, .beta = 0.95, .criterion = design::Criterion::exact, .v0_low = 0.9}};
  const Figure one = figure(page(RegionReport{only, design::answer(only)}), "region");
  BOOST_TEST((named(one.areas, "admissible").ink == figures::Ink::sky));
  BOOST_TEST(one.caption() ==
             "A damper in the area without hatching is admissible with every hit of the range.");
}

/// With f >= 0.0513 for the peak, no rest in the dead zone is within 0.05.
BOOST_AUTO_TEST_CASE(an_only_area_within_a_residual_is_called_admissible) {
  const design::RegionRequest request{.problem = {.v0 = 1, .p = 1, .beta = 0.95, .residual = 0.05}};
  const Figure drawn = figure(page(RegionReport{request, design::answer(request)}), "region");
  BOOST_TEST((named(drawn.areas, "admissible").ink == figures::Ink::sky));
  BOOST_TEST(!has(drawn.areas, "arrival 1"));
  BOOST_TEST(drawn.caption() == "A damper in the area without hatching is admissible.");
}

/// m V0^2/2 = 100 t (0.4 m/s)^2/2 = 8 kJ.
BOOST_AUTO_TEST_CASE(the_energy_is_in_kilojoules_and_every_part_has_a_name) {
  const HtmlPage page = isolator();
  const Figure& drawn = figure(page, "energy");
  BOOST_TEST(drawn.y.label == "energy, kJ");
  BOOST_TEST(contains(drawn.description, "Of the energy of 8 kJ at the start"), drawn.description);
  for (const char* part : {"kinetic and spring", "constant friction", "notch"}) {
    BOOST_TEST(has(drawn.areas, part), part);
  }
}

BOOST_AUTO_TEST_CASE(text_alternatives_carry_units) {
  for (const Figure& drawn : isolator().figures) {
    const char* const unit = drawn.id == "energy" ? " kJ" : drawn.id == "hits" ? " m/s" : " mm";
    BOOST_TEST(contains(drawn.description, unit), drawn.description);
    BOOST_TEST(!drawn.caption().empty());
  }
}

BOOST_AUTO_TEST_CASE(tables_have_the_units_of_the_figures_and_mark_what_is_violated) {
  BOOST_TEST(contains(isolator().body, "\u00a0mm</td>"));
  BOOST_TEST(contains(isolator().body, "<th>peak,\u00a0mm</th><th>stop time,\u00a0s</th>"));
  BOOST_TEST(contains(region(0.9, 0.5, 0.37).body, "<tr class=\"violated\"><td>return</td>"));
  BOOST_TEST(!contains(region(0.9, 0.26, 0.37).body, "class=\"violated\""));
}

BOOST_AUTO_TEST_CASE(the_answer_stands_above_the_figures) {
  const std::string whole = figures::html(isolator());
  BOOST_TEST(whole.find("<th>works for</th>") < whole.find("<figure>"));
}

BOOST_AUTO_TEST_CASE(a_last_odd_figure_stands_beside_the_tables) {
  HtmlPage page = isolator();
  const auto odd = [&page] { return contains(figures::html(page), "</div>\n<figure>"); };
  page.figures.resize(3);
  BOOST_TEST(odd());
  page.figures.resize(2);
  BOOST_TEST(!odd());
}

BOOST_AUTO_TEST_CASE(a_folded_figure_stands_with_the_one_above_it) {
  HtmlPage page = isolator();
  page.figures.resize(3);
  page.figures[1].folded = "more";
  const std::string whole = figures::html(page);
  const std::size_t fold = whole.find("<details><summary>more</summary>\n<figure>");
  BOOST_TEST_REQUIRE(fold != std::string::npos);
  const auto title = [&](std::size_t i) {
    return whole.find("id=\"" + page.figures[i].id + "-title\"");
  };
  BOOST_TEST(title(0) < fold);
  BOOST_TEST(fold < title(1));
  BOOST_TEST(whole.find("</details>", fold) > title(1));
  BOOST_TEST(whole.find("</details>", fold) < title(2));
}

BOOST_AUTO_TEST_CASE(the_report_as_text_is_folded_away) {
  const HtmlPage page = isolator();
  const std::string whole = figures::html(page);
  const std::size_t folded = whole.find("<details>");
  BOOST_TEST_REQUIRE(folded != std::string::npos);
  BOOST_TEST(folded > whole.find("Constraints"));
  BOOST_TEST(contains(page.report, page.verdict.substr(0, 20)));
}

BOOST_AUTO_TEST_SUITE_END()
