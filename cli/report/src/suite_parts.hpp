// SPDX-License-Identifier: MIT
#pragma once

// What the reports of a suite of records share.

#include "units.hpp"

#include <stillpoint/design/suite_task.hpp>
#include <stillpoint/report/document.hpp>

#include <optional>
#include <string>

namespace stillpoint::report {

/// "2 x a.AT2": its factor and its file.
[[nodiscard]] std::string record_label(const design::SuiteRecord& record);

/// Where a notch differs from the paper's.
void add_real_notch(Section& section, const std::optional<double>& hold,
                    const std::optional<double>& width, const Physical& physical);

}  // namespace stillpoint::report
