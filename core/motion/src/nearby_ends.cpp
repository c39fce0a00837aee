// SPDX-License-Identifier: MIT
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/nearby_ends.hpp>

#include <algorithm>

namespace stillpoint {

namespace {

struct End {
  std::optional<double> rest;
  bool locked{false};
};

/// A run that is cut may end at rest too.
End end_of(const ForcedResponse& response) {
  const bool rests = response.stop_position || response.final_velocity == 0;
  return {rests ? response.final_position : std::nullopt, response.locks()};
}

}  // namespace

std::optional<NearbyEnds> nearby_ends(const SimulationRequest& request, const Simulation& motion) {
  constexpr double off = 0.01;
  constexpr int most_asked = 1000;
  constexpr double most_half_cycles = 1e6;
  int asked = 0;
  const ForcedOptions options{.t_end = is_forced(request) ? request.t_end : std::nullopt,
                              .half_cycle_limit = most_half_cycles,
                              .go_on = [&asked](double) { return ++asked < most_asked; }};
  const End as_given =
      motion.forced ? end_of(*motion.forced) : End{motion.response.stop_position, false};
  NearbyEnds ends;
  if (as_given.rest) {
    ends.rests = {*as_given.rest, *as_given.rest};
  }
  for (const double of_f : {1 - off, 1 + off}) {
    for (const double of_delta : {1 - off, 1 + off}) {
      Oscillator damper = request.oscillator;
      damper.f *= of_f;
      damper.delta *= of_delta;
      Surface surface = request.surface;
      for (FrictionZone& zone : surface.zones) {
        zone.f *= of_f;
      }
      End end;
      try {
        end = end_of(forced_response(damper, request.start, request.excitation, options, surface));
      } catch (const TooManyHalfCycles&) {
        return std::nullopt;
      }
      ends.rest_differs |= end.rest.has_value() != as_given.rest.has_value();
      ends.lock_differs |= end.locked != as_given.locked;
      if (ends.rests && end.rest) {
        ends.rests = {std::min(ends.rests->low, *end.rest), std::max(ends.rests->high, *end.rest)};
      }
    }
  }
  return asked < most_asked ? std::optional(ends) : std::nullopt;
}

}  // namespace stillpoint
