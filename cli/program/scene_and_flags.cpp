// SPDX-License-Identifier: MIT
#include "scene_and_flags.hpp"

#include "pulse_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>

namespace stillpoint::cli {

namespace {

using Names = std::span<const std::string_view>;

/// Of each row at most one can be given.
constexpr std::array<std::array<std::string_view, 3>, 6> rivals{{{"v0", "velocity", "pulse"},
                                                                 {"p", "period", "stiffness"},
                                                                 {"beta", "max-displacement"},
                                                                 {"x0", "x0-m"},
                                                                 {"delta", "delta-m"},
                                                                 {"delta-max", "delta-max-m"}}};
constexpr std::array<std::string_view, 5> wave{"excitation", "k", "lambda", "phase", "duration"};
constexpr std::array<std::string_view, 4> of_a_record{"record", "record-units", "record-step",
                                                      "record-scale"};

bool has_any(const Settings& settings, Names names) {
  return std::ranges::any_of(names, [&](std::string_view name) { return settings.has(name); });
}

void drop(Settings& scene, Names names) {
  std::ranges::for_each(names, [&](std::string_view name) { scene.drop(name); });
}

void displace_rivals(const Settings& flags, Settings& scene) {
  for (const Names row : rivals) {
    if (has_any(flags, row)) {
      drop(scene, row);
    }
  }
}

/// A scene's wave is no more where a flag asks for a record, and the other way round; nor is its
/// pulse in either case, but its k and lambda serve a wave.
void displace_excitation(const Settings& flags, Settings& scene) {
  const std::string type = flags.text("excitation").value_or(flags.has("record") ? "record" : "");
  if (type.empty()) {
    return;
  }
  if (type == "record") {
    drop(scene, wave);
  } else {
    drop(scene, of_a_record);
  }
  scene.drop("pulse");
}

/// For a motion the scene's pulse is an excitation like any other.
void follow_pulse(Settings& scene) {
  if (!scene.has("pulse") || scene.has("excitation") || scene.has("record")) {
    return;
  }
  for (const std::string_view start : {"v0", "velocity"}) {
    if (scene.has(start)) {
      throw UsageError(fmt::format("{} and pulse exclude each other: give one of them", start));
    }
  }
  scene.set(*find_option("excitation"), pulse_type(scene).value());
  scene.drop("pulse");
}

}  // namespace

Settings scene_and_flags(Command command, const Settings& flags, Settings& scene) {
  const bool had_pulse = scene.has("pulse");
  displace_rivals(flags, scene);
  displace_excitation(flags, scene);
  if (command == Command::simulate || command == Command::accuracy) {
    follow_pulse(scene);
  }
  const bool pulse_serves = scene.has("pulse") && find_option("pulse")->serves(command);
  if (had_pulse && !pulse_serves && !scene.has("excitation") && !flags.has("excitation")) {
    scene.drop("k");
    scene.drop("lambda");
  }
  Settings settings = flags;
  settings.complete_with(scene);
  return settings;
}

}  // namespace stillpoint::cli
