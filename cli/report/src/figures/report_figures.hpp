// SPDX-License-Identifier: MIT
#pragma once

// The figures of a spectrum and of a design under records.

#include "figures/drawing.hpp"

#include <stillpoint/design/record_design_result.hpp>
#include <stillpoint/design/spectrum.hpp>

namespace stillpoint::report {

/// Transmitted acceleration, peak and residual over the period, with the notch and without; for a
/// design, `chosen` is its p, which is marked.
[[nodiscard]] std::vector<Figure> spectrum_figures(
    const design::Spectrum& spectrum, const FigureUnits& units,
    const std::optional<double>& chosen = std::nullopt);

/// The plane of f and delta where the objective is good, then what lies about the damper; none if
/// f or delta was not searched.
[[nodiscard]] std::vector<Figure> record_maps(const design::RecordDesign& result,
                                              const FigureUnits& units);

}  // namespace stillpoint::report
