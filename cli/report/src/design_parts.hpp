// SPDX-License-Identifier: MIT
#pragma once

// The parts of the document of a design.

#include "sections.hpp"

#include <stillpoint/report/report.hpp>

#include <string>

namespace stillpoint::report {

/// The best is at the very end of the feasible f, no constant friction: a limit, which the search
/// comes near and nobody builds.
[[nodiscard]] bool wants_no_friction(const DesignReport& report);

/// What to build.
[[nodiscard]] std::string verdict(const DesignReport& report, const Physical& physical);

/// What it does, and how far it can be trusted.
void add_answer(Section& answer, const DesignReport& report, const Physical& physical);

/// How the motion under a pulse compares with that from a velocity in its place.
void add_pulse_check(Document& document, const design::PulseCheck& check, double beta,
                     const Physical& physical);
/// The same in one line.
[[nodiscard]] std::string reduction_text(const design::PulseCheck& check);

/// What a notch that is not the paper's changes.
void add_built_notch(Document& document, const design::BuiltNotch& built,
                     const design::Finding& finding, const Physical& physical);

}  // namespace stillpoint::report
