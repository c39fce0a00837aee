// SPDX-License-Identifier: MIT
#pragma once

// The report of a response spectrum, in metres and seconds.

#include <stillpoint/design/physical.hpp>
#include <stillpoint/design/spectrum.hpp>
#include <stillpoint/figures/figure.hpp>
#include <stillpoint/report/document.hpp>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace stillpoint::report {

struct SpectrumReport {
  design::Spectrum result;
  design::PhysicalInput physical;  ///< its period is not one of the spectrum's
};

/// "locked: at 3 of 9 periods ..."; empty if it locks at none.
[[nodiscard]] std::string verdict(const SpectrumReport& report);
[[nodiscard]] Document document(const SpectrumReport& report);
/// As docs/reports.md describes it.
[[nodiscard]] nlohmann::ordered_json json(const SpectrumReport& report);
[[nodiscard]] std::vector<figures::Figure> drawings(const SpectrumReport& report);

/// A row for each record and period. A value that does not exist is left out in CSV and NaN in
/// NumPy's format.
[[nodiscard]] std::string spectrum_csv(const SpectrumReport& report);
[[nodiscard]] std::string spectrum_npy(const SpectrumReport& report);

}  // namespace stillpoint::report
