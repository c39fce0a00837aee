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
  const auto to = [](const std::optional<std::string>& end) { return end ? " to " + *end : ""; };
  const std::string weakest = k_low ? format("{:.6g} to ", *k_low) : "";
  std::optional<std::string> highest;
  std::optional<std::string> longest;
  double shortest = lasts;
  if (lambda_high) {
    highest = frequency_text(physical, *lambda_high);
    longest = time_text(physical, lasts);
    shortest = lasts * (lambda / *lambda_high);
  }
  task.row("pulse", format("{}, k = {}{:.6g} g, lambda {}{}{}", design::name(pulse), weakest,
                           design::peak_load(pulse), highest ? "from " : "= ",
                           frequency_text(physical, lambda), to(highest)));
  task.row("duration", (longest ? "from " : "") + time_text(physical, shortest) + to(longest));
}

Section& add_pulse_region(Document& document, const design::RegionVerdict& verdict,
                          const Physical& physical) {
  const design::Region& region = verdict.region;
  Section& section = document.detail("Bounds");
  section.row("found by", "the forced motion itself, from rest, for each f");
  if (region.feasible) {
    section.row("amplitude",
                format("f >= {:.6g}{}", region.f2, region.f2 == 0 ? "  (does not bind)" : ""));
  }
  const bool up_to_k = region.beta_min == 0;
  section.row("return", up_to_k ? "with every f that starts" : format("f <= {:.6g}", region.f3));
  section.row("start",
              "f below the peak load; nothing bounds delta, since the mass starts from rest");
  section.row("smallest beta", up_to_k ? "none: with f just below the peak load it hardly moves"
                                       : length_text(physical, region.beta_min));
  const std::string feasible =
      region.feasible ? range_digits(*region.f_lower, *region.f_upper) : "";
  for (const auto& [low, high] : verdict.intervals.value()) {
    if (const std::string all = range_digits(low, high); all != feasible) {
      section.row("admissible f", all);  // without the tolerance, or of other islands
    }
  }
  if (region.feasible) {
    section.row("feasible f", feasible);
  }
  return section;
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
