// SPDX-License-Identifier: MIT
#include "scene.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <set>
#include <vector>

namespace stillpoint::cli {

namespace {

using nlohmann::json;

constexpr std::size_t longest_message = 300;
/// A scene has some hundred bytes.
constexpr std::size_t largest_scene = std::size_t{1} << 20U;

std::string read_all(std::FILE* file, const std::string& source) {
  std::string text;
  std::vector<char> buffer(std::size_t{1} << 16U);
  for (;;) {
    const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file);
    text.append(buffer.data(), count);
    if (text.size() > largest_scene) {
      throw UsageError(
          fmt::format("scene {}: is too large, must be at most {} bytes", source, largest_scene));
    }
    if (count == 0) {
      break;
    }
  }
  if (std::ferror(file) != 0) {
    throw UsageError(fmt::format("scene {}: cannot be read: {}", source, std::strerror(errno)));
  }
  return text;
}

[[noreturn]] void refuse_twice(const std::string& key) {
  throw UsageError(fmt::format("{} is set twice: a key may stand only once in a scene",
                               records::shortened(key, records::longest_word)));
}

/// What the library passes over, watched for while it parses: of two equal keys it keeps the last,
/// and it prints a value by recursion, so that the stack ends with a deep one.
class SceneWatch {
 public:
  explicit SceneWatch(std::string_view source) : source_(source) {}

  bool operator()(int depth, json::parse_event_t event, const json& parsed) {
    constexpr int deepest = 16;  // a scene has three levels
    if (depth > deepest) {
      throw UsageError(fmt::format("scene {}: is nested deeper than {} levels, which no scene is",
                                   source_, deepest));
    }
    const auto level = static_cast<std::size_t>(depth);
    if (event == json::parse_event_t::object_start) {
      seen_.resize(level + 1);
      seen_[level].clear();
    } else if (event == json::parse_event_t::key) {
      const auto key = parsed.get<std::string>();
      last_ = key;
      if (!seen_.at(level - 1).insert(key).second) {
        refuse_twice(key);
      }
    }
    return true;
  }

  /// The key that was read last; empty before the first.
  [[nodiscard]] const std::string& last() const { return last_; }

 private:
  std::string source_;
  std::string last_;
  std::vector<std::set<std::string>> seen_;
};

/// The library's message without its "[json.exception...] ".
std::string_view without_prefix(std::string_view message) {
  const std::size_t prefix = message.find("] ");
  return prefix == std::string_view::npos ? message : message.substr(prefix + 2);
}

json parse_json(std::string_view text, std::string_view source) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    throw UsageError(fmt::format("scene {}: is empty, must be a JSON object", source));
  }
  SceneWatch watch(source);
  try {
    return json::parse(text, [&watch](int depth, json::parse_event_t event, const json& parsed) {
      return watch(depth, event, parsed);
    });
  } catch (const json::out_of_range& error) {
    throw UsageError(
        fmt::format("scene {}: {}: {}, must have a magnitude up to 1.8e308", source,
                    records::shortened(watch.last(), records::longest_word),
                    records::printable(without_prefix(error.what()), longest_message)));
  } catch (const json::exception& error) {
    throw UsageError(
        fmt::format("scene {}: is not valid JSON: {}", source,
                    records::printable(without_prefix(error.what()), longest_message)));
  }
}

/// A number, a text "first:last:count" or an array of numbers.
Axis axis(const Option& option, const json& value) {
  const std::string field(option.name);
  const auto wrong = [&] {
    return InputError(field, value.dump(),
                      "must be a number, a range \"first:last:count\" or an array of numbers");
  };
  if (value.is_string()) {
    return parse_axis(field, value.get<std::string>());
  }
  std::vector<double> values;
  for (const json& entry : value.is_array() ? value : json::array({value})) {
    if (!entry.is_number()) {
      throw wrong();
    }
    values.push_back(entry.get<double>());
  }
  if (values.empty()) {
    throw wrong();
  }
  return Axis(std::move(values));
}

Settings::Value typed(const Option& option, const json& value, Command command) {
  const auto wrong_type = [&](std::string_view wanted) {
    return InputError(std::string(option.name), value.dump(), fmt::format("must be {}", wanted));
  };
  switch (option.kind_in(command)) {
    case OptionKind::axis:
      return axis(option, value);
    case OptionKind::number:
      if (!value.is_number()) {
        throw wrong_type("a number");
      }
      return value.get<double>();
    case OptionKind::integer:
      if (!value.is_number_integer()) {
        throw wrong_type("a whole number");
      }
      if (value.is_number_unsigned() &&
          value.get<std::uint64_t>() > std::numeric_limits<std::int64_t>::max()) {
        throw wrong_type("a whole number of at most 18 digits");
      }
      return value.get<std::int64_t>();
    case OptionKind::text:
      if (!value.is_string()) {
        throw wrong_type("a text in quotes");
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

void add_key(Settings& settings, const std::string& key, const json& value, const Option* option,
             Command command) {
  if (option == nullptr) {
    throw InputError(records::shortened(key, records::longest_word), value.dump(),
                     fmt::format("is not a key of a scene{}", suggestion(key)));
  }
  if (settings.has(option->name)) {
    refuse_twice(key);
  }
  settings.set(*option, typed(*option, value, command));
}

/// "excitation" may be an object of its own; its "type" is the option excitation.
void add_keys(Settings& settings, const json& object, std::string_view within, Command command) {
  for (const auto& [key, value] : object.items()) {
    std::string wanted = key;
    std::ranges::replace(wanted, '_', '-');
    const Option* option = find_option(wanted);
    if (within.empty() && wanted == "excitation" && value.is_object()) {
      if (value.empty()) {
        throw InputError(key, "{}", "must have a type");
      }
      add_keys(settings, value, wanted, command);
    } else if (within.empty()) {
      add_key(settings, key, value, option, command);
    } else {
      const bool of_it = option != nullptr && option->group == find_option(within)->group &&
                         option->name != within;
      add_key(settings, fmt::format("{}.{}", within, key), value,
              wanted == "type" ? find_option(within)
              : of_it          ? option
                               : nullptr,
              command);
    }
  }
}

}  // namespace

Settings parse_scene(std::string_view text, std::string_view source, Command command) {
  const json scene = parse_json(text, source);
  if (!scene.is_object()) {
    throw UsageError(
        fmt::format("scene {}: is a JSON {}, must be an object", source, scene.type_name()));
  }
  Settings settings;
  add_keys(settings, scene, "", command);
  return settings;
}

Settings read_scene(const std::string& path, Command command) {
  if (path == "-") {
    return parse_scene(read_all(stdin, "from standard input"), "from standard input", command);
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) {
    throw UsageError(fmt::format("scene {}: cannot be read: {}",
                                 records::shortened(path, records::longest_path),
                                 std::strerror(errno)));
  }
  return parse_scene(read_all(file.get(), path), path, command);
}

}  // namespace stillpoint::cli
