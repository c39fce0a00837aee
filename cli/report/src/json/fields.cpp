// SPDX-License-Identifier: MIT
#include "json/fields.hpp"

#include <string>
#include <utility>

namespace stillpoint::report {

using nlohmann::ordered_json;

namespace {

/// Null of what does not exist, without scales, and of a force whose mass is not known.
ordered_json in_si(const ordered_json& value, Dimension dimension, Scales scales) {
  if (scales == nullptr || value.is_null()) {
    return nullptr;
  }
  if (value.is_array()) {
    return list_json(value, [&](const ordered_json& end) { return in_si(end, dimension, scales); });
  }
  return scales->in_si(dimension, value.get<double>());
}

}  // namespace

ordered_json number_json(double value, Numbers numbers) {
  return numbers == Numbers::counts || numbers == Numbers::from_one ? count(value)
                                                                    : ordered_json(value);
}

void put(ordered_json& object, std::string_view name, ordered_json value) {
  object[std::string(name)] = std::move(value);
}

std::string si_name(std::string_view name, const Measure& measure) {
  return measure.physical.empty() ? std::string(name) + std::string(si_suffix(measure.dimension))
                                  : std::string(measure.physical);
}

void put(ordered_json& object, std::string_view name, ordered_json value, const Measure& measure,
         Scales scales) {
  if (measure.si == InSi::alone || measure.si == InSi::always) {
    object[std::string(name)] = in_si(value, measure.dimension, scales);
    return;
  }
  ordered_json& now = object[std::string(name)] = std::move(value);
  if (measure.si == InSi::beside) {
    ordered_json twin = in_si(now, measure.dimension, scales);
    object[si_name(name, measure)] = std::move(twin);
  }
}

}  // namespace stillpoint::report
