// SPDX-License-Identifier: MIT
#include "json/fields.hpp"

#include <string>
#include <utility>

namespace stillpoint::report {

using nlohmann::ordered_json;

ordered_json number_json(double value, const Measure& measure) {
  return measure.numbers == Numbers::counts || measure.numbers == Numbers::from_one
             ? count(value)
             : ordered_json(value);
}

void put(ordered_json& object, std::string_view name, ordered_json value) {
  object[std::string(name)] = std::move(value);
}

}  // namespace stillpoint::report
