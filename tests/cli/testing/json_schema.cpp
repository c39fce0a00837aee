// SPDX-License-Identifier: MIT
#include "json_schema.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>

namespace stillpoint::cli_test {

namespace {

using nlohmann::json;

bool has_type(const json& value, std::string_view type) {
  if (type == "integer") {
    return value.is_number_integer();
  }
  return type == (value.is_number() ? "number" : value.type_name());
}

bool is_one_of(const json& value, const json& list) {
  return std::ranges::find(list, value) != list.end();
}

/// Walks through a schema and a value side by side.
class Validator {
 public:
  Validator(const json& root, UnknownProperties unknown) : root_(root), unknown_(unknown) {}

  void check(const json& schema, const json& value, const std::string& place) {
    require_known_keywords(schema);
    if (schema.contains("$ref")) {
      check(target(schema["$ref"].get<std::string>()), value, place);
    }
    if (schema.contains("anyOf")) {
      check_any(schema["anyOf"], value, place);
    }
    check_value(schema, value, place);
    if (value.is_object()) {
      check_object(schema, value, place);
    } else if (value.is_array()) {
      check_array(schema, value, place);
    }
  }

  [[nodiscard]] std::vector<std::string> faults() && { return std::move(faults_); }

 private:
  static void require_known_keywords(const json& schema) {
    static const std::set<std::string> known{
        "$schema",   "$id",        "$defs", "$ref",          "title",
        "type",      "enum",       "const", "description",   "required",
        "minimum",   "properties", "items", "minItems",      "additionalProperties",
        "minLength", "pattern",    "anyOf", "minProperties", "dependentRequired"};
    for (const auto& [keyword, setting] : schema.items()) {
      if (!known.contains(keyword)) {
        throw std::logic_error("the validator of the tests has no keyword " + keyword);
      }
    }
  }

  [[nodiscard]] const json& target(const std::string& reference) const {
    if (!reference.starts_with('#')) {
      throw std::logic_error("not within the schema: " + reference);
    }
    return root_.at(json::json_pointer(reference.substr(1)));
  }

  void check_any(const json& schemas, const json& value, const std::string& place) {
    std::string all;
    for (const json& schema : schemas) {
      Validator alone(root_, unknown_);
      alone.check(schema, value, place);
      if (alone.faults_.empty()) {
        return;
      }
      all.append("; not one of them: ").append(alone.faults_.front());
    }
    fault(place, "fits none of what is allowed" + all);
  }

  void check_value(const json& schema, const json& value, const std::string& place) {
    if (schema.contains("type")) {
      const json& types = schema["type"];
      const auto fits = [&](const json& type) { return has_type(value, type.get<std::string>()); };
      if (types.is_array() ? !std::ranges::any_of(types, fits) : !fits(types)) {
        fault(place, "must be " + types.dump() + ", is " + value.dump());
      }
    }
    if (schema.contains("const") && schema["const"] != value) {
      fault(place, "must be " + schema["const"].dump() + ", is " + value.dump());
    }
    if (schema.contains("enum") && !is_one_of(value, schema["enum"])) {
      fault(place, "must be of " + schema["enum"].dump() + ", is " + value.dump());
    }
    if (schema.contains("minimum") && value.is_number() &&
        value.get<double>() < schema["minimum"].get<double>()) {
      fault(place, "is less than " + schema["minimum"].dump() + ": " + value.dump());
    }
    if (value.is_string()) {
      const auto& text = value.get_ref<const std::string&>();
      if (text.size() < schema.value("minLength", std::size_t{0})) {
        fault(place, "is too short");
      }
      if (schema.contains("pattern") &&
          !std::regex_search(text, std::regex(schema["pattern"].get<std::string>()))) {
        fault(place, "does not match: " + text);
      }
    }
  }

  void check_object(const json& schema, const json& value, const std::string& place) {
    for (const json& name : schema.value("required", json::array())) {
      if (!value.contains(name.get<std::string>())) {
        fault(place, "lacks " + name.get<std::string>());
      }
    }
    const json companions = schema.value("dependentRequired", json::object());
    for (const auto& [name, others] : companions.items()) {
      for (const json& other : others) {
        if (value.contains(name) && !value.contains(other.get<std::string>())) {
          fault(place, "has " + name + " without " + other.get<std::string>());
        }
      }
    }
    if (value.size() < schema.value("minProperties", std::size_t{0})) {
      fault(place, "has too few properties");
    }
    if (schema.contains("properties")) {
      check_properties(schema, value, place);
    }
  }

  void check_properties(const json& schema, const json& value, const std::string& place) {
    const json others = schema.value("additionalProperties", json(true));
    const bool closed = unknown_ == UnknownProperties::fail || others == false;
    const json& properties = schema["properties"];
    for (const auto& [name, entry] : value.items()) {
      std::string inside = place;
      inside.append("/").append(name);
      if (properties.contains(name)) {
        check(properties[name], entry, inside);
      } else if (others.is_object()) {
        check(others, entry, inside);
      } else if (closed) {
        fault(inside, "is unknown to the schema");
      }
    }
  }

  void check_array(const json& schema, const json& value, const std::string& place) {
    if (value.size() < schema.value("minItems", std::size_t{0})) {
      fault(place, "has too few entries");
    }
    if (schema.contains("items")) {
      for (std::size_t i = 0; i < value.size(); ++i) {
        std::string inside = place;
        inside.append("/").append(std::to_string(i));
        check(schema["items"], value[i], inside);
      }
    }
  }

  void fault(const std::string& place, const std::string& what) {
    faults_.push_back((place.empty() ? "the whole" : place) + ": " + what);
  }

  const json& root_;
  UnknownProperties unknown_;
  std::vector<std::string> faults_;
};

std::map<std::string, json> read_report_schemas() {
  std::map<std::string, json> schemas;
  const std::filesystem::path folder = std::filesystem::path(STILLPOINT_DATA_DIR) / "schemas";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") {
      json schema = data_json("schemas/" + entry.path().filename().string());
      if (schema.at("properties").contains("schema")) {  // a scene has none
        const auto name = schema["properties"]["schema"].at("const").get<std::string>();
        schemas[name] = std::move(schema);
      }
    }
  }
  return schemas;
}

}  // namespace

std::vector<std::string> schema_faults(const json& schema, const json& value,
                                       UnknownProperties unknown) {
  Validator validator(schema, unknown);
  validator.check(schema, value, "");
  return std::move(validator).faults();
}

const json& report_schema(const std::string& name) {
  static const std::map<std::string, json> schemas = read_report_schemas();
  const auto found = schemas.find(name);
  if (found == schemas.end()) {
    throw std::runtime_error("data/schemas has no schema of " + name);
  }
  return found->second;
}

json data_json(std::string_view file) {
  const std::filesystem::path path = std::filesystem::path(STILLPOINT_DATA_DIR) / file;
  std::ifstream stream(path);
  if (!stream) {
    throw std::runtime_error("cannot be read: " + path.string());
  }
  return json::parse(stream);
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
