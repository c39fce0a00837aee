// SPDX-License-Identifier: MIT
#include <stillpoint/core/names.hpp>
#include <stillpoint/records/record_options.hpp>

#include <array>

namespace stillpoint::records {

std::span<const Named<RecordUnits>> enumerators(RecordUnits) noexcept {
  static constexpr auto rows = std::to_array<Named<RecordUnits>>(
      {{RecordUnits::g, "g"}, {RecordUnits::m_per_s2, "m/s2"}, {RecordUnits::cm_per_s2, "cm/s2"}});
  return rows;
}

}  // namespace stillpoint::records
