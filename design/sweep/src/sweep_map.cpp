// SPDX-License-Identifier: MIT
#include "sweep_map.hpp"

#include "progress.hpp"
#include "sweep_outcome.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace stillpoint::cli {

namespace {

using Eigen::Index;

/// Finer than a page shows. Of longer axes every so manyth value is drawn.
constexpr std::int64_t most_cells = 2000;

const SweepAxis& axis_of(const SweepTask& task, Quantity quantity) {
  return *std::ranges::find(task.axes, quantity, &SweepAxis::quantity);
}

const SweepTask& drawable(const SweepTask& task) {
  if (task.listed || task.kind == SweepKind::design) {
    throw UsageError(fmt::format("html and svg draw a grid over f and delta; this is {}",
                                 task.listed ? "a list" : "a grid of design problems"));
  }
  for (const SweepAxis& swept : task.axes) {
    if (swept.quantity != Quantity::f && swept.quantity != Quantity::delta &&
        swept.axis.size() > 1) {
      throw UsageError(
          fmt::format("html and svg draw a grid over f and delta alone: give one value of {}",
                      name(swept.quantity)));
    }
  }
  return task;
}

/// Of at least one.
std::size_t range_of(double half_cycles) {
  const auto& firsts = SweepClass::first_half_cycles;
  const auto* const beyond = std::ranges::upper_bound(firsts, half_cycles);
  return static_cast<std::size_t>(beyond - firsts.begin()) - 1;
}

std::uint8_t class_of(const SweepBlock& block, Index i) {
  const auto outcome = static_cast<std::size_t>(block[Quantity::outcome][i]);
  return outcome == too_many_half_cycles
             ? SweepClass::too_many
             : SweepClass::of(static_cast<Outcome>(outcome), block[Quantity::half_cycles][i]);
}

}  // namespace

std::uint8_t SweepClass::of(Outcome outcome, double half_cycles) {
  constexpr std::uint8_t does_not_move = 2 * ranges;
  if (half_cycles == 0) {
    return does_not_move;
  }
  switch (outcome) {
    case Outcome::stopped_at_zero:
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

MapAxis::MapAxis(const SweepAxis& swept)
    : axis_(swept.axis),
      stride_((axis_.size() + most_cells - 1) / most_cells),
      cells_((axis_.size() + stride_ - 1) / stride_),
      falling_(axis_[0] > axis_[axis_.size() - 1]) {
  if (!axis_.spacing() || axis_.size() < 2 || axis_[0] == axis_[axis_.size() - 1]) {
    throw UsageError(
        fmt::format("html and svg draw a grid over ranges: give --{} as first:last:count, with 2 "
                    "values or more",
                    name(swept.quantity)));
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

SweepMap::SweepMap(const SweepTask& task)
    : f_(axis_of(drawable(task), Quantity::f)),
      delta_(axis_of(task, Quantity::delta)),
      delta_size_(axis_of(task, Quantity::delta).axis.size()),
      cells_(static_cast<std::size_t>(f_.cells() * delta_.cells()), unknown) {}

void SweepMap::add(const SweepBlock& block) {
  for (Index i = 0; i < block.size; ++i) {
    const std::int64_t entry = block.first + i;
    const auto f_cell = f_.cell(entry / delta_size_);
    const auto delta_cell = delta_.cell(entry % delta_size_);
    if (f_cell && delta_cell) {
      at(*f_cell, *delta_cell) = class_of(block, i);
    }
  }
}

bool SweepMap::complete(const SweepTask& task, SweepRun& run) {
  for (std::int64_t f_cell = 0; f_cell < f_.cells() && !Progress::interrupted(); ++f_cell) {
    if (at(f_cell, 0) != unknown && at(f_cell, delta_.cells() - 1) != unknown) {
      continue;  // a column is written in one direction
    }
    SweepBlock block;
    block.size = delta_.cells();
    for (const SweepAxis& swept : task.axes) {
      block[swept.quantity].setConstant(block.size, swept.axis[0]);
    }
    block[Quantity::f].setConstant(f_.value(f_cell));
    for (std::int64_t i = 0; i < block.size; ++i) {
      block[Quantity::delta][i] = delta_.value(i);
    }
    run(block);
    for (std::int64_t i = 0; i < block.size; ++i) {
      at(f_cell, i) = class_of(block, i);
    }
  }
  return !Progress::interrupted();
}

}  // namespace stillpoint::cli
