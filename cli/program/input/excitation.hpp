// SPDX-License-Identifier: MIT
#pragma once

#include "input/motion.hpp"

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/report/report.hpp>

namespace stillpoint::cli {

/// What shakes the base, and where a record comes from.
struct ExcitationInput {
  Excitation excitation;
  std::optional<report::RecordOrigin> record;
};

/// The kind that --excitation names; with only --record, "record". Empty: free motion. Throws
/// InputError for another name.
[[nodiscard]] std::optional<std::string> excitation_type(const Settings& settings);

/// Empty for a free motion. With physical input frequencies are in hertz and the times of a record
/// in seconds; `p` is that of the motion, empty if there are several.
/// Throws UsageError for options that cannot be combined, FileError for a wrong file and InputError
/// for a wrong value.
[[nodiscard]] std::optional<ExcitationInput> excitation_input(const Settings& settings,
                                                              const Physical& physical,
                                                              std::optional<double> p);

/// Throws UsageError for an option that only shapes another load than a record.
void require_options_of_record(const Settings& settings);

/// --end-time or --t-end, in tau; empty if neither is given. Throws InputError.
[[nodiscard]] std::optional<double> end_of_run(const Settings& settings, const Physical& physical);

/// The same of a run under the excitation; empty: up to the end of the motion. Throws InputError.
[[nodiscard]] std::optional<double> forced_end(const Settings& settings,
                                               const Excitation& excitation,
                                               const Physical& physical);

/// Throws UsageError for an option of pulses if there is no pulse.
void require_no_pulse_options(const Settings& settings);

/// The pulse that gives the initial velocity of a design, with ranges the strongest and longest;
/// empty if none is asked for. Throws UsageError for its options without it, and InputError for
/// a wrong value.
[[nodiscard]] std::optional<design::Pulse> pulse_input(const Settings& settings,
                                                       const Physical& physical);
/// The other ends of that pulse's ranges. Throws InputError.
[[nodiscard]] design::PulseRanges pulse_ranges(const Settings& settings,
                                               const std::optional<design::Pulse>& pulse);

}  // namespace stillpoint::cli
