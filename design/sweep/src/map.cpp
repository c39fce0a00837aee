// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/map.hpp>

#include "step.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/sweep/quantity.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stillpoint::sweep {

namespace {

using Eigen::Index;

/// More than a page shows. On a longer axis every n-th value is drawn.
constexpr std::int64_t most_cells = 2000;

const SweepAxis& axis_of(const SweepSpec& spec, Quantity quantity) {
  return *std::ranges::find(spec.axes, quantity, &SweepAxis::quantity);
}

const SweepSpec& drawable(const SweepSpec& spec) {
  if (spec.part) {
    throw InputError("map", fmt::format("of part {}", text(*spec.part)),
                     "can only be drawn of a whole sweep");
  }
  if (spec.list || spec.kind == SweepKind::design) {
    throw InputError("map", spec.list ? "of a list" : "of design problems",
                     "can only be drawn of a grid of motions over f and delta");
  }
  if (spec.records.size() > 1) {
    throw InputError("record", fmt::format("{} records", spec.records.size()),
                     "must be one if a map of f and delta is drawn");
  }
  for (const SweepAxis& swept : spec.axes) {
    if (swept.quantity != Quantity::f && swept.quantity != Quantity::delta &&
        swept.axis.size() > 1) {
      throw InputError(option_name(swept.quantity, spec.units), swept.axis.text(),
                       "must be one number if a map of f and delta is drawn");
    }
  }
  return spec;
}

/// Of at least one.
std::size_t range_of(double half_cycles) {
  const auto& firsts = SweepClass::first_half_cycles;
  const auto* const beyond = std::ranges::upper_bound(firsts, half_cycles);
  return static_cast<std::size_t>(beyond - firsts.begin()) - 1;
}

std::uint8_t class_of(const SweepBlock& block, Index i) {
  if (block.locks(i)) {
    return SweepClass::locked;
  }
  const auto outcome = motion_outcome(static_cast<std::size_t>(block[Quantity::outcome][i]));
  return outcome ? SweepClass::of(*outcome, block[Quantity::half_cycles][i]) : SweepClass::too_many;
}

}  // namespace

std::uint8_t SweepClass::of(Outcome outcome, double half_cycles) {
  constexpr std::uint8_t does_not_move = 2 * ranges;
  if (half_cycles == 0) {
    return does_not_move;
  }
  switch (outcome) {
    case Outcome::stopped_at_zero:
    case Outcome::stopped_in_notch:
      return static_cast<std::uint8_t>(range_of(half_cycles));
    case Outcome::stopped_in_dead_zone:
      return static_cast<std::uint8_t>(ranges + range_of(half_cycles));
    case Outcome::caught_at_start:
      return does_not_move;
    case Outcome::never_stops:
      return 2 * ranges + 1;
    case Outcome::running:
      break;
  }
  return 2 * ranges + 2;
}

MapAxis::MapAxis(const SweepAxis& swept, const std::optional<SweepUnits>& units)
    : axis_(swept.axis),
      stride_((axis_.size() + most_cells - 1) / most_cells),
      cells_((axis_.size() + stride_ - 1) / stride_),
      falling_(axis_[0] > axis_[axis_.size() - 1]) {
  if (!axis_.spacing() || axis_.size() < 2 || axis_[0] == axis_[axis_.size() - 1]) {
    throw InputError(option_name(swept.quantity, units), axis_.text(),
                     "must be an axis first:last:count of 2 values or more if a map is drawn");
  }
}

std::optional<std::int64_t> MapAxis::cell(std::int64_t i) const {
  if (i % stride_ != 0) {
    return std::nullopt;
  }
  return falling_ ? cells_ - 1 - i / stride_ : i / stride_;
}

double MapAxis::value(std::int64_t cell) const {
  return axis_[(falling_ ? cells_ - 1 - cell : cell) * stride_];
}

SweepMap::SweepMap(const SweepSpec& spec)
    : f_(axis_of(drawable(spec), Quantity::f), spec.units),
      delta_(axis_of(spec, Quantity::delta), spec.units),
      delta_size_(axis_of(spec, Quantity::delta).axis.size()),
      cells_(static_cast<std::size_t>(f_.cells() * delta_.cells()), unknown),
      peaks_(spec.kind == SweepKind::forced ? cells_.size() : 0) {}

void SweepMap::fill(std::size_t cell, const SweepBlock& block, std::int64_t i) {
  cells_[cell] = class_of(block, i);
  if (!peaks_.empty()) {
    peaks_[cell] = block[Quantity::peak_amplitude][i];
  }
}

void SweepMap::add(const SweepBlock& block) {
  for (Index i = 0; i < block.size; ++i) {
    const std::int64_t entry = block.first + i;
    const auto f_cell = f_.cell(entry / delta_size_);
    const auto delta_cell = delta_.cell(entry % delta_size_);
    if (f_cell && delta_cell) {
      fill(index(*f_cell, *delta_cell), block, i);
    }
  }
}

ClassCounts SweepMap::counts() const {
  ClassCounts counts;
  for (const std::uint8_t cell : cells_) {
    ++counts.of.at(cell);
  }
  return counts;
}

std::vector<double> SweepMap::peaks_of(std::size_t index) const {
  std::vector<double> all;
  for (std::size_t i = 0; i < peaks_.size(); ++i) {
    if (cells_[i] == index) {
      all.push_back(peaks_[i]);
    }
  }
  return all;
}

bool SweepMap::complete(const SweepSpec& spec, SweepStep& step, const std::stop_token& stop) {
  for (std::int64_t f_cell = 0; f_cell < f_.cells() && !stop.stop_requested(); ++f_cell) {
    if (cells_[index(f_cell, 0)] != unknown &&
        cells_[index(f_cell, delta_.cells() - 1)] != unknown) {
      continue;  // a column is written in one direction
    }
    SweepBlock block;
    block.size = delta_.cells();
    for (const SweepAxis& swept : spec.axes) {
      block[swept.quantity].setConstant(block.size, swept.axis[0]);
    }
    block[Quantity::f].setConstant(f_.value(f_cell));
    for (std::int64_t i = 0; i < block.size; ++i) {
      block[Quantity::delta][i] = delta_.value(i);
    }
    step(block);
    if (stop.stop_requested()) {
      return false;
    }
    for (std::int64_t i = 0; i < block.size; ++i) {
      fill(index(f_cell, i), block, i);
    }
  }
  return !stop.stop_requested();
}

}  // namespace stillpoint::sweep
