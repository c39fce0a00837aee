// SPDX-License-Identifier: MIT
#include "arguments.hpp"

#include "input/warnings.hpp"
#include "options/scene.hpp"
#include "values.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace stillpoint::python {

namespace py = pybind11;
using cli::Command;
using cli::Option;
using cli::Settings;

namespace {

/// An option in Python; lambda is a keyword of the language.
std::string keyword_of(const Option& option) {
  std::string keyword = records::underscored(option.name);
  return keyword == "lambda" ? "lambda_" : keyword;
}

const Option& option_of(Command command, const std::string& keyword) {
  const std::string wanted = records::hyphened(keyword == "lambda_" ? "lambda" : keyword);
  const Option* const option = cli::find_option(wanted);
  if (option == nullptr) {
    throw cli::UsageError(
        fmt::format("{}: unknown option{}", keyword, cli::suggestion(wanted, command)));
  }
  if (!option->serves_in_python(command)) {
    throw cli::UsageError(fmt::format("{}: is not an option of {}", keyword, name(command)));
  }
  return *option;
}

Settings from_scene(Command command, const py::object& scene) {
  const nlohmann::json given = to_json("scene", scene);
  if (!given.is_object() && !given.is_string()) {
    throw InputError("scene", py::repr(scene).cast<std::string>(), "must be a path or a dict");
  }
  Settings all = given.is_object() ? cli::scene_settings(given, command)
                                   : cli::read_scene(given.get<std::string>(), command);
  for (const Option& option : cli::options()) {
    if (option.traits.role == cli::Role::output && !option.serves_in_python(command)) {
      all.drop(option.name);
    }
  }
  return all;
}

std::string type_of(const Option& option, Command command) {
  switch (option.kind_in(command)) {
    case cli::OptionKind::axis:
      return "Axis";
    case cli::OptionKind::number:
      return option.takes_range_in(command)                        ? "Range"
             : option.traits.dimension != records::Dimension::none ? "Number"
                                                                   : "float";
    case cli::OptionKind::integer:
      return "int";
    case cli::OptionKind::flag:
      return "bool";
    case cli::OptionKind::text:
      break;
  }
  return option.traits.file != cli::FileUse::none
             ? option.repeats_in(command) ? "Path | Sequence[Path]" : "Path"
         : option.traits.in_scene == cli::InScene::group ? "str | Mapping[str, Any]"
         : option.traits.in_scene == cli::InScene::zones ? "str | Sequence[Mapping[str, Any]]"
         : option.repeats_in(command)                    ? "str | Sequence[str]"
                                                         : "str";
}

std::string help_of(const Option& option) {
  const auto& here = option.traits.python;
  return here && !here->help.empty() ? std::string(here->help) : option.help;
}

}  // namespace

std::string documentation(Command command, std::string_view about) {
  std::string signature = fmt::format("{}(scene=None, /, *", name(command));
  std::string list;
  for (const Option& option : cli::options()) {
    if (option.serves_in_python(command)) {
      const std::string keyword = keyword_of(option);
      signature += fmt::format(", {}=None", keyword);
      list += fmt::format("\n{:<21} {}", keyword, help_of(option));
    }
  }
  return fmt::format(
      "{})\n--\n\n{}\n\nscene is a path or a dict, as for the program; an option overrides its "
      "key. A value may be a string with its unit, \"150mm\".\nRaises InputError with the text of "
      "the "
      "program.\n\nOptions:{}",
      signature, about, list);
}

py::list options(const std::string& command) {
  py::list all;
  const std::optional<Command> known = parse<Command>(command);
  if (!known) {
    throw InputError("command", command, "must be design, region, simulate, spectrum or sweep");
  }
  for (const Option& option : cli::options()) {
    if (option.serves_in_python(*known)) {
      all.append(py::make_tuple(keyword_of(option), type_of(option, *known), help_of(option)));
    }
  }
  return all;
}

void warn_of_doubts(const Settings& settings, Command command) {
  for (const std::string& warning : cli::warnings(settings, command)) {
    if (PyErr_WarnEx(PyExc_UserWarning, warning.c_str(), 1) != 0) {
      throw py::error_already_set();
    }
  }
}

Settings settings(Command command, const py::object& scene, const py::dict& options) {
  nlohmann::json given = nlohmann::json::object();
  for (const auto& [key, value] : options) {
    const auto keyword = key.cast<std::string>();
    const Option& option = option_of(command, keyword);
    if (!value.is_none()) {
      given[std::string(option.name)] = to_json(std::string(option.name), value);
    }
  }
  Settings flags = cli::scene_settings(given, command);
  Settings of_scene = scene.is_none() ? Settings() : from_scene(command, scene);
  if (command == Command::design && !flags.has("part") && !of_scene.has("part")) {
    if (flags.has("output")) {
      throw cli::UsageError("output needs a part of a design: give part as well");
    }
    of_scene.drop("output");
  }
  return scene.is_none() ? flags : cli::scene_and_flags(command, flags, of_scene);
}

}  // namespace stillpoint::python
