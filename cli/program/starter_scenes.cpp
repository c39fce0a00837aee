// SPDX-License-Identifier: MIT
#include "starter_scenes.hpp"

#include "options.hpp"

#include <stillpoint/core/input_error.hpp>

#include <array>

namespace stillpoint::cli {

namespace {

struct Starter {
  std::string_view name;
  std::string_view text;
};

constexpr std::array starters{
    Starter{"building", R"(// A building on isolators. Change the values, then run
//   stillpoint design scene.json
{
  "title": "office building, six storeys",

  // The isolators alone, without friction. Instead of the period: "natural_frequency": "0.36Hz",
  // or "stiffness": "6.04MN/m", which needs the mass.
  "period": "2.8s",

  // The mass above the isolators. It adds forces and energies to the report.
  "mass": "1200t",

  // The hit: how fast the building moves against the ground after the main pulse, at most about the
  // peak ground velocity.
  "velocity": "400mm/s",

  // The gap around the building. It must never move further than this.
  "max_displacement": "150mm",

  // How far friction and notch may be off when they are built: 0.1 is 10 %.
  "tolerance": 0.1

  // Other limits, if you have them:
  // "f_max": 0.05,            the largest friction coefficient that can be made
  // "delta_max_m": "10mm",    the largest point friction
}
)"},
    Starter{
        "machine",
        R"(// A machine on springs that takes a shock, for example a forging hammer. Change the values, then run
//   stillpoint design scene.json
{
  "title": "forging hammer on a spring-mounted block",

  // The springs and what stands on them. Instead of stiffness: "natural_frequency": "4.5Hz", or
  // "period".
  "stiffness": "64MN/m",
  "mass": "80t",

  // The hit: the velocity of the block after the blow, that is, the momentum of the tup (here 2.5 t
  // at 6 m/s, with a rebound) divided by the mass of the block.
  "velocity": "0.25m/s",

  // How far the block may move.
  "max_displacement": "8mm",

  // What can be made: friction up to this coefficient ...
  "f_max": 0.25,

  // ... and how far it may be off: 0.1 is 10 %.
  "tolerance": 0.1
}
)"},
    Starter{
        "equipment",
        R"(// Equipment on a pad that takes a shock pulse from below. Change the values, then run
//   stillpoint design scene.json
{
  "title": "control cabinet on a sliding pad",

  // The pad and its springs. Instead of the frequency: "period": "400ms", or "stiffness".
  "natural_frequency": "2.5Hz",
  "mass": "350kg",

  // The shock: a half-sine pulse of this peak and duration. A full sine or a rectangle is possible
  // as well, of any duration.
  "pulse": "half-sine",
  "k": "4g",
  "pulse_duration": "11ms",

  // How far the cabinet may slide.
  "max_displacement": "15mm",

  // The largest notch: the energy that it takes over the weight of the cabinet.
  "delta_max_m": "5mm",

  // How far friction and notch may be off when they are built: 0.05 is 5 %.
  "tolerance": 0.05
}
)"},
};

}  // namespace

std::vector<std::string_view> starter_names() {
  std::vector<std::string_view> names;
  names.reserve(starters.size());
  for (const Starter& starter : starters) {
    names.push_back(starter.name);
  }
  return names;
}

std::string starter_scene(const std::optional<std::string>& kind) {
  const std::string wanted = kind.value_or(std::string(starters.front().name));
  for (const Starter& starter : starters) {
    if (starter.name == wanted) {
      return std::string(starter.text);
    }
  }
  const std::vector<std::string_view> names = starter_names();
  throw InputError("init", wanted, "must be " + listed(names) + suggestion(wanted, names));
}

}  // namespace stillpoint::cli
