// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/records/record_file.hpp>

#include <optional>
#include <string>

namespace stillpoint::records {

/// The largest |W| in g, the peak ground acceleration.
[[nodiscard]] double peak_acceleration(const Record& record);

/// The mean of W over the record, in g; 0 for a single value.
[[nodiscard]] double mean_value(const Record& record);

/// The mean time in tau between two values; empty for a single one.
[[nodiscard]] std::optional<double> mean_interval(const Record& record);

/// Of the critical damping, in `spectral_acceleration`.
inline constexpr double spectrum_damping = 0.05;

/// The elastic response spectrum of a record, as a pseudo-acceleration in g: p^2 times the largest
/// displacement of a linear oscillator with the angular frequency p > 0 in 1/tau and the damping
/// above, during the record and after it. Throws InputError for a period 2 pi/p shorter than the
/// mean interval, which the record does not resolve.
[[nodiscard]] double spectral_acceleration(const Record& record, double p);

/// What a record is scaled to: a peak or a value of its spectrum, in g; with neither it is not
/// scaled.
struct RecordTarget {
  std::optional<double> peak{};
  std::optional<double> spectrum{};

  [[nodiscard]] bool is_given() const { return peak || spectrum; }
};

/// How the values of records are scaled.
struct RecordScale {
  double factor{1};  ///< of require_scale
  RecordTarget target{};
  /// Where the spectrum is taken; empty: the motions have several p, and a target of the spectrum
  /// is refused.
  std::optional<double> spectrum_p{};
};

/// The factor that scales `record`, read from `path`, to the target: 1 without one. Throws
/// InputError for a wrong target and for a period that the record does not resolve, FileError for a
/// record that is 0 throughout.
[[nodiscard]] double factor_to_target(const RecordScale& scale, const Record& record,
                                      const std::string& path, const RecordClock& clock);

}  // namespace stillpoint::records
