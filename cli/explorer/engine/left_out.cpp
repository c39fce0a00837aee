// SPDX-License-Identifier: MIT
// What the rooms call and a page never does: only sweeps have maps, and fronts are not drawn.
#include <stillpoint/design/record_design_result.hpp>
#include <stillpoint/figures/figure.hpp>
#include <stillpoint/report/report.hpp>

#include <string>

namespace stillpoint::report {
struct FigureUnits;
}

namespace stillpoint::figures {

std::string map_base64(const FigureMap& map);
std::string map_base64(const FigureMap& /*map*/) {
  return {};
}

}  // namespace stillpoint::figures

namespace stillpoint::report {

void add_parts(figures::Figure& figure, const Catalogue& catalogue, const FigureUnits& units);
void add_parts(figures::Figure& /*figure*/, const Catalogue& /*catalogue*/,
               const FigureUnits& /*units*/) {}
figures::Figure front_figure(const design::RecordDesign& result, const FigureUnits& units);
figures::Figure front_figure(const design::RecordDesign& /*result*/, const FigureUnits& /*units*/) {
  return {};
}

}  // namespace stillpoint::report
