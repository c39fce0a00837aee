// SPDX-License-Identifier: MIT
#pragma once

#include "units.hpp"

#include <stillpoint/design/spectrum.hpp>
#include <stillpoint/figures/figure.hpp>

#include <optional>
#include <vector>

namespace stillpoint::report {

/// Transmitted acceleration, peak and residual over the period, with the notch and without; for a
/// design, `chosen` is its p, which is marked.
[[nodiscard]] std::vector<figures::Figure> spectrum_figures(
    const design::Spectrum& spectrum, const FigureUnits& units,
    const std::optional<double>& chosen = std::nullopt);

}  // namespace stillpoint::report
