// SPDX-License-Identifier: MIT
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/records/decimal.hpp>
#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace stillpoint::report {

std::string in_words(std::string_view name) {
  const std::size_t at = name.find("_max");  // delta_max_m is delta_max in metres
  std::string text(name.substr(0, at));
  std::ranges::replace(text, '_', ' ');
  return at == std::string_view::npos ? text : "largest " + text;
}

bool stops_by_delta1(std::span<const design::Constraint> constraints) {
  return std::ranges::any_of(constraints, [](const design::Constraint& now) {
    return now.name == "stop" && now.variable == "delta";
  });
}

bool returns(std::span<const design::Constraint> constraints) {
  return std::ranges::none_of(constraints, [](const design::Constraint& now) {
    return (now.name == "return" || now.name == "residual") && !now.satisfied;
  });
}

namespace {

std::pair<double, std::string> unit_of(std::string_view variable, const FigureUnits& units) {
  return variable == "delta" || variable == "peak" ? std::pair(units.length, units.length_unit)
         : variable == "v0"                        ? std::pair(units.velocity, units.velocity_unit)
         : variable == "acceleration"              ? std::pair(1.0, std::string("g"))
                                                   : std::pair(1.0, std::string());
}

/// Then its slack is the distance to what no damper has.
bool bounds_nothing(const design::Constraint& now) {
  return now.relation.front() == '>' && now.limit <= 0;
}

using records::decimal;
using records::Rounding;

constexpr int digits_of_bounds = 6;  // a least stroke has one more, which tables round

/// With which f >= f2 and f <= f3, so rounded, can both be met where the region is not empty.
int digits_between(std::span<const design::Constraint> constraints) {
  double f2 = 0;
  double f3 = HUGE_VAL;
  for (const design::Constraint& now : constraints) {
    if (now.variable == "f") {
      const bool upwards = now.relation.front() == '>';
      (upwards ? f2 : f3) = upwards ? std::max(f2, now.limit) : std::min(f3, now.limit);
    }
  }
  constexpr int every = 17;  // that a double has
  int shown = digits_of_bounds;
  while (f2 > 0 && f2 <= f3 && shown < every &&
         decimal(f2, shown, Rounding::up) > decimal(f3, shown, Rounding::down)) {
    ++shown;
  }
  return shown;
}

/// "delta <= 8.1577 mm", rounded so that what is as printed meets it.
std::string requirement(const design::Constraint& now, const FigureUnits& units, int shown) {
  constexpr double conversion = 1e-12;  // the rounding of 150 mm to dimensionless and back
  const auto [unit, unit_name] = unit_of(now.variable, units);
  const bool upwards = now.relation.front() == '>';
  if (bounds_nothing(now)) {
    return format("any {}", now.variable);
  }
  const double limit = now.limit * unit * (upwards ? 1 - conversion : 1 + conversion);
  return format("{} {} {}{}", now.variable == "acceleration" ? "outside the notch" : now.variable,
                now.relation, limit > 0 ? limit_digits(limit, upwards, shown) : digits(limit),
                with_blank(unit_name));
}

}  // namespace

std::vector<Interval> merged(std::vector<Interval> all) {
  std::ranges::sort(all, {}, &Interval::low);
  std::vector<Interval> apart;
  for (const Interval& now : all) {
    if (!apart.empty() && now.low <= apart.back().high) {
      apart.back().high = std::max(apart.back().high, now.high);
    } else {
      apart.push_back(now);
    }
  }
  return apart;
}

std::string feasible_words(const design::RegionVerdict& verdict, const design::Problem& problem,
                           const design::Limits& limits) {
  std::vector<Interval> all;
  if (!verdict.intervals && (problem.arrivals > 1 || problem.residual)) {
    for (const design::Strip& strip : design::strips(problem, limits)) {
      if (strip.f_lower) {
        all.push_back({*strip.f_lower, *strip.f_upper});
      }
    }
  } else {
    all.push_back({*verdict.region.f_lower, *verdict.region.f_upper});
  }
  std::string words;
  for (const auto& [low, high] : merged(std::move(all))) {
    words += (words.empty() ? "" : " or ") + range_digits(low, high);
  }
  return words;
}

namespace {

/// The least stroke, and the f that are feasible.
void add_feasible(Section& section, const design::RegionVerdict& verdict,
                  const design::Problem& problem, const design::Limits& limits,
                  const Physical& physical) {
  const design::Region& region = verdict.region;
  if (region.beta_min == 0) {
    section.row("least stroke",
                "as small as you like: with f just below the peak load the mass hardly moves");
  } else if (region.conflict != design::Conflict::no_arrival) {  // where no stroke helps
    section.row(physical ? "least stroke" : "least beta",
                length_limit(physical, region.beta_min, true, digits_of_bounds + 1));
  }
  if (region.feasible) {
    section.row("feasible f", feasible_words(verdict, problem, limits) +
                                  (limits.tolerance > 0 ? ", with the tolerance asked for" : ""));
  }
}

}  // namespace

void add_region(Document& document, const design::RegionVerdict& verdict,
                const design::Problem& problem, const design::Limits& limits,
                const Physical& physical) {
  const design::Region& region = verdict.region;
  const bool pulsed = verdict.intervals.has_value();
  const FigureUnits units(physical);
  std::vector<design::Constraint> bounds;
  const auto add = [&](std::string_view name, std::string_view variable, std::string_view relation,
                       double limit) {
    bounds.push_back(design::Constraint::compared(name, variable, relation, 0, limit));
  };
  if (!pulsed || region.feasible) {
    add("amplitude", "f", ">=", std::max(region.f2, 0.0));
  }
  if (region.beta_min > 0 && !problem.residual) {
    add("return", "f", "<=", region.f3);
  } else if (region.beta_min > 0 && !design::dead_zone_binds(problem)) {
    add("residual", "f", "<=", design::largest_stopping_f(problem));
  }
  if (region.f4) {
    add("acceleration", "f", "<=", *region.f4);
  }
  if (region.delta2) {
    add("dead_zone", "f", "<", region.f1);
    add("start", "delta", "<=", *region.delta2);
  }
  for (const design::LimitKind& kind : design::limit_kinds()) {
    if (const auto& most = limits.*kind.value; most && (pulsed || !kind.figure)) {
      add(kind.constraint,
          kind.figure       ? kind.constraint
          : kind.bounds_f() ? "f"
                            : "delta",
          "<=", *most);
    }
  }
  Section& section = document.section("Bounds");
  for (const design::Constraint& now : bounds) {
    section.row(in_words(now.name), requirement(now, units, digits_between(bounds)));
  }
  if (!region.delta2) {
    section.row("start", "f below the peak load k");
  }
  add_feasible(section, verdict, problem, limits, physical);
}

void add_constraints(Document& document, std::span<const design::Constraint> constraints,
                     const Physical& physical) {
  const FigureUnits units(physical);
  const bool back = returns(constraints);
  const int shown = digits_between(constraints);
  Table table{{"", "requirement", "slack", ""}, {}};
  for (const design::Constraint& now : constraints) {
    if (!back && now.name == "stop") {
      table.rows.push_back({{"stop", "-", "-", "not reached"}});
      continue;
    }
    const auto [unit, unit_name] = unit_of(now.variable, units);
    table.rows.push_back(
        {{in_words(now.name), requirement(now, units, shown),
          bounds_nothing(now) ? "-" : few_digits(now.slack * unit) + with_blank(unit_name),
          now.satisfied ? "met" : "violated"},
         now.satisfied ? Tone::good : Tone::bad});
  }
  Section& section = document.section("Constraints");
  section.detail = std::ranges::all_of(constraints, &design::Constraint::satisfied);
  section.parts.emplace_back(std::move(table));
  if (std::ranges::any_of(constraints, [](const design::Constraint& now) {
        return now.variable == "peak" || now.variable == "acceleration";
      })) {
    section.line("Each is of the motion up to the first return.");
  }
}

}  // namespace stillpoint::report
