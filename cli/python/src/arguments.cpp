// SPDX-License-Identifier: MIT
#include "arguments.hpp"

#include "held_arrays.hpp"
#include "input/request.hpp"
#include "options/scene.hpp"

#include <stillpoint/report/document.hpp>

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

/// The value of an option, or of a key that is none.
nlohmann::json json_of(const Option* option, const std::string& key, py::handle value,
                       HeldArrays& arrays) {
  return option == nullptr || option->traits.file == cli::FileUse::none ? to_json(key, value)
         : option->name == "record"                                     ? arrays.names_in(value)
         : option->name == "list"                                       ? arrays.name_of_list(value)
                                                                        : to_paths(key, value);
}

Settings from_mapping(Command command, const py::object& scene, HeldArrays& arrays) {
  nlohmann::json given = nlohmann::json::object();
  for (const auto& [key, value] : py::dict(scene)) {
    const auto name = py::str(key).cast<std::string>();
    given[name] = json_of(cli::find_option(records::hyphened(name)), name, value, arrays);
  }
  return cli::scene_settings(given, command);
}

Settings from_scene(Command command, const py::object& scene, HeldArrays& arrays) {
  Settings all =
      py::hasattr(scene, "keys")
          ? from_mapping(command, scene, arrays)
          : cli::read_scene(to_path("scene", scene, "must be a path or a dict"), command);
  for (const Option& option : cli::options()) {
    if (option.traits.role == cli::Role::output && !option.serves_in_python(command)) {
      all.drop(option.name);
    }
  }
  return all;
}

std::string type_of(const Option& option, Command command) {
  using cli::OptionKind;
  const OptionKind kind = option.kind_in(command);
  if (kind != OptionKind::text) {
    return kind == OptionKind::axis                              ? "Axis"
           : kind == OptionKind::integer                         ? "int"
           : kind == OptionKind::flag                            ? "bool"
           : option.takes_range_in(command)                      ? "Range"
           : option.traits.dimension != records::Dimension::none ? "Number"
                                                                 : "float";
  }
  return option.name == "record"
             ? option.repeats_in(command) ? "Record | Sequence[Record]" : "Record"
         : option.name == "list" ? "Path | Mapping[str, ArrayLike] | ArrayLike"
         : option.traits.file != cli::FileUse::none
             ? option.repeats_in(command) ? "Path | Sequence[Path]" : "Path"
         : option.traits.in_scene == cli::InScene::group ? "str | Mapping[str, Any]"
         : option.traits.in_scene == cli::InScene::zones ? "str | Sequence[Mapping[str, Any]]"
         : option.repeats_in(command)                    ? "str | Sequence[str]"
                                                         : "str";
}

std::string help_of(const Option& option) {
  const auto& here = option.traits.python;
  return std::string(here && !here->help.empty() ? here->help : option.help);
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
      "key. A value may be a string with its unit, \"150mm\"; a record may be arrays, (times, "
      "accelerations).\nRaises InputError with the text of "
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
    constexpr int of_the_caller = 2;  // of the function of the package that called this
    const py::str text = to_str(report::spelled_out(warning));
    if (PyErr_WarnFormat(PyExc_UserWarning, of_the_caller, "%U", text.ptr()) != 0) {
      throw py::error_already_set();
    }
  }
}

Settings settings(Command command, const py::object& scene, const py::dict& options) {
  HeldArrays arrays;
  nlohmann::json given = nlohmann::json::object();
  for (const auto& [key, value] : options) {
    const Option& option = option_of(command, key.cast<std::string>());
    const std::string name(option.name);
    if (!value.is_none()) {
      given[name] = json_of(&option, name, value, arrays);
    }
  }
  const Settings flags = cli::scene_settings(given, command);
  Settings all = flags;
  if (!scene.is_none()) {
    Settings of_scene = from_scene(command, scene, arrays);
    all = cli::scene_and_flags(command, flags, of_scene);
  }
  all.hold_records(arrays.files());
  all.hold_list(arrays.list());
  return all;
}

}  // namespace stillpoint::python
