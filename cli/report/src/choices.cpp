// SPDX-License-Identifier: MIT
#include "choices.hpp"
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace stillpoint::report {

namespace {

constexpr std::size_t most_rows = 12;  // with the answer, a screen
constexpr std::size_t most_parts = 10;
constexpr std::size_t most_misses = 4;  // parts that are not admissible: each has several lines

/// What goes wrong if a constraint is violated: "swings beyond 150 mm".
std::string consequence(const design::Constraint& violated, const ShownTask& task) {
  const std::string_view name = violated.name;
  const std::string stroke = length_shown(task.physical, task.problem.beta);
  return name == "stop" ? violated.by_criterion_alone ? "stops, but not by the published criterion"
                                                      : "passes x = 0"
         : name == "return" || name == "residual"
             ? task.problem.residual ? "rests too far off centre" : "rests off centre"
         : name == "amplitude" ? "swings beyond " + stroke
         : name == "acceleration"
             ? "transmits more than " + acceleration_shown(task.limits.acceleration_max.value_or(0))
         : name == "start"     ? "is held from the start"
         : name == "dead_zone" ? "could be held at " + stroke + " by friction"
                               : "exceeds the " + in_words(name);
}

/// "f must be 12 % larger", "f is 12 % too large", "delta is far too large"; of what the
/// consequence names "by 12 %".
std::string by_how_much(const design::Constraint& violated) {
  const bool too_large = violated.relation.front() == '<';
  const std::string_view what = violated.variable;
  if (too_large && violated.limit < 0) {
    return format("at any {}", what);
  }
  const double off = 100 * std::abs(violated.slack) / (too_large ? violated.limit : violated.value);
  constexpr double far = 1e3;  // per cent
  const std::string part = off > 0 && off < far ? limit_digits(off * (1 - 1e-12), true, 3) : "";
  const bool named = what == "peak" || what == "acceleration" || violated.name.ends_with("_max");
  return named          ? "by " + (part.empty() ? "far" : part + " %")
         : part.empty() ? format("{} is far too {}", what, too_large ? "large" : "small")
         : too_large    ? format("{} is {} % too large", what, part)
                        : format("{} must be {} % larger", what, part);
}

/// "stroke", of a limit on the figure of a motion.
std::string_view figure_words(std::string_view constraint) {
  return std::ranges::find(design::suite_figure_kinds, constraint,
                           &design::SuiteFigureKind::constraint)
      ->words;
}

}  // namespace

std::string violations(std::span<const design::Constraint> all, const ShownTask& task) {
  std::vector<std::string> wrong;
  for (const design::Constraint& now : all) {
    if (!now.satisfied && (returns(all) || now.name != "stop")) {
      wrong.push_back(format("{} ({})", consequence(now, task), by_how_much(now)));
    }
  }
  std::string text;
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < wrong.size() ? ", " : " and ") + wrong[i];
  }
  return text;
}

std::string judgement(const design::RatedPart& rated, const ShownTask& task) {
  return rated.admissible         ? "fits"
         : rated.tolerance        ? "tolerates too little"
         : rated.violated.empty() ? "is not admissible"
                                  : violations(rated.violated, task);
}

std::string broken(std::span<const design::Constraint> constraints, const Physical& physical,
                   bool exact) {
  constexpr std::size_t most_told = 2;
  std::vector<std::string> all;
  for (const design::Constraint& now : constraints) {
    if (now.satisfied) {
      continue;
    }
    const std::string amount =
        now.known ? beyond(physical, now.dimension(), now.value, now.limit) : "";
    const std::string_view what = now.variable;
    const std::string words =
        now.name == "start"
            ? format("the {} does not start the mass", what == "f" ? "pulse" : "hit")
        : amount.empty()             ? std::string("it never comes to rest")
        : now.name == "dead_zone"    ? std::string("friction could hold the mass beyond its stroke")
        : now.name == "stop"         ? std::string("it passes x = 0 too often")
        : now.name.ends_with("_max") ? format("{} {} {}", what, exact ? "is" : "may be", amount)
                                     : format("the {} is {}", figure_words(now.name), amount);
    const std::string whole = words + (now.in_case.empty() ? "" : " in case " + now.in_case);
    if (std::ranges::find(all, whole) == all.end()) {
      all.push_back(whole);
    }
  }
  const std::size_t told = std::min(all.size(), most_told);
  std::string text;
  for (std::size_t i = 0; i < told; ++i) {
    text += (i == 0 ? "" : told == all.size() ? " and " : ", ") + all[i];
  }
  return text + (told < all.size() ? format(", and {} more", all.size() - told) : "");
}

void add_parts(Document& document, const Catalogue& catalogue, const ShownTask& task) {
  add_parts(document, catalogue.parts, task.physical, task.limits,
            [&](const design::RatedPart& rated) { return judgement(rated, task); });
}

void add_parts(Document& document, const std::vector<design::RatedPart>& parts,
               const Physical& physical, const design::Limits& limits,
               const std::function<std::string(const design::RatedPart&)>& judged) {
  const FigureUnits units = units_of(physical);
  Table table{{"part", "f", in("delta", units.length), "tolerance", ""}, {}};
  const auto hits = static_cast<std::size_t>(std::ranges::count_if(
      parts, [](const design::RatedPart& now) { return now.tolerance.has_value(); }));
  const std::size_t shown = std::min({parts.size(), most_parts, hits + most_misses});
  for (const design::RatedPart& rated : std::span(parts).first(shown)) {
    const auto& [name, f, delta] = rated.part;
    table.rows.push_back({{name, digits(f), digits(delta * units.length),
                           tolerance_cell(limits, rated.tolerance), judged(rated)},
                          rated.admissible ? Tone::good : Tone::bad});
  }
  const auto fit = std::ranges::count(parts, true, &design::RatedPart::admissible);
  Section& section = document.section(format("Parts, best first: {} of {} fit", fit, parts.size()),
                                      {std::move(table)});
  section.line(parts.size() > shown ? "--json lists them all." : "", Tone::faint);
}

void add_trade_off(Document& document, const std::vector<design::TradeOff>& front,
                   const ShownTask& task) {
  if (front.empty()) {
    return;
  }
  const FigureUnits units = units_of(task.physical);
  Table table{{in("stroke", units.length), "acceleration, g", "tolerance",
               in("stop time", units.time), "f", in("delta", units.length)},
              {}};
  const auto aligned = [](double value) { return format("{:#.6g}", value); };  // zeros too
  const std::size_t step = (front.size() + most_rows - 1) / most_rows;
  // Every n-th damper, and the end of the front.
  for (std::size_t i = 0; i < front.size() + step - 1; i += step) {
    const auto& [damper, peak, acceleration, stop_time] = front[std::min(i, front.size() - 1)];
    table.rows.push_back(
        {{aligned(peak * units.length), aligned(acceleration),
          tolerance_cell(task.limits, damper.tolerance), aligned(stop_time * units.time),
          aligned(damper.f), aligned(damper.delta * units.length)}});
  }
  const std::size_t shown = table.rows.size();
  document
      .section("Trade-off of stroke, acceleration outside the notch and tolerance",
               {std::move(table)})
      .line(shown < front.size() ? format("{} of {} dampers.", shown, front.size()) : "",
            Tone::faint);
}

}  // namespace stillpoint::report
