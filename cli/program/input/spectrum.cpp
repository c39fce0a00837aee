// SPDX-License-Identifier: MIT
#include "input/cases.hpp"
#include "input/request.hpp"

namespace stillpoint::cli {

namespace {

/// A page can still show this many.
constexpr std::int64_t most_periods = 10'000;

std::vector<double> periods(const Settings& settings) {
  const auto axis = settings.axis("period");
  if (!axis) {
    throw InputError::missing("period", "give --period first:last:count, in s");
  }
  if (axis->size() > most_periods) {
    throw InputError("period", axis->text(),
                     fmt::format("must have at most {} values", most_periods));
  }
  std::vector<double> list;
  list.reserve(static_cast<std::size_t>(axis->size()));
  for (std::int64_t i = 0; i < axis->size(); ++i) {
    records::require_physical("period", Dimension::time, (*axis)[i]);
    list.push_back((*axis)[i]);
  }
  return list;
}

}  // namespace

report::SpectrumReport spectrum_input(const Settings& given) {
  const Settings settings = given.over_weight();
  static_cast<void>(is_physical(settings, Command::spectrum));
  const std::vector<double> list = periods(settings);
  design::PhysicalIsolator isolator;
  isolator.period_s = std::ranges::max(list);
  isolator.mass_kg = settings.number("mass");
  isolator.gravity_m_per_s2 = settings.number("gravity").value_or(isolator.gravity_m_per_s2);
  isolator.inches = settings.in_inches();
  report::SpectrumReport report{{}, design::physical_input(isolator, 0, 0)};
  const design::Scales& scales = report.physical.scales;
  design::SpectrumRequest& request = report.result.request;
  for (const double period : list) {
    request.p.push_back(scales.p_of(period));
  }
  request.damper = oscillator_input(settings, {.physical = report.physical});
  request.notch_width = notch_width(settings, report.physical);
  request.threads = threads(settings);
  require_one_load(settings);
  if (settings.known("pulse") && with_unit(settings, "lambda") == nullptr) {
    throw InputError::missing("pulse-duration",
                              "give --pulse-duration in s or --excitation-frequency in Hz: lambda "
                              "is relative to one natural frequency");
  }
  request.load = load_case({"", settings}, {.p = scales.p, .physical = report.physical}, false);
  return report;
}

}  // namespace stillpoint::cli
