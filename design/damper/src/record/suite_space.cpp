// SPDX-License-Identifier: MIT
#include "record/suite_space.hpp"

#include "record/suite_request.hpp"

#include <stillpoint/core/elementary.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace stillpoint::design {

namespace {

/// A range of a friction that begins at 0 is searched down to this part of its end; 0 itself is
/// another space.
constexpr double least_part_searched = 1e-3;
/// A box reaches down to this part of a value at least.
constexpr double least_factor = 0.02;
/// Of logarithms, for rounding.
constexpr double same_place = 1e-12;

/// In the order of SuiteAxis::Variable.
constexpr std::array values{&SuiteDamper::f,     &SuiteDamper::delta, &SuiteDamper::p,
                            &SuiteDamper::width, &SuiteDamper::load,  &SuiteDamper::damping};

}  // namespace

SuiteFrictions frictions_of(const SuiteDamper& damper) {
  return damper.delta == 0 ? SuiteFrictions::constant
         : damper.f == 0   ? SuiteFrictions::point
                           : SuiteFrictions::both;
}

double SuiteAxis::value(const SuiteDamper& damper) const {
  const double value = damper.*values.at(static_cast<std::size_t>(variable_));
  return variable_ == Variable::period    ? 1 / value
         : variable_ == Variable::damping ? 1 + value  // at least 1, as its logarithm is taken
                                          : value;
}

void SuiteAxis::set(SuiteDamper& damper, double value) const {
  damper.*values.at(static_cast<std::size_t>(variable_)) = variable_ == Variable::period ? 1 / value
                                                           : variable_ == Variable::damping
                                                               ? value - 1
                                                               : value;
}

double SuiteAxis::low() const {
  return elementary::log(range_.low);
}

double SuiteAxis::high() const {
  return elementary::log(range_.high);
}

double SuiteAxis::down() const {
  return -elementary::log(1 - spread_.below);
}

double SuiteAxis::up() const {
  return elementary::log(1 + spread_.above);
}

bool worst_at_corners(const RecordDesignRequest& task) {
  const auto stops_at_once = [](const LoadCase& each) {
    return each.v0 && each.weakest > 0 && each.limits.passages == 0.0 &&
           each.limits.residual == 0.0 && !each.limits.stop_time;
  };
  return !task.hold && !task.width && task.zeta.low == task.zeta.high &&
         std::ranges::all_of(task.cases, stops_at_once);
}

SuiteSpace::SuiteSpace(const RecordDesignRequest& task, SuiteFrictions frictions, double scale)
    : corners_suffice_(worst_at_corners(task)), fixed_{task.p.low, 0, 0, 0} {
  const Interval none;
  const SuiteTolerance& tolerance = task.tolerance;
  const bool notch = frictions != SuiteFrictions::constant;
  add(SuiteAxis::Variable::f, frictions == SuiteFrictions::point ? none : *task.f, tolerance.f,
      scale,
      std::min({task.f_max.value_or(HUGE_VAL), task.f_start.value_or(HUGE_VAL),
                most_in_dead_zone(task, softest(task, task.p.low))}));
  possible_ = possible_ && (frictions != SuiteFrictions::point || task.f->low == 0);
  add(SuiteAxis::Variable::delta, notch ? *task.delta : none, tolerance.delta, scale,
      std::min(task.delta_max.value_or(HUGE_VAL), task.delta_start.value_or(HUGE_VAL)));
  possible_ = possible_ && (notch || task.delta->low == 0);
  add(SuiteAxis::Variable::period, {1 / task.p.high, 1 / task.p.low}, tolerance.period, scale,
      HUGE_VAL, task.spring);
  if (notch && task.width) {
    add(SuiteAxis::Variable::width, *task.width, tolerance.width, scale, HUGE_VAL);
  }
  add(SuiteAxis::Variable::load, {1, 1}, {}, scale, HUGE_VAL, {1 - weakest_load(task), 0});
  add(SuiteAxis::Variable::damping, {1, 1}, {}, scale, HUGE_VAL,
      {0, task.zeta.low < task.zeta.high ? 1.0 : 0.0});
}

void SuiteSpace::add(SuiteAxis::Variable variable, Interval range, const Spread& whole,
                     double scale, double most, const Spread& always) {
  if (range.high == 0) {
    return;
  }
  const Spread spread =
      combined(always, {std::min(whole.below * scale, 1 - least_factor), whole.above * scale});
  range.high = std::min(range.high, most / (1 + spread.above));
  if (range.low == 0) {
    range.low = least_part_searched * range.high;
  }
  possible_ = possible_ && range.low <= range.high;
  const SuiteAxis axis(variable, range, spread);
  if (axis.searched() || whole.below + whole.above + always.below + always.above > 0) {
    axes_.push_back(axis);
  }
  axis.set(fixed_, range.low);
}

std::size_t SuiteSpace::toleranced() const {
  return static_cast<std::size_t>(std::ranges::count_if(axes_, &SuiteAxis::toleranced));
}

std::size_t SuiteSpace::searched() const {
  return static_cast<std::size_t>(std::ranges::count_if(axes_, &SuiteAxis::searched));
}

SuiteDamper SuiteSpace::at(const SuitePlace& logs) const {
  SuiteDamper damper = fixed_;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const SuiteAxis& axis = axes_[i];
    const double log = logs.at(i);
    // An end, such as the only value, as it was given.
    axis.set(damper, log == axis.low()    ? axis.range().low
                     : log == axis.high() ? axis.range().high
                                          : elementary::exp(log));
  }
  return damper;
}

SuitePlace SuiteSpace::place(const SuiteDamper& damper) const {
  SuitePlace logs{};
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    logs.at(i) = elementary::log(axes_[i].value(damper));
  }
  return logs;
}

SuiteDamper SuiteSpace::nearest(const SuiteDamper& damper) const {
  SuiteDamper near = damper;
  for (const SuiteAxis& axis : axes_) {
    axis.set(near, std::clamp(axis.value(damper), axis.range().low, axis.range().high));
  }
  return near;
}

SuiteDamper SuiteSpace::off(const SuiteDamper& nominal, const SuitePlace& unit) const {
  SuiteDamper damper = nominal;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const double part = unit.at(i);
    const Spread& spread = axes_[i].spread();
    if (part != 0) {
      axes_[i].set(damper,
                   axes_[i].value(nominal) * (1 + part * (part < 0 ? spread.below : spread.above)));
    }
  }
  return damper;
}

bool SuiteSpace::includes(const SuitePlace& logs) const {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (logs.at(i) < axes_[i].low() - same_place || logs.at(i) > axes_[i].high() + same_place) {
      return false;
    }
  }
  return true;
}

}  // namespace stillpoint::design
