// SPDX-License-Identifier: MIT
#include "options/scene.hpp"

#include <stillpoint/records/text_file.hpp>
#include <stillpoint/sweep/json_text.hpp>
#include "input/motion.hpp"

#include <nlohmann/json.hpp>

namespace stillpoint::cli {

namespace {

/// A scene has a few hundred bytes.
constexpr std::size_t largest_scene = std::size_t{1} << 20U;

constexpr std::string_view standard_input = "from standard input";

/// A number, or "LOW:HIGH" for [LOW, HIGH], as on the command line.
std::string range_text(const Option& option, const nlohmann::json& value) {
  const auto is_end = [](const nlohmann::json& end) { return end.is_number() || end.is_string(); };
  const auto text = [](const nlohmann::json& end) {
    return end.is_string() ? end.get<std::string>() : fmt::format("{}", end.get<double>());
  };
  if (is_end(value)) {
    return text(value);
  }
  if (value.size() != 2 || !std::ranges::all_of(value, is_end)) {
    throw InputError(std::string(option.name), value.dump(),
                     "must be a number, or a range [LOW, HIGH]");
  }
  return fmt::format("{}:{}", text(value[0]), text(value[1]));
}

bool is_text_of(const nlohmann::json& value, char character) {
  return value.is_string() && value.get<std::string>().find(character) != std::string::npos;
}

bool has_its_unit(const Option& option, const nlohmann::json& value) {
  return (option.traits.dimension != Dimension::none ||
          option.traits.or_per_weight.dimension != Dimension::none) &&
         value.is_string() && has_unit(value.get<std::string>());
}

/// A number, a string "first:last:count" or an array of numbers, which may be ranges if the option
/// takes one.
std::string axis_text(const Option& option, const nlohmann::json& value, Command command) {
  if (value.is_string()) {
    return value.get<std::string>();
  }
  const bool has_ranges =
      value.is_array() && std::ranges::any_of(value, [&](const nlohmann::json& entry) {
        return option.takes_range_in(command) && (entry.is_array() || is_text_of(entry, ':'));
      });
  std::string text;
  for (const nlohmann::json& entry : value.is_array() ? value : nlohmann::json::array({value})) {
    if (!has_ranges && !has_its_unit(option, entry) && !entry.is_number()) {
      text.clear();
      break;
    }
    text += (text.empty() ? "" : ",") + range_text(option, entry);
  }
  if (text.empty()) {
    throw InputError(std::string(option.name), value.dump(),
                     "must be a number, an axis \"first:last:count\" or an array of numbers");
  }
  return text;
}

/// As on the command line; for any option but a flag.
std::string text_of(const Option& option, const nlohmann::json& value, Command command) {
  const auto must_be = [&](bool right, const std::string& wanted) {
    if (!right) {
      throw InputError(std::string(option.name), value.dump(), wanted);
    }
  };
  const bool takes_range = option.takes_range_in(command);
  switch (option.kind_in(command)) {
    case OptionKind::axis:
      return axis_text(option, value, command);
    case OptionKind::number:
      must_be(takes_range || !value.is_array(), "must be one number, not a range");
      must_be(value.is_number() || has_its_unit(option, value) ||
                  (takes_range && (value.is_array() || is_text_of(value, ':'))),
              fmt::format("must be a number{}{}",
                          option.traits.dimension == Dimension::none
                              ? ""
                              : ", or a string with a number and its unit",
                          takes_range ? ", or a range [LOW, HIGH]" : ""));
      return range_text(option, value);
    case OptionKind::integer:
      must_be(value.is_number(), fmt::format("must be {}", whole_number(option)));
      return value.dump();
    case OptionKind::text:
    case OptionKind::flag:
      break;
  }
  if (option.traits.in_scene == InScene::zones && value.is_array()) {
    return zones_text(value);
  }
  if (option.traits.in_scene == InScene::cases && value.is_array()) {
    return value.dump();
  }
  const bool is_one = option.traits.repeats && !option.repeats_in(command);
  const char* const wanted = option.traits.in_scene == InScene::cases ? "must be a list of objects"
                             : option.traits.in_scene == InScene::group
                                 ? R"(must be a string, or an object with a "type")"
                             : option.traits.file == FileUse::none ? "must be a string"
                             : is_one                              ? "must be one path"
                                                                   : "must be a path";
  const bool takes_list = option.traits.repeats && !(is_one && option.serves(command));
  if (!takes_list || !value.is_array()) {
    must_be(value.is_string(), wanted);
    return value.get<std::string>();
  }
  must_be(!value.empty(), "must have at least one string");
  std::string lines;  // as repeated flags give them
  for (const nlohmann::json& entry : value) {
    if (!entry.is_string()) {
      throw InputError(std::string(option.name), entry.dump(), wanted);
    }
    lines += (lines.empty() ? "" : "\n") + entry.get<std::string>();
  }
  return lines;
}

void set_key(Settings& settings, const std::string& key, const nlohmann::json& value,
             const Option* option, Command command) {
  if (option == nullptr) {
    throw InputError(records::printable(key, records::longest_word), value.dump(),
                     fmt::format("is not a key of a scene{}", suggestion(records::hyphened(key))));
  }
  if (settings.has(option->name)) {
    throw UsageError(fmt::format("{} is set twice in the scene: a key may appear only once", key));
  }
  if (option->kind != OptionKind::flag) {
    return settings.set_text(*option, text_of(*option, value, command), command);
  }
  if (!value.is_boolean()) {
    throw InputError(std::string(option->name), value.dump(), "must be true or false");
  }
  settings.set(*option, value.get<bool>());
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
    const Option* const option = find_option(records::hyphened(key));
    const bool is_group = option != nullptr && option->traits.in_scene == InScene::group;
    if (!is_group || !value.is_object() || value.empty()) {
      add_key(settings, key, value, option, command, places);
      continue;
    }
    for (const auto& [inner, inner_value] : value.items()) {
      add_key(settings, fmt::format("{}.{}", key, inner), inner_value,
              option_within(*option, records::hyphened(inner)), command, places);
    }
  }
}

/// Those that one of its cases names.
void find_files_of(nlohmann::json& load_case, const std::string& scene) {
  const auto find = [&](nlohmann::json& name) {
    if (name.is_string()) {
      name = records::beside(scene, name.get<std::string>());
    }
  };
  for (const auto& [key, value] : load_case.items()) {
    const Option* const option = find_option(records::hyphened(key));
    if (option != nullptr && option->traits.file == FileUse::read) {
      if (value.is_array()) {
        std::ranges::for_each(value, find);
      } else {
        find(value);
      }
    }
  }
}

/// The files that a scene names are looked for beside it first.
void find_files(Settings& settings, const std::string& scene) {
  for (const Option& option : options()) {
    if (option.traits.file != FileUse::read || !settings.has(option.name)) {
      continue;
    }
    std::string found;
    for (const std::string& name : settings.texts(option.name)) {
      found += (found.empty() ? "" : "\n") + (name == "-" ? name : records::beside(scene, name));
    }
    settings.set(option, found);
  }
  if (const auto text = settings.text("cases")) {
    auto cases = nlohmann::json::parse(*text, nullptr, false);
    if (cases.is_array()) {
      std::ranges::for_each(cases, [&](nlohmann::json& each) { find_files_of(each, scene); });
      settings.set("cases", cases.dump());
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
  if (path == "-") {
    return parse_scene(records::read_text_stream("scene", standard_input, largest_scene, stdin),
                       standard_input, command);
  }
  Settings settings =
      parse_scene(records::read_text_file("scene", path, largest_scene), path, command);
  find_files(settings, path);
  return settings;
}

}  // namespace stillpoint::cli
