// SPDX-License-Identifier: MIT
#include "json_schema.hpp"
#include "testing/folder.hpp"

#include <fmt/format.h>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <map>
#include <regex>
#include <stdexcept>

namespace stillpoint::cli_test {

namespace {

using nlohmann::json;

bool has(const json& list, const json& value) {
  return std::ranges::find(list, value) != list.end();
}

bool has_type(const json& type, const json& value) {
  return type == "integer" ? value.is_number_integer()
                           : type == (value.is_number() ? "number" : value.type_name());
}

bool lacks_one(const json& names, const json& value) {
  return value.is_object() && std::ranges::any_of(names, [&value](const json& name) {
           return !value.contains(name.get<std::string>());
         });
}

/// Whether a value is wrong by a keyword that looks at nothing inside it; silent ones never say so.
bool is_wrong(const std::string& keyword, const json& setting, const json& value) {
  using Check = bool (*)(const json& setting, const json& value);
  static constexpr Check never = [](const json&, const json&) { return false; };
  static const std::map<std::string, Check> checks{
      {"$schema", never},
      {"$id", never},
      {"$defs", never},
      {"title", never},
      {"description", never},
      {"default", never},
      {"additionalProperties", never},
      {"type",
       [](const json& types, const json& now) {
         return types.is_array() ? std::ranges::none_of(
                                       types, [&](const json& type) { return has_type(type, now); })
                                 : !has_type(types, now);
       }},
      {"const", [](const json& due, const json& now) { return due != now; }},
      {"enum", [](const json& list, const json& now) { return !has(list, now); }},
      {"minimum",
       [](const json& least, const json& now) { return now.is_number() && now < least; }},
      {"minLength",
       [](const json& least, const json& now) {
         return now.is_string() && now.get_ref<const std::string&>().size() < least;
       }},
      {"pattern",
       [](const json& pattern, const json& now) {
         return now.is_string() && !std::regex_search(now.get_ref<const std::string&>(),
                                                      std::regex(pattern.get<std::string>()));
       }},
      {"minItems",
       [](const json& least, const json& now) { return now.is_array() && now.size() < least; }},
      {"minProperties",
       [](const json& least, const json& now) { return now.is_object() && now.size() < least; }},
      {"required", &lacks_one},
      {"dependentRequired", [](const json& companions, const json& now) {
         return std::ranges::any_of(companions.items(), [&now](const auto& entry) {
           return now.contains(entry.key()) && lacks_one(entry.value(), now);
         });
       }}};
  const auto found = checks.find(keyword);
  if (found == checks.end()) {
    throw std::logic_error("the validator of the tests has no keyword " + keyword);
  }
  return found->second(setting, value);
}

/// Walks through a schema and a value side by side.
struct Validator {
  const json& root;
  UnknownProperties unknown;
  std::vector<std::string> faults{};

  void check(const json& schema, const json& value, const std::string& place) {
    for (const auto& [keyword, setting] : schema.items()) {
      if (keyword == "$ref") {
        check(root.at(json::json_pointer(setting.get<std::string>().substr(1))), value, place);
      } else if (keyword == "anyOf") {
        if (std::ranges::none_of(setting, [&](const json& one) {
              Validator alone{root, unknown};
              alone.check(one, value, place);
              return alone.faults.empty();
            })) {
          faults.push_back(place + ": fits none of what is allowed: " + value.dump());
        }
      } else if (keyword == "properties") {
        check_properties(schema, value, place);
      } else if (keyword == "items") {
        for (std::size_t i = 0; value.is_array() && i < value.size(); ++i) {
          check(setting, value[i], fmt::format("{}/{}", place, i));
        }
      } else if (is_wrong(keyword, setting, value)) {
        faults.push_back(
            fmt::format("{}: {} {}, is {}", place, keyword, setting.dump(), value.dump()));
      }
    }
  }

  void check_properties(const json& schema, const json& value, const std::string& place) {
    if (!value.is_object()) {
      return;
    }
    const json others = schema.value("additionalProperties", json(true));
    for (const auto& [name, entry] : value.items()) {
      const std::string inside = fmt::format("{}/{}", place, name);
      if (schema["properties"].contains(name)) {
        check(schema["properties"][name], entry, inside);
      } else if (others.is_object()) {
        check(others, entry, inside);
      } else if (unknown == UnknownProperties::fail || others == false) {
        faults.push_back(inside + ": is unknown to the schema");
      }
    }
  }
};

std::map<std::string, json> read_report_schemas() {
  std::map<std::string, json> schemas;
  for (const std::filesystem::path& path : json_files("schemas")) {
    json schema = data_json(path);
    if (schema.at("properties").contains("schema")) {  // a scene has none
      const auto name = schema["properties"]["schema"].at("const").get<std::string>();
      schemas[name] = std::move(schema);
    }
  }
  return schemas;
}

}  // namespace

std::vector<std::string> schema_faults(const json& schema, const json& value,
                                       UnknownProperties unknown) {
  Validator validator{schema, unknown};
  validator.check(schema, value, "");
  return validator.faults;
}

const json& report_schema(const std::string& name) {
  static const std::map<std::string, json> schemas = read_report_schemas();
  const auto found = schemas.find(name);
  if (found == schemas.end()) {
    throw std::runtime_error("data/schemas has no schema of " + name);
  }
  return found->second;
}

json data_json(const std::filesystem::path& file) {
  return json::parse(test::text_of(STILLPOINT_DATA_DIR / file));
}

std::vector<std::filesystem::path> json_files(std::string_view folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(STILLPOINT_DATA_DIR) / folder)) {
    if (entry.path().extension() == ".json") {
      files.push_back(entry.path());
    }
  }
  return files;
}

void check_report_schema(std::string_view text) {
  if (!text.starts_with('{')) {
    return;
  }
  const json report = json::parse(text, nullptr, false);
  if (!report.is_object()) {
    return;
  }
  const std::vector<std::string> faults = schema_faults(
      report_schema(report.value("schema", "nothing")), report, UnknownProperties::fail);
  for (const std::string& fault : faults) {
    BOOST_ERROR("not as the schema of the report has it: " + fault);
  }
}

}  // namespace stillpoint::cli_test
