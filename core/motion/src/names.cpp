// SPDX-License-Identifier: MIT
#include <stillpoint/core/forced_event.hpp>
#include <stillpoint/core/names.hpp>
#include <stillpoint/core/outcome.hpp>

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

constexpr Names kinds(std::to_array<Named<ForcedEventKind>>({
    {ForcedEventKind::start, "start"},
    {ForcedEventKind::arrival, "arrival"},
    {ForcedEventKind::passage, "passage"},
    {ForcedEventKind::turn, "turn"},
    {ForcedEventKind::excitation_end, "excitation_end"},
    {ForcedEventKind::stick, "stick"},
    {ForcedEventKind::release, "release"},
    {ForcedEventKind::rest, "rest"},
    {ForcedEventKind::end, "end"},
}));

}  // namespace

std::string_view name(Outcome outcome) noexcept {
  return outcomes.name(outcome);
}

std::optional<Outcome> parse_outcome(std::string_view name) noexcept {
  return outcomes.parse(name);
}

std::string_view name(ForcedEventKind kind) noexcept {
  return kinds.name(kind);
}

std::optional<ForcedEventKind> parse_forced_event_kind(std::string_view name) noexcept {
  return kinds.parse(name);
}

}  // namespace stillpoint
