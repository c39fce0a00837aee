// SPDX-License-Identifier: MIT
#include "format.hpp"
#include "sections.hpp"
#include "sentence.hpp"

#include <stillpoint/core/nearby_ends.hpp>
#include <stillpoint/records/record_scaling.hpp>
#include <stillpoint/report/digits.hpp>
#include <stillpoint/report/report.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace stillpoint::report {

namespace {

/// How long the load acts.
double load_end(const SimulationRequest& request) {
  return std::min(duration(request.excitation).value_or(HUGE_VAL),
                  request.t_end.value_or(HUGE_VAL));
}

/// How a motion that goes on under a harmonic load develops: " Its peaks settle at 144 mm.", by the
/// last of them; empty if they are not listed.
std::string peaks_words(const MotionReport& report) {
  const auto* const load = std::get_if<Harmonic>(&report.request.excitation);
  const std::vector<HalfCycle>& listed = report.answer.half_cycles;
  constexpr std::size_t compared = 8;
  constexpr std::size_t settled = 4;
  if (load == nullptr || load->duration || listed.size() <= compared ||
      report.answer.response.half_cycles != static_cast<double>(listed.size())) {
    return "";
  }
  const bool cut = listed.back().peak_time == listed.back().end_time;  // before its peak
  const auto last = listed.end() - (cut ? 1 : 0);
  std::vector<double> peaks;
  std::transform(last - compared, last, std::back_inserter(peaks),
                 [](const HalfCycle& now) { return now.peak; });
  const auto shown = [&](double length) { return length_shown(report.physical, length); };
  constexpr double same = 0.005;
  const auto [low, high] = std::ranges::minmax(std::span(peaks).last(settled));
  if (high - low <= same * high) {
    return format(" Its peaks settle at {}.", shown(peaks.back()));
  }
  const bool grow = std::ranges::is_sorted(peaks);
  if (grow || std::ranges::is_sorted(peaks, std::ranges::greater())) {
    return format(" Its peaks {}, the last to {}.", grow ? "grow" : "shrink", shown(peaks.back()));
  }
  const auto [least, most] = std::ranges::minmax(peaks);
  return format(" Its last {} peaks lie between {} and {}.", compared, shown(least), shown(most));
}

/// Of a run that ends before its load does; empty otherwise.
std::string cut_words(const MotionReport& report) {
  const std::optional<double> load = duration(report.request.excitation);
  const std::optional<double>& end = report.request.t_end;
  return load && end && *end < *load
             ? format(" The run ends after {} of the {} of the load.",
                      time_shown(report.physical, *end), time_shown(report.physical, *load))
             : "";
}

/// Where the largest transmitted acceleration is felt, if there is a notch. While the mass slides
/// it is at most that of the peak: docs/theory.md section 11.
std::string felt_where(const MotionReport& report) {
  const auto& [p, f, delta, hold] = report.request.oscillator;
  const Response& response = report.answer.response;
  const auto& forced = report.answer.forced;
  const bool wide = report.request.surface.notch_width.has_value();
  const bool acts = delta > 0 && response.peak_amplitude > 0;
  const std::string jumps =
      forced && response.jump > 0 ? jumps_shown(report.physical, response.jump) : "";
  const std::string on_top = jumps.empty() ? "" : "; " + jumps + " come on top";
  if (forced && forced->largest_load_while_locked == response.peak_absolute_acceleration) {
    return " while it is locked" + on_top;
  }
  if (!acts) {
    return "";
  }
  const auto& [notch_width, zones] = report.request.surface;
  const auto outside = zones.empty() ? felt_outside(response, p, f, notch_width) : std::nullopt;
  if (wide) {
    return outside && report.request.start.x0 == 0
               ? format(" inside the notch, {} outside it", acceleration_shown(*outside))
               : ", the notch included";
  }
  return hold && outside ? " while the notch holds it" + on_top
         : jumps.empty() ? ", outside the notch"
                         : between_jumps(report.physical, response.jump);
}

/// What a load makes the structure feel, where the notch makes the velocity jump. The words of a
/// lock have its acceleration already.
std::string jolt_words(const MotionReport& report) {
  const Response& response = report.answer.response;
  const auto& forced = report.answer.forced;
  if (!forced || response.jump == 0) {
    return "";
  }
  return forced->locked_from
             ? format(" At the notch its velocity jumps by up to {}.",
                      FigureUnits(report.physical).velocity_words(response.jump))
             : format(" It transmits up to {}{}.",
                      acceleration_shown(response.peak_absolute_acceleration), felt_where(report));
}

std::string verdict(const MotionReport& report) {
  const Response& response = report.answer.response;
  const Physical& physical = report.physical;
  if (const std::string held = lock_sentence(report); !held.empty()) {
    const bool locked = report.answer.forced && report.answer.forced->locked_from;
    return sentence(locked ? held : "it " + held) + jolt_words(report) + cut_words(report);
  }
  std::string text =
      response.stop_position.value_or(0) != 0
          ? format("It stops in the {} at x = {}",
                   response.outcome == Outcome::stopped_in_notch ? "notch" : "dead zone",
                   length_shown(physical, *response.stop_position))
          : format("It {}", report.answer.forced ? outcome_phrase(*report.answer.forced)
                                                 : outcome_phrase(response.outcome));
  if (response.stop_time && *response.stop_time > 0) {
    text += format(" after {}", time_shown(physical, *response.stop_time));
  }
  return text + "." + (response.outcome == Outcome::running ? peaks_words(report) : "") +
         jolt_words(report) + cut_words(report);
}

/// No |W| is larger.
double peak_load(const Excitation& excitation) {
  return std::visit(
      []<class Kind>(const Kind& kind) {
        if constexpr (requires { kind.k; }) {
          return std::abs(kind.k);
        } else if constexpr (requires { kind.values; }) {
          return records::peak_acceleration(kind);
        } else {
          return 0.0;
        }
      },
      excitation);
}

bool lie_far_apart(const Interval& rests, double peak) {
  constexpr double of_the_peak = 0.01;
  constexpr double of_the_rest = 0.1;
  const double farthest = std::max(std::abs(rests.low), std::abs(rests.high));
  return rests.high - rests.low > std::max(of_the_peak * peak, of_the_rest * farthest);
}

/// Empty if f and Delta slightly off change the end little.
std::string nearby_words(const MotionReport& report) {
  const auto ends = nearby_ends(report.request, report.answer);
  if (!ends) {
    return "";
  }
  const std::string_view changes = ends->rest_differs   ? "whether it comes to rest"
                                   : ends->lock_differs ? "whether it locks"
                                                        : "";
  const std::string damper = report.request.oscillator.delta > 0 ? "f and delta" : "f";
  if (ends->rests && lie_far_apart(*ends->rests, report.answer.response.peak_amplitude)) {
    constexpr int digits = 3;
    return format("with {} 1 % off either way it rests from x = {} to {}{}{}", damper,
                  length_shown(report.physical, ends->rests->low, digits),
                  length_shown(report.physical, ends->rests->high, digits),
                  changes.empty() ? "" : ", and that may change ", changes);
  }
  return changes.empty() ? "" : format("{} 1 % off may change {}", damper, changes);
}

void add_answer(Section& answer, const MotionReport& report) {
  const auto& [p, f, delta, hold] = report.request.oscillator;
  const Response& response = report.answer.response;
  const Physical& physical = report.physical;
  const auto& zones = report.request.surface.zones;
  answer.row("damper",
             format("f = {}{}, delta = {}", digits(f),
                    zones.empty() ? "" : " beyond " + length_shown(physical, zones.back().to),
                    length_shown(physical, delta)));
  if (report.record) {
    answer.row("record",
               record_words(report.record->file, report.record->factor, report.record->units_read,
                            report.record->assumed, peak_load(report.request.excitation)));
  }
  add_surface(answer, report.request, physical);
  if (moves(response)) {
    answer.row("peak", length_shown(physical, response.peak_amplitude), Tone::heading);
  }
  const auto caught = caught_impulse(report);
  if (report.answer.forced || moves(response)) {
    answer.row("acceleration",
               format("{} transmitted{}", acceleration_shown(response.peak_absolute_acceleration),
                      felt_where(report)));
  }
  if (report.answer.forced && report.answer.forced->left_notch_from_rest) {
    const double centre = friction_at_centre(report.request);
    const StartUnderLoad start{centre, delta, peak_load(report.request.excitation)};
    const std::string none =
        no_notch_words(start, response.peak_amplitude, "", "the load", physical);
    if (!none.empty()) {
      answer.row("start", none, Tone::bad);
    } else {
      add_start(answer, start, format("delta/(load - {})", zones.empty() ? "f" : digits(centre)),
                physical);
    }
  }
  if (caught) {
    answer.row("impulse", format("{}: the notch transmits the hit in full, like any hit below {}",
                                 impulse_shown(physical, *caught),
                                 FigureUnits(physical).velocity_words(std::sqrt(2 * delta))));
  }
  // No damper is built more accurately than the first. That of a load or a surface is no tolerance:
  // below the second, rounding may decide.
  const bool of_inputs = !report.answer.forced && report.request.surface.plain();
  const double worth_saying = of_inputs ? 0.01 : 1e-9;
  if (response.decision_margin && *response.decision_margin < worth_saying) {
    const double margin = *response.decision_margin;
    answer.row("note",
               format("{} could change {}",
                      response.outcome == Outcome::caught_at_start
                          ? "whether it starts"
                          : "the number of half-cycles or where it stops",
                      of_inputs && margin > std::numeric_limits<double>::epsilon()
                          ? format("if all inputs shift by {:.2g} %", 100 * margin)
                          : "by rounding"),
               Tone::bad);
  }
  if (const std::string words = of_inputs ? "" : nearby_words(report); !words.empty()) {
    answer.row("note", words, Tone::bad);
  }
  if (report.answer.forced && response.outcome == Outcome::running) {
    const ForcedResponse& forced = *report.answer.forced;
    answer.row("at the end", format("x = {} at {}", length_shown(physical, *forced.final_position),
                                    time_shown(physical, *forced.end_time)));
  }
}

}  // namespace

std::string locked_words(const ForcedResponse& locked, double load_end, const Physical& physical) {
  const double from = locked.locked_from.value();
  const double load = locked.largest_load_while_locked.value();
  const double at = locked.final_position.value();  // off x = 0 in a notch with a width
  const std::string where =
      at == 0 ? "at x = 0" : format("in the notch, at x = {},", length_shown(physical, at));
  if (from == 0) {
    return format("locked {} throughout the load; the structure feels up to {:.3g} g", where, load);
  }
  const std::string when = physical ? format("{:.4g} s of {:.4g} s", from * physical->scales.time_s,
                                             load_end * physical->scales.time_s)
                                    : format("tau = {:.4g} of {:.4g}", from, load_end);
  return format("locked {} from {}; the structure then feels up to {:.3g} g", where, when, load);
}

namespace {

/// Why the mass never moves though nothing locks it; empty if it moves.
std::string held_words(const MotionReport& report) {
  const Response& response = report.answer.response;
  if (response.outcome == Outcome::caught_at_start) {
    return outcome_phrase(response.outcome);
  }
  return moves(response)
             ? ""
             : format("never moves: {} holds it {}",
                      response.outcome == Outcome::stopped_in_notch ? "the notch" : "friction",
                      is_forced(report.request)
                          ? format("throughout the load; the structure feels up to "
                                   "{:.3g} g",
                                   response.peak_absolute_acceleration)
                          : "at x = " + length_shown(report.physical, *response.stop_position));
}

}  // namespace

std::string lock_sentence(const MotionReport& report) {
  const auto& forced = report.answer.forced;
  if (!forced || !forced->locked_from) {
    return held_words(report);
  }
  // A run that is cut counts the rest in which it is locked as a stick.
  const double last =
      forced->outcome == Outcome::running ? *forced->end_time - *forced->locked_from : 0;
  const double moved = *forced->locked_from - (forced->stick_time - last);
  constexpr double hardly = 0.1;
  return locked_words(*forced, load_end(report.request), report.physical) +
         (*forced->locked_from > 0 && moved < hardly * *forced->locked_from
              ? format("; before that it moves for {} in all", time_shown(report.physical, moved))
              : "");
}

std::optional<double> caught_impulse(const MotionReport& report) {
  const Oscillator& oscillator = report.request.oscillator;
  const Start& start = report.request.start;
  // A load can free the mass from a notch that lets go.
  const bool freed = report.answer.forced && oscillator.hold && start.x0 == 0 &&
                     !report.request.surface.notch_width &&
                     holds_at_start(oscillator.delta, start.v0);
  const bool caught = report.answer.response.outcome == Outcome::caught_at_start || freed;
  return caught && start.v0 != 0 ? std::optional(std::abs(start.v0)) : std::nullopt;
}

Advice advice(const MotionReport& report) {
  Advice advice;
  advice.alarming = !lock_sentence(report).empty();
  advice.remarks = verdict(report);
  return advice;
}

Document document(const MotionReport& report) {
  const auto& [p, f, delta, hold] = report.request.oscillator;
  const Start& start = report.request.start;
  Document document;
  document.title = is_forced(report.request) ? "Forced motion" : "Free motion";
  const Advice said = advice(report);
  document.verdict = said.remarks;
  document.tone = said.alarming ? Tone::bad : Tone::plain;
  add_answer(document.answer, report);
  Section& scene = document.detail("Scene");
  if (report.physical) {
    add_physical_input(scene, *report.physical);
  }
  scene.row("dimensionless", format("v0 = {:.6g}, p = {:.6g}, x0 = {:.6g}, delta = {:.6g}",
                                    start.v0, p, start.x0, delta));
  add_damper_physics(scene, report.physical, f, delta,
                     report.request.surface.zones.empty() ? "" : ", beyond the zones");
  if (is_forced(report.request)) {
    add_excitation(scene, report.request.excitation, report.record, report.physical);
  }
  add_response(document.detail("Motion"), report.answer, report.physical,
               report.request.surface.plain());
  if (const auto lines = practice_of(report)) {
    Section& practice = document.detail("In practice");
    add_practice(practice, {lines, ""}, report.physical);
    add_notch_used(practice, {lines, ""}, report.physical);
  }
  if (const auto& half_cycles = report.answer.half_cycles; !half_cycles.empty()) {
    add_half_cycles(document.section("Half-cycles"), half_cycles,
                    report.answer.response.half_cycles, "lists more, see --max-half-cycles",
                    report.physical);
  }
  return document;
}

}  // namespace stillpoint::report
