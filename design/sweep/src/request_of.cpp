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

namespace {

std::optional<double> if_given(const SweepSpec& spec, const std::function<double(Quantity)>& at,
                               Quantity input) {
  return given(spec, input) ? std::optional(at(input)) : std::nullopt;
}

}  // namespace

std::int64_t whole_arrivals(double value) {
  if (!(value >= 1 && value <= design::most_arrivals && value == std::floor(value))) {
    throw InputError("arrivals", value,
                     fmt::format("must be a whole number from 1 to {}", design::most_arrivals));
  }
  return static_cast<std::int64_t>(value);
}

design::DesignRequest request_of(const SweepSpec& spec, const std::function<double(Quantity)>& at) {
  const auto find = [&](Quantity input) { return if_given(spec, at, input); };
  design::DesignRequest request{spec.task, spec.limits, spec.search, spec.pulse};
  design::Problem& problem = request.problem;
  problem.v0 = find(Quantity::v0).value_or(0);
  problem.v0_low = find(Quantity::v0_low);
  problem.p = at(Quantity::p);
  problem.p_high = find(Quantity::p_high);
  problem.beta = at(Quantity::beta);
  problem.residual = find(Quantity::residual);
  if (const auto arrivals = find(Quantity::arrivals)) {
    problem.arrivals = whole_arrivals(*arrivals);
  }
  if (request.pulse) {
    std::visit(
        [&](auto& pulse) {
          pulse.k = at(Quantity::k);
          pulse.lambda = at(Quantity::lambda);
        },
        *request.pulse);
    request.pulse_ranges = {find(Quantity::k_low), find(Quantity::lambda_high)};
  }
  return request;
}

namespace {

/// The hit or the pulse of a design, and what is required under it.
design::LoadCase case_of(const design::DesignRequest& request) {
  const design::Problem& problem = request.problem;
  design::LoadCase load;
  load.pulse = request.pulse;
  if (!request.pulse) {
    load.v0 = problem.v0;
  }
  const auto& low = request.pulse ? request.pulse_ranges.k_low : problem.v0_low;
  load.weakest = low ? *low / (request.pulse ? design::peak_load(*request.pulse) : problem.v0) : 1;
  load.limits.peak = problem.beta;
  load.limits.acceleration = request.limits.acceleration_max;
  load.limits.residual = problem.residual.value_or(0);
  load.limits.passages = static_cast<double>(problem.arrivals - 1);
  return load;
}

/// The box that must hold, or the shape of the one that is enlarged.
design::SuiteTolerance tolerance_of(const design::Limits& limits, bool grows) {
  const auto& [f_low, f_high, delta_low, delta_high] = limits.shape;
  design::SuiteTolerance of{design::times({f_low, f_high}, limits.tolerance),
                            design::times({delta_low, delta_high}, limits.tolerance)};
  for (design::Spread* const each : {&of.f, &of.delta}) {
    if (grows && each->below + each->above == 0) {
      *each = design::SuiteTolerance().f;
    }
  }
  return of;
}

}  // namespace

std::optional<design::RecordDesignRequest> simulated_request(
    const SweepSpec& spec, const std::function<double(Quantity)>& at) {
  const double zeta = if_given(spec, at, Quantity::damping).value_or(0);
  const double breakaway = if_given(spec, at, Quantity::breakaway).value_or(1);
  if (zeta == 0 && breakaway == 1) {
    return std::nullopt;
  }
  const auto refuse = [&](Quantity input, const char* instead) {
    if (given(spec, input)) {
      const auto axis = std::ranges::find(spec.axes, input, &SweepAxis::quantity);
      throw InputError(option_name(input, spec.units),
                       axis == spec.axes.end() ? at(input) : axis->axis.ends().high,
                       fmt::format("must be left out with damping or breakaway: {}", instead));
    }
  };
  refuse(Quantity::trade_off, "give them to design itself");
  refuse(Quantity::lambda_high, "give an entry for each length");
  const design::DesignRequest asked = request_of(spec, at);
  const design::LoadCase load = case_of(asked);
  if (load.weakest > 0 && load.weakest < design::least_weakest) {
    const Quantity low = spec.pulse ? Quantity::k_low : Quantity::v0_low;
    throw InputError(option_name(low, spec.units), at(low),
                     fmt::format("must be 0 or at least {} of the other end with damping or "
                                 "breakaway",
                                 design::least_weakest));
  }
  const design::Problem& problem = asked.problem;
  design::RecordDesignRequest request{
      .cases = {load},
      .p = {problem.p, problem.p},
      .f_max = asked.limits.f_max,
      .delta_max = asked.limits.delta_max,
      .objective = *parse<design::SuiteObjective>(name(asked.search.objective))};
  request.tolerance =
      tolerance_of(asked.limits, request.objective == design::SuiteObjective::robust);
  request.requires_tolerance = asked.limits.tolerance > 0;
  request.threads = 1;
  request.printed = design::PrintedUnits();
  request.spring = {1 - problem.p / problem.stiffest_p(), 0};
  request.zeta = {zeta, zeta};
  request.breakaway = breakaway;
  request.parts = spec.parts;
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
  const auto find = [&](Quantity input) { return if_given(spec, at, input); };
  return {{.p = at(Quantity::p),
           .f = at(Quantity::f),
           .delta = at(Quantity::delta),
           .hold = find(Quantity::hold),
           .zeta = find(Quantity::damping).value_or(0),
           .breakaway = find(Quantity::breakaway).value_or(1)},
          {.x0 = at(Quantity::x0), .v0 = at(Quantity::v0)},
          {find(Quantity::notch_width), spec.zones}};
}

}  // namespace stillpoint::sweep
