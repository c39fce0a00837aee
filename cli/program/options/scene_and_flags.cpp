// SPDX-License-Identifier: MIT
#include "input/excitation.hpp"
#include "options/scene.hpp"

namespace stillpoint::cli {

namespace {

void drop_rivals(const Settings& flags, Settings& scene) {
  for (const Option& option : options()) {
    if (option.traits.rivals != Rivals::none && flags.given(option.traits.rivals) != nullptr) {
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
  for (const Option& option : options()) {
    if (option.traits.load != Load::none &&
        (option.traits.load == Load::record) != asks_for_record) {
      scene.drop(option.name);
    }
  }
  scene.drop("pulse");
}

/// A design or a spectrum is for a hit or under records. A flag for one sets aside the other in the
/// scene; if a scene has both, for several commands, the hit counts, unless they are of several
/// cases.
void keep_one_load(const Settings& flags, Settings& settings) {
  const bool for_a_hit = flags.given(Rivals::hit) != nullptr ||
                         (settings.given(Rivals::hit) != nullptr && !asks_for_records(flags));
  if ((!for_a_hit && !asks_for_records(settings)) || settings.has("cases")) {
    return;
  }
  for (const Option& option : options()) {
    const bool of_the_hit = option.traits.rivals == Rivals::hit || option.shapes(Load::pulse);
    const bool of_records = option.design_for() == DesignFor::records ||
                            (option.design_for() == DesignFor::cases && asks_for_records(settings));
    if ((for_a_hit ? of_records : of_the_hit) && !flags.has(option.name)) {
      settings.drop(option.name);
    }
  }
}

/// A scene's pulse excites a motion like any other excitation.
void follow_pulse(Settings& scene) {
  if (!scene.has("pulse") || scene.has("excitation") || scene.has("record")) {
    return;
  }
  scene.set("excitation", *scene.known("pulse"));
  scene.drop("pulse");
  if (const Option* const start = scene.given(Rivals::hit)) {
    throw UsageError(fmt::format("{} and pulse cannot be combined: give one of them", start->name));
  }
}

/// A scene's notch that will be built is for its design: the region of a hit is of the paper's.
void drop_built_notch(const Settings& flags, Settings& settings) {
  const Option* const notch = settings.given(Rivals::notch);
  if (notch != nullptr && !flags.has(notch->name) && !settings.has("cases") &&
      !asks_for_records(settings)) {
    settings.drop(notch->name);
  }
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
    for (const Option& option : options()) {
      if (option.shapes(Load::pulse)) {
        scene.drop(option.name);
      }
    }
  }
  Settings settings = flags;
  settings.complete_with(scene);
  if (command == Command::design || command == Command::region || command == Command::spectrum) {
    keep_one_load(flags, settings);
  }
  if (command == Command::region) {
    drop_built_notch(flags, settings);
  }
  return settings;
}

}  // namespace stillpoint::cli
