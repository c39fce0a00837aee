// SPDX-License-Identifier: MIT
#include "sections.hpp"

namespace stillpoint::report {

/// "tolerance 1e-09"; "" if it has none.
std::string setting(const peers::MethodRow& now) {
  return now.setting ? format("{} {:.3g}", now.setting->name, now.setting->value) : "";
}

/// Why simulate uses the first method.
std::string_view reason(const SimulationRequest& request) {
  return is_forced(request)
             ? "between events the motion is a closed form, and the first event is found by a "
               "bound that cannot step over it"
             : "between edges and turns the motion is a closed form, exact without a step or a "
               "tolerance to choose";
}

namespace {

std::string counts(const peers::Result& result) {
  return format("{}, {}, {}", result.passages, result.turns, result.sticks);
}

std::string shown_time(double seconds) {
  constexpr int digits = 3;
  return with_unit(seconds, "s", digits);
}

std::string exponent(double error) {
  return error == 0 ? "0" : format("{:.1e}", error);
}

TableRow method_row(const peers::MethodRow& now) {
  if (now.run != peers::Run::done) {
    return {{std::string(now.name), setting(now), "not run", "", "", "",
             now.run == peers::Run::nothing_moves ? "nothing moves" : "too long"},
            Tone::faint};
  }
  return {
      {std::string(now.name), setting(now), shown_time(now.time.median), exponent(now.peak_error),
       exponent(now.end_error), counts(now.result), now.counts_right ? "right" : "wrong"},
      now.counts_right ? Tone::good : Tone::bad};
}

/// The accuracy of simulate's own method.
std::string verdict(const peers::MethodRow& kernel, bool stops) {
  if (kernel.run != peers::Run::done) {
    return "";
  }
  return format("simulate is off by {} in the peak and {} {}, and takes {}.",
                exponent(kernel.peak_error), exponent(kernel.end_error),
                stops ? "at rest" : "at the end", shown_time(kernel.time.median));
}

}  // namespace

Document document(const AccuracyReport& report) {
  const peers::Result& truth = report.comparison.exact.rounded;
  const bool stops = truth.outcome != Outcome::running;
  Document document{.title = "Accuracy", .verdict = verdict(report.comparison.rows.front(), stops)};
  Table table{{"", "setting", "time", "error of peak", stops ? "of rest" : "of end", "counts", ""},
              {}};
  for (const peers::MethodRow& now : report.comparison.rows) {
    table.rows.push_back(method_row(now));
  }
  Section& methods = document.section("Methods", {std::move(table)});
  methods.line(
      stops ? "Errors of the peak and of the place of rest are relative to the peak, of the "
              "stop time to itself."
            : "Errors of the peak and of x are relative to the peak, of v to p times the peak.");
  methods.line("The counts are of passages, turning points and sticks.");
  methods.line(format("simulate uses stillpoint: {}.", reason(report.request)));
  return document;
}

}  // namespace stillpoint::report
