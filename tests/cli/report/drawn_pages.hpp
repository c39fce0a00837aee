// SPDX-License-Identifier: MIT
#pragma once

// Pages of figures, and what is drawn on them.

#include "testing/random_scene.hpp"
#include "testing/simulation_of.hpp"
#include "testing/test.hpp"

#include <stillpoint/design/design.hpp>
#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/report.hpp>

namespace stillpoint::test {

using figures::Figure;
using figures::HtmlPage;

inline const Figure& figure(const HtmlPage& page, const std::string& id) {
  const auto found = std::ranges::find(page.figures, id, &Figure::id);
  BOOST_TEST_REQUIRE((found != page.figures.end()), id);
  return *found;
}

template <class Things>
bool has(const Things& things, const std::string& name) {
  return std::ranges::any_of(things, [&](const auto& thing) { return thing.name == name; });
}

/// The one of that name.
template <class Things>
const auto& named(const Things& things, const std::string& name) {
  const auto found =
      std::ranges::find_if(things, [&](const auto& now) { return now.name == name; });
  BOOST_TEST_REQUIRE((found != things.end()), name);
  return *found;
}

inline bool has_note(const Figure& figure, const std::string& text) {
  return std::ranges::count(figure.notes, text, &figures::FigureNote::text) == 1;
}

/// Of 2.8 s, 0.4 m/s, 100 t.
inline report::DesignReport isolator_report() {
  design::PhysicalIsolator isolator;
  isolator.period_s = 2.8;
  isolator.mass_kg = 1e5;
  design::PhysicalInput physical = design::physical_input(isolator, 0.4, 0);
  const double p = physical.scales.p;
  const design::DesignRequest request{
      .problem = {.v0 = p, .p = p, .beta = 0.15 / physical.scales.length_m}};
  return {design::design(request), physical};
}

inline HtmlPage page_of(const SimulationRequest& request) {
  return page(report::MotionReport{request, simulate(request)});
}

inline HtmlPage isolator() {
  return page(isolator_report());
}

}  // namespace stillpoint::test
