// SPDX-License-Identifier: MIT
#include "arguments.hpp"

#include "options/scene.hpp"
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

/// An option in Python; lambda is a word of the language.
std::string keyword_of(const Option& option) {
  std::string keyword(option.name);
  std::ranges::replace(keyword, '-', '_');
  return keyword == "lambda" ? "lambda_" : keyword;
}

const Option& option_of(Command command, const std::string& keyword) {
  std::string wanted = keyword == "lambda_" ? "lambda" : keyword;
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
  const bool of_rows =
      command == Command::sweep && (option.name == "output" || option.name == "columns");
  const bool of_parts =
      command == Command::design && (option.name == "part" || option.name == "resume");
  return option.serves(command) && option.name != "title" && !of_parts &&
         (option.traits.role != cli::Role::output || option.name == "samples" || of_rows);
}

namespace {

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
         : option.name == "excitation"     ? "str | Mapping[str, Any]"
         : option.name == "friction-zones" ? "str | Sequence[Mapping[str, Any]]"
         : option.repeats_in(command)      ? "str | Sequence[str]"
                                           : "str";
}

/// In Python a trajectory is an array, not a file.
std::string help_of(const Option& option) {
  return option.name == "samples"
             ? "asks for the trajectory: evenly spaced instants besides every event"
             : option.help;
}

}  // namespace

std::string documentation(Command command, std::string_view about) {
  std::string signature = fmt::format("{}(scene=None, /, *", name(command));
  std::string list;
  for (const Option& option : cli::options()) {
    if (takes(command, option)) {
      const std::string keyword = keyword_of(option);
      signature += fmt::format(", {}=None", keyword);
      list += fmt::format("\n{:<21} {}", keyword, help_of(option));
    }
  }
  return fmt::format(
      "{})\n--\n\n{}\n\nscene is a path or a dict, as for the program; an option overrides its "
      "key. "
      "A value may be a text with its unit, \"150mm\".\nRaises InputError with the text of the "
      "program.\n\nOptions:{}",
      signature, about, list);
}

py::list options(const std::string& command) {
  py::list all;
  const std::optional<Command> known = parse<Command>(command);
  for (const Option& option : cli::options()) {
    if (known && takes(*known, option)) {
      all.append(py::make_tuple(keyword_of(option), type_of(option, *known), help_of(option)));
    }
  }
  return all;
}

void warn_of_doubts(const Settings& settings, Command command) {
  for (const std::string& doubt : cli::doubts(settings, command)) {
    if (PyErr_WarnEx(PyExc_UserWarning, doubt.c_str(), 1) != 0) {
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
  if (scene.is_none()) {
    return flags;
  }
  Settings of_scene = from_scene(command, scene);
  return cli::scene_and_flags(command, flags, of_scene);
}

}  // namespace stillpoint::python
