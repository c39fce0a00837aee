// SPDX-License-Identifier: MIT
#include <stillpoint/core/forced_event.hpp>
#include <stillpoint/core/names.hpp>

namespace stillpoint {

namespace {

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

std::string_view name(ForcedEventKind kind) noexcept {
  return kinds.name(kind);
}

std::optional<ForcedEventKind> parse_forced_event_kind(std::string_view name) noexcept {
  return kinds.parse(name);
}

}  // namespace stillpoint
