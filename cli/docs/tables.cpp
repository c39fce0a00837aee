// SPDX-License-Identifier: MIT
#include "generated_docs.hpp"

#include <stillpoint/core/response_fields.hpp>
#include <stillpoint/report/report.hpp>
#include <stillpoint/report/schemas.hpp>
#include <stillpoint/sweep/quantity.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <regex>
#include <type_traits>

namespace stillpoint::cli {

namespace {

/// In a cell of a table in docs, where the pages that it names are links.
std::string in_markdown(std::string_view words) {
  const std::string linked =
      std::regex_replace(std::string(words), std::regex("([a-z-]+\\.md)"), "[$1]($1)");
  return std::regex_replace(linked, std::regex("\\|"), "\\|");
}

/// "`names` of the enumerators; "; empty for anything else.
template <class Value>
std::string choices() {
  if constexpr (HasNames<Value>) {
    return fmt::format("`{}`; ", fmt::join(names<Value>(), " "));
  }
  return "";
}

template <class Result, class Fields>
std::string table_of(const Fields& all) {
  std::string text = "| field | in `physical` | what it holds |\n|---|---|---|\n";
  for_each_field(all, [&]<class Get>(const Field<Get>& field) {
    using Value = std::remove_cvref_t<std::invoke_result_t<Get, const Result&>>;
    const std::string_view physical = field.measure.physical;
    text += fmt::format("| `{}` | {}| {}{} |\n", field.name,
                        physical.empty() ? "" : fmt::format("`{}` ", physical), choices<Value>(),
                        in_markdown(field.words));
  });
  return text;
}

}  // namespace

std::string motion_tables() {
  return table_of<Response>(fields<Response>) + "\n" +
         table_of<MotionEnergies>(fields<MotionEnergies>) + "\n" +
         table_of<ForcedResponse>(forced_fields);
}

std::string sweep_columns_row() {
  std::string plain;
  std::string physical;
  for_each_field(sweep::motion_columns, [&](const auto& column) {
    const sweep::QuantityForm form = sweep::form_of(column);
    if (!form.physical.empty()) {
      const std::string_view gap = plain.empty() ? "" : " ";
      plain += fmt::format("{}{}", gap, form.name);
      physical += fmt::format("{}{}", gap, form.physical);
    }
  });
  return fmt::format("| `{}` | `{}` |\n", plain, physical);
}

std::string report_schema(std::string_view name) {
  const auto* const schema =
      std::ranges::find(report::report_schemas, name, &report::ReportSchema::name);
  return schema == report::report_schemas.end() ? "" : report::json_text(schema->make());
}

}  // namespace stillpoint::cli
