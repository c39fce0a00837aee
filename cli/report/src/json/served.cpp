// SPDX-License-Identifier: MIT
// What a damper serves and what practice asks of it, dimensionless.
#include "json/parts.hpp"

namespace stillpoint::report {

using nlohmann::ordered_json;

namespace {

ordered_json interval_json(const design::ServedInterval& interval) {
  return {number(interval.low), number(interval.high)};
}

}  // namespace

ordered_json works_for_json(const design::WorksFor& served) {
  return {{"v0", interval_json(served.v0)}, {"p", interval_json(served.p)}};
}

ordered_json hits_json(const std::vector<design::Hits>& hits) {
  return list_json(hits, [](const design::Hits& now) -> ordered_json {
    return {{"from", number(now.from)},
            {"to", number(now.to)},
            {"ends", name(now.end)},
            {"arrivals", count(now.arrivals)},
            {"rest", number(now.rest)}};
  });
}

ordered_json practice_json(const design::Practice& lines) {
  return {{"secant_stiffness", number(lines.secant_stiffness)},
          {"equivalent_damping", number(lines.equivalent_damping)},
          {"base_shear_over_weight", number(lines.base_shear)},
          {"restoring_over_weight", number(lines.restoring)},
          {"energy_ratio", number(lines.energy_ratio)},
          {"residual_ratio", number(lines.residual_ratio)},
          {"impulse_at_stop", number(lines.impulse_at_stop)},
          {"impulse_largest", number(lines.impulse_largest)},
          {"notch_capacity", number(lines.notch_capacity)},
          {"notch_used", number(lines.notch_used)},
          {"notch_width_min", number(lines.notch_width_min)}};
}

}  // namespace stillpoint::report
