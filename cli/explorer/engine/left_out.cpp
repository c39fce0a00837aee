// SPDX-License-Identifier: MIT
// What the rooms call and a page never does: only sweeps have maps, fronts are not drawn, and the
// engine of pulses would be a tenth of all code here.
#include "options/settings.hpp"

#include <stillpoint/design/catalogue.hpp>
#include <stillpoint/design/design.hpp>
#include <stillpoint/design/hits.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/record_design_result.hpp>
#include <stillpoint/design/region.hpp>
#include <stillpoint/design/works_for.hpp>
#include <stillpoint/figures/figure.hpp>
#include <stillpoint/report/report.hpp>

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

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

namespace stillpoint::design {

namespace {

[[noreturn]] void refuse_pulse() {
  throw cli::UsageError(
      "a task under a pulse needs the installed program: stillpoint design --pulse");
}

}  // namespace

RegionAnswer answer_under_pulse(const RegionRequest& asked);
RegionAnswer answer_under_pulse(const RegionRequest& /*asked*/) {
  refuse_pulse();
}
Choice choose_under_pulse(const PulseRequest& request, std::span<const Part> parts);
Choice choose_under_pulse(const PulseRequest& /*request*/, std::span<const Part> /*parts*/) {
  refuse_pulse();
}
DesignResult design(const PulseRequest& /*request*/) {
  refuse_pulse();
}
std::optional<double> least_delta(const PulseProblem& /*problem*/, double /*f*/) {
  refuse_pulse();
}
std::function<std::optional<double>(double)> least_delta(const PulseProblem& /*problem*/) {
  refuse_pulse();
}
std::function<std::optional<Interval>(double)> feasible_delta(const PulseProblem& /*problem*/,
                                                              const Limits& /*limits*/) {
  refuse_pulse();
}
std::vector<Hits> shown_strengths(const PulseProblem& /*problem*/, double /*f*/, double /*delta*/,
                                  double /*k_most*/) {
  refuse_pulse();
}
std::optional<WorksFor> works_for(const PulseProblem& /*problem*/, const Limits& /*limits*/,
                                  double /*f*/, double /*delta*/) {
  refuse_pulse();
}

}  // namespace stillpoint::design
