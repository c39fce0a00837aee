// SPDX-License-Identifier: MIT
// The areas of the plane of f and Delta in words and colours.
#include "figures/region_figures.hpp"

#include <array>
#include <iterator>

namespace stillpoint::report {

using design::PlaneArea;
using design::PlaneKind;

namespace {

struct PlaneLook {
  PlaneKind kind;
  const char* name;  ///< with {beta}, {beyond}, {hits}, {n} and {last}
  Ink ink{Ink::grey};
  AreaLook look{AreaLook::hatched};
  const char* with_residual{nullptr};  ///< its name there, if it is another
};

PlaneLook look_of(PlaneKind kind) {
  using enum PlaneKind;
  using enum AreaLook;
  static constexpr std::array looks{
      PlaneLook{any_rest, "any rest within the residual", Ink::amber, filled},
      PlaneLook{arrival, "arrival {n}", Ink::sky, filled},
      PlaneLook{later_arrivals, "arrivals {n} to {last}, thin strips with gaps", Ink::grey, filled},
      PlaneLook{admissible, "admissible", Ink::sky, filled},
      PlaneLook{too_weak, "too weak: exceeds {beta}"},
      PlaneLook{too_strong, "too strong: does not return", Ink::grey, hatched,
                "too strong: rests too far off"},
      PlaneLook{dead_zone, "too strong: dead zone exceeds {beta}"},
      PlaneLook{never_starts, "too strong: never starts"},
      PlaneLook{too_weak_and_strong, "gap: no f returns within {beta}", Ink::orange, filled,
                "gap: no f is admissible"},
      PlaneLook{held_at_start, "notch holds at the start"},
      PlaneLook{too_weak_and_limited, "gap: too weak; {beyond}", Ink::orange, filled},
      PlaneLook{beyond_limit, "{beyond}", Ink::amber},
      PlaneLook{misses_limits, "does not meet the limits"},
      PlaneLook{exceeds_everywhere, "exceeds {beta}"},
      PlaneLook{notch_too_weak, "notch too weak"},
      PlaneLook{by_criterion_alone, "stops, but not by the published criterion", Ink::amber},
      PlaneLook{above_delta_max, "above the largest Δ", Ink::amber},
      PlaneLook{notch_too_weak_and_limited, "gap: no notch is strong enough", Ink::orange, filled},
      PlaneLook{off_centre, "{hits} off centre", Ink::grey, hatched, "{hits} too far off"}};
  return *std::ranges::find(looks, kind, &PlaneLook::kind);
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
  for (const PlaneArea& area : areas) {
    const PlaneLook look = look_of(area.kind);
    const auto n = static_cast<double>(area.arrival);
    const bool strip = area.kind == PlaneKind::arrival;
    const bool other = problem.residual && look.with_residual != nullptr;
    figure.areas.push_back(
        {.name = fmt::format(
             fmt::runtime(other ? look.with_residual : look.name),
             fmt::arg("beta", units.length.words(problem.beta)), fmt::arg("beyond", beyond),
             fmt::arg("hits", problem.v0_low || problem.p_high ? "some hits rest" : "rests"),
             fmt::arg("n", area.arrival), fmt::arg("last", problem.arrivals)),
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
