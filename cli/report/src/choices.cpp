// SPDX-License-Identifier: MIT
#include "choices.hpp"

#include <stillpoint/texts/embedded.hpp>

#include <fmt/ranges.h>

#include <cstddef>
#include <iterator>
#include <numbers>

namespace stillpoint::report {

namespace {

constexpr std::size_t most_rows = 12;  // with the answer, a screen
constexpr std::size_t most_parts = 10;
constexpr std::size_t most_misses = 4;  // parts that are not admissible: each has several lines

/// "the mass does not come back (needs f <= 0.353553)", "the stroke is 412 mm where 400 mm is
/// allowed".
std::string violation(const design::Constraint& now, const Physical& physical) {
  const auto* const kind =
      std::ranges::find(design::suite_figure_kinds, now.name, &design::SuiteFigureKind::constraint);
  const std::string words =
      now.by_criterion_alone       ? "it stops, but not by the published criterion"
      : !now.known                 ? "it never comes to rest"
      : now.variable == "passages" ? "it passes x = 0 too often"
      : kind != design::suite_figure_kinds.end() && kind->variable == now.variable
          ? format("the {} is {}", kind->words,
                   beyond(physical, now.dimension(), now.value, now.limit))
          : format("{} ({})", texts::line_of("words/violations.txt", now.name),
                   need(now, units_of(physical)));
  return words + (now.in_case.empty() ? "" : " in case " + now.in_case);
}

}  // namespace

std::string broken(std::span<const design::Constraint> constraints, const Physical& physical) {
  constexpr std::size_t most_told = 2;
  std::vector<std::string> all;
  for (const design::Constraint& now : constraints) {
    const bool unreached =
        now.name == "stop" && now.variable != "passages" && !returns(constraints);
    std::string words = now.satisfied || unreached ? "" : violation(now, physical);
    if (!words.empty() && std::ranges::find(all, words) == all.end()) {
      all.push_back(std::move(words));
    }
  }
  const std::size_t told = std::min(all.size(), most_told);
  return format("{}{}",
                fmt::join(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(told), " and "),
                told < all.size() ? format(", and {} more", all.size() - told) : "");
}

std::string judgement(const design::RatedPart& rated, const Physical& physical) {
  return rated.admissible         ? "fits"
         : rated.violated.empty() ? rated.tolerance ? "tolerates too little" : "is not admissible"
                                  : broken(rated.violated, physical);
}

void add_parts(Document& document, const std::vector<design::RatedPart>& parts,
               const Physical& physical, const design::Limits& limits) {
  const FigureUnits units = units_of(physical);
  Table table{{"part", "f", in("delta", units.length), "tolerance", ""}, {}};
  const auto hits = static_cast<std::size_t>(std::ranges::count_if(
      parts, [](const design::RatedPart& now) { return now.tolerance.has_value(); }));
  const std::size_t shown = std::min({parts.size(), most_parts, hits + most_misses});
  for (const design::RatedPart& rated : std::span(parts).first(shown)) {
    const auto& [name, f, delta] = rated.part;
    table.rows.push_back({{name, digits(f), digits(delta * units.length),
                           tolerance_cell(limits, rated.tolerance), judgement(rated, physical)},
                          rated.admissible ? Tone::good : Tone::bad});
  }
  const auto fit = std::ranges::count(parts, true, &design::RatedPart::admissible);
  Section& section = document.section(format("Parts, best first: {} of {} fit", fit, parts.size()),
                                      {std::move(table)});
  section.line(parts.size() > shown ? "--json lists them all." : "", Tone::faint);
}

std::vector<Traded> front_of(const DesignReport& report) {
  std::vector<Traded> front;
  for (const auto& [damper, peak, transmitted, stop_time] :
       report.trade_off.value_or(std::vector<design::TradeOff>())) {
    front.push_back({{report.result.request.problem.p, damper.f, damper.delta},
                     damper.tolerance,
                     {},
                     stop_time,
                     peak,
                     transmitted});
  }
  return front;
}

std::vector<Traded> front_of(const design::RecordDesign& result) {
  std::vector<Traded> front;
  std::ranges::transform(result.trade_off, std::back_inserter(front),
                         [](const design::SuitePoint& one) { return traded(one); });
  return front;
}

Traded traded(const design::SuitePoint& one) {
  const design::SuiteFigures worst = largest(one.figures);
  return {one.damper, {}, worst.residual, {}, worst.peak, worst.acceleration};
}

void add_trade_off(Document& document, const std::vector<Traded>& front, const Physical& physical,
                   const design::Limits& limits) {
  if (front.empty()) {
    return;
  }
  const FigureUnits units = units_of(physical);
  Table table{{in("stroke", units.length), "acceleration, g", in("residual", units.length),
               "tolerance", in("stop time", units.time), "f", in("delta", units.length),
               in("width", units.length), in("period", units.time)},
              {}};
  const auto cell = [](const std::optional<double>& value, double unit = 1) {
    return value ? format("{:#.6g}", *value * unit) : "";  // zeros too
  };
  const auto [low, high] = std::ranges::minmax(front, {}, &Traded::p);
  const std::size_t step = (front.size() + most_rows - 1) / most_rows;
  // Every n-th damper, and the end of the front.
  for (std::size_t i = 0; i < front.size() + step - 1; i += step) {
    const Traded& now = front[std::min(i, front.size() - 1)];
    table.rows.push_back(
        {{cell(now.peak, units.length.factor), cell(now.transmitted),
          cell(now.residual, units.length.factor),
          now.tolerance ? tolerance_cell(limits, now.tolerance) : "",
          cell(now.stop_time, units.time.factor), cell(now.f), cell(now.delta, units.length.factor),
          cell(now.notch_width(), units.length.factor),
          low.p < high.p ? cell(2 * std::numbers::pi / now.p, units.time.factor) : ""}});
  }
  const std::size_t shown = table.rows.size();
  document
      .section("Trade-off of stroke and acceleration", {without_empty_columns(std::move(table))})
      .line(shown < front.size() ? format("{} of {} dampers.", shown, front.size()) : "",
            Tone::faint);
}

}  // namespace stillpoint::report
