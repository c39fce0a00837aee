// SPDX-License-Identifier: MIT
#include "sweep_corners.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/problem.hpp>

#include <array>
#include <cstddef>

namespace stillpoint::cli {

namespace {

using Corner = std::array<double, quantity_count>;

void check(const Corner& corner, const SweepTask& task) {
  const auto at = [&corner](Quantity quantity) { return corner[index(quantity)]; };
  if (task.kind == SweepKind::design) {
    require_valid(design::Problem{.v0 = at(Quantity::v0),
                                  .p = at(Quantity::p),
                                  .beta = at(Quantity::beta),
                                  .criterion = task.criterion},
                  task.limits);
    return;
  }
  const Oscillator oscillator{
      .p = at(Quantity::p), .f = at(Quantity::f), .delta = at(Quantity::delta)};
  const Start start{.x0 = at(Quantity::x0), .v0 = at(Quantity::v0)};
  if (task.kind == SweepKind::forced) {
    require_valid(oscillator, start, task.excitation, task.t_end);
  } else {
    require_valid(oscillator, start);
  }
}

}  // namespace

void check_corners(const std::vector<SweepAxis>& axes, const SweepTask& task) {
  const std::size_t corners = std::size_t{1} << axes.size();
  for (std::size_t chosen = 0; chosen < corners; ++chosen) {
    Corner corner{};
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const auto [least, most] = axes[i].axis.ends();
      corner[index(axes[i].quantity)] = (chosen >> i & 1U) != 0 ? most : least;
    }
    check(corner, task);
  }
}

}  // namespace stillpoint::cli
