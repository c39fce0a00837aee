// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/spec.hpp>

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/surface.hpp>
#include <stillpoint/design/physical.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace stillpoint::sweep {

namespace {

bool contains(std::span<const Quantity> quantities, Quantity quantity) {
  return std::ranges::find(quantities, quantity) != quantities.end();
}

/// What has a unit, in it: the kernel would name dimensionless numbers.
void require_in_units(const std::string& field, records::Dimension dimension, double value,
                      double least) {
  const auto units = records::units_of(dimension);
  if (!units.empty() && !(value >= least && value <= design::largest_physical)) {
    const std::string_view unit = units.front().name;
    throw InputError(
        field, fmt::format("{} {}", value, unit),
        fmt::format("must be from {} to {} {}", least, design::largest_physical, unit));
  }
}

void require_in_units(const SweepSpec& spec) {
  for (const SweepAxis& swept : spec.axes) {
    const auto [least, most] = swept.axis.ends();
    require_in_units(spec, swept.quantity, least);
    require_in_units(spec, swept.quantity, most);
  }
  if (spec.units && spec.limits.delta_max) {
    require_in_units("delta-max-m", records::Dimension::length, *spec.limits.delta_max,
                     design::smallest_physical);
  }
}

/// Each input has one axis, or is a column of the list.
void require_inputs(const SweepSpec& spec) {
  for (const SweepAxis& swept : spec.axes) {
    const std::string field = option_name(swept.quantity, spec.units);
    const auto refuse = [&](const std::string& bound) {
      throw InputError(field, swept.axis.text(), bound);
    };
    if (!contains(inputs(spec.kind), swept.quantity)) {
      refuse(fmt::format("is not an input of a {} sweep", name(spec.kind)));
    }
    if (std::ranges::count(spec.axes, swept.quantity, &SweepAxis::quantity) > 1) {
      refuse("must not be given twice");
    }
    if (spec.list && spec.list->has(swept.quantity)) {
      refuse("is a column of the list as well: give only one of them");
    }
    if (spec.list && swept.axis.size() > 1) {
      refuse("must be one number beside a list");
    }
  }
  for (const Quantity input : inputs(spec.kind)) {
    const bool may_be_left_out = input == Quantity::hold || input == Quantity::notch_width;
    if (!may_be_left_out && !given(spec, input)) {
      throw InputError::missing(
          option_name(input, spec.units),
          fmt::format("give a number, a range first:last:count, or numbers a,b,c{}",
                      spec.list ? ", or make it a column of the list" : ""));
    }
  }
}

void require_columns(const SweepSpec& spec) {
  if (spec.columns.empty()) {
    throw InputError::missing("columns", "name at least one");
  }
  for (const Quantity column : spec.columns) {
    if (!contains(inputs(spec.kind), column) && !contains(results(spec.kind), column)) {
      throw InputError("columns", std::string(name(column)),
                       fmt::format("is not a column of a {} sweep", name(spec.kind)));
    }
    if (contains(inputs(spec.kind), column) && !given(spec, column)) {
      throw InputError("columns", std::string(name(column, spec.units)),
                       "is an input that is not given");
    }
  }
}

using Corner = std::array<double, quantity_count>;

void check(const Corner& corner, const SweepSpec& spec) {
  const auto at = [&corner](Quantity quantity) { return corner[index(quantity)]; };
  if (spec.kind == SweepKind::design) {
    design::Problem problem = spec.task;
    problem.v0 = at(Quantity::v0);
    problem.p = at(Quantity::p);
    problem.beta = at(Quantity::beta);
    require_valid(problem, spec.limits);
    return;
  }
  Oscillator oscillator{.p = at(Quantity::p), .f = at(Quantity::f), .delta = at(Quantity::delta)};
  if (given(spec, Quantity::hold)) {
    oscillator.hold = at(Quantity::hold);
  }
  Surface surface{{}, spec.zones};
  if (given(spec, Quantity::notch_width)) {
    surface.notch_width = at(Quantity::notch_width);
  }
  const Start start{.x0 = at(Quantity::x0), .v0 = at(Quantity::v0)};
  if (spec.kind == SweepKind::forced) {
    require_valid(oscillator, start, spec.excitation, spec.t_end);
  } else {
    require_valid(oscillator, start);
  }
  require_valid(oscillator, surface);
}

void check_corners(const SweepSpec& spec) {
  const std::size_t corners = std::size_t{1} << spec.axes.size();
  for (std::size_t chosen = 0; chosen < corners; ++chosen) {
    Corner corner{};
    for (std::size_t i = 0; i < spec.axes.size(); ++i) {
      const auto [least, most] = spec.axes[i].axis.ends();
      const Quantity input = spec.axes[i].quantity;
      const double value = (chosen >> i & 1U) != 0 ? most : least;
      corner[index(input)] = spec.units ? spec.units->plain(input, value) : value;
    }
    check(corner, spec);
  }
}

}  // namespace

void require_in_units(const SweepSpec& spec, Quantity input, double value) {
  const bool may_be_negative =
      input == Quantity::x0 || (input == Quantity::v0 && spec.kind != SweepKind::design);
  require_in_units(option_name(input, spec.units), dimension(input, spec.units), value,
                   may_be_negative            ? -design::largest_physical
                   : input == Quantity::delta ? 0
                                              : design::smallest_physical);
}

void require_valid(const SweepSpec& spec) {
  require_in_units(spec);
  require_inputs(spec);
  require_columns(spec);
  if (spec.threads < 1) {
    throw InputError("threads", fmt::format("{}", spec.threads), "must be 1 or more");
  }
  if (spec.half_cycle_limit) {
    require_within("half-cycle-limit", *spec.half_cycle_limit, 1, 1e15);
  }
  if (spec.part && spec.list && !spec.listed) {
    throw InputError("part", text(*spec.part), "needs to know how many entries the list has");
  }
  if (entries(spec)) {
    check_corners(spec);
  }
}

}  // namespace stillpoint::sweep
