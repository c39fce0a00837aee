// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/identity.hpp>
#include <stillpoint/sweep/spec.hpp>
#include <stillpoint/sweep/state.hpp>

#include <nlohmann/json.hpp>

namespace stillpoint::sweep {

std::string identity_of(const SweepSpec& spec, const std::string& inputs,
                        std::string_view version) {
  nlohmann::ordered_json result;
  result["version"] = version;
  result["kind"] = name(spec.kind);
  result["format"] = name(spec.format);
  for (const Quantity column : spec.columns) {
    result["columns"].push_back(name(column));
  }
  result["list"] = spec.list != nullptr;
  result.update(nlohmann::ordered_json::parse(inputs));
  result["record_digest"] = digest(spec.excitation);
  if (!spec.parts.empty()) {
    result["catalogue_digest"] = digest(spec.parts);
  }
  return result.dump();
}

}  // namespace stillpoint::sweep
