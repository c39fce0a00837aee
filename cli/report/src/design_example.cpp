// SPDX-License-Identifier: MIT
// What a notch with a width would do to a design with the paper's.
#include "design_parts.hpp"
#include "format.hpp"

#include <stillpoint/records/decimal.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace stillpoint::report {

namespace {

/// A width that keeps the limit of the acceleration inside it, as it is printed, if one is known.
std::optional<double> limiting_width(const DesignReport& report) {
  const design::Finding& finding = *report.result.finding;
  const auto lines =
      told_practice(task_of(report), finding.practice, finding.point.f, finding.point.delta).lines;
  return lines && lines->notch_width_min
             ? std::optional(limit_of_digits(report.physical, *lines->notch_width_min))
             : std::nullopt;
}

/// Under a pulse from those that hold the mass to those that it would not leave, and from those
/// that keep the limit.
std::vector<double> widths_to_try(const DesignReport& report) {
  const design::DesignResult& result = report.result;
  const double peak = result.finding->response.peak_amplitude;
  if (result.finding->point.delta == 0) {
    return {};
  }
  const auto limiting = limiting_width(report);
  if (!result.request.pulse) {
    return {limiting ? *limiting : example_width(report.physical, peak)};
  }
  constexpr int count = 12;
  std::vector<double> widths;
  const auto add_from = [&](double least) {
    for (int i = 1; i <= count && least < 2 * peak; ++i) {
      const double width = least * std::pow(2 * peak / least, i / (count + 1.0));
      widths.push_back(of_two_digits(report.physical, width));
    }
  };
  add_from(start_under_pulse(result).width());
  if (limiting) {
    add_from(*limiting);
  }
  return widths;
}

/// Those of a design are outside the notch, unless its width is said to keep the limit inside too.
std::string example_fault(const design::BuiltNotch& example, const DesignReport& report) {
  design::DesignRequest promised = report.result.request;
  if (promised.pulse || !limiting_width(report)) {
    promised.limits.acceleration_max.reset();
  }
  return notch_fault(example, promised, report.physical);
}

bool exceeds_limit(const design::BuiltNotch& example, const DesignReport& report) {
  const auto& limit = report.result.request.limits.acceleration_max;
  return limit && most_felt(example) > *limit * for_rounding;
}

/// After the motion shown, or the farthest of ranges.
double rest_of(const design::BuiltNotch& notch) {
  return std::abs(notch.worst ? notch.worst->farthest.rest() : *notch.response.stop_position);
}

/// Of the peak; infinite if it does not move, or not stop.
double off_centre(const design::BuiltNotch& notch) {
  const ForcedResponse& response = notch.response;
  return response.stop_position && response.half_cycles > 0
             ? rest_of(notch) / response.peak_amplitude
             : HUGE_VAL;
}

std::string none_works(const DesignReport& report) {
  return no_notch_words(start_under_pulse(report.result),
                        report.result.finding->response.peak_amplitude, "", "this pulse",
                        report.physical);
}

}  // namespace

bool no_notch_works(const DesignReport& report) {
  const auto& finding = report.result.finding;
  return finding && finding->point.delta > 0 && !none_works(report).empty();
}

double limit_of_digits(const Physical& physical, double length) {
  constexpr int with_a_unit = 5;
  constexpr int plain = 6;
  const double unit = physical ? physical->scales.length_m : 1;
  return records::decimal(length * unit, physical ? with_a_unit : plain, records::Rounding::up) /
         unit;
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

std::optional<design::BuiltNotch> example_notch(const DesignReport& report) {
  const design::DesignResult& result = report.result;
  const auto badness = [&](const design::BuiltNotch& notch) {
    return std::tuple(!example_fault(notch, report).empty(), exceeds_limit(notch, report),
                      off_centre(notch));
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
  if (!result.request.pulse || result.finding->point.delta == 0) {
    return {};
  }
  if (std::string none = none_works(report); !none.empty()) {
    return none;
  }
  if (!report.example || example_fault(*report.example, report).empty()) {
    return {};
  }
  const ForcedResponse& best = report.example->response;
  const double width = *report.example->shape.width;
  return "no notch width that was tried brings the mass back to x = 0: " +
         (best.stop_position && best.peak_amplitude > width / 2 && !report.example->worst
              ? format("the nearest for its stroke, {} wide, leaves it {} off centre after a "
                       "stroke of {}",
                       length_shown(physical, width),
                       length_shown(physical, std::abs(*best.stop_position)),
                       length_shown(physical, best.peak_amplitude))
              : format("with the nearest for its stroke, {} wide, {}",
                       length_shown(physical, width), example_fault(*report.example, report)));
}

std::string example_words(const DesignReport& report, const Physical& physical,
                          std::string_view command) {
  if (!report.example) {
    return {};
  }
  const double width = *report.example->shape.width;
  const std::string fault = example_fault(*report.example, report);
  if (!report.result.request.pulse) {
    const bool ranges_by_one = report.example->worst && !command.empty();
    return fault.empty() ? ""
                         : format(
                               " That is for a notch with next to no width: with one {} wide, "
                               "{}.{}",
                               length_shown(physical, width), fault,
                               ranges_by_one ? ""
                                             : format(" Try others with {}--notch-width{}.",
                                                      command, physical ? "-m" : ""));
  }
  return fault.empty()
             ? format(
                   " That is for a notch that {}: one {} wide acts from the start, and leaves the "
                   "mass {}{} off centre after a stroke of {}.",
                   acts_late, length_shown(physical, width), report.example->worst ? "up to " : "",
                   length_shown(physical, rest_of(*report.example)),
                   length_shown(physical, report.example->response.peak_amplitude))
             : "";
}

std::string told_notch_fault(const DesignReport& report) {
  std::string words = notch_sentence(report);
  if (!words.empty() || !report.example || report.result.request.pulse) {
    return words;
  }
  const std::string fault = example_fault(*report.example, report);
  return fault.empty() ? ""
                       : format("with one {} wide {}",
                                length_shown(report.physical, *report.example->shape.width), fault);
}

std::string inside_example(const DesignReport& report, const Physical& physical) {
  const auto& [problem, limits, search, pulse, ranges] = report.result.request;
  const auto& finding = report.result.finding;
  if (!finding || finding->point.delta == 0 || (!pulse && !report.example)) {
    return {};
  }
  if (!report.example) {
    return acceleration_shown(design::peak_load(*pulse)) + " if it holds the mass";
  }
  const std::string up_to = report.example->worst ? "up to " : "";
  const std::string wide = length_shown(physical, *report.example->shape.width) + " wide";
  const bool exceeds = exceeds_limit(*report.example, report);
  const std::string most = acceleration_shown(most_felt(*report.example));
  if (pulse) {
    return format("{}{} with one {}{}", up_to, most, wide, exceeds ? ", more than the limit" : "");
  }
  if (!limiting_width(report)) {
    return {};
  }
  const std::string leaves = example_fault(*report.example, report).empty()
                                 ? format(", which leaves it {}{} off centre", up_to,
                                          length_shown(physical, rest_of(*report.example)))
                                 : "";
  return format("{} at most inside one {}{}, with {} as given{}",
                exceeds ? most : acceleration_shown(*limits.acceleration_max),
                problem.has_caught_hits(finding->point.delta) || exceeds ? "" : "at least ", wide,
                problem.v0_low ? "f and delta" : "f, delta and the hit", leaves);
}

}  // namespace stillpoint::report
