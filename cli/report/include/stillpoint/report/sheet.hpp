// SPDX-License-Identifier: MIT
#pragma once

// The specification of a damper, for those who build and check it: at most two pages of paper.

#include <stillpoint/report/page_frame.hpp>
#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/report.hpp>

namespace stillpoint::report {

struct SheetFrame : PageFrame {
  std::string revision{};  ///< empty: a blank to fill in
  std::string date{};
};

/// "2026-11-28": of SOURCE_DATE_EPOCH, as packagers set it, else today in UTC. Throws InputError
/// unless that is a number of seconds.
[[nodiscard]] std::string sheet_date();

/// What stands on it, as HTML; empty without an admissible damper.
[[nodiscard]] std::optional<std::string> sheet(const DesignReport& report, const SheetFrame& frame);
[[nodiscard]] std::optional<std::string> sheet(const RegionReport& report, const SheetFrame& frame);
[[nodiscard]] std::optional<std::string> sheet(const RecordDesignReport& report,
                                               const SheetFrame& frame);

}  // namespace stillpoint::report
