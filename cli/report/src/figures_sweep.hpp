// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/figures/figure.hpp>
#include <stillpoint/sweep/map.hpp>

namespace stillpoint::report {

/// The plane of f and Delta, coloured by how the motions end and after how many half-cycles; of
/// free motions from x = 0 with the analytic boundaries on top.
[[nodiscard]] figures::Figure sweep_figure(const sweep::SweepSpec& spec,
                                           const sweep::SweepMap& map);

}  // namespace stillpoint::report
