// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"

#include <stillpoint/design/record_design.hpp>
#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/record_scan.hpp>
#include <stillpoint/sweep/output.hpp>

#include <optional>
#include <string>

namespace stillpoint::cli {

/// A part of the scan of a design under records.
struct RecordPart {
  report::RecordScan scan;
  bool computed{true};  ///< not found in its file
};

/// The part that --part asks for, which must be resolved; with --resume that of its file if it is
/// whole. Empty where `ask` ended it. Throws InputError, and LeftoverError where the file is of
/// another part of the same design.
[[nodiscard]] std::optional<RecordPart> record_part(const Settings& settings,
                                                    const report::RecordDesignInput& input,
                                                    const design::RecordWatch& ask);

/// What its file holds.
[[nodiscard]] std::string text(const report::RecordScan& scan);

/// Into its file, if it has one that does not hold it already.
void write(const RecordPart& part, sweep::Output& output);

}  // namespace stillpoint::cli
