// SPDX-License-Identifier: MIT
#pragma once

#include "record_clock.hpp"
#include "settings.hpp"

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/report/record_origin.hpp>

#include <optional>

namespace stillpoint::cli {

/// What shakes the base, and where a record comes from.
struct ExcitationInput {
  Excitation excitation;
  std::optional<report::RecordOrigin> record;
};

/// Empty where nothing is asked for. A record's times become tau by its `clock`.
/// Throws UsageError for options that do not go together or a file that is not in order, and
/// InputError for a wrong value.
[[nodiscard]] std::optional<ExcitationInput> excitation_input(const Settings& settings,
                                                              const records::RecordClock& clock,
                                                              double gravity);

}  // namespace stillpoint::cli
