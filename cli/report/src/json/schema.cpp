// SPDX-License-Identifier: MIT
#include "json/schema.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace stillpoint::report {

using nlohmann::ordered_json;

ordered_json number_schema(bool whole, Numbers numbers) {
  ordered_json schema{{"type", whole ? "integer" : "number"}};
  if (numbers != Numbers::all) {
    schema["minimum"] = numbers == Numbers::from_one ? 1 : 0;
  }
  return schema;
}

ordered_json text_schema(std::span<const std::string_view> texts, bool may_be_empty) {
  if (texts.empty()) {
    return may_be_empty ? ordered_json{{"type", "string"}}
                        : ordered_json{{"type", "string"}, {"minLength", 1}};
  }
  return texts.size() == 1 ? ordered_json{{"const", texts.front()}} : ordered_json{{"enum", texts}};
}

ordered_json list_schema(ordered_json item, int least) {
  ordered_json schema{{"type", "array"}, {"items", std::move(item)}};
  if (least > 0) {
    schema["minItems"] = least;
  }
  return schema;
}

ordered_json or_null_schema(ordered_json schema) {
  if (schema.contains("$ref")) {
    return {{"anyOf", {std::move(schema), {{"type", "null"}}}}};
  }
  if (schema.contains("enum")) {
    schema["enum"].push_back(nullptr);
  } else if (schema.contains("anyOf")) {
    schema["anyOf"].push_back({{"type", "null"}});
  } else if (schema.contains("const")) {
    return {{"enum", {schema["const"], nullptr}}};
  } else if (schema.contains("type")) {
    schema["type"] = {schema["type"], "null"};
  }
  return schema;
}

void add_property(ordered_json& properties, std::string_view name, std::string_view words,
                  ordered_json schema, const Measure& measure) {
  // In SI units it may always be null.
  const bool can_be_null = schema.contains("type") && schema["type"].is_array();
  const bool has_twin = measure.si == InSi::beside || measure.si == InSi::alone;
  const ordered_json in_si = has_twin && !can_be_null ? or_null_schema(schema) : schema;
  ordered_json& now = properties[std::string(name)] = measure.si == InSi::alone ? in_si : schema;
  if (!words.empty()) {
    now["description"] = words;
  }
  if (measure.usual) {
    now["default"] = can_be_null ? ordered_json(nullptr) : ordered_json(*measure.usual);
  }
  if (measure.si == InSi::beside) {
    properties[si_name(name, measure)] = in_si;
  }
}

ordered_json object_schema(ordered_json properties) {
  auto required = ordered_json::array();
  for (const auto& [name, property] : properties.items()) {
    if (!property.contains("default")) {
      required.push_back(name);
    }
  }
  return {
      {"type", "object"}, {"required", std::move(required)}, {"properties", std::move(properties)}};
}

ordered_json document_schema(std::string_view name, std::string_view command,
                             std::string_view description, ordered_json properties,
                             ordered_json definitions) {
  ordered_json schema{
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"$id", fmt::format("urn:{}", fmt::join(records::split(name, '/'), ":"))},
      {"title", fmt::format("What stillpoint {} prints", command)},
      {"description",
       fmt::format("{}; what does not exist is null. docs/reports.md says what each field holds.",
                   description)}};
  schema.update(object_schema(std::move(properties)));
  if (!definitions.is_null()) {
    schema["$defs"] = std::move(definitions);
  }
  return schema;
}

}  // namespace stillpoint::report
