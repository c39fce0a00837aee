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
#include "starters.inc"
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
