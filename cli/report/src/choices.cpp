// SPDX-License-Identifier: MIT
#include "choices.hpp"
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>

namespace stillpoint::report {

namespace {

constexpr std::size_t most_rows = 12;  // with the answer, a screen

/// What goes wrong if a constraint is violated: "exceeds 150 mm".
std::string consequence(const design::Constraint& violated, const ShownTask& task) {
  const std::string_view name = violated.name;
  const std::string stroke = length_shown(task.physical, task.problem.beta);
  if (name == "amplitude") {
    return "exceeds " + stroke;
  }
  if (name == "acceleration") {
    return "exceeds " + acceleration_shown(task.limits.acceleration_max.value_or(0));
  }
  return name == "start" ? violated.variable == "f" ? "is held by friction" : "is held by the notch"
         : name == "return" || name == "residual"
             ? format("{}{}", task.problem.residual ? "rests too far off" : "rests off centre",
                      violated.variable == "v0" && task.problem.v0_low
                          ? " after the weaker hits of the range"
                          : "")
         : name == "stop"      ? violated.by_criterion_alone
                                     ? format("stops{}, but not by the published criterion",
                                         task.problem.residual ? "" : " at x = 0")
                                 : violated.slack == 0 ? "is on the edge of passing x = 0"
                                 : task.problem.residual
                                     ? format("passes x = 0, and only {} (--arrivals)",
                                         task.problem.arrivals == 1
                                                  ? "the first arrival counts"
                                                  : format("{} arrivals count", task.problem.arrivals))
                                     : "passes x = 0"
         : name == "dead_zone" ? "could be held at " + stroke + " by friction"
                               : "exceeds the " + in_words(name);
}

/// "f must be 12 % larger", "f is 12 % too large", "delta is 3.4 times the limit".
std::string by_how_much(const design::Constraint& violated) {
  const auto& [name, measured, relation, value, limit, slack, satisfied, by_criterion] = violated;
  const std::string variable = (violated.variable == "peak" || violated.variable == "acceleration")
                                   ? format("the {} of the first swing", measured)
                                   : std::string(measured);
  const bool too_large = relation.front() == '<';
  const double off = std::abs(slack) / (too_large ? limit : value);
  if (limit <= 0 && too_large) {
    return format("no {} is small enough", variable);
  }
  if (!std::isfinite(off)) {
    return format("{} is too {}", variable, too_large ? "large" : "small");
  }
  if (off == 0) {
    return format("{} is just too {}", variable, too_large ? "large" : "small");
  }
  constexpr double next_to_all = 0.99;  // which two digits may call all of it
  constexpr double far = 200;           // times
  if (off <= 1) {
    const std::string part =
        off < next_to_all ? limit_digits(100 * off * (1 - 1e-12), true, 2) : "100";
    return too_large ? format("{} is {} % too large", variable, part)
                     : format("{} must be {} % larger", variable, part);
  }
  if (off >= far) {
    return format("{} is far too {}", variable, too_large ? "large" : "small");
  }
  return too_large ? format("{} is {:.3g} times the limit", variable, value / limit)
                   : format("{} must be {} times as large", variable,
                            limit_digits(limit / value * (1 - 1e-12), true, 3));
}

/// What fills the columns of the tolerance, with what stands before and behind it.
std::vector<std::string> around(std::vector<std::string> cells,
                                const std::vector<std::string>& tolerance,
                                const std::vector<std::string>& behind) {
  cells.insert(cells.end(), tolerance.begin(), tolerance.end());
  cells.insert(cells.end(), behind.begin(), behind.end());
  return cells;
}

/// "7 of 40 parts fit"
std::string how_many_fit(const std::vector<design::RatedPart>& parts) {
  const auto fit = std::ranges::count(parts, true, &design::RatedPart::admissible);
  return format("{} of {} part{} fit{}", fit, parts.size(), parts.size() == 1 ? "" : "s",
                fit == 1 ? "s" : "");
}

}  // namespace

std::string violation(const design::Constraint& violated, const ShownTask& task) {
  return format("{}: {}", consequence(violated, task), by_how_much(violated));
}

std::string judgement(const design::RatedPart& rated, const ShownTask& task) {
  std::string text = rated.admissible         ? "fits"
                     : rated.tolerance        ? "tolerates too little"
                     : rated.violated.empty() ? "is not admissible"
                                              : "";
  for (const design::Constraint& violated : rated.violated) {
    text += (text.empty() ? "" : "; ") + violation(violated, task);
  }
  return text;
}

void add_parts(Document& document, const Catalogue& catalogue, const ShownTask& task) {
  const FigureUnits units(task.physical);
  const auto& parts = catalogue.parts;
  Table table{
      around({"part", "f", in("delta", units.length_unit)}, tolerance_heads(task.limits), {""}),
      {}};
  const std::size_t shown = std::min(parts.size(), most_rows);
  for (const design::RatedPart& rated : std::span(parts).first(shown)) {
    const auto& [name, f, delta] = rated.part;
    table.rows.push_back(
        {around({name, digits(f), digits(delta * units.length)},
                tolerance_cells(task.limits, rated.tolerance), {judgement(rated, task)}),
         rated.admissible ? Tone::good : Tone::bad});
  }
  Section& section = document.section(format("Parts, best first: {}", how_many_fit(parts)));
  section.parts.emplace_back(std::move(table));
  if (parts.size() > shown) {
    section.line(format("{} more; --json lists them all.", parts.size() - shown), Tone::faint);
  }
}

void add_trade_off(Document& document, const std::vector<design::TradeOff>& front,
                   const ShownTask& task) {
  const FigureUnits units(task.physical);
  Table table{
      around({in("stroke", units.length_unit), "acceleration, g"}, tolerance_heads(task.limits),
             {in("stop time", units.time_unit), "f", in("delta", units.length_unit)}),
      {}};
  const auto aligned = [](double value) { return format("{:#.6g}", value); };  // zeros too
  const std::size_t step = (front.size() + most_rows - 1) / most_rows;
  // Every n-th damper, and the end of the front.
  for (std::size_t i = 0; i < front.size() + step - 1; i += step) {
    const auto& [damper, peak, acceleration, stop_time] = front[std::min(i, front.size() - 1)];
    table.rows.push_back({around({aligned(peak * units.length), aligned(acceleration)},
                                 tolerance_cells(task.limits, damper.tolerance),
                                 {aligned(stop_time * units.time), aligned(damper.f),
                                  aligned(damper.delta * units.length)})});
  }
  const std::size_t shown = table.rows.size();
  Section& section = document.section("Trade-off of stroke, acceleration and tolerance");
  section.parts.emplace_back(std::move(table));
  section.line(
      format("{}Accelerations are those outside the notch.",
             step == 1 ? ""
                       : format("{} of {} dampers; --json lists them all. ", shown, front.size())),
      Tone::faint);
}

}  // namespace stillpoint::report
