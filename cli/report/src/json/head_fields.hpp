// SPDX-License-Identifier: MIT
#pragma once

// The rows with which every report begins.

#include "json/motion_fields.hpp"
#include "json/shown_findings.hpp"

#include <tuple>

namespace stillpoint::report {

/// `names` holds the name of the schema.
template <class Report, const auto& names>
inline constexpr auto head_fields =
    std::tuple{Field{"schema", [](const Report&) { return names.front(); }, "", {.texts = names}},
               Field{"program", [](const Report&) { return Program(); }}};

/// Of a report that has findings.
template <class Report>
inline constexpr auto told_fields =
    std::tuple{Field{"verdict", [](const Report& report) { return verdict(report); },
                     "the answer, in a sentence or two"},
               Field{"findings", [](const Report& report) {
                       return ShownFindings{findings(report), report.physical};
                     }}};

}  // namespace stillpoint::report
