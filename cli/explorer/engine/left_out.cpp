// SPDX-License-Identifier: MIT
// What the rooms call and a page never does: only sweeps have maps, and fronts are not drawn.
#include <stillpoint/figures/figure.hpp>
#include <stillpoint/report/report.hpp>

#include <string>
#include <vector>

namespace stillpoint::report {
struct FigureUnits;
struct Traded;
}  // namespace stillpoint::report

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
std::vector<figures::Figure> trade_off_figures(const std::vector<Traded>& front,
                                               const Traded& chosen, const FigureUnits& units);
std::vector<figures::Figure> trade_off_figures(const std::vector<Traded>& /*front*/,
                                               const Traded& /*chosen*/,
                                               const FigureUnits& /*units*/) {
  return {};
}

}  // namespace stillpoint::report
