// SPDX-License-Identifier: MIT
#include "request_of.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/record_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <variant>

namespace stillpoint::sweep {

std::int64_t whole_arrivals(double value) {
  if (!(value >= 1 && value <= design::most_arrivals && value == std::floor(value))) {
    throw InputError("arrivals", value,
                     fmt::format("must be a whole number from 1 to {}", design::most_arrivals));
  }
  return static_cast<std::int64_t>(value);
}

design::DesignRequest request_of(const SweepSpec& spec, const std::function<double(Quantity)>& at) {
  const auto if_given = [&](Quantity input) {
    return given(spec, input) ? std::optional(at(input)) : std::nullopt;
  };
  design::DesignRequest request{spec.task, spec.limits, spec.search, spec.pulse};
  design::Problem& problem = request.problem;
  problem.v0 = if_given(Quantity::v0).value_or(0);
  problem.v0_low = if_given(Quantity::v0_low);
  problem.p = at(Quantity::p);
  problem.p_high = if_given(Quantity::p_high);
  problem.beta = at(Quantity::beta);
  problem.residual = if_given(Quantity::residual);
  if (const auto arrivals = if_given(Quantity::arrivals)) {
    problem.arrivals = whole_arrivals(*arrivals);
  }
  if (request.pulse) {
    std::visit(
        [&](auto& pulse) {
          pulse.k = at(Quantity::k);
          pulse.lambda = at(Quantity::lambda);
        },
        *request.pulse);
    request.pulse_ranges = {if_given(Quantity::k_low), if_given(Quantity::lambda_high)};
  }
  return request;
}

Excitation load_of(const SweepSpec& spec, const std::function<double(Quantity)>& at) {
  Record record = spec.records[static_cast<std::size_t>(at(Quantity::record))].record;
  const double scale = at(Quantity::record_scale);
  records::require_scale(scale);
  std::ranges::for_each(record.values, [scale](double& value) { value *= scale; });
  return record;
}

MotionRequest motion_of(const SweepSpec& spec, const std::function<double(Quantity)>& at) {
  MotionRequest motion{{.p = at(Quantity::p), .f = at(Quantity::f), .delta = at(Quantity::delta)},
                       {.x0 = at(Quantity::x0), .v0 = at(Quantity::v0)},
                       {{}, spec.zones}};
  if (given(spec, Quantity::hold)) {
    motion.oscillator.hold = at(Quantity::hold);
  }
  if (given(spec, Quantity::damping)) {
    motion.oscillator.zeta = at(Quantity::damping);
  }
  if (given(spec, Quantity::breakaway)) {
    motion.oscillator.breakaway = at(Quantity::breakaway);
  }
  if (given(spec, Quantity::notch_width)) {
    motion.surface.notch_width = at(Quantity::notch_width);
  }
  return motion;
}

}  // namespace stillpoint::sweep
