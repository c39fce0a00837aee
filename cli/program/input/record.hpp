// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"

#include <stillpoint/records/record_suite.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stillpoint::cli {

/// How the files of records are read, for a motion with this clock; the factor is 1.
[[nodiscard]] records::RecordOptions record_options(const Settings& settings,
                                                    const records::RecordClock& clock);

/// `p` of the spectrum where --record-spectrum-period does not give it. Throws InputError.
[[nodiscard]] records::RecordScale record_scale(const Settings& settings,
                                                const records::RecordClock& clock,
                                                std::optional<double> p);

/// The records of --record and --records-list. `p` is that of a spectrum to scale to; empty where
/// the motions have several. Throws InputError and FileError.
[[nodiscard]] std::vector<records::SuiteRecord> read_suite(const Settings& settings,
                                                           const records::RecordClock& clock,
                                                           std::optional<double> p);

/// What a folder of records has beside them, a sentence each. Throws FileError.
[[nodiscard]] std::vector<std::string> left_out_files(const Settings& settings);

}  // namespace stillpoint::cli
