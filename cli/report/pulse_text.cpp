// SPDX-License-Identifier: MIT
#include "pulse_text.hpp"

#include "text_sections.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace stillpoint::cli {

using fmt::format;

namespace {

/// "0.28 % more than", "0.28 % less than": the reduced figure against the true one.
std::string off_by(double relative) {
  return format("{:.2g} % {}", 100 * std::abs(relative), relative < 0 ? "less than" : "more than");
}

std::string sentence(design::PulseWarning warning, const design::PulseCheck& check) {
  switch (warning) {
    case design::PulseWarning::pulse_not_short:
      return format(
          "the pulse is not short, p/lambda = {:.3g}: the design is for an initial velocity, and "
          "the error of that grows like the square of p/lambda",
          check.shortness);
    case design::PulseWarning::friction_not_small:
      return format(
          "f is not small against k, f/k = {:.3g}: friction takes a large part of the velocity "
          "while the pulse lasts",
          check.friction_ratio);
  }
  return {};
}

}  // namespace

void add_pulse(Page& page, const design::Pulse& pulse,
               const std::optional<design::PhysicalInput>& physical) {
  const double lambda = design::angular_frequency(pulse);
  page.row("pulse", format("{}, k = {:.6g}, lambda = {:.6g}{}", design::name(pulse),
                           design::peak_load(pulse), lambda, in_rad_per_s(physical, lambda)));
  const double lasts = duration(design::excitation(pulse)).value();
  page.row("lasts", format("{:.6g}{}", lasts, in_seconds(physical, lasts)));
}

void add_pulse_check(Page& page, const design::PulseCheck& check,
                     const std::optional<design::PhysicalInput>& physical) {
  page.section("Under the pulse itself");
  page.row("reduced to", format("v0 = {:.6g} at tau = {:.6g}", check.start.speed, check.start.tau));
  page.row("p/lambda, f/k", format("{:.4g}, {:.4g}", check.shortness, check.friction_ratio));
  add_response(page, check.response, physical, forced_margin);
  page.row("reduction", format("its peak is {} this", off_by(check.peak_error)));
  if (check.stop_time_error) {
    page.row("", format("its stop time is {} this", off_by(*check.stop_time_error)));
  }
  for (const design::PulseWarning warning : check.warnings) {
    page.line(format("Note: {}.", sentence(warning, check)), Tone::bad);
  }
}

}  // namespace stillpoint::cli
