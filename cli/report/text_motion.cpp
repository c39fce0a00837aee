// SPDX-License-Identifier: MIT
#include "text_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace stillpoint::cli {

using fmt::format;

namespace {

std::string outcome_sentence(const Response& response) {
  switch (response.outcome) {
    case Outcome::stopped_at_zero:
      return "stops at x = 0";
    case Outcome::stopped_in_dead_zone:
      return "stops off x = 0, in the dead zone";
    case Outcome::never_stops:
      return "never stops: there is no friction";
    case Outcome::caught_at_start:
      return "never starts: v0^2 < 2 delta, the notch holds it";
    case Outcome::running:
      return "goes on at the end of the run";
  }
  return {};
}

std::string arrival(const HalfCycle& half_cycle, Outcome outcome) {
  if (half_cycle.arrival_speed) {
    return figure(*half_cycle.arrival_speed);
  }
  const bool stops = outcome == Outcome::stopped_in_dead_zone;
  return format("{} at {}", stops ? "rests" : "is", figure(half_cycle.end_position));
}

}  // namespace

void add_response(Page& page, const Response& response,
                  const std::optional<design::PhysicalInput>& physical, std::string_view margin) {
  page.row("outcome", outcome_sentence(response));
  page.row("peak", format("{:.6g}{}", response.peak_amplitude,
                          in_metres(physical, response.peak_amplitude)));
  page.row("peak acceleration",
           physical ? format("{:.6g} g = {:.5g} m/s2", response.peak_acceleration,
                             response.peak_acceleration * physical->scales.gravity_m_per_s2)
                    : figure(response.peak_acceleration));
  if (response.stop_time) {
    page.row("stop time",
             format("{:.6g}{}", *response.stop_time, in_seconds(physical, *response.stop_time)));
    page.row("stop position", format("{:.6g}{}", *response.stop_position,
                                     in_metres(physical, *response.stop_position)));
  }
  if (response.arrival_speed) {
    page.row("arrival speed", format("{:.6g}, the last at x = 0", *response.arrival_speed));
  }
  if (response.half_cycles) {
    page.row("counts", format("{}, {}, {}", plural(response.half_cycles, "half-cycle"),
                              plural(response.zero_passages, "passage"),
                              plural(response.turning_points, "turning point")));
  }
  if (response.decision_margin) {
    page.row("decision margin", format("{:.2g} %: {}", 100 * *response.decision_margin, margin));
  }
}

void add_excitation(Page& page, const SimulateInput& input) {
  const Excitation& excitation = input.request.excitation;
  const auto& physical = input.physical;
  std::string what(name(excitation));
  std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.lambda; }) {
          what += format(", k = {:.6g}, lambda = {:.6g}{}", kind.k, kind.lambda,
                         in_rad_per_s(physical, kind.lambda));
        } else if constexpr (requires { kind.values; }) {
          const auto [least, most] = std::ranges::minmax(kind.values);
          what += format(", {} values from {:.6g} g to {:.6g} g", kind.values.size(), least + 0.0,
                         most + 0.0);  // no -0
        }
      },
      excitation);
  if (const auto* harmonic = std::get_if<Harmonic>(&excitation); harmonic != nullptr) {
    what += format(", phase {:.6g}", harmonic->phase);
  }
  page.row("excitation", what);
  if (input.record) {
    page.row("record", spelled_out(input.record->file));
    if (!input.record->description.empty()) {
      page.row("", spelled_out(input.record->description));
    }
  }
  if (const auto lasts = duration(excitation)) {
    page.row("lasts", format("{:.6g}{}", *lasts, in_seconds(physical, *lasts)));
  }
}

void add_forced_response(Page& page, const ForcedResponse& response,
                         const std::optional<design::PhysicalInput>& physical) {
  if (response.sticks > 0) {
    page.row("sticks", format("{} of {:.6g}{} in all", plural(response.sticks, "stick"),
                              response.stick_time, in_seconds(physical, response.stick_time)));
  }
  if (response.end_time && response.outcome == Outcome::running) {
    page.row("at the end",
             format("tau = {:.6g}{}, x = {:.6g}{}, v = {:.6g}", *response.end_time,
                    in_seconds(physical, *response.end_time), *response.final_position,
                    in_metres(physical, *response.final_position), *response.final_velocity));
  }
  if (response.left_notch_from_rest) {
    page.row("note", "set off from rest at x = 0: the notch acts from the first return on");
  }
}

void add_half_cycles(Page& page, const Simulation& answer) {
  constexpr std::size_t most_listed = 12;
  if (answer.half_cycles.empty()) {
    return;
  }
  page.section("Half-cycles");
  std::vector<std::vector<std::string>> rows{
      {"", "starts", "leaves at", "peak at", "peak", "ends", "arrives at"}};
  const std::size_t listed = std::min(most_listed, answer.half_cycles.size());
  for (std::size_t i = 0; i < listed; ++i) {
    const HalfCycle& now = answer.half_cycles[i];
    rows.push_back({format("{}", now.index), figure(now.start_time), figure(now.departure_speed),
                    figure(now.peak_time), figure(now.side * now.peak), figure(now.end_time),
                    arrival(now, answer.response.outcome)});
  }
  page.table(rows, std::vector<Tone>(rows.size(), Tone::plain));
  if (const double all = answer.response.half_cycles.value_or(HUGE_VAL);
      all > static_cast<double>(listed)) {
    page.line("... the JSON report lists more, see --max-half-cycles", Tone::faint);
  }
}

}  // namespace stillpoint::cli
