// SPDX-License-Identifier: MIT
#pragma once

// The report of a response spectrum, in metres and seconds.

#include <stillpoint/design/physical.hpp>
#include <stillpoint/design/spectrum.hpp>
#include <stillpoint/figures/figure.hpp>
#include <stillpoint/report/document.hpp>

#include <nlohmann/json.hpp>

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

/// A row for each motion and period, as CSV or in NumPy's format. A value that does not exist is
/// left out in the one and NaN in the other.
[[nodiscard]] std::string spectrum_rows(const SpectrumReport& report, bool npy);

}  // namespace stillpoint::report
