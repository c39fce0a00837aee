// SPDX-License-Identifier: MIT
#include <stillpoint/core/names.hpp>
#include <stillpoint/core/outcome.hpp>

namespace stillpoint {

namespace {

constexpr Names outcomes(std::to_array<Named<Outcome>>({
    {Outcome::stopped_at_zero, "stopped_at_zero"},
    {Outcome::stopped_in_dead_zone, "stopped_in_dead_zone"},
    {Outcome::never_stops, "never_stops"},
    {Outcome::caught_at_start, "caught_at_start"},
    {Outcome::running, "running"},
}));

}  // namespace

std::string_view name(Outcome outcome) noexcept {
  return outcomes.name(outcome);
}

std::optional<Outcome> parse_outcome(std::string_view name) noexcept {
  return outcomes.parse(name);
}

}  // namespace stillpoint
