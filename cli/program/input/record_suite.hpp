// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"

#include <stillpoint/design/record_design.hpp>
#include <stillpoint/records/record_file.hpp>

#include <optional>
#include <vector>

namespace stillpoint::cli {

/// The records of --record and --records-list, with the factors that they are scaled by. `p` is
/// that of a spectrum to scale to; empty where the motions have several. Throws UsageError,
/// InputError and FileError.
[[nodiscard]] std::vector<design::SuiteRecord> read_suite(const Settings& settings,
                                                          const records::RecordClock& clock,
                                                          std::optional<double> p);

}  // namespace stillpoint::cli
