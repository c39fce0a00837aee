// SPDX-License-Identifier: MIT
#include "drawn_pages.hpp"

#include <stillpoint/core/half_cycles.hpp>
#include <stillpoint/design/built_notch.hpp>
#include <stillpoint/design/shown_motion.hpp>

// What a reader must see of a motion: over time, and in the phase plane.

BOOST_AUTO_TEST_SUITE(motion_figures_test)

using namespace stillpoint;
using namespace stillpoint::report;
using namespace stillpoint::test;

/// The motion without friction; without strokes if it is left out.
figures::FigureCurve ghost_of(const Figure& drawn) {
  const auto found = std::ranges::find_if(drawn.curves, [](const figures::FigureCurve& curve) {
    return curve.name.starts_with("without ");
  });
  return found == drawn.curves.end() ? figures::FigureCurve() : *found;
}

HtmlPage motion(const Oscillator& oscillator, const Excitation& excitation = {},
                const Start& start = {0, 1}) {
  return page_of(simulation_of(oscillator, start, excitation));
}

BOOST_AUTO_TEST_CASE(the_motion_is_labelled_in_place_beside_one_without_friction) {
  const HtmlPage page = isolator();
  const Figure& drawn = figure(page, "motion");
  BOOST_TEST(std::ranges::any_of(drawn.notes, [](const figures::FigureNote& note) {
    return contains(note.text, "peak 13") && contains(note.text, " mm");
  }));
  BOOST_TEST(has(drawn.curves, "limit 150 mm"));
  // Without friction the peak is V0/p = 0.4 m/s * 2.8 s/(2 pi) = 178.25 mm.
  const auto ghost = ghost_of(drawn);
  const auto [least, most] = std::ranges::minmax(ghost.strokes[0], {}, &figures::FigurePoint::y);
  BOOST_TEST(most.y == 178.25, tt::tolerance(1e-3));  // of samples
  // On its way back it passes the lower end of the frame, which is next to x = 0.
  BOOST_TEST(drawn.y.least > least.y);
}

BOOST_AUTO_TEST_CASE(many_half_cycles_become_an_envelope_of_the_whole_motion) {
  const HtmlPage page = motion({1, 1e-3, 1e-4});  // 424 half-cycles
  const Figure& drawn = figure(page, "motion");
  BOOST_TEST(has(drawn.curves, "envelope"));
  BOOST_TEST(!has(drawn.curves, "x"));
  BOOST_TEST(drawn.title == "Motion");              // not only its beginning
  const HtmlPage longer = motion({1, 1e-4, 1e-4});  // 2254 half-cycles
  BOOST_TEST(!has(figure(motion({1, 0.02, 0.02}), "motion").curves, "envelope"));
}

/// Without a notch a peak is 2 f lower than the one before it, half a period or pi earlier. A
/// column of time holds only a part of these 100 half-cycles.
BOOST_AUTO_TEST_CASE(the_envelope_goes_through_the_peaks) {
  constexpr double f = 0.005;
  const HtmlPage page = motion({1, f, 0});
  const auto& outline = named(figure(page, "motion").curves, "envelope").strokes[0];
  const auto peak = [](double half_cycles) { return 1 - 2 * f * half_cycles; };
  constexpr double before = 2;  // half-cycles: a column has the largest of its time
  constexpr double behind = 2;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const double now = outline[i].x / std::numbers::pi;
    const double away = i < outline.size() / 2 ? outline[i].y : -outline[i].y;
    if (2 < now && now < 90) {  // beyond the first turn of either side
      BOOST_TEST(away >= peak(now + behind), away << " after " << now << " half-cycles");
      BOOST_TEST(away <= peak(now - before), away << " after " << now << " half-cycles");
    }
  }
}

/// In resonance A grows by pi k/2 a half-cycle: a motion that goes on ends as wide as it was.
BOOST_AUTO_TEST_CASE(the_envelope_of_a_motion_that_goes_on_does_not_end) {
  SimulationRequest request =
      simulation_of({1, 0.05, 0}, {0, 1}, Harmonic{.k = 0.2, .lambda = 0.7});
  for (const double end : {250.0, 251.0, 252.0, 253.0, 254.0, 255.0, 256.0}) {
    request.t_end = end;
    const Figure drawn = figure(page_of(request), "motion");
    const auto& outline = named(drawn.curves, "envelope").strokes[0];
    const std::size_t columns = outline.size() / 2;
    const double settled = outline[columns - 20].y;
    for (std::size_t i = columns - 20; i < columns; ++i) {
      BOOST_TEST(outline[i].y >= 0.95 * settled, "column " << i << " up to " << end);
    }
  }
}

/// From x = 0 freely to the peak A and back to the rest x: the zones take theirs over every path,
/// a notch with a width takes delta/w for the way into it.
BOOST_AUTO_TEST_CASE(zones_and_a_notch_with_a_width_take_their_part_of_the_energy) {
  SimulationRequest request = simulation_of({1, 0.26, 0.37}, {0, 1});
  request.surface = {0.05, {{0.2, 0.1}}};
  const Simulation answer = simulate(request);
  BOOST_TEST_REQUIRE(answer.response.zero_passages == 0);
  const double rest = answer.response.stop_position.value();
  const double peak = answer.response.peak_amplitude;
  const double friction = 0.1 * (0.2 + 0.2 - rest) + 2 * 0.26 * (peak - 0.2);
  const Figure drawn = figure(page(MotionReport{request, answer}), "energy");
  const auto last = [&](std::size_t curve) { return drawn.curves[curve].strokes[0].back().y; };
  BOOST_TEST(last(0) == rest * rest / 2, tt::tolerance(1e-9));
  BOOST_TEST(last(1) - last(0) == friction, tt::tolerance(1e-9));
  BOOST_TEST(last(2) - last(1) == 0.37 / 0.05 * (0.025 - rest), tt::tolerance(1e-9));
}

/// Two passages, then a rest at |x|, in the width. The damper takes the integral of 2 zeta p v^2.
BOOST_AUTO_TEST_CASE(damping_takes_its_part_of_the_energy) {
  constexpr double zeta = 0.05;
  for (const bool wide : {false, true}) {
    SimulationRequest request =
        simulation_of({.p = 2, .f = 0.2, .delta = 0.02, .zeta = zeta, .breakaway = 1.5}, {0, 1});
    request.samples = 100'000;
    if (wide) {
      request.surface.notch_width = 0.02;
    }
    const Simulation answer = simulate(request);
    BOOST_TEST_REQUIRE(answer.response.zero_passages == 2);
    const double rest = std::abs(answer.response.stop_position.value());
    double path = -rest;
    for (const HalfCycle& now : answer.half_cycles) {
      path += 2 * now.peak;
    }
    double damping = 0;
    for (std::size_t i = 1; i < answer.trajectory.size(); ++i) {
      const TracedState& from = answer.trajectory[i - 1];
      const TracedState& to = answer.trajectory[i];
      damping += 2 * zeta * 2 * (from.v * from.v + to.v * to.v) / 2 * (to.tau - from.tau);
    }
    const Energies& energies = answer.energies.energies.value();
    BOOST_TEST(energies.slip_path == path, tt::tolerance(1e-12));
    BOOST_TEST(energies.damping == damping, tt::tolerance(1e-7));
    const Figure drawn = figure(page(MotionReport{request, answer}), "energy");
    const auto last = [&](std::size_t curve) { return drawn.curves[curve].strokes[0].back().y; };
    BOOST_TEST(contains(drawn.caption(), ", damping 0.1"));
    BOOST_TEST(last(0) == 2 * rest * rest, tt::tolerance(1e-9));
    BOOST_TEST(last(1) - last(0) == 0.2 * path, tt::tolerance(1e-9));
    BOOST_TEST(last(2) - last(1) == damping, tt::tolerance(1e-7));  // of the trapezoids
    const double inside = wide ? std::max(0.01 - rest, 0.0) / 0.02 : 0;
    BOOST_TEST(last(3) - last(2) == 0.02 * (2 + inside), tt::tolerance(1e-9));
  }
}

/// What friction and damping take is the area that their curve has gone round.
BOOST_AUTO_TEST_CASE(the_loop_encloses_what_the_damper_takes) {
  for (const double zeta : {0.0, 0.1}) {
    SimulationRequest request = simulation_of({.p = 1, .f = 0.2, .zeta = zeta}, {0, 1});
    request.excitation = HalfSine{0.3, 2};
    const Simulation answer = simulate(request);
    const Figure drawn = figure(page(MotionReport{request, answer}), "loop");
    const Energies& energies = answer.energies.energies.value();
    double area = 0;
    for (const auto& arc : drawn.curves[0].strokes) {
      for (std::size_t i = 1; i < arc.size(); ++i) {
        area += (arc[i].x - arc[i - 1].x) * (arc[i].y + arc[i - 1].y) / 2;
      }
    }
    const double by_trapezoids = zeta > 0 ? 1e-4 : 1e-12;
    BOOST_TEST(area == energies.friction + energies.damping, tt::tolerance(by_trapezoids));
  }
}

BOOST_AUTO_TEST_CASE(a_locked_mass_transmits_the_load_but_exerts_no_friction_in_its_loop) {
  const HtmlPage drawn = motion({1, 0.1, 1}, HalfSine{0.5, 0.7}, {1, 0});
  const auto& felt = figure(drawn, "transmitted").curves[0].strokes[0];
  BOOST_TEST(std::ranges::max(felt, {}, &figures::FigurePoint::y).y == 0.5, tt::tolerance(1e-3));
  BOOST_TEST(std::abs(felt.back().y) <= 1e-15);
  const auto& friction = figure(drawn, "loop").curves[0].strokes[0];
  BOOST_TEST(std::ranges::min(friction, {}, &figures::FigurePoint::y).y == -0.1);
}

/// x = V0/(p w) exp(-zeta p tau) sin(p w tau), w^2 = 1 - zeta^2, is largest where tan(w p tau) =
/// w/zeta. Under a load it is followed beyond its end.
BOOST_AUTO_TEST_CASE(a_damped_motion_stands_beside_one_without_friction_as_damped) {
  constexpr double zeta = 0.2;
  const double w = std::sqrt(1 - zeta * zeta);
  const HtmlPage drawn = motion({.p = 1, .f = 0.1, .delta = 0, .zeta = zeta});
  const auto ghost = ghost_of(figure(drawn, "motion"));
  const auto most = std::ranges::max(ghost.strokes[0], {}, &figures::FigurePoint::y);
  BOOST_TEST(most.y == std::exp(-zeta / w * std::acos(zeta)), tt::tolerance(1e-3));  // of samples
  BOOST_TEST(ghost_of(figure(motion({.p = 1, .f = 0, .delta = 0, .zeta = zeta}), "motion"))
                 .strokes.empty());
  const design::ShownMotion hit = design::shown_motion(
      simulation_of({.p = 1, .f = 0.1, .delta = 0, .zeta = zeta}, {}, Rectangle{1e4, 3e4}));
  BOOST_TEST(hit.frictionless.value().reach.low == -std::numbers::pi / 3 * most.y,
             tt::tolerance(1e-3));
}

/// Where the friction changes there is a state, a mark and a kink, out and in again.
BOOST_AUTO_TEST_CASE(the_edges_of_a_notch_with_a_width_are_drawn) {
  SimulationRequest request = simulation_of({1, 0.26, 0.37}, {0, 1});
  request.surface = {0.05, {}};
  const Simulation answer = simulate(request);
  const HtmlPage drawn = page(MotionReport{request, answer});
  for (const char* const id : {"motion", "phase"}) {
    const Figure& each = figure(drawn, id);
    const auto& notch = named(each.areas, "notch").outline;
    const auto across =
        id == std::string("phase") ? &figures::FigurePoint::x : &figures::FigurePoint::y;
    BOOST_TEST((std::ranges::max(notch, {}, across).*across == 0.025));
    const auto& edges = named(each.marks, "edge of the notch").points;
    BOOST_TEST_REQUIRE(edges.size() == 2U);
    for (const figures::FigurePoint& at : edges) {
      BOOST_TEST((at.*across == 0.025));
    }
    BOOST_TEST(!has(each.marks, "passage"));
    BOOST_TEST(named(each.marks, "turn").points.size() == 1U);  // the other is the rest
  }
  // v^2/2 at the edge, from the peak inwards: (A^2 - x^2)/2 - f (A - x).
  const double peak = answer.response.peak_amplitude;
  const double v = named(figure(drawn, "phase").marks, "edge of the notch").points[1].y;
  const double fallen = (peak * peak - 0.025 * 0.025) / 2 - 0.26 * (peak - 0.025);
  BOOST_TEST(v * v / 2 == fallen, tt::tolerance(1e-9));
  request.surface.notch_width = 4;  // beyond the figure on both sides
  const HtmlPage all = page_of(request);
  BOOST_TEST(!has(figure(all, "motion").areas, "notch"));
}

/// The motion that the headline tells, and the paper's beside it where the eye can tell them apart.
BOOST_AUTO_TEST_CASE(a_design_is_drawn_with_the_notch_that_will_be_built) {
  const auto drawn = [](const design::NotchShape& shape, const design::DesignRequest& request) {
    DesignReport report{design::design(request), {}};
    report.built_notch = built_notch(report.result, shape);
    return page(report);
  };
  const design::DesignRequest hit{.problem = {.v0 = 1, .p = 1, .beta = 0.9}};
  const HtmlPage wide = drawn({.width = 0.1}, hit);
  const Figure& motion = figure(wide, "motion");
  BOOST_TEST(named(motion.marks, "rest").points.front().y > 0.01);
  BOOST_TEST(named(motion.curves, "notch that has no width").strokes[0].back().y == 0);
  BOOST_TEST(has(figure(wide, "phase").areas, "notch"));
  BOOST_TEST(has(figure(wide, "energy").areas, "notch"));
  for (const design::NotchShape& same : {design::NotchShape{.width = 1e-3}, {.hold = 0.1}}) {
    const Figure alike = figure(drawn(same, hit), "motion");
    BOOST_TEST(!has(alike.curves, "notch that has no width"));
    BOOST_TEST(!has(alike.curves, "notch that holds any load"));
  }
  design::DesignRequest shaken = hit;
  shaken.pulse = HalfSine{0.5, 20};
  shaken.problem = {.v0 = 0, .p = 1, .beta = 0.05};
  const HtmlPage held = drawn({.hold = 1}, shaken);
  BOOST_TEST(has(figure(held, "pulse").areas, "locked throughout"));
  BOOST_TEST(has(figure(held, "pulse").curves, "notch that acts only after the start"));
  BOOST_TEST(std::ranges::count(held.figures, "phase", &Figure::id) == 0);
}

/// The time at rest is a part of each figure over time.
BOOST_AUTO_TEST_CASE(the_energy_is_drawn_over_the_time_of_the_motion) {
  const HtmlPage page = motion({1, 0.3, 0.4});
  const Figure& moving = figure(page, "motion");
  const double rest = named(moving.marks, "rest").points.front().x;
  BOOST_TEST(moving.x.most == 1.25 * rest);
  BOOST_TEST(figure(page, "energy").x.most == moving.x.most);
  for (const auto& curve : figure(page, "energy").curves) {
    BOOST_TEST(curve.strokes[0].back().x == moving.x.most);
  }
  const figures::FigurePoint end = named(moving.curves, "x").strokes[0].back();
  BOOST_TEST(end.x == moving.x.most);
  BOOST_TEST(end.y == 0);
}

/// The notch takes what is left of the speed at once, at the stop too: nothing is rounded off.
BOOST_AUTO_TEST_CASE(the_stop_of_a_forced_motion_is_a_jump) {
  const Figure drawn = figure(motion({1, 0.3, 0.4}, HalfSine{0.05, 3}), "phase");
  const auto& jumps = named(drawn.curves, "jump at x = 0");
  BOOST_TEST(jumps.strokes.back().front().y < -0.1);
  BOOST_TEST(jumps.strokes.back().back().y == 0);
  SimulationRequest zones = simulation_of({1, 0.1, 0}, {0, 1});
  zones.surface.zones = {{0.2, 0.3}, {0.5, 0.15}};
  const HtmlPage without = page_of(zones);
  BOOST_TEST(!has(figure(without, "phase").curves, "jump at x = 0"));
}

/// Near resonance the notch holds up to f + 0.1 g: it stops the mass, and the load frees it later.
BOOST_AUTO_TEST_CASE(a_notch_that_lets_go_is_marked_apart_from_a_passage) {
  Oscillator holding{1, 0.05, 0.1};
  const Harmonic load{.k = 0.2, .lambda = 0.8, .duration = 60};
  const auto marked = [&](const char* name) {
    return named(figure(motion(holding, load), "phase").marks, name).points;
  };
  BOOST_TEST(!marked("passage").empty());
  BOOST_TEST(marked("stopped by the notch, then freed").empty());
  holding.hold = 0.1;
  const auto freed = marked("stopped by the notch, then freed");
  BOOST_TEST(!freed.empty());
  const auto passed = marked("passage");
  const auto stands = [](const figures::FigurePoint& at) { return at.y == 0; };
  BOOST_TEST(std::ranges::all_of(freed, stands));
  BOOST_TEST(std::ranges::none_of(passed, stands));
}

/// The record of 0.35 g moves the free mass a hundred times as far as the one with this notch.
BOOST_AUTO_TEST_CASE(a_motion_without_friction_is_left_out_where_it_only_crosses_the_figure) {
  const Harmonic load{.k = 0.35, .lambda = 1, .duration = 20};
  const auto drawn = [&](double f) { return figure(motion({1, f, 0}, load, {0, 0}), "motion"); };
  const Figure barely = drawn(0.345);
  BOOST_TEST(ghost_of(barely).strokes.empty());
  BOOST_TEST(!ghost_of(drawn(0.1)).strokes.empty());
}

/// Caught at its first return; the load lasts 40.
BOOST_AUTO_TEST_CASE(the_time_locked_is_shaded_above_the_whole_load) {
  const Harmonic load{.k = 0.05, .lambda = 3, .duration = 40};
  const HtmlPage page = motion({1, 0.3, 0.4}, load);
  const Figure& moving = figure(page, "motion");
  const Figure& below = page.figures.at(1);
  BOOST_TEST(below.id == "excitation");
  BOOST_TEST(below.below);
  BOOST_TEST(below.x.most == moving.x.most);
  BOOST_TEST(below.x.most >= 40);
  for (const Figure* const drawn : {&moving, &below}) {
    BOOST_TEST_REQUIRE(!drawn->areas.empty());
    BOOST_TEST(contains(drawn->areas.front().name, "locked from"));
    BOOST_TEST(drawn->areas.front().outline[1].x == drawn->x.most);
    BOOST_TEST(drawn->areas.front().outline[0].x < 5);
  }
}

/// The amplitude falls from 1 by 2 f = 0.002 a half-cycle: loops 0.05 apart.
BOOST_AUTO_TEST_CASE(loops_of_a_phase_portrait_of_many_turns_are_told_apart) {
  const Figure drawn = figure(motion({1, 1e-3, 0}), "phase");
  BOOST_TEST(drawn.title == "Phase portrait (some of the turns)");
  BOOST_TEST_REQUIRE(drawn.curves.size() == 1U);
  const auto& strokes = drawn.curves.front().strokes;
  BOOST_TEST(strokes.size() == 20U);
  for (std::size_t i = 1; i < strokes.size(); ++i) {
    BOOST_TEST(std::abs(strokes[i].front().x) < std::abs(strokes[i - 1].front().x) - 0.049);
  }
  BOOST_TEST(drawn.curves.front().directed);
}

/// A motion over 3 under a load that lasts 2000: too few points would be joined by a curve that
/// leaves the frame.
BOOST_AUTO_TEST_CASE(a_short_motion_under_a_long_load_is_drawn_finely) {
  const Harmonic load{.k = 1e-3, .lambda = 0.01, .duration = 2000};
  const Figure drawn = figure(motion({1, 0.3, 0.4}, load), "phase");
  const auto& arc = drawn.curves.front().strokes[0];
  BOOST_TEST(arc.size() > 100U);
  for (std::size_t i = 1; i < arc.size(); ++i) {
    BOOST_TEST(std::abs(arc[i].y - arc[i - 1].y) < 0.05 * (drawn.y.most - drawn.y.least));
  }
}

BOOST_AUTO_TEST_SUITE_END()
