// SPDX-License-Identifier: MIT
// What a design with the paper's notch asks of the notch that is built.
#include "design_parts.hpp"
#include "format.hpp"

#include <stillpoint/records/decimal.hpp>

namespace stillpoint::report {

namespace {

/// Rounded up as a limit is printed.
double limit_of_digits(const Physical& physical, double length) {
  constexpr int with_a_unit = 5;
  constexpr int plain = 6;
  const double unit = physical ? physical->scales.length_m : 1;
  return records::decimal(length * unit, physical ? with_a_unit : plain, records::Rounding::up) /
         unit;
}

/// A width that keeps the limit of the acceleration inside it, as it is printed, if one is known.
std::optional<double> limiting_width(const DesignReport& report) {
  const design::Found& finding = *report.result.finding;
  const auto lines =
      told_practice(task_of(report), finding.practice, finding.point.f, finding.point.delta).lines;
  return lines && lines->notch_width_min
             ? std::optional(limit_of_digits(report.physical, *lines->notch_width_min))
             : std::nullopt;
}

/// A hit's v0 is the speed with which the mass leaves the notch; under a pulse it starts in it.
bool starts_in_notch(const DesignReport& report) {
  return report.result.request.pulse && report.result.finding &&
         report.result.finding->point.delta > 0;
}

}  // namespace

bool no_notch_works(const DesignReport& report) {
  return starts_in_notch(report) && start_under_pulse(report.result).width() >=
                                        2 * report.result.finding->response.peak_amplitude;
}

double of_two_digits(const Physical& physical, double length) {
  const double unit = physical ? physical->scales.length_m : 1;
  return records::decimal(length * unit, 2) / unit;
}

StartUnderLoad start_under_pulse(const design::DesignResult& result) {
  const auto& [f, delta, tolerance] = result.finding->point;
  const design::DesignRequest& request = result.request;
  return {f, delta, request.pulse_ranges.k_low.value_or(design::peak_load(*request.pulse))};
}

std::string notch_sentence(const DesignReport& report) {
  if (report.built_notch) {
    const std::string fault = built_notch_fault(report);
    return fault.empty() ? "" : "with this notch " + fault;
  }
  return no_notch_works(report) ? no_notch_words(start_under_pulse(report.result),
                                                 report.result.finding->response.peak_amplitude, "",
                                                 "this pulse", report.physical)
                                : "";
}

std::string late_notch_words(const DesignReport& report, std::string_view command) {
  return starts_in_notch(report) && !report.built_notch && !no_notch_works(report)
             ? format(" That is for a notch that {}; {}--notch-width{} shows what a real one does.",
                      acts_late, command, report.physical ? "-m" : "")
             : "";
}

std::string inside_limit(const DesignReport& report, const Physical& physical) {
  const design::DesignRequest& request = report.result.request;
  const auto& finding = report.result.finding;
  if (starts_in_notch(report)) {
    return acceleration_shown(design::peak_load(*request.pulse)) + " if it holds the mass";
  }
  if (!finding || finding->point.delta == 0) {
    return {};
  }
  const auto width = limiting_width(report);
  return width ? format("{} at most inside one {}{} wide, with {} as given",
                        acceleration_shown(*request.limits.acceleration_max),
                        request.problem.has_caught_hits(finding->point.delta) ? "" : "at least ",
                        length_shown(physical, *width),
                        request.problem.v0_low ? "f and delta" : "f, delta and the hit")
               : "";
}

}  // namespace stillpoint::report
