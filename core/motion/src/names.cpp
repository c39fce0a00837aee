// SPDX-License-Identifier: MIT
#include <stillpoint/core/names.hpp>
#include <stillpoint/core/outcome.hpp>
#include <stillpoint/core/state.hpp>

namespace stillpoint {

namespace {

constexpr Names outcomes(std::to_array<Named<Outcome>>({
    {Outcome::stopped_at_zero, "stopped_at_zero"},
    {Outcome::stopped_in_dead_zone, "stopped_in_dead_zone"},
    {Outcome::stopped_in_notch, "stopped_in_notch"},
    {Outcome::never_stops, "never_stops"},
    {Outcome::caught_at_start, "caught_at_start"},
    {Outcome::running, "running"},
}));

constexpr Names kinds(std::to_array<Named<EventKind>>({
    {EventKind::start, "start"},
    {EventKind::arrival, "arrival"},
    {EventKind::passage, "passage"},
    {EventKind::turn, "turn"},
    {EventKind::excitation_end, "excitation_end"},
    {EventKind::stick, "stick"},
    {EventKind::release, "release"},
    {EventKind::rest, "rest"},
    {EventKind::end, "end"},
}));

}  // namespace

std::string_view name(Outcome outcome) noexcept {
  return outcomes.name(outcome);
}

std::optional<Outcome> parse_outcome(std::string_view name) noexcept {
  return outcomes.parse(name);
}

std::string_view name(EventKind kind) noexcept {
  return kinds.name(kind);
}

std::optional<EventKind> parse_event_kind(std::string_view name) noexcept {
  return kinds.parse(name);
}

}  // namespace stillpoint
