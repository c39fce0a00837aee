// SPDX-License-Identifier: MIT
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/record_scaling.hpp>
#include <stillpoint/records/units.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace stillpoint::records {

double peak_acceleration(const Record& record) {
  double peak = 0;
  for (const double value : record.values) {
    peak = std::max(peak, std::abs(value));
  }
  return peak;
}

double mean_value(const Record& record) {
  double sum = 0;
  double length = 0;
  for (std::size_t i = 0; i + 1 < record.values.size(); ++i) {
    const double step = record.times.empty() ? record.step : record.times[i + 1] - record.times[i];
    sum += step * (record.values[i] + record.values[i + 1]) / 2;
    length += step;
  }
  return length > 0 ? sum / length : 0;
}

std::optional<double> mean_interval(const Record& record) {
  if (record.values.size() < 2) {
    return std::nullopt;
  }
  return record.times.empty() ? record.step
                              : (record.times.back() - record.times.front()) /
                                    static_cast<double>(record.times.size() - 1);
}

namespace {

/// A period may have come from a quotient: an ulp or two do not matter.
bool resolved(double period, double shortest) {
  constexpr double rounding = 1e-12;
  return period >= shortest * (1 - rounding);
}

/// The spectrum that is scaled to the target.
double own_spectrum(const Record& record, const std::string& path, const RecordClock& clock,
                    std::optional<double> p) {
  if (!p) {
    throw InputError::missing("record-spectrum-period",
                              "the motions may have several periods: give the one at which the "
                              "spectrum is scaled");
  }
  const double period = 2 * std::numbers::pi * clock.per_tau / *p;
  const double shortest = mean_interval(record).value_or(0) * clock.per_tau;
  if (!resolved(period, shortest)) {
    throw InputError(
        "record-spectrum-period", fmt::format("{} {}", period, clock.unit),
        fmt::format("must be at least {:.6g} {}, the mean time between two values of record {}",
                    shortest, clock.unit, path));
  }
  return spectral_acceleration(record, *p);
}

void require_target(const char* name, const std::optional<double>& target) {
  if (target) {
    require_physical(name, Dimension::gravities, *target);
  }
}

}  // namespace

double spectral_acceleration(const Record& record, double p) {
  const double period = 2 * std::numbers::pi / p;
  const double shortest = mean_interval(record).value_or(0);  // any
  if (!resolved(period, shortest)) {
    throw InputError(
        "record-spectrum-period", period,
        fmt::format("in tau must be at least {:.6g}, the mean time between two values", shortest));
  }
  // The first turn after the record is at most half a period of the damped oscillator later.
  const double end = duration(Excitation(record)).value_or(0) + period;
  const Oscillator linear{.p = p, .zeta = spectrum_damping};
  return p * p * forced_response(linear, {}, record, {.t_end = end}).peak_amplitude;
}

double factor_to_target(const RecordScale& scale, const Record& record, const std::string& path,
                        const RecordClock& clock) {
  const auto& [peak, spectrum] = scale.target;
  require_target("record-peak", peak);
  require_target("record-spectrum", spectrum);
  if (!scale.target.is_given()) {
    return 1;
  }
  const double own =
      spectrum ? own_spectrum(record, path, clock, scale.spectrum_p) : peak_acceleration(record);
  if (own == 0) {
    throw FileError({"record", path}, spectrum
                                          ? "moves no oscillator, so its spectrum cannot be scaled"
                                          : "is 0 throughout, so it cannot be scaled to a peak");
  }
  return (spectrum ? *spectrum : *peak) / own;
}

}  // namespace stillpoint::records
