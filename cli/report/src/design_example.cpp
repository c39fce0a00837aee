// SPDX-License-Identifier: MIT
// What a notch with a width would do to a design with the paper's.
#include "design_parts.hpp"
#include "format.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace stillpoint::report {

namespace {

/// Under a pulse from those that hold the mass to those that it would not leave.
std::vector<double> widths_to_try(const DesignReport& report) {
  const design::DesignResult& result = report.result;
  const double peak = result.finding->response.peak_amplitude;
  if (result.finding->point.delta == 0) {
    return {};
  }
  if (!result.request.pulse) {
    return {example_width(report.physical, peak)};
  }
  constexpr int count = 12;
  const double least = start_under_pulse(result).width();
  std::vector<double> widths;
  for (int i = 1; i <= count && least < 2 * peak; ++i) {
    const double width = least * std::pow(2 * peak / least, i / (count + 1.0));
    widths.push_back(of_two_digits(report.physical, width));
  }
  return widths;
}

/// Accelerations apart: those of a design are those outside the notch.
std::string example_fault(const design::BuiltNotch& example, const DesignReport& report) {
  design::DesignRequest promised = report.result.request;
  promised.limits.acceleration_max.reset();
  return notch_fault(example, promised, report.physical);
}

/// After the motion shown, or the farthest of ranges.
double rest_of(const design::BuiltNotch& notch) {
  return std::abs(notch.farthest ? notch.farthest->rest : *notch.response.stop_position);
}

/// Of the peak; infinite if it does not move, or not stop.
double off_centre(const design::BuiltNotch& notch) {
  const ForcedResponse& response = notch.response;
  return response.stop_position && response.half_cycles > 0
             ? rest_of(notch) / response.peak_amplitude
             : HUGE_VAL;
}

}  // namespace

double of_two_digits(const Physical& physical, double length) {
  const double unit = physical ? physical->scales.length_m : 1;
  return std::stod(format("{:.2g}", length * unit)) / unit;
}

StartUnderLoad start_under_pulse(const design::DesignResult& result) {
  const auto& [f, delta, tolerance] = result.finding->point;
  const design::DesignRequest& request = result.request;
  return {f, delta, request.pulse_ranges.k_low.value_or(design::peak_load(*request.pulse))};
}

std::optional<design::BuiltNotch> example_notch(const DesignReport& report) {
  const design::DesignResult& result = report.result;
  const auto badness = [&](const design::BuiltNotch& notch) {
    return std::pair(!example_fault(notch, report).empty(), off_centre(notch));
  };
  std::optional<design::BuiltNotch> best;
  for (const double width : widths_to_try(report)) {
    if (can_be_followed(width, result.finding->point.delta, result.request.problem.p)) {
      const design::BuiltNotch tried = design::built_notch(result, {width});
      if (!best || badness(tried) < badness(*best)) {
        best = tried;
      }
    }
  }
  return best;
}

std::string notch_sentence(const DesignReport& report) {
  const design::DesignResult& result = report.result;
  const Physical& physical = report.physical;
  if (!result.finding) {
    return {};
  }
  if (report.built_notch) {
    const std::string fault = built_notch_fault(report, physical);
    return fault.empty() ? "" : "with this notch " + fault;
  }
  const double peak = result.finding->response.peak_amplitude;
  if (!result.request.pulse || result.finding->point.delta == 0) {
    return {};
  }
  if (std::string none =
          no_notch_words(start_under_pulse(result), peak, "", "this pulse", physical);
      !none.empty()) {
    return none;
  }
  if (!report.example || example_fault(*report.example, report).empty()) {
    return {};
  }
  const ForcedResponse& best = report.example->response;
  const double width = *report.example->shape.width;
  return "no notch width that was tried brings the mass back to x = 0: " +
         (best.stop_position && best.peak_amplitude > width / 2 && !report.example->farthest
              ? format("the nearest, {} wide, leaves it {} off centre after a stroke of {}",
                       length_shown(physical, width),
                       length_shown(physical, std::abs(*best.stop_position)),
                       length_shown(physical, best.peak_amplitude))
              : format("with the nearest, {} wide, {}", length_shown(physical, width),
                       example_fault(*report.example, report)));
}

std::string example_words(const DesignReport& report, const Physical& physical) {
  if (!report.example) {
    return {};
  }
  const double width = *report.example->shape.width;
  const std::string fault = example_fault(*report.example, report);
  if (!report.result.request.pulse) {
    return fault.empty() ? "" : example_sentence("with next to no width", width, fault, physical);
  }
  return fault.empty()
             ? format(
                   " That is for a notch that {}: one {} wide acts from the start, and leaves the "
                   "mass {}{} off centre after a stroke of {}.",
                   acts_late, length_shown(physical, width),
                   report.example->farthest ? "up to " : "",
                   length_shown(physical, rest_of(*report.example)),
                   length_shown(physical, report.example->response.peak_amplitude))
             : "";
}

std::string inside_example(const DesignReport& report, const Physical& physical) {
  return report.example
             ? format("{} with one {} wide{}",
                      acceleration_shown(report.example->response.peak_absolute_acceleration),
                      length_shown(physical, *report.example->shape.width),
                      report.result.finding->pulse->worst ? " under the pulse shown" : "")
             : format("{} if it holds the mass",
                      acceleration_shown(design::peak_load(*report.result.request.pulse)));
}

}  // namespace stillpoint::report
