// SPDX-License-Identifier: MIT
#pragma once

// The choices: the parts of a catalogue and the front of a trade-off.

#include "sections.hpp"

#include <stillpoint/figures/figure.hpp>

#include <functional>

namespace stillpoint::report {

/// "swings beyond 150 mm: f must be 12 % larger; ..." of those that are not met; of a motion that
/// does not return none says where it would stop.
[[nodiscard]] std::string violations(std::span<const design::Constraint> all,
                                     const ShownTask& task);
/// The violations of a part, or "fits".
[[nodiscard]] std::string judgement(const design::RatedPart& rated, const ShownTask& task);

/// "the residual is 40 mm where 30 mm is allowed in case service and 2 more"; of a damper that is
/// `exact` or one that is off.
[[nodiscard]] std::string broken(std::span<const design::Constraint> constraints,
                                 const Physical& physical, bool exact);

/// The best parts, and how far the others fail, as `judged` says.
void add_parts(Document& document, const Catalogue& catalogue, const ShownTask& task);
void add_parts(Document& document, const std::vector<design::RatedPart>& parts,
               const Physical& physical, const design::Limits& limits,
               const std::function<std::string(const design::RatedPart&)>& judged);
/// Their marks, without those beyond the axes.
void add_parts(figures::Figure& figure, const Catalogue& catalogue, const FigureUnits& units);

/// The table of the front.
void add_trade_off(Document& document, const std::vector<design::TradeOff>& front,
                   const ShownTask& task);
/// Acceleration over stroke, and tolerance below it.
[[nodiscard]] std::vector<figures::Figure> trade_off_figures(
    const std::vector<design::TradeOff>& front, const design::Found& found,
    const FigureUnits& units);

}  // namespace stillpoint::report
