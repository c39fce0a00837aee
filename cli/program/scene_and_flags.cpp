// SPDX-License-Identifier: MIT
#include "excitation_input.hpp"
#include "excitation_kinds.hpp"
#include "scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace stillpoint::cli {

namespace {

bool has_rival_of(const Settings& settings, const Option& option) {
  return std::ranges::any_of(options(), [&](const Option& other) {
    return other.traits.rivals == option.traits.rivals && settings.has(other.name);
  });
}

void drop_rivals(const Settings& flags, Settings& scene) {
  for (const Option& option : options()) {
    if (option.traits.rivals != Rivals::none && has_rival_of(flags, option)) {
      scene.drop(option.name);
    }
  }
}

/// A flag that asks for a record removes the scene's wave, one that asks for a wave its record, and
/// both its pulse. A wave may still use the k and lambda of the scene.
void drop_excitation(const Settings& flags, Settings& scene) {
  const auto type = excitation_type(flags);
  if (!type) {
    return;
  }
  const bool asks_for_record = *type == "record";
  if (asks_for_record) {
    scene.drop("excitation");
  }
  for (const ExcitationKind& kind : excitation_kinds()) {
    if ((kind.wave == nullptr) != asks_for_record) {
      std::ranges::for_each(kind.takes, [&](std::string_view option) { scene.drop(option); });
    }
  }
  scene.drop("pulse");
}

/// A scene's pulse excites a motion like any other excitation.
void follow_pulse(Settings& scene) {
  if (!scene.has("pulse") || scene.has("excitation") || scene.has("record")) {
    return;
  }
  for (const std::string_view start : {"v0", "velocity"}) {
    if (scene.has(start)) {
      throw UsageError(fmt::format("{} and pulse exclude each other: give one of them", start));
    }
  }
  scene.set(*find_option("excitation"), *scene.known("pulse"));
  scene.drop("pulse");
}

}  // namespace

Settings scene_and_flags(Command command, const Settings& flags, Settings& scene) {
  const bool had_pulse = scene.has("pulse");
  drop_rivals(flags, scene);
  drop_excitation(flags, scene);
  if (command == Command::simulate || command == Command::accuracy) {
    follow_pulse(scene);
  }
  const bool pulse_serves = scene.has("pulse") && find_option("pulse")->serves(command);
  if (had_pulse && !pulse_serves && !scene.has("excitation") && !flags.has("excitation")) {
    for (const std::string_view option : pulse_options) {
      scene.drop(option);
    }
  }
  Settings settings = flags;
  settings.complete_with(scene);
  return settings;
}

}  // namespace stillpoint::cli
