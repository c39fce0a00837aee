// SPDX-License-Identifier: MIT
#include "options/scene.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/records/text_file.hpp>
#include <stillpoint/sweep/json_text.hpp>
#include "input/motion.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace stillpoint::cli {

namespace {

/// A scene has a few hundred bytes.
constexpr std::size_t largest_scene = std::size_t{1} << 20U;

constexpr std::string_view standard_input = "from standard input";

std::string shown(std::string_view key) {
  return records::printable(key, records::longest_word);
}

/// As options are spelled.
std::string hyphened(std::string key) {
  std::ranges::replace(key, '_', '-');
  return key;
}

/// "LOW:HIGH" for [LOW, HIGH], as on the command line.
std::string range_text(const Option& option, const nlohmann::json& value) {
  if (value.is_string()) {
    return value.get<std::string>();
  }
  const auto is_end = [](const nlohmann::json& end) { return end.is_number() || end.is_string(); };
  if (value.size() != 2 || !std::ranges::all_of(value, is_end)) {
    throw InputError(std::string(option.name), value.dump(),
                     "must be a number, or a range [LOW, HIGH]");
  }
  const auto text = [](const nlohmann::json& end) {
    return end.is_string() ? end.get<std::string>() : fmt::format("{}", end.get<double>());
  };
  return fmt::format("{}:{}", text(value[0]), text(value[1]));
}

bool is_text_of(const nlohmann::json& value, char character) {
  return value.is_string() && value.get<std::string>().find(character) != std::string::npos;
}

/// A number, a string "first:last:count" or an array of numbers, which may be ranges if the option
/// takes one.
Axis axis(const Option& option, const nlohmann::json& value, Command command) {
  const std::string field(option.name);
  const auto wrong = [&] {
    return InputError(field, value.dump(),
                      "must be a number, a range \"first:last:count\" or an array of numbers");
  };
  if (value.is_string()) {
    return axis_value(option, value.get<std::string>(), command);
  }
  const auto is_range = [&](const nlohmann::json& entry) {
    return option.takes_range_in(command) && (entry.is_array() || is_text_of(entry, ':'));
  };
  if (value.is_array() && std::ranges::any_of(value, is_range)) {
    std::string text;
    for (const nlohmann::json& entry : value) {
      text +=
          (text.empty() ? "" : ",") +
          (entry.is_number() ? fmt::format("{}", entry.get<double>()) : range_text(option, entry));
    }
    return axis_value(option, text, command);
  }
  std::vector<double> values;
  for (const nlohmann::json& entry : value.is_array() ? value : nlohmann::json::array({value})) {
    if (entry.is_string() && option.traits.dimension != Dimension::none &&
        has_unit(entry.get<std::string>())) {
      values.push_back(parse_value(option, entry.get<std::string>()));
    } else if (entry.is_number()) {
      values.push_back(entry.get<double>());
    } else {
      throw wrong();
    }
  }
  if (values.empty()) {
    throw wrong();
  }
  return Axis(std::move(values));
}

std::string must_be_text(const Option& option, Command command) {
  return option.traits.file == FileUse::none                    ? "must be a string"
         : option.traits.repeats && !option.repeats_in(command) ? "must be one path"
                                                                : "must be a path";
}

/// One line for each, as repeated flags give them.
std::string joined_texts(const Option& option, const nlohmann::json& list, Command command) {
  std::string text;
  for (const nlohmann::json& entry : list) {
    if (!entry.is_string()) {
      throw InputError(std::string(option.name), entry.dump(), must_be_text(option, command));
    }
    text += (text.empty() ? "" : "\n") + entry.get<std::string>();
  }
  if (text.empty()) {
    throw InputError(std::string(option.name), list.dump(), "must have at least one string");
  }
  return text;
}

/// For any value but a string with a number and its unit.
Settings::Value typed(const Option& option, const nlohmann::json& value, Command command) {
  const auto wrong_type = [&](std::string_view wanted) {
    return InputError(std::string(option.name), value.dump(), fmt::format("must be {}", wanted));
  };
  switch (option.kind_in(command)) {
    case OptionKind::axis:
      return axis(option, value, command);
    case OptionKind::number:
      if (value.is_array()) {
        throw wrong_type("one number, not a range");
      }
      if (!value.is_number()) {
        throw wrong_type(fmt::format(
            "a number{}{}",
            option.traits.dimension == Dimension::none ? ""
                                                       : ", or a string with a number and its unit",
            option.takes_range_in(command) ? ", or a range [LOW, HIGH]" : ""));
      }
      return value.get<double>();
    case OptionKind::integer:
      if (!value.is_number()) {
        throw wrong_type(whole_number(option));
      }
      return integer_value(option, value.dump());
    case OptionKind::text:
      if (option.traits.in_scene == InScene::zones && value.is_array()) {
        return zones_text(value);
      }
      if (option.traits.repeats && value.is_array() &&
          (option.repeats_in(command) || !option.serves(command))) {
        return joined_texts(option, value, command);
      }
      if (!value.is_string()) {
        throw InputError(std::string(option.name), value.dump(), must_be_text(option, command));
      }
      return value.get<std::string>();
    case OptionKind::flag:
      break;
  }
  if (!value.is_boolean()) {
    throw wrong_type("true or false");
  }
  return value.get<bool>();
}

void set_key(Settings& settings, const std::string& key, const nlohmann::json& value,
             const Option* option, Command command) {
  if (option == nullptr) {
    throw InputError(shown(key), value.dump(),
                     fmt::format("is not a key of a scene{}", suggestion(hyphened(key))));
  }
  if (settings.has(option->name)) {
    throw UsageError(
        fmt::format("{} is set twice in the scene: a key may appear only once", shown(key)));
  }
  const bool is_range =
      option->takes_range_in(command) && (value.is_array() || is_text_of(value, ':'));
  const bool with_unit = option->traits.dimension != Dimension::none && value.is_string() &&
                         has_unit(value.get<std::string>());
  if (option->kind_in(command) == OptionKind::number && (is_range || with_unit)) {
    settings.set_number(*option, range_text(*option, value), command);
  } else {
    settings.set(*option, typed(*option, value, command));
  }
}

void add_key(Settings& settings, const std::string& key, const nlohmann::json& value,
             const Option* option, Command command, const sweep::KeyPlaces& places) {
  const auto place = places.find(key);
  if (place == places.end()) {
    return set_key(settings, key, value, option, command);
  }
  try {
    set_key(settings, key, value, option, command);
  } catch (const InputError& error) {
    throw records::FileError(place->second, error.what());
  } catch (const UsageError& error) {
    throw records::FileError(place->second, error.what());
  }
  settings.set_place(*option, place->second);
}

/// The option that a key means within the object of `outer`, whose "type" is that option itself;
/// null if there is none.
const Option* option_within(const Option& outer, std::string_view key) {
  if (key == "type") {
    return &outer;
  }
  const Option* const option = find_option(key);
  return option != nullptr && option != &outer && option->group == outer.group ? option : nullptr;
}

void add_keys(Settings& settings, const nlohmann::json& object, Command command,
              const sweep::KeyPlaces& places) {
  for (const auto& [key, value] : object.items()) {
    const Option* const option = find_option(hyphened(key));
    const bool is_group = option != nullptr && option->traits.in_scene == InScene::group;
    if (!is_group || !value.is_object()) {
      add_key(settings, key, value, option, command, places);
      continue;
    }
    if (value.empty()) {
      throw InputError(key, "{}", "must have a type");
    }
    for (const auto& [inner, inner_value] : value.items()) {
      add_key(settings, fmt::format("{}.{}", key, inner), inner_value,
              option_within(*option, hyphened(inner)), command, places);
    }
  }
}

}  // namespace

Settings parse_scene(std::string_view text, std::string_view source, Command command) {
  const sweep::KeyPlaces places = sweep::require_json_object(text, {"scene", std::string(source)});
  Settings settings;
  add_keys(settings, nlohmann::json::parse(text, nullptr, true, true), command, places);
  return settings;
}

Settings scene_settings(const nlohmann::json& scene, Command command) {
  Settings settings;
  add_keys(settings, scene, command, {});
  return settings;
}

Settings read_scene(const std::string& path, Command command) {
  return path == "-"
             ? parse_scene(records::read_text_stream("scene", standard_input, largest_scene, stdin),
                           standard_input, command)
             : parse_scene(records::read_text_file("scene", path, largest_scene), path, command);
}

}  // namespace stillpoint::cli
