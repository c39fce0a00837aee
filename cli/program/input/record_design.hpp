// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"

#include <stillpoint/report/record_design.hpp>

namespace stillpoint::cli {

/// Whether `design` is asked for a damper under records, not for a hit. Throws UsageError where it
/// is asked for both.
[[nodiscard]] bool designs_under_records(const Settings& settings);

/// The request, and what a report needs beside it. Throws UsageError, InputError and FileError.
[[nodiscard]] report::RecordDesignInput record_design_input(const Settings& settings);

/// UsageError for an option that only a design under records takes.
void require_no_record_options(const Settings& settings);

}  // namespace stillpoint::cli
