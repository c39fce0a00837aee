// SPDX-License-Identifier: MIT
// What a report says of a pulse.
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>

namespace stillpoint::report {

void add_pulse(Section& task, const design::Pulse& pulse, const design::PulseRanges& ranges,
               const Physical& physical) {
  const auto& [k_low, lambda_high] = ranges;
  const double lambda = design::angular_frequency(pulse);
  const double lasts = duration(design::excitation(pulse)).value();
  task.row("pulse",
           format("{}, k = {}{:.6g} g, {}", design::name(pulse),
                  k_low ? format("{:.6g} to ", *k_low) : "", design::peak_load(pulse),
                  frequency_shown(physical, lambda) +
                      (lambda_high ? " to " + frequency_shown(physical, *lambda_high) : "")));
  task.row("duration",
           (lambda_high ? time_shown(physical, lasts * (lambda / *lambda_high)) + " to " : "") +
               time_shown(physical, lasts));
}

DeltaNeeds delta_needs(const design::DesignResult& result) {
  const auto& [problem, limits, search, pulse, ranges] = result.request;
  const double f = result.finding->point.f;
  if (!pulse) {
    return {design::delta1_published(problem, f), design::delta1_exact(problem, f)};
  }
  const auto least = [&](design::Criterion criterion) {
    design::PulseProblem task = design::pulse_request(result.request).problem;
    task.criterion = criterion;
    return design::least_delta(task, f);
  };
  return {least(design::Criterion::published).value_or(0), least(design::Criterion::exact)};
}

}  // namespace stillpoint::report
