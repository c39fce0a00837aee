// SPDX-License-Identifier: MIT
#pragma once

// What the specification sheet says of a damper, whatever load it is for.

#include "sections.hpp"

#include <stillpoint/design/duty.hpp>
#include <stillpoint/report/sheet.hpp>

namespace stillpoint::report {

/// A case as it stands on the sheet.
struct SheetCase {
  std::string name;
  std::string under;  ///< the motion that moves the mass farthest
  design::Duty duty;
  std::optional<double> allowed;              ///< of the stroke
  std::optional<design::SuiteFigures> worst;  ///< of records and of several cases
  std::string governs;
  SimulationRequest motion;
};

/// A damper with all that is said of it.
struct Specified {
  const Physical& physical;
  std::string verdict;
  std::span<const design::Finding> findings;
  std::span<const design::Constraint> constraints;
  std::string_view of_constraints;
  const design::CrossCheck* check;
  const std::optional<design::WorksFor>& works_for;
  const design::Practice* practice;  ///< of ranges the worst
  design::SuiteDamper damper;
  Interval f, delta, width, p;  ///< of the tolerance
  std::string tolerance;
  std::vector<SheetCase> cases;
};

[[nodiscard]] inline bool has_mass(const Physical& physical) {
  return physical && physical->scales.mass_kg;
}

/// Its friction, notch and spring, with the least and the most of each.
void specify_damper(Document& sheet, const Specified& of);
/// Its page, but for the frame.
[[nodiscard]] std::string body(const Specified& of, const SheetFrame& frame);

}  // namespace stillpoint::report
