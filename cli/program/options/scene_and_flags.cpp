// SPDX-License-Identifier: MIT
#include "input/excitation.hpp"
#include "options/excitation_kinds.hpp"
#include "options/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
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

/// A design is for a hit or under records. A flag for one sets the other of the scene aside; of a
/// scene that has both, for several commands, a design takes the hit.
void keep_one_design(const Settings& flags, Settings& settings) {
  constexpr std::array<std::string_view, 7> hit{
      "v0", "velocity", "pulse", "k", "lambda", "pulse-duration", "excitation-frequency"};
  constexpr std::array<std::string_view, 14> records{
      "record",      "records-list",    "record-units",           "record-step", "record-scale",
      "record-peak", "record-spectrum", "record-spectrum-period", "combine",     "search-f",
      "hold",        "search-delta-m",  "search-period",          "threads"};
  const auto any = [](const Settings& given, std::span<const std::string_view> names) {
    return std::ranges::any_of(names, [&](std::string_view name) { return given.has(name); });
  };
  const bool records_asked = any(flags, std::span(records).first(2));
  const bool for_a_hit = any(flags, std::span(hit).first(3)) ||
                         (any(settings, std::span(hit).first(3)) && !records_asked);
  if (!for_a_hit && !any(settings, std::span(records).first(2))) {
    return;
  }
  for (const std::string_view name : for_a_hit ? std::span<const std::string_view>(records)
                                               : std::span<const std::string_view>(hit)) {
    if (!flags.has(name)) {
      settings.drop(name);
    }
  }
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
  if (command == Command::design) {
    keep_one_design(flags, settings);
  }
  return settings;
}

}  // namespace stillpoint::cli
