// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>
#include "generated_docs.hpp"
#include "option_facts.hpp"

#include <stillpoint/report/report.hpp>

#include <cassert>

namespace stillpoint::cli {

namespace {

using nlohmann::ordered_json;

/// A number, or a string with a number and its unit, of one or the other dimension.
ordered_json number_type(Dimension dimension, Dimension other = Dimension::none) {
  std::string names;
  for (const Dimension each : {dimension, other}) {
    for (const records::Unit& unit : records::units_of(each)) {
      names += fmt::format("{}{}", names.empty() ? "" : "|", unit.name);
    }
  }
  if (names.empty()) {
    return {{"type", "number"}};
  }
  return {{"type", {"number", "string"}},
          {"pattern",
           fmt::format("^[-+]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][-+]?[0-9]+)? *({})$", names)}};
}

bool sweeps(const Option& option) {
  return option.traits.axis.has(Command::sweep);
}

/// The load of a case and its own limits, each as outside of the cases.
ordered_json type_of_case() {
  ordered_json properties{{"name", {{"type", "string"}, {"minLength", 1}}}};
  for (const Option& option : options()) {
    if (option.is_of_case()) {
      for (const std::string& key : {records::underscored(option.name), std::string(option.name)}) {
        properties[key] = {{"$ref", "#/properties/" + key}};
      }
    }
  }
  return {{"type", "object"},
          {"required", {"name"}},
          {"properties", properties},
          {"additionalProperties", false}};
}

ordered_json type_of(const Option& option) {
  const bool ranges = option.traits.range != RangeEnd::none;
  const Dimension per_weight = option.traits.or_per_weight.dimension;
  ordered_json number = number_type(option.traits.dimension, per_weight);
  if (ranges && !sweeps(option)) {
    return {{"type", {"number", "string", "array"}},
            {"items", per_weight != Dimension::none ? number : number_type(Dimension::none)},
            {"minItems", 2}};
  }
  if (sweeps(option)) {
    const bool whole = option.kind == OptionKind::integer;
    return {{"type", {whole ? "integer" : "number", "string", "array"}},
            {"items", whole    ? ordered_json{{"type", "integer"}}
                      : ranges ? ordered_json{{"type", {"number", "string", "array"}}}
                               : number},
            {"minItems", 1}};
  }
  switch (option.kind) {
    case OptionKind::number:
      return number;
    case OptionKind::integer:
      return {{"type", "integer"}};
    case OptionKind::text:
      if (option.traits.in_scene == InScene::zones) {
        const ordered_json zone{
            {"type", "object"},
            {"required", {"to", "f"}},
            {"properties", {{"to", number_type(Dimension::length)}, {"f", {{"type", "number"}}}}},
            {"additionalProperties", false}};
        return {{"type", {"string", "array"}}, {"minItems", 1}, {"items", zone}};
      }
      if (option.traits.in_scene == InScene::cases) {
        return {{"type", {"string", "array"}}, {"minItems", 1}, {"items", type_of_case()}};
      }
      if (option.traits.repeats) {
        return {{"type", {"string", "array"}}, {"minItems", 1}, {"items", {{"type", "string"}}}};
      }
      return option.values().empty() ? ordered_json{{"type", "string"}}
                                     : ordered_json{{"type", "string"}, {"enum", option.values()}};
    case OptionKind::flag:
      return {{"type", "boolean"}};
    case OptionKind::axis:
      break;
  }
  assert(false && "an option of the table is not an axis by itself");
  return {};
}

/// "; in a string it may have a unit: m, cm or mm; with a mass J, kJ or MJ"
std::string units_text(const Option& option) {
  std::string text;
  for (const auto& [dimension, condition] :
       {std::pair{option.traits.dimension, "in a string it may have a unit:"},
        std::pair{option.traits.or_per_weight.dimension, "in a string, with a mass, also"}}) {
    const std::string names = records::unit_names(dimension);
    text += names.empty() ? "" : fmt::format("; {} {}", condition, names);
  }
  return text;
}

ordered_json described(const Option& option) {
  ordered_json entry = type_of(option);
  entry["description"] =
      std::string(option.help) + " (" + command_names(&option, ", ") + ")" +
      (option.traits.axis.has(Command::spectrum) ? "; only a sweep and a spectrum take an axis"
       : sweeps(option)                          ? "; only a sweep takes an axis"
                                                 : "") +
      (option.traits.range == RangeEnd::none ? ""
       : sweeps(option) ? "; design and region also take a range [LOW, HIGH], a sweep over designs "
                          "[[LOW, HIGH], ...]"
                        : "; also takes a range [LOW, HIGH]") +
      units_text(option);
  return entry;
}

/// Under both spellings of its name.
void add(ordered_json& properties, const Option& option, const ordered_json& entry) {
  properties[records::underscored(option.name)] = entry;
  properties[std::string(option.name)] = entry;
}

/// The value, or an object that has it as `type` beside the options of its group.
ordered_json group(const Option& option) {
  ordered_json properties{{"type", type_of(option)}};
  properties["type"]["description"] = option.help;
  for (const Option& other : options()) {
    if (other.group == option.group && other.name != option.name) {
      add(properties, other, described(other));
    }
  }
  const ordered_json object{{"type", "object"},
                            {"minProperties", 1},
                            {"properties", properties},
                            {"additionalProperties", false}};
  return {{"anyOf", {described(option), object}}};
}

}  // namespace

std::string scene_schema() {
  ordered_json properties = ordered_json::object();
  for (const Option& option : options()) {
    add(properties, option,
        option.traits.in_scene == InScene::group ? group(option) : described(option));
  }
  const ordered_json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                            {"$id", "urn:stillpoint:scene"},
                            {"title", "A scene: the input of stillpoint"},
                            {"description",
                             "The keys are the names of the options; _ and - are the same. The "
                             "program also accepts // and /* */ comments."},
                            {"type", "object"},
                            {"properties", properties},
                            {"additionalProperties", false}};
  return report::json_text(schema);
}

}  // namespace stillpoint::cli
