// SPDX-License-Identifier: MIT
#include "arguments.hpp"

#include "scene.hpp"
#include "values.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace stillpoint::python {

namespace py = pybind11;
using cli::Command;
using cli::Option;
using cli::Settings;

namespace {

const Option& option_of(Command command, const std::string& keyword) {
  std::string wanted = keyword;
  std::ranges::replace(wanted, '_', '-');
  const Option* const option = cli::find_option(wanted);
  if (option == nullptr) {
    throw cli::UsageError(
        fmt::format("{}: unknown option{}", keyword, cli::suggestion(wanted, command)));
  }
  if (!takes(command, *option)) {
    throw cli::UsageError(fmt::format("{}: is not an option of {}", keyword, name(command)));
  }
  return *option;
}

Settings from_scene(Command command, const py::object& scene) {
  Settings all;
  if (py::isinstance<py::dict>(scene)) {
    all = cli::scene_settings(to_json("scene", scene), command);
  } else {
    all = cli::read_scene(to_json("scene", scene).get<std::string>(), command);
  }
  for (const Option& option : cli::options()) {
    if (option.traits.role == cli::Role::output && !takes(command, option)) {
      all.drop(option.name);
    }
  }
  return all;
}

}  // namespace

bool takes(Command command, const Option& option) {
  const bool of_rows = command == Command::sweep && (option.name == "output" ||
                                                     option.name == "columns");
  return option.serves(command) &&
         (option.traits.role != cli::Role::output || option.name == "samples" || of_rows);
}

Settings settings(Command command, const py::object& scene, const py::dict& options) {
  nlohmann::json given = nlohmann::json::object();
  for (const auto& [key, value] : options) {
    const auto keyword = key.cast<std::string>();
    const Option& option = option_of(command, keyword);
    if (!value.is_none()) {
      given[keyword] = to_json(std::string(option.name), value);
    }
  }
  const Settings flags = cli::scene_settings(given, command);
  if (scene.is_none()) {
    return flags;
  }
  Settings of_scene = from_scene(command, scene);
  return cli::scene_and_flags(command, flags, of_scene);
}

}  // namespace stillpoint::python
