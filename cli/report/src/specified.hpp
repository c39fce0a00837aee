// SPDX-License-Identifier: MIT
#pragma once

// What the specification sheet says of a damper, whatever load it is for.

#include "json/answer_fields.hpp"

#include <stillpoint/report/sheet.hpp>

namespace stillpoint::report {

/// A case as it stands on the sheet.
struct SheetCase : ShownCase {
  std::string under;              ///< the motion that moves the mass farthest
  std::optional<double> allowed;  ///< of the stroke
  std::string governs;
  SimulationRequest motion;
};

/// A damper with all that is said of it.
struct Specified {
  const ShownAnswer& answer;
  std::string_view of_constraints;
  design::SuiteDamper damper;
  Interval f, delta, width, p;  ///< of the tolerance
  std::string tolerance;
  std::vector<SheetCase> cases;

  const Physical& physical{answer.units};
};

[[nodiscard]] inline bool has_mass(const Physical& physical) {
  return physical && physical->scales.mass_kg;
}

/// Its friction, notch and spring, with the least and the most of each.
void specify_damper(Document& sheet, const Specified& of);
/// Its page, but for the frame.
[[nodiscard]] std::string body(const Specified& of, const SheetFrame& frame);

}  // namespace stillpoint::report
