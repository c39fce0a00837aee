// SPDX-License-Identifier: MIT
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/records/decimal.hpp>
#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

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

constexpr int digits_of_bounds = 6;
constexpr int digits_of_tables = 6;  // rounded to the nearest, a stroke must not be below the least

/// With which f >= f2 and f <= f3, so rounded, can both be met where the region is not empty.
int digits_between(double f2, double f3) {
  constexpr int every = 17;  // that a double has
  int shown = digits_of_bounds;
  while (f2 > 0 && f2 <= f3 && shown < every &&
         decimal(f2, shown, Rounding::up) > decimal(f3, shown, Rounding::down)) {
    ++shown;
  }
  return shown;
}

int digits_between(std::span<const design::Constraint> constraints) {
  double f2 = 0;
  double f3 = HUGE_VAL;
  for (const design::Constraint& now : constraints) {
    if (now.variable == "f") {
      const bool upwards = now.relation.front() == '>';
      (upwards ? f2 : f3) = upwards ? std::max(f2, now.limit) : std::min(f3, now.limit);
    }
  }
  return digits_between(f2, f3);
}

/// "delta <= 8.1577 mm", rounded so that what is as printed meets it.
std::string requirement(const design::Constraint& now, const FigureUnits& units,
                        int shown = digits_of_bounds) {
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

/// Of a limit that a damper is compared with.
void add_bound(Section& section, const FigureUnits& units, std::string_view name,
               std::string_view variable, std::string_view relation, double limit,
               std::string_view note = "", int shown = digits_of_bounds) {
  const auto bound = design::Constraint::compared(name, variable, relation, 0, limit);
  section.row(in_words(name), format("{}{}", requirement(bound, units, shown), note));
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
  const bool others =
      limits.tolerance > 0 ||
      std::ranges::any_of(design::limit_kinds(), [&](const design::LimitKind& kind) {
        return (limits.*kind.value).has_value();
      });
  if (region.beta_min == 0) {
    section.row("least stroke",
                "as small as you like: with f just below the peak load the mass hardly moves");
  } else if (region.conflict != design::Conflict::no_arrival) {  // where no stroke helps
    section.row(physical ? "least stroke" : "least beta",
                format("{}{}", length_limit(physical, region.beta_min, true, digits_of_tables + 1),
                       others ? ", if only the stroke were limited" : ""));
  }
  const std::string feasible = region.feasible ? feasible_words(verdict, problem, limits) : "";
  const auto intervals = verdict.intervals.value_or(std::vector<Interval>());
  const bool all_meet = region.feasible && limits.tolerance == 0;
  if (all_meet) {
    section.row("feasible f",
                feasible + (intervals.size() > 1 ? ", with the most tolerant damper" : ""));
  }
  for (const auto& [low, high] : intervals) {
    if (const std::string all = range_digits(low, high); all != feasible) {
      section.row(all_meet ? "" : "admissible f", format("{}{}", all_meet ? "or " : "", all));
    }
  }
  if (region.feasible && !all_meet) {
    section.row("feasible f", feasible + ", with the tolerance asked for");
  }
}

}  // namespace

Section& add_region(Document& document, const design::RegionVerdict& verdict,
                    const design::Problem& problem, const design::Limits& limits,
                    const Physical& physical) {
  const design::Region& region = verdict.region;
  const bool pulsed = verdict.intervals.has_value();
  const FigureUnits units(physical);
  Section& section = document.detail("Bounds");
  const int shown = digits_between(region.f2, region.f3);
  if (!pulsed || region.feasible) {
    add_bound(section, units, "amplitude", "f", ">=", std::max(region.f2, 0.0),
              region.f2 <= 0 ? "  (does not bind)" : "", shown);
  }
  if (pulsed && region.beta_min == 0) {
    section.row("return", "even with f just below the peak load");
  } else if (!problem.residual || !design::dead_zone_binds(problem)) {
    add_bound(section, units, problem.residual ? "residual" : "return", "f",
              "<=", problem.residual ? design::largest_stopping_f(problem) : region.f3, "", shown);
  }
  if (region.f4) {
    add_bound(section, units, "acceleration", "f", "<=", *region.f4,
              *region.f4 < 0 ? "  (no f is small enough)" : "");
  }
  if (region.delta2) {
    add_bound(section, units, "dead_zone", "f", "<", region.f1, "", shown);
    add_bound(section, units, "start", "delta", "<=", *region.delta2);
  } else {
    section.row("start",
                "f below the peak load k; a notch no wider than delta/(k - f) holds the mass");
  }
  for (const design::LimitKind& kind : design::limit_kinds()) {
    if (const auto& most = limits.*kind.value; most && (pulsed || !kind.figure)) {
      const std::string_view bounded = kind.figure       ? kind.constraint
                                       : kind.bounds_f() ? "f"
                                                         : "delta";
      add_bound(section, units, kind.constraint, bounded, "<=", *most);
    }
  }
  add_feasible(section, verdict, problem, limits, physical);
  return section;
}

Section& add_constraints(Document& document, std::span<const design::Constraint> constraints,
                         const design::Limits& limits, const Physical& physical) {
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
  if (limits.tolerance > 0) {
    section.row("tolerance", "at least " + box_text(limits, limits.tolerance));
  }
  if (std::ranges::any_of(constraints, [](const design::Constraint& now) {
        return now.variable == "peak" || now.variable == "acceleration";
      })) {
    section.line("Each is of the motion up to the first return.");
  }
  return section;
}

}  // namespace stillpoint::report
