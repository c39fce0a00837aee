// SPDX-License-Identifier: MIT
#include "design_parts.hpp"
#include "format.hpp"

#include <cmath>

namespace stillpoint::report {

namespace {

/// "0.28 % larger", "0.28 % smaller": the reduced figure against the true one.
std::string off_by(double relative) {
  return format("{:.2g} % {}", 100 * std::abs(relative), relative < 0 ? "smaller" : "larger");
}

/// Why the reduction to a velocity is off.
std::string warning_text(design::PulseWarning warning, const design::PulseCheck& check) {
  switch (warning) {
    case design::PulseWarning::pulse_not_short:
      return format("the pulse is not short, p/lambda = {:.3g}", check.shortness);
    case design::PulseWarning::friction_not_small:
      return format("f is not small against k, f/k = {:.3g}", check.friction_ratio);
  }
  return {};
}

std::string reduction_text(const design::PulseCheck& check) {
  if (!check.start) {
    return "not used: this pulse leaves no velocity";
  }
  std::string text = format("not used; with an initial velocity for the pulse the peak would be {}",
                            off_by(check.peak_error.value_or(0)));
  for (const design::PulseWarning warning : check.warnings) {
    text += "; " + warning_text(warning, check);
  }
  return text;
}

}  // namespace

std::string lock_sentence(const DesignReport& report) {
  const auto& finding = report.result.finding;
  if (!finding || !finding->pulse || !finding->pulse->response.locked_from) {
    return {};
  }
  const design::PulseCheck& check = *finding->pulse;
  return locked_words(check.response, duration(design::excitation(check.pulse)).value(),
                      report.physical);
}

void add_pulse_check(Document& document, const design::PulseCheck& check,
                     const Physical& physical) {
  Section& section = document.detail("Under the pulse itself");
  section.row("p/lambda, f/k", format("{:.4g}, {:.4g}", check.shortness, check.friction_ratio));
  add_response(section, check.response, physical);
  section.row("reduction", reduction_text(check));
  if (check.start) {
    section.row("", format("that velocity is {}, at {}",
                           FigureUnits(physical).velocity_words(check.start->speed),
                           time_shown(physical, check.start->tau)));
  }
  if (check.stop_time_error) {
    section.row("", format("with it the stop time would be {}", off_by(*check.stop_time_error)));
  }
}

}  // namespace stillpoint::report
