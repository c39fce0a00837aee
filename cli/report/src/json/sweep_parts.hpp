// SPDX-License-Identifier: MIT
#pragma once

// What the JSON of sweeps with and without rows shares.

#include "json/motion_fields.hpp"

#include <stillpoint/sweep/spec.hpp>
#include <stillpoint/sweep/state.hpp>

namespace stillpoint::report {

/// How many entries have each outcome.
[[nodiscard]] nlohmann::ordered_json outcomes_schema();
[[nodiscard]] Printed<outcomes_schema> outcomes_of(const sweep::SweepState::Counts& counts);

/// What `get` gives of the state of a sweep of motions, or of designs; empty of the other.
constexpr auto only_of(bool designs, auto kind, auto state, auto get) {
  const auto holds = [=](const auto& report) {
    return (std::invoke(kind, report) == sweep::SweepKind::design) == designs;
  };
  return only_if(holds, in(state, get));
}

/// How the entries of a sweep end, from its kind and its state.
constexpr auto ended_fields(auto kind, auto state) {
  using sweep::SweepState;
  return std::tuple{
      Field{"outcomes", only_of(false, kind, state, in(&SweepState::outcomes, &outcomes_of)),
            "how many rows have each outcome; null for designs"},
      Field{"locked", only_of(false, kind, state, &SweepState::locked),
            "motions that the notch holds while the load goes on; null for designs"},
      Field{"feasible", only_of(true, kind, state, &SweepState::feasible),
            "how many designs there are; null for motions"}};
}

}  // namespace stillpoint::report

namespace stillpoint {

template <>
inline constexpr auto fields<sweep::SweepPart> =
    std::tuple{Field{"number", &sweep::SweepPart::number, "which part", {Numbers::from_one}},
               Field{"count", &sweep::SweepPart::count, "of how many", {Numbers::from_one}}};

}  // namespace stillpoint
