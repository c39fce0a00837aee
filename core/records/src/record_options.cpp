// SPDX-License-Identifier: MIT
#include <stillpoint/core/names.hpp>
#include <stillpoint/records/record_options.hpp>

#include <array>

namespace stillpoint::records {

namespace {

constexpr Names units_names(std::to_array<Named<RecordUnits>>({
    {RecordUnits::g, "g"},
    {RecordUnits::m_per_s2, "m/s2"},
    {RecordUnits::cm_per_s2, "cm/s2"},
}));

}  // namespace

std::string_view name(RecordUnits units) noexcept {
  return units_names.name(units);
}

std::optional<RecordUnits> parse_record_units(std::string_view name) noexcept {
  return units_names.parse(name);
}

std::span<const std::string_view> record_unit_names() {
  return units_names.all();
}

}  // namespace stillpoint::records
