// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::cli_test {

/// Properties that a schema does not name. Users' schemas let them pass, because reports may grow;
/// here they are an error, so that the schemas grow with the reports.
enum class UnknownProperties { pass, fail };

/// The faults of `value` against a JSON Schema (draft 2020-12), each with the place it is found at;
/// none where it is valid. Throws std::logic_error for a keyword that this validator does not know.
[[nodiscard]] std::vector<std::string> schema_faults(const nlohmann::json& schema,
                                                     const nlohmann::json& value,
                                                     UnknownProperties unknown);

/// The schema of a report by its `schema`, "stillpoint/NAME/VERSION"; throws where there is none.
[[nodiscard]] const nlohmann::json& report_schema(const std::string& name);

/// The contents of data/FILE; throws if it is not JSON.
[[nodiscard]] nlohmann::json data_json(const std::filesystem::path& file);

/// The files .json in a folder of data.
[[nodiscard]] std::vector<std::filesystem::path> json_files(std::string_view folder);

/// Asserts that `text`, where it is a JSON object, is a report that its schema allows.
void check_report_schema(std::string_view text);

}  // namespace stillpoint::cli_test
