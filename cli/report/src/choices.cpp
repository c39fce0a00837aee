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

/// What goes wrong if a constraint is violated: "swings beyond 150 mm".
std::string consequence(const design::Constraint& violated, const ShownTask& task) {
  const std::string_view name = violated.name;
  const std::string stroke = length_shown(task.physical, task.problem.beta);
  const bool residual = task.problem.residual.has_value();
  if (name == "stop") {
    return violated.by_criterion_alone
               ? format("stops{}, but not by the published criterion", residual ? "" : " at x = 0")
           : residual ? "passes x = 0 more often than --arrivals allows"
                      : "passes x = 0";
  }
  if (name == "return" || name == "residual") {
    return format("{}{}", residual ? "rests too far off" : "rests off centre",
                  violated.variable == "v0" && task.problem.v0_low
                      ? " after the weaker hits of the range"
                      : "");
  }
  return name == "amplitude" ? "swings beyond " + stroke
         : name == "acceleration"
             ? "transmits more than " + acceleration_shown(task.limits.acceleration_max.value_or(0))
         : name == "start"
             ? violated.variable == "f" ? "is held by friction" : "is held by the notch"
         : name == "dead_zone" ? "could be held at " + stroke + " by friction"
                               : "exceeds the " + in_words(name);
}

/// "f must be 12 % larger", "f is 12 % too large", "delta is far too large".
std::string by_how_much(const design::Constraint& violated) {
  const std::string_view measured = violated.variable;
  const std::string variable = (measured == "peak" || measured == "acceleration")
                                   ? format("the {} of the first swing", measured)
                                   : std::string(measured);
  const bool too_large = violated.relation.front() == '<';
  if (too_large && violated.limit < 0) {
    return format("no {} is small enough", variable);
  }
  const std::string_view how = too_large ? "large" : "small";
  const double off = 100 * std::abs(violated.slack) / (too_large ? violated.limit : violated.value);
  constexpr double far = 1e3;  // per cent
  constexpr double next_to_all = 99;
  if (!(off > 0 && off < far)) {
    return format("{} is {} too {}", variable, off == 0 ? "just" : "far", how);
  }
  const std::string part = limit_digits(off * (1 - 1e-12), true, off < next_to_all ? 2 : 3);
  return too_large ? format("{} is {} % too large", variable, part)
                   : format("{} must be {} % larger", variable, part);
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
  const FigureUnits units = units_of(task.physical);
  const auto& parts = catalogue.parts;
  Table table{{"part", "f", in("delta", units.length), tolerance_head(task.limits), ""}, {}};
  const std::size_t shown = std::min(parts.size(), most_rows);
  for (const design::RatedPart& rated : std::span(parts).first(shown)) {
    const auto& [name, f, delta] = rated.part;
    table.rows.push_back({{name, digits(f), digits(delta * units.length),
                           tolerance_cell(task.limits, rated.tolerance), judgement(rated, task)},
                          rated.admissible ? Tone::good : Tone::bad});
  }
  Section& section =
      document.section(format("Parts, best first: {}", how_many_fit(parts)), std::move(table));
  if (parts.size() > shown) {
    section.line(format("{} more; --json lists them all.", parts.size() - shown), Tone::faint);
  }
}

void add_trade_off(Document& document, const std::vector<design::TradeOff>& front,
                   const ShownTask& task) {
  const FigureUnits units = units_of(task.physical);
  Table table{{in("stroke", units.length), "acceleration, g", tolerance_head(task.limits),
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
  Section& section =
      document.section("Trade-off of stroke, acceleration and tolerance", std::move(table));
  section.line(
      format("{}Accelerations are those outside the notch.",
             step == 1 ? ""
                       : format("{} of {} dampers; --json lists them all. ", shown, front.size())),
      Tone::faint);
}

}  // namespace stillpoint::report
