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
        {"f", f},
        {"delta", delta},
        {"delta_m", metres(task.physical, delta)},
        {"admissible", rated.admissible},
        {"tolerance", rated.tolerance},
        {"why", rated.admissible ? ordered_json(nullptr) : ordered_json(judgement(rated, task))},
        {"violates", list_json(rated.violated, constraint_json)}};
  });
}

ordered_json trade_off_json(const std::vector<design::TradeOff>& front, const Physical& physical) {
  return list_json(front, [&](const design::TradeOff& now) -> ordered_json {
    const auto& [damper, peak, acceleration, stop_time] = now;
    return {{"f", damper.f},
            {"delta", damper.delta},
            {"delta_m", metres(physical, damper.delta)},
            {"tolerance", damper.tolerance},
            {"peak_amplitude", peak},
            {"peak_m", metres(physical, peak)},
            {"peak_absolute_acceleration", acceleration},
            {"stop_time", stop_time},
            {"stop_time_s", seconds(physical, stop_time)}};
  });
}

}  // namespace stillpoint::report
