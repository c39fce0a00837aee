// SPDX-License-Identifier: MIT
#include "choices.hpp"
#include "json/parts.hpp"

namespace stillpoint::report {

using nlohmann::ordered_json;

namespace {

ordered_json metres(const Physical& physical, double length) {
  return physical ? number(length * physical->scales.length_m) : ordered_json(nullptr);
}

}  // namespace

ordered_json catalogue_json(const std::optional<Catalogue>& catalogue, const PartTask& task) {
  if (!catalogue) {
    return nullptr;
  }
  ordered_json list = ordered_json::array();
  for (const design::RatedPart& rated : catalogue->parts) {
    const auto& [name, f, delta] = rated.part;
    list.push_back(
        {{"name", name},
         {"f", number(f)},
         {"delta", number(delta)},
         {"delta_m", metres(task.physical, delta)},
         {"admissible", rated.admissible},
         {"tolerance", number(rated.tolerance)},
         {"why", rated.admissible ? ordered_json(nullptr) : ordered_json(judgement(rated, task))},
         {"violates", constraints_json(rated.violated)}});
  }
  return list;
}

ordered_json trade_off_json(const std::optional<std::vector<design::TradeOff>>& front,
                            const Physical& physical) {
  if (!front) {
    return nullptr;
  }
  ordered_json list = ordered_json::array();
  for (const auto& [damper, peak, acceleration, stop_time] : *front) {
    list.push_back({{"f", number(damper.f)},
                    {"delta", number(damper.delta)},
                    {"delta_m", metres(physical, damper.delta)},
                    {"tolerance", number(damper.tolerance)},
                    {"peak_amplitude", number(peak)},
                    {"peak_m", metres(physical, peak)},
                    {"peak_absolute_acceleration", number(acceleration)},
                    {"stop_time", number(stop_time)},
                    {"stop_time_s", physical ? number(stop_time * physical->scales.time_s)
                                             : ordered_json(nullptr)}});
  }
  return list;
}

}  // namespace stillpoint::report
