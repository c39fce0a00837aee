// SPDX-License-Identifier: MIT
#include "sections.hpp"

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

/// Then its slack is the distance to what no damper has.
bool bounds_nothing(const design::Constraint& now) {
  return now.relation.front() == '>' && now.limit <= 0;
}

/// The limit is a signed square root, negative where no f is small enough.
bool nothing_meets(const design::Constraint& now) {
  return now.relation.front() == '<' && now.limit < 0;
}

}  // namespace

std::string requirement(const design::Constraint& now, const FigureUnits& units) {
  constexpr int shown = 6;
  constexpr double conversion = 1e-12;  // the rounding of 150 mm to dimensionless and back
  const auto [unit, unit_name] = units.of(now.dimension());
  const bool upwards = now.relation.front() == '>';
  if (bounds_nothing(now)) {
    return format("any {}", now.variable);
  }
  if (nothing_meets(now)) {
    return format("no {} meets it", now.variable);
  }
  const double limit = now.limit * unit * (upwards ? 1 - conversion : 1 + conversion);
  return format("{} {} {}{}", now.variable, now.relation,
                limit > 0 ? limit_digits(limit, upwards, shown) : digits(limit),
                with_blank(unit_name));
}

std::string need(const design::Constraint& now, const FigureUnits& units) {
  return (nothing_meets(now) ? "" : "needs ") + requirement(now, units);
}

void add_constraints(Document& document, std::span<const design::Constraint> constraints,
                     const Physical& physical, std::string_view of_what) {
  if (constraints.empty()) {
    return;
  }
  const FigureUnits units = units_of(physical);
  const bool back = returns(constraints);
  const bool of_cases = std::ranges::any_of(
      constraints, [](const design::Constraint& now) { return !now.in_case.empty(); });
  Table table{{"case", "", "requirement", "slack", "under", ""}, {}};
  for (const design::Constraint& now : constraints) {
    if (!back && now.name == "stop" && now.variable != "passages") {
      table.rows.push_back({{"", "stop", "-", "-", "", "not reached"}});
      continue;
    }
    table.rows.push_back(
        {{of_cases && now.in_case.empty() ? "all" : now.in_case, in_words(now.name),
          requirement(now, units),
          bounds_nothing(now) || nothing_meets(now) || !now.known
              ? "-"
              : units.of(now.dimension()).words(now.slack),
          now.motion && now.in_case.empty() ? scaled_name(now.motion->file, now.motion->scale) : "",
          now.satisfied ? "met" : "violated"},
         now.satisfied ? Tone::good : Tone::bad});
  }
  Section& section = document.section("Constraints", {without_empty_columns(std::move(table))});
  section.detail = std::ranges::all_of(constraints, &design::Constraint::satisfied);
  section.line(std::string(of_what));
}

}  // namespace stillpoint::report
