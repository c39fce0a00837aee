// SPDX-License-Identifier: MIT
#include "format.hpp"
#include "json/parts.hpp"
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>
#include <stillpoint/report/report.hpp>

#include <variant>

namespace stillpoint::report {

using nlohmann::ordered_json;

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

/// As in --json.
std::string_view not_run(peers::Run run) {
  return run == peers::Run::nothing_moves ? "nothing_moves" : "too_long";
}

/// "tolerance 1e-09"; "" if it has none.
std::string setting(const peers::MethodRow& now) {
  return now.setting ? format("{} {:.3g}", now.setting->name, now.setting->value) : "";
}

ordered_json method_json(const peers::MethodRow& now, bool used) {
  const bool done = now.run == peers::Run::done;
  const auto found = [done](auto value) { return done ? ordered_json(value) : nullptr; };
  return {{"name", now.name},
          {"setting", setting(now)},
          {"used_by_simulate", used},
          {"wall_time_s", found(now.time.median)},
          {"peak_error", found(now.peak_error)},
          {"end_error", found(now.end_error)},
          {"zero_passages", found(now.result.passages)},
          {"turning_points", found(now.result.turns)},
          {"sticks", found(now.result.sticks)},
          {"counts_right", found(now.counts_right)},
          {"not_run", done ? ordered_json(nullptr) : not_run(now.run)}};
}

/// Why simulate uses the first method.
std::string_view reason(const SimulationRequest& request) {
  const auto& [p, f, delta, hold] = request.oscillator;
  if (!is_forced(request) && !request.surface.plain()) {
    return "between edges and turns the motion is a closed form, and so are its times";
  }
  if (!is_forced(request)) {
    return f > 0 && delta > 0
               ? "the half-cycle map is exact from peak to peak, one square root each, and has no "
                 "step or tolerance to choose"
               : "with only one friction the end is a closed form, an exact remainder, for any "
                 "number of half-cycles";
  }
  return std::holds_alternative<Record>(request.excitation)
             ? "between samples the motion is a closed form with constant coefficients, and each "
               "interval is proved to contain no event or searched for one"
             : "between events the motion is a closed form, and the first event is found by a "
               "bound that cannot step over it";
}

/// Null with dimensionless input.
ordered_json physical_json(const AccuracyReport& report) {
  if (!report.physical) {
    return nullptr;
  }
  const design::Scales& scales = report.physical->scales;
  const peers::Result& truth = report.comparison.exact.rounded;
  const bool stops = truth.outcome != Outcome::running;
  return {{"length_unit_m", scales.length_m},
          {"time_unit_s", scales.time_s},
          {"peak_m", truth.peak * scales.length_m},
          {"end_time_s", truth.end_time * scales.time_s},
          {"final_position_m", truth.x * scales.length_m},
          {"final_velocity_m_per_s", stops ? 0 : truth.v * scales.velocity_m_per_s}};
}

}  // namespace

ordered_json json(const AccuracyReport& report) {
  const peers::Result& truth = report.comparison.exact.rounded;
  const bool stops = truth.outcome != Outcome::running;
  ordered_json methods = ordered_json::array();
  for (const peers::MethodRow& now : report.comparison.rows) {
    methods.push_back(method_json(now, methods.empty()));
  }
  return {{"schema", "stillpoint/accuracy-report/1"},
          {"program", program_json()},
          {"input", motion_input_json(report.request, report.record)},
          {"reference",
           {{"digits", 50},
            {"outcome", name(truth.outcome)},
            {"peak_amplitude", truth.peak},
            {"end_time", truth.end_time},
            {"final_position", truth.x},
            {"final_velocity", stops ? 0 : truth.v},
            {"zero_passages", truth.passages},
            {"turning_points", truth.turns},
            {"sticks", truth.sticks}}},
          {"methods", methods},
          {"why", reason(report.request)},
          {"physical", physical_json(report)}};
}

namespace {

/// All digits, and with physical input the usual units as well.
std::string exact_text(const Physical& physical, double value, const std::string& words) {
  return format("{:.17g}{}", value, physical ? " = " + words : "");
}

void add_truth(Document& document, const AccuracyReport& report, bool stops) {
  const peers::Result& truth = report.comparison.exact.rounded;
  const FigureUnits units(report.physical);
  Section& section = document.section("In 50 digits");
  section.row("peak", exact_text(report.physical, truth.peak, units.length_words(truth.peak)));
  section.row(stops ? "rests at tau" : "ends at tau",
              exact_text(report.physical, truth.end_time, units.time_words(truth.end_time)));
  section.row("x there", exact_text(report.physical, truth.x, units.length_words(truth.x)));
  if (!stops) {
    section.row("v there", exact_text(report.physical, truth.v, units.velocity_words(truth.v)));
  }
  section.row("counts", counts(truth) + " (passages, turning points, sticks)");
}

TableRow method_row(const peers::MethodRow& now) {
  if (now.run != peers::Run::done) {
    return {{std::string(now.name), setting(now), "", "", "", "",
             now.run == peers::Run::nothing_moves ? "not run: nothing moves" : "not run: too long"},
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
  const auto& [p, f, delta, hold] = report.request.oscillator;
  const Start& start = report.request.start;
  const peers::Result& truth = report.comparison.exact.rounded;
  const bool stops = truth.outcome != Outcome::running;
  Document document;
  document.title = "Accuracy";
  document.verdict = verdict(report.comparison.rows.front(), stops);
  Section& scene = document.section("Scene");
  scene.row("dimensionless",
            format("v0 = {:.6g}, p = {:.6g}, x0 = {:.6g}, f = {:.6g}, delta = {:.6g}", start.v0, p,
                   start.x0, f, delta));
  add_surface(scene, report.request, report.physical);
  if (is_forced(report.request)) {
    add_excitation(scene, report.request.excitation, report.record, report.physical);
  }
  if (report.physical) {
    add_physical_input(scene, *report.physical);
  }
  add_truth(document, report, stops);
  Table table{{"", "setting", "time", "error of peak", stops ? "of rest" : "of end", "counts", ""},
              {}};
  for (const peers::MethodRow& now : report.comparison.rows) {
    table.rows.push_back(method_row(now));
  }
  Section& methods = document.section("Methods");
  methods.parts.emplace_back(std::move(table));
  methods.line(
      stops ? "Errors of the peak and of the place of rest are relative to the peak, of the "
              "stop time to itself."
            : "Errors of the peak and of x are relative to the peak, of v to p times the peak.");
  methods.line(format("simulate uses stillpoint: {}.", reason(report.request)));
  return document;
}

}  // namespace stillpoint::report
