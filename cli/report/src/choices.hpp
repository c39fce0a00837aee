// SPDX-License-Identifier: MIT
#pragma once

// The choices: the parts of a catalogue and the front of a trade-off.

#include "sections.hpp"

#include <stillpoint/figures/figure.hpp>

namespace stillpoint::report {

/// What is not met: "the residual is 40 mm where 30 mm is allowed in case service, and 2 more"; of
/// a motion that does not return not where it would stop.
[[nodiscard]] std::string broken(std::span<const design::Constraint> constraints,
                                 const Physical& physical);
/// That of a part, or "fits".
[[nodiscard]] std::string judgement(const design::RatedPart& rated, const Physical& physical);

/// The best parts, and how far the others fail.
void add_parts(Document& document, const std::vector<design::RatedPart>& parts,
               const Physical& physical, const design::Limits& limits = {});
/// Their marks, without those beyond the axes.
void add_parts(figures::Figure& figure, const Catalogue& catalogue, const FigureUnits& units);

/// A damper of a front; of load cases with the worst of all within its tolerance.
struct Traded : design::SuiteDamper {
  std::optional<double> tolerance{}, residual{}, stop_time{};
  double peak{0}, transmitted{0};
};
[[nodiscard]] Traded traded(const design::SuitePoint& one);
[[nodiscard]] std::vector<Traded> front_of(const DesignReport& report);
[[nodiscard]] std::vector<Traded> front_of(const design::RecordDesign& result);
/// The table of the front.
void add_trade_off(Document& document, const std::vector<Traded>& front, const Physical& physical,
                   const design::Limits& limits = {});
/// Acceleration over stroke, and tolerance below it where that is of each its own.
[[nodiscard]] std::vector<figures::Figure> trade_off_figures(const std::vector<Traded>& front,
                                                             const Traded& chosen,
                                                             const FigureUnits& units);

}  // namespace stillpoint::report
