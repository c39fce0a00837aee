// SPDX-License-Identifier: MIT
#pragma once

#include "input/motion.hpp"

#include <stillpoint/records/record_suite.hpp>

namespace stillpoint::cli {

/// Seconds with physical input, else tau, for a motion with this p.
[[nodiscard]] records::RecordClock record_clock(const Physical& physical, double p);

/// How record files are read, for a motion with this clock; the factor is 1.
[[nodiscard]] records::RecordOptions record_options(const Settings& settings,
                                                    const records::RecordClock& clock);

/// The `p` of the spectrum if --record-spectrum-period does not give it. Throws InputError.
[[nodiscard]] records::RecordScale record_scale(const Settings& settings,
                                                const records::RecordClock& clock,
                                                std::optional<double> p);

/// Where --record and --records-list say that the records are.
[[nodiscard]] records::SuiteFiles suite_files(const Settings& settings);

/// The records of --record and --records-list. `p` is that of a spectrum to scale to; empty if the
/// motions have several. Throws InputError and FileError.
[[nodiscard]] std::vector<records::SuiteRecord> read_suite(const Settings& settings,
                                                           const records::RecordClock& clock,
                                                           std::optional<double> p);

}  // namespace stillpoint::cli
