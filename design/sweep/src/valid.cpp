// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/spec.hpp>

#include "request_of.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/surface.hpp>
#include <stillpoint/design/limit_kinds.hpp>
#include <stillpoint/design/physical.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace stillpoint::sweep {

namespace {

/// Checks values with a unit in that unit: the kernel would name dimensionless numbers.
void require_in_units(const SweepSpec& spec) {
  const auto require_ends = [&](Quantity input, const Axis& axis) {
    const auto [least, most] = axis.ends();
    require_in_units(spec, input, least);
    require_in_units(spec, input, most);
  };
  for (const SweepAxis& swept : spec.axes) {
    require_ends(swept.quantity, swept.axis);
    const Quantity other = other_end(swept.quantity).value_or(swept.quantity);
    if (swept.axis.has_ranges() && contains(inputs(spec.kind), other)) {
      require_ends(other, swept.axis.other_ends());
    }
  }
  for (const design::LimitKind& kind : design::limit_kinds()) {
    const auto& limit = spec.limits.*kind.value;
    if (spec.units && limit && !kind.in_metres.empty()) {
      records::require_physical(records::hyphened(kind.in_metres), records::Dimension::length,
                                *limit);
    }
  }
}

/// A pulse takes the place of v0.
bool may_be_left_out(const SweepSpec& spec, Quantity input) {
  constexpr std::array always{Quantity::record,   Quantity::record_scale, Quantity::v0_low,
                              Quantity::p_high,   Quantity::k_low,        Quantity::lambda_high,
                              Quantity::residual, Quantity::arrivals,     Quantity::trade_off,
                              Quantity::hold,     Quantity::notch_width,  Quantity::damping,
                              Quantity::breakaway};
  const bool of_pulse = input == Quantity::k || input == Quantity::lambda;
  return contains(always, input) || (spec.pulse ? input == Quantity::v0 : of_pulse);
}

/// For designs, the inputs of the hit that the entries do not have.
void require_one_hit(const SweepSpec& spec) {
  constexpr std::array of_velocity{Quantity::v0, Quantity::v0_low};
  constexpr std::array of_pulse{Quantity::k, Quantity::k_low, Quantity::lambda,
                                Quantity::lambda_high};
  const auto others = spec.pulse ? std::span<const Quantity>(of_velocity) : of_pulse;
  for (const Quantity other : others) {
    if (given(spec, other)) {
      throw InputError(option_name(other, spec.units), "an input",
                       spec.pulse ? "must be left out: the pulse is the hit"
                                  : "must be left out without a pulse");
    }
  }
}

/// Where there are several records, and only there, each entry has one and its scale.
void require_records(const SweepSpec& spec) {
  for (const Quantity input : {Quantity::record, Quantity::record_scale}) {
    const std::string field = option_name(input, spec.units);
    if (given(spec, input) == spec.records.empty()) {
      throw InputError(
          field, "an input",
          spec.records.empty() ? "must be left out without records" : "must have an axis");
    }
  }
  const auto found = std::ranges::find(spec.axes, Quantity::record, &SweepAxis::quantity);
  if (found != spec.axes.end() &&
      (found->axis.ends().low != 0 ||
       found->axis.ends().high != static_cast<double>(std::ssize(spec.records) - 1) ||
       found->axis.size() != std::ssize(spec.records))) {
    throw InputError("record", found->axis.text(), "must be the places of the records, from 0");
  }
  if (spec.list && spec.records.size() > 1) {
    throw InputError("record", fmt::format("{} records", spec.records.size()),
                     "must be one if there is a list");
  }
}

/// Each input has one axis, or is a column of the list.
void require_inputs(const SweepSpec& spec) {
  if (spec.list) {
    for (const Quantity column : spec.list->columns()) {
      if (!contains(inputs(spec.kind), column)) {
        throw InputError(
            std::string(name(column, spec.units)), "a column of the list",
            fmt::format("must be left out: it is not an input of a {} sweep", name(spec.kind)));
      }
    }
  }
  if (spec.kind == SweepKind::design) {
    require_one_hit(spec);
  }
  if (spec.kind == SweepKind::forced) {
    require_records(spec);
  }
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
    const auto other =
        swept.axis.has_ranges() ? other_end(swept.quantity) : std::optional<Quantity>();
    if (swept.axis.has_ranges() && !(other && contains(inputs(spec.kind), *other))) {
      refuse(fmt::format(
          "must be an axis first:last:count or numbers: {} a range LOW:HIGH",
          spec.kind == SweepKind::design ? "only design itself takes such" : "only designs take"));
    }
    if (spec.list && (spec.list->has(swept.quantity) || (other && spec.list->has(*other)))) {
      refuse("is also a column of the list: give only one of them");
    }
    if (spec.list && swept.axis.size() > 1 && swept.quantity != Quantity::trade_off) {
      refuse("must be one number if there is a list");
    }
  }
  for (const Quantity input : inputs(spec.kind)) {
    if (!may_be_left_out(spec, input) && !given(spec, input)) {
      throw InputError::missing(
          option_name(input, spec.units),
          fmt::format("give a number, an axis first:last:count, or numbers a,b,c{}",
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
                       "is an input, but it is not given");
    }
  }
}

using Corner = std::array<double, quantity_count>;

void check(const Corner& corner, const SweepSpec& spec) {
  const auto at = [&corner](Quantity quantity) { return corner[index(quantity)]; };
  if (spec.kind == SweepKind::design) {
    if (const auto simulated = simulated_request(spec, at)) {
      return require_valid(*simulated);
    }
    const design::DesignRequest request = request_of(spec, at);
    if (request.pulse) {
      const design::PulseRequest pulse = pulse_request(request);
      return require_valid(pulse.problem, pulse.limits);
    }
    require_valid(request.problem, request.limits);
    return;
  }
  const auto [oscillator, start, surface] = motion_of(spec, at);
  if (spec.kind == SweepKind::forced) {
    if (spec.records.empty()) {
      require_valid(oscillator, start, spec.excitation, spec.t_end);
    } else {
      require_valid(oscillator, start, load_of(spec, at), spec.t_end);
    }
  } else {
    require_valid(oscillator, start);
  }
  require_valid(oscillator, surface);
}

/// The largest is small, so every value of a sensible axis is checked.
void check_arrivals(const SweepSpec& spec) {
  const auto found = std::ranges::find(spec.axes, Quantity::arrivals, &SweepAxis::quantity);
  const std::int64_t count = found == spec.axes.end() ? 0 : found->axis.size();
  for (std::int64_t i = 0; i < std::min(count, design::most_arrivals); ++i) {
    static_cast<void>(whole_arrivals(found->axis[i]));
  }
}

/// The axes of `corner` before `next` are set. The corners of an axis without ranges are its ends;
/// of one with ranges, all its values: each has two ends.
void check_corners(const SweepSpec& spec, Corner& corner, std::size_t next = 0) {
  if (next == spec.axes.size()) {
    return check(corner, spec);
  }
  const auto set = [&](Quantity input, double value) {
    corner[index(input)] = spec.units ? spec.units->plain(input, value) : value;
  };
  const auto& [input, axis] = spec.axes[next];
  if (axis.has_ranges()) {
    const Axis others = axis.other_ends();
    for (std::int64_t i = 0; i < axis.size(); ++i) {
      set(input, axis[i]);
      set(*other_end(input), others[i]);
      check_corners(spec, corner, next + 1);
    }
    return;
  }
  const auto [least, most] = axis.ends();
  for (const double end : {least, most}) {
    set(input, end);
    check_corners(spec, corner, next + 1);
  }
}

}  // namespace

void require_in_order(const SweepSpec& spec, Quantity input, double value, double other) {
  const std::string_view field = name(*other_end(input), spec.units);
  const bool low = field.ends_with("_low");
  if (low ? !(other <= value) : !(other >= value)) {
    throw InputError(std::string(field), other,
                     fmt::format("must be at {} {} = {}", low ? "most" : "least",
                                 name(input, spec.units), value));
  }
}

void require_in_units(const SweepSpec& spec, Quantity input, double value) {
  constexpr std::array may_be_zero{Quantity::delta, Quantity::v0_low, Quantity::residual};
  const bool may_be_negative =
      input == Quantity::x0 || (input == Quantity::v0 && spec.kind != SweepKind::design);
  if (const auto unit = dimension(input, spec.units); unit != records::Dimension::none) {
    records::require_physical(option_name(input, spec.units), unit, value,
                              may_be_negative                ? -design::largest_physical
                              : contains(may_be_zero, input) ? 0
                                                             : design::smallest_physical);
  }
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
    throw InputError("part", text(*spec.part), "needs the number of entries of the list");
  }
  check_arrivals(spec);
  if (entries(spec) && !spec.list) {
    Corner corner{};
    check_corners(spec, corner);
  }
}

}  // namespace stillpoint::sweep
