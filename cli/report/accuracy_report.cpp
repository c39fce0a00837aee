// SPDX-License-Identifier: MIT
#include "accuracy_report.hpp"

#include "json_report.hpp"
#include "text_sections.hpp"
#include "version.hpp"

#include <fmt/format.h>

namespace stillpoint::cli {

using fmt::format;
using nlohmann::ordered_json;

namespace {

std::string counts(const peers::Result& result) {
  return format("{}, {}, {}", result.passages, result.turns, result.sticks);
}

std::string microseconds(double seconds) {
  return format("{:.3g} us", 1e6 * seconds);
}

std::string exponent(double error) {
  return error == 0 ? "0" : format("{:.1e}", error);
}

/// As --json has it.
std::string_view not_run(peers::Run run) {
  return run == peers::Run::nothing_moves ? "nothing_moves" : "too_long";
}

/// "tolerance 1e-09"; "" where it has none.
std::string setting(const peers::MethodRow& now) {
  return now.knob.empty() ? "" : format("{} {:.3g}", now.knob, now.setting);
}

ordered_json method_json(const peers::MethodRow& now, bool used) {
  ordered_json json{
      {"name", now.name},         {"setting", setting(now)},   {"used_by_simulate", used},
      {"wall_time_s", nullptr},   {"peak_error", nullptr},     {"end_error", nullptr},
      {"zero_passages", nullptr}, {"turning_points", nullptr}, {"sticks", nullptr},
      {"counts_right", nullptr},  {"not_run", nullptr}};
  if (now.run != peers::Run::done) {
    json["not_run"] = not_run(now.run);
  } else {
    json["wall_time_s"] = now.time.median;
    json["peak_error"] = now.peak_error;
    json["end_error"] = now.end_error;
    json["zero_passages"] = now.result.passages;
    json["turning_points"] = now.result.turns;
    json["sticks"] = now.result.sticks;
    json["counts_right"] = now.counts_right;
  }
  return json;
}

}  // namespace

ordered_json accuracy_json(const SimulateInput& input, const AccuracyAnswer& answer) {
  const peers::Result& truth = answer.comparison.exact.rounded;
  const bool stops = truth.outcome != Outcome::running;
  ordered_json methods = ordered_json::array();
  for (const peers::MethodRow& now : answer.comparison.rows) {
    methods.push_back(method_json(now, methods.empty()));
  }
  return {{"schema", "stillpoint/accuracy-report/1"},
          {"program", program_json()},
          {"input", simulate_input_json(input)},
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
          {"why", answer.why}};
}

std::string accuracy_text(const SimulateInput& input, const AccuracyAnswer& answer,
                          const std::optional<std::string>& title, Style style) {
  const peers::Result& truth = answer.comparison.exact.rounded;
  const bool stops = truth.outcome != Outcome::running;
  Page page(style);
  add_title(page, "Accuracy", title);
  page.section("Scene");
  page.row("dimensionless",
           format("v0 = {:.6g}   p = {:.6g}   x0 = {:.6g}   f = {:.6g}   delta = {:.6g}",
                  input.request.start.v0, input.request.oscillator.p, input.request.start.x0,
                  input.request.oscillator.f, input.request.oscillator.delta));
  if (is_forced(input.request)) {
    add_excitation(page, input);
  }
  page.section("In 50 digits");
  page.row("peak", format("{:.17g}", truth.peak));
  page.row(stops ? "rests at tau" : "ends at tau", format("{:.17g}", truth.end_time));
  page.row("x there", format("{:.17g}", truth.x));
  if (!stops) {
    page.row("v there", format("{:.17g}", truth.v));
  }
  page.row("counts", counts(truth) + " (passages, turning points, sticks)");
  page.section("Methods");
  std::vector<std::vector<std::string>> rows{
      {"", "setting", "time", "error of peak", stops ? "of rest" : "of end", "counts", ""}};
  std::vector<Tone> tones{Tone::plain};
  for (const peers::MethodRow& now : answer.comparison.rows) {
    if (now.run != peers::Run::done) {
      rows.push_back(
          {std::string(now.name), setting(now), "", "", "", "",
           now.run == peers::Run::nothing_moves ? "not run: nothing moves" : "not run: too long"});
      tones.push_back(Tone::faint);
      continue;
    }
    rows.push_back({std::string(now.name), setting(now), microseconds(now.time.median),
                    exponent(now.peak_error), exponent(now.end_error), counts(now.result),
                    now.counts_right ? "right" : "wrong"});
    tones.push_back(now.counts_right ? Tone::good : Tone::bad);
  }
  page.table(rows, tones);
  page.line(
      stops ? "Errors of the peak and of the place of rest are relative to the peak, of the "
              "stop time to itself."
            : "Errors of the peak and of x are relative to the peak, of v to p times the peak.");
  page.line(format("simulate uses stillpoint: {}.", answer.why));
  return page.text();
}

}  // namespace stillpoint::cli
