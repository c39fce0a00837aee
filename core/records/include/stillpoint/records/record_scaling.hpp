// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>

#include <string>
#include <vector>

namespace stillpoint::records {

/// The largest |W| in g, the peak ground acceleration.
[[nodiscard]] double peak_acceleration(const Record& record);

/// The mean time in tau between two values; 0 for a single one.
[[nodiscard]] double mean_interval(const Record& record);

/// Of the critical damping, in `spectral_acceleration`.
inline constexpr double spectrum_damping = 0.05;

/// The elastic response spectrum of a record, as a pseudo-acceleration in g: p^2 times the largest
/// displacement of a linear oscillator with the angular frequency p > 0 in 1/tau and the damping
/// above, during the record and after it. docs/records.md, (1) and (2). Throws InputError for a
/// period 2 pi/p shorter than the mean interval, which the record does not resolve.
[[nodiscard]] double spectral_acceleration(const Record& record, double p);

/// The files of a folder that may be records, by the ending of their names, in the order of their
/// names; of anything else the path itself. Throws FileError for a folder without any.
[[nodiscard]] std::vector<std::string> record_files(const std::string& path);

}  // namespace stillpoint::records
