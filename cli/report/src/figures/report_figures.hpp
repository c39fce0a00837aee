// SPDX-License-Identifier: MIT
#pragma once

// The figures of a spectrum and of a sweep.

#include "units.hpp"

#include <stillpoint/design/spectrum.hpp>
#include <stillpoint/figures/figure.hpp>
#include <stillpoint/sweep/map.hpp>

#include <optional>
#include <vector>

namespace stillpoint::report {

/// Transmitted acceleration, peak and residual over the period, with the notch and without; for a
/// design, `chosen` is its p, which is marked.
[[nodiscard]] std::vector<figures::Figure> spectrum_figures(
    const design::Spectrum& spectrum, const FigureUnits& units,
    const std::optional<double>& chosen = std::nullopt);

/// The plane of f and Delta, coloured by how the motions end and after how many half-cycles; of
/// free motions from x = 0 with the analytic boundaries on top.
[[nodiscard]] figures::Figure sweep_figure(const sweep::SweepSpec& spec,
                                           const sweep::SweepMap& map);

}  // namespace stillpoint::report
