// SPDX-License-Identifier: MIT
// The areas of the plane of f and Delta in words and colours.
#include "figures/region_figures.hpp"

#include <stillpoint/core/names.hpp>
#include <stillpoint/report/findings.hpp>
#include <stillpoint/texts/embedded.hpp>

#include <array>
#include <iterator>

namespace stillpoint::report {

using design::PlaneArea;
using design::PlaneKind;

namespace {

/// Its name is in data/words/plane.txt.
struct PlaneLook {
  PlaneKind kind;
  Ink ink{Ink::grey};
  AreaLook look{AreaLook::hatched};
};

PlaneLook look_of(PlaneKind kind) {
  using enum PlaneKind;
  using enum AreaLook;
  static constexpr auto looks =
      std::to_array<PlaneLook>({{any_rest, Ink::amber, filled},
                                {arrival, Ink::sky, filled},
                                {later_arrivals, Ink::grey, filled},
                                {admissible, Ink::sky, filled},
                                {too_weak_and_strong, Ink::orange, filled},
                                {too_weak_and_limited, Ink::orange, filled},
                                {beyond_limit, Ink::amber},
                                {by_criterion_alone, Ink::amber},
                                {above_delta_max, Ink::amber},
                                {notch_too_weak_and_limited, Ink::orange, filled}});
  const auto* const found = std::ranges::find(looks, kind, &PlaneLook::kind);
  return found != looks.end() ? *found : PlaneLook{kind};
}

}  // namespace

Points outline(const PlaneArea& area, double unit) {
  Points lower;
  Points upper;
  for (const auto& [f, delta] : area.columns) {
    lower.push_back({f, delta.low * unit});
    upper.push_back({f, delta.high * unit});
  }
  return between(std::move(lower), upper);
}

void add_areas(Figure& figure, const std::vector<PlaneArea>& areas, const ShownTask& task,
               const FigureUnits& units) {
  const design::Problem& problem = task.problem;
  const auto beyond = task.pulse ? std::string_view() : design::beyond_limits(problem, task.limits);
  std::set<double> arrivals;
  for (const PlaneArea& area : areas) {
    if (area.kind == PlaneKind::arrival) {
      arrivals.insert(static_cast<double>(area.arrival));
    }
  }
  std::vector<design::FindingValue> values{
      {"n", std::int64_t{}},
      {"last", problem.arrivals},
      {"beta", units.length.words(problem.beta)},
      {"limited", std::string(beyond)},
      {"hits", problem.v0_low || problem.p_high ? "some hits rest" : "rests"}};
  if (problem.residual) {
    values.push_back({"residual", std::string()});
  }
  for (const PlaneArea& area : areas) {
    const PlaneLook look = look_of(area.kind);
    const auto n = static_cast<double>(area.arrival);
    const bool strip = area.kind == PlaneKind::arrival;
    values[0].value = static_cast<std::int64_t>(area.arrival);
    figure.areas.push_back(
        {.name = filled(texts::line_of("words/plane.txt", name(area.kind)), values, task.physical),
         .outline = outline(area, units.length.factor),
         .ink = strip ? arrival_ink(n) : look.ink,
         .look = look.look,
         .key = strip ? key_of_arrivals(arrivals, n) : ""});
  }
}

Ink arrival_ink(double arrival) {
  constexpr std::array inks{Ink::sky, Ink::green, Ink::purple};
  return inks.at(static_cast<std::size_t>(std::fmod(arrival - 1, inks.size())));
}

std::string key_of_arrivals(const std::set<double>& arrivals, double one) {
  constexpr std::size_t most = 6;
  std::vector<double> alike;
  std::ranges::copy_if(arrivals, std::back_inserter(alike),
                       [one](double arrival) { return arrival_ink(arrival) == arrival_ink(one); });
  if (alike.size() < 2) {
    return "";
  }
  std::string text = "arrivals";
  for (std::size_t i = 0; i < alike.size(); ++i) {
    if (i < most || i + 1 == alike.size()) {
      text += format("{} {}", i == 0 ? "" : i > most ? ", …," : ",", alike[i]);
    }
  }
  return text;
}

}  // namespace stillpoint::report
