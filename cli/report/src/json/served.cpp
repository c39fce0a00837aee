// SPDX-License-Identifier: MIT
// What a damper works for, and the figures used in practice, dimensionless.
#include "json/parts.hpp"

namespace stillpoint::report {

using nlohmann::ordered_json;

ordered_json works_for_json(const design::WorksFor& served) {
  return {{"v0", interval_json(served.v0)}, {"p", interval_json(served.p)}};
}

ordered_json hits_json(const design::Problem& problem, double f, double delta) {
  return list_json(shown_hits(problem, f, delta), [](const design::Hits& now) -> ordered_json {
    return {{"from", now.from},
            {"to", now.to},
            {"ends", name(now.end)},
            {"arrivals", count(now.arrivals)},
            {"rest", now.rest}};
  });
}

ordered_json practice_json(const design::Practice& lines) {
  return {{"secant_stiffness", lines.secant_stiffness},
          {"equivalent_damping", lines.equivalent_damping},
          {"base_shear_over_weight", lines.base_shear},
          {"restoring_over_weight", lines.restoring},
          {"energy_ratio", lines.energy_ratio},
          {"residual_ratio", lines.residual_ratio},
          {"impulse_at_stop", lines.impulse_at_stop},
          {"impulse_largest", lines.impulse_largest},
          {"notch_capacity", lines.notch_capacity},
          {"notch_used", lines.notch_used},
          {"notch_width_min", lines.notch_width_min}};
}

}  // namespace stillpoint::report
