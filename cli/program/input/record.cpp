// SPDX-License-Identifier: MIT
#include "input/record.hpp"

#include <cmath>
#include <numbers>

namespace stillpoint::cli {

namespace {

/// A time in the unit of the records' times. Without physical input that is tau, and seconds are
/// wrong.
std::optional<double> record_time(const Settings& settings, std::string_view name,
                                  const records::RecordClock& clock) {
  const auto given = settings.entries().find(name);
  if (given != settings.entries().end() && given->second.with_unit && clock.unit != "s") {
    throw InputError(std::string(name), *given->second.with_unit,
                     "must be a number without a unit: without physical input times are in tau");
  }
  return settings.number(name);
}

/// Of a sweep over scales the one that changes a record most.
double farthest(const Axis& scales) {
  const auto [least, most] = scales.ends();
  return std::abs(least) > std::abs(most) ? least : most;
}

}  // namespace

records::SuiteFiles suite_files(const Settings& settings) {
  return {settings.texts("record"), settings.text("records-list")};
}

records::RecordClock record_clock(const Physical& physical, double p) {
  return {physical ? "s" : "tau", physical ? physical->scales.time_s : 1, p};
}

records::RecordOptions record_options(const Settings& settings, const records::RecordClock& clock) {
  records::RecordOptions options;
  options.step = record_time(settings, "record-step", clock);
  options.units = settings.named<records::RecordUnits>("record-units");
  options.gravity_m_per_s2 = settings.number("gravity").value_or(design::Scales().gravity_m_per_s2);
  options.clock = clock;
  options.held = settings.held_records();
  return options;
}

records::RecordScale record_scale(const Settings& settings, const records::RecordClock& clock,
                                  std::optional<double> p) {
  if (const auto period = record_time(settings, "record-spectrum-period", clock)) {
    require_within("record-spectrum-period", *period, smallest_physical, largest_physical);
    p = 2 * std::numbers::pi * clock.per_tau / *period;
  }
  const auto axis = settings.axis("record-scale");
  return {axis ? farthest(*axis) : settings.number("record-scale").value_or(1),
          {settings.number("record-peak"), settings.number("record-spectrum")},
          p};
}

std::vector<records::SuiteRecord> read_suite(const Settings& settings,
                                             const records::RecordClock& clock,
                                             std::optional<double> p) {
  return records::read_suite(suite_files(settings), record_scale(settings, clock, p),
                             record_options(settings, clock));
}

}  // namespace stillpoint::cli
