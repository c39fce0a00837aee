// SPDX-License-Identifier: MIT
#include "input/record.hpp"

#include "input/motion.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/design/physical.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/record_scaling.hpp>

#include <fmt/format.h>

#include <numbers>

namespace stillpoint::cli {

namespace {

/// A time in the unit of the records' times. Without physical input that is tau, and seconds are
/// wrong.
std::optional<double> record_time(const Settings& settings, std::string_view name,
                                  const records::RecordClock& clock) {
  if (const auto given = settings.with_unit(name); given && clock.unit != "s") {
    throw InputError(std::string(name), *given,
                     "must be a number without a unit: without physical input times are in tau");
  }
  return settings.number(name);
}

std::optional<double> target_value(const Settings& settings, const char* name) {
  const auto value = settings.number(name);
  if (value) {
    require_within(name, *value, smallest_physical, largest_physical);
  }
  return value;
}

}  // namespace

records::RecordOptions record_options(const Settings& settings, const records::RecordClock& clock) {
  records::RecordOptions options;
  options.step = record_time(settings, "record-step", clock);
  if (const auto units = settings.known("record-units")) {
    options.units = records::parse_record_units(*units);
  }
  options.gravity_m_per_s2 = settings.number("gravity").value_or(design::Scales().gravity_m_per_s2);
  options.clock = clock;
  return options;
}

records::RecordTarget record_target(const Settings& settings) {
  const records::RecordTarget target{target_value(settings, "record-peak"),
                                     target_value(settings, "record-spectrum")};
  return target;
}

RecordScaling::RecordScaling(const Settings& settings, const records::RecordClock& clock,
                             std::optional<double> p)
    : clock_(clock), p_(p) {
  const auto period = record_time(settings, "record-spectrum-period", clock);
  if (period) {
    require_within("record-spectrum-period", *period, smallest_physical, largest_physical);
    p_ = 2 * std::numbers::pi * clock.per_tau / *period;
  }
}

double RecordScaling::factor(const Record& record, const std::string& path,
                             const records::RecordTarget& target) const {
  if (!target.is_given()) {
    return 1;
  }
  double reached = records::peak_acceleration(record);
  if (target.spectrum) {
    if (!p_) {
      throw InputError::missing("record-spectrum-period",
                                "the motions may have several periods: give the one at which the "
                                "spectrum is scaled");
    }
    const double period = 2 * std::numbers::pi * clock_.per_tau / *p_;
    const double shortest = records::mean_interval(record) * clock_.per_tau;
    if (period < shortest * (1 - 1e-12)) {  // an ulp or two of a quotient do not matter
      throw InputError("record-spectrum-period", period,
                       fmt::format("must be at least {:.6g} {}, the mean time between two values "
                                   "of record {}",
                                   shortest, clock_.unit, path));
    }
    reached = records::spectral_acceleration(record, *p_);
  }
  if (reached == 0) {
    throw records::FileError(
        {"record", path}, target.spectrum ? "moves no oscillator, so its spectrum cannot be scaled"
                                          : "is 0 throughout, so it cannot be scaled to a peak");
  }
  return target.peak.value_or(target.spectrum.value_or(reached)) / reached;
}

}  // namespace stillpoint::cli
