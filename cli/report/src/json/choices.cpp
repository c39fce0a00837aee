// SPDX-License-Identifier: MIT
#include "choices.hpp"
#include "json/parts.hpp"

namespace stillpoint::report {

using nlohmann::ordered_json;

ordered_json catalogue_json(const Catalogue& catalogue, const ShownTask& task) {
  return list_json(catalogue.parts, [&](const design::RatedPart& rated) -> ordered_json {
    const auto& [name, f, delta] = rated.part;
    return {
        {"name", name},
        {"f", number(f)},
        {"delta", number(delta)},
        {"delta_m", metres(task.physical, delta)},
        {"admissible", rated.admissible},
        {"tolerance", number(rated.tolerance)},
        {"why", rated.admissible ? ordered_json(nullptr) : ordered_json(judgement(rated, task))},
        {"violates", constraints_json(rated.violated)}};
  });
}

ordered_json trade_off_json(const std::vector<design::TradeOff>& front, const Physical& physical) {
  return list_json(front, [&](const design::TradeOff& now) -> ordered_json {
    const auto& [damper, peak, acceleration, stop_time] = now;
    return {{"f", number(damper.f)},
            {"delta", number(damper.delta)},
            {"delta_m", metres(physical, damper.delta)},
            {"tolerance", number(damper.tolerance)},
            {"peak_amplitude", number(peak)},
            {"peak_m", metres(physical, peak)},
            {"peak_absolute_acceleration", number(acceleration)},
            {"stop_time", number(stop_time)},
            {"stop_time_s", seconds(physical, stop_time)}};
  });
}

}  // namespace stillpoint::report
